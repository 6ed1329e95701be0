//! Contacts that hold more than their load come apart.

use crate::coupled::rows::Row;
use crate::coupled::tie::Tie;
use crate::model::Model;

/// Share of the speed that unheld energy would give, so that it stays below v_ref in a hit, where the
/// time step's error in the stored energy is a few per cent.
const LET_GO: f64 = 0.8;

/// Raises each v_ref of an island's contacts to the speed that the stored energy which no load holds would
/// give. `unheld_j` has room for a number a body.
///
/// v_ref alone forgets: where the relative velocity changes sign by a trifle, as it does when a ship on
/// several fenders yaws a little while she comes back, it starts again from next to nothing, and she
/// rests for ever deeper than her load holds her, or stays pressed on when the wind has died. A spring
/// at δ that is held by N < f has about U (1 − N/f)² more than it needs (exactly, where it is linear);
/// all contacts between the same two bodies, or of one body with what is fixed, let go together. As
/// N ≤ f still, and N < f only while the contact opens, nothing is made out of nothing.
#[inline]
pub(crate) fn let_go(model: &Model, rows: &mut [Row], ties: &mut [Tie], unheld_j: &mut [f64]) {
    // While bodies close most of them come faster than all of it could give them.
    if let ([row], [tie]) = (&mut *rows, &mut *ties) {
        if rises(row.unheld_j, row, tie) {
            raise(row.unheld_j, row, tie);
        }
        return;
    }
    let all_j = rows.iter().map(|row| row.unheld_j).sum();
    let rises = |(row, tie): (&Row, &Tie)| rises(all_j, row, tie);
    if rows.iter().zip(&*ties).any(rises) {
        let_go_together(model, rows, ties, unheld_j);
    }
}

#[inline(always)]
fn rises(unheld_j: f64, row: &Row, tie: &Tie) -> bool {
    speed_squared(unheld_j, tie) > row.v_ref_mps * row.v_ref_mps
}

/// Square of the speed that unheld energy would give the two bodies of a contact, without rotation [m²/s²]:
/// contacts at both ends of a ship do not turn her.
#[inline(always)]
fn speed_squared(unheld_j: f64, tie: &Tie) -> f64 {
    LET_GO * LET_GO * 2.0 * unheld_j * tie.linear
}

/// It goes on until the contact closes again: else the bound would come and go with N.
#[cold]
#[inline(never)]
fn raise(unheld_j: f64, row: &mut Row, tie: &mut Tie) {
    let speed_mps = libm::sqrt(speed_squared(unheld_j, tie));
    tie.rebound_mps = tie.rebound_mps.max(tie.restitution * speed_mps);
    row.v_ref_mps = row.v_ref_mps.max(speed_mps);
}

/// The unheld energy of all contacts that let go together, and what it makes of their v_ref.
#[cold]
#[inline(never)]
fn let_go_together(model: &Model, rows: &mut [Row], ties: &mut [Tie], unheld_j: &mut [f64]) {
    let fixed = |rank: u32| model.ranked[rank as usize].is_fixed();
    for tie in ties.iter() {
        unheld_j[tie.a as usize] = 0.0;
        unheld_j[tie.b as usize] = 0.0;
    }
    for (row, tie) in rows.iter().zip(ties.iter()) {
        match (fixed(tie.a), fixed(tie.b)) {
            (true, _) => unheld_j[tie.b as usize] += row.unheld_j,
            (_, true) => unheld_j[tie.a as usize] += row.unheld_j,
            _ => {}
        }
    }
    let mut from = 0;
    while from < rows.len() {
        let (a, b) = (ties[from].a, ties[from].b);
        let count = ties[from..].iter().take_while(|tie| (tie.a, tie.b) == (a, b)).count();
        let own = from..from + count;
        let all_j = match (fixed(a), fixed(b)) {
            (true, _) => unheld_j[b as usize],
            (_, true) => unheld_j[a as usize],
            _ => rows[own.clone()].iter().map(|row| row.unheld_j).sum(),
        };
        if all_j > 0.0 {
            for (row, tie) in rows[own.clone()].iter_mut().zip(&mut ties[own]) {
                raise(all_j, row, tie);
            }
        }
        from += count;
    }
}
