//! The work of the line handlers: which lines an order may send to which bollard, and which line the handlers take
//! next.

use std::borrow::Cow;

use fenderline_contact::BodyState;

use super::line::{Mooring, MooringSetup};
use super::setup::WorldSetup;
use super::shore::Shore;
use crate::order::{Action, LineAction, Order, OrderError};

/// An order to send a line to a bollard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sending {
    /// Index of the line in the set-up.
    pub line: usize,
    /// Index of the bollard in the set-up.
    pub bollard: usize,
}

/// The lines as they will be after the orders. If none of the orders is to a line, the result is the present lines.
pub(super) fn after_orders<'l, 'o>(
    lines: &'l [Mooring],
    setup: &WorldSetup,
    orders: impl Iterator<Item = &'o Order>,
    t_s: f64,
) -> Cow<'l, [Mooring]> {
    let mut after = Cow::Borrowed(lines);
    for order in orders {
        match order.action {
            Action::Line(line, LineAction::LetGo) => {
                after.to_mut()[line].let_go(&setup.lines[line], t_s);
            }
            // A line that is not on board at that time is not sent.
            Action::Line(line, LineAction::Send { bollard }) if after[line].aboard => {
                after.to_mut()[line].send(bollard, t_s);
            }
            Action::Line(..) | Action::Vessel(..) | Action::Tug(..) | Action::Anchor(..) => {}
        }
    }
    after
}

/// Checks that an order can send a line to a bollard now.
///
/// # Errors
/// Returns the reason why the line cannot go: the line is not on board, the bollard has no free place, or the bollard
/// is out of reach.
pub(super) fn may_send(
    lines: &[Mooring],
    setup: &WorldSetup,
    states: &[BodyState],
    shore: Shore<'_>,
    Sending { line, bollard: to }: Sending,
) -> Result<(), OrderError> {
    let (own, of, bollard) = (&lines[line], &setup.lines[line], &setup.bollards[to]);
    let name = || of.line.name.clone();
    if own.has_parted() {
        return Err(OrderError::LineParted { line: name() });
    }
    if own.sent.is_some() {
        return Err(OrderError::LineUnderWay { line: name() });
    }
    if !own.aboard {
        return Err(OrderError::LineInUse { line: name() });
    }
    let others = lines.iter().filter(|other| other.bollard == Some(to) && !other.has_parted());
    if others.count() >= bollard.most_lines {
        let (bollard, most_lines) = (bollard.name.clone(), bollard.most_lines);
        return Err(OrderError::BollardTaken { bollard, most_lines });
    }
    let distance_m = distance_m(of, setup, states, shore, to);
    let handling = &setup.line_handling;
    let out_of_reach = |reach_m: f64, by: &'static str| {
        let bollard = bollard.name.clone();
        Err(OrderError::OutOfReach { line: name(), bollard, distance_m, reach_m, by })
    };
    if distance_m > of.reach_m() {
        return out_of_reach(of.reach_m(), "the rope");
    }
    if handling.time_s(distance_m).is_none() {
        return out_of_reach(handling.heaving_line_m, "a heaving line");
    }
    Ok(())
}

/// Gives the waiting lines to free line handlers, in the order in which the lines were sent. If the bollard is by then
/// out of reach, the program finds this when the line should be made fast.
pub(super) fn take_lines(
    lines: &mut [Mooring],
    setup: &WorldSetup,
    states: &[BodyState],
    shore: Shore<'_>,
    t_s: f64,
) {
    if lines.iter().all(|line| !line.waits_for_handlers(t_s)) {
        return;
    }
    let at_work = |line: &Mooring| line.sent.is_some_and(|sent| sent.fast_at_s.is_some());
    let mut free =
        setup.line_handling.gangs.saturating_sub(lines.iter().filter(|line| at_work(line)).count());
    while free > 0 {
        let waiting = lines.iter().enumerate().filter(|(_, line)| line.waits_for_handlers(t_s));
        let since_s = |line: &Mooring| line.sent.map_or(f64::INFINITY, |sent| sent.since_s);
        // Of lines sent at the same time, the first in the scenario is taken.
        let next = waiting.min_by(|one, other| since_s(one.1).total_cmp(&since_s(other.1)));
        let Some((index, own)) = next else { return };
        let (Some(mut sent), Some(to)) = (own.sent, own.bollard) else { return };
        let distance_m = distance_m(&setup.lines[index], setup, states, shore, to);
        let handling = &setup.line_handling;
        sent.fast_at_s = Some(t_s + handling.time_s(distance_m).unwrap_or(handling.heaving_line_s));
        lines[index].sent = Some(sent);
        free -= 1;
    }
}

/// Distance from a line's fairlead to a bollard (m).
fn distance_m(
    line: &MooringSetup,
    setup: &WorldSetup,
    states: &[BodyState],
    shore: Shore<'_>,
    to: usize,
) -> f64 {
    line.ends(setup.bollards[to].end(), states, shore).distance_m()
}
