//! The unloading law of a fender: rubber returns less energy than it absorbs.
//!
//! A fender's loading force is the gradient of an energy U, which depends on the hull's position (`face.rs`). On
//! unloading, the force of the fender falls to a lower curve. The lower curve is the gradient of another energy U_u,
//! which is nowhere steeper than U: ∇U_u = (R_u/R) ∇U. Between the two curves the force is F = ∇U_u + z ∇D, with D = U
//! − U_u ≥ 0 and 0 ≤ z ≤ 1. The factor z depends on the energy D alone: z = Σ q_i z_i over a few *play operators*. Each
//! play operator has one state, its top T_i, and the factor z_i = (D − (1 − w_i) T_i)/(w_i T_i), where D moves T_i so
//! that 0 ≤ z_i ≤ 1.
//!
//! During loading the energy D equals the tops T_i, and z = 1. On unloading, the factor z falls to 0 while D loses the
//! share w_i of T_i. On reloading, the factor z rises in the same way. This form of the unloading law has the following
//! consequences:
//!
//! - While the tops T_i stay constant, the force is the gradient of the energy that the fender can still return, V =
//!   U_u + Σ q_i (D − (1 − w_i)T_i)²/(2 w_i T_i). As with an elastic fender, the path of the hull and the tilt of the
//!   face do not matter.
//! - Along any path of the hull the work is dW = dV + heat. Heat arises only when a top rises: q_i (1 − w_i/2) dT_i
//!   ≥ 0. So the unloading law is passive: it creates no energy. Nothing is dissipated while D moves within the plays,
//!   nor when a top falls.
//! - The unloading law does not contain time: results depend neither on the speed nor on Δt.
//! - The unloading law has no scale except the load itself. A loop from zero to any deflection and back absorbs the
//!   energy U. Such a loop returns U_u + c D, with c = Σ q_i w_i/2. With R_u = r R the returned share of U is the same
//!   for any deflection and any reaction law. The factor r = (η − c)/(1 − c) makes this share equal to η.
//! - A ship under a steady load rests on the fender where she stops. Any deflection between the two curves carries the
//!   load of the ship. The ship does not creep, because between the two curves the plays act as springs.
//!
//! Play operators in parallel are the Prandtl-Ishlinskii model of hysteresis. Plays of several widths make the turn
//! between the curves round, and let small oscillations decay that a single play would sustain. We chose the widths and
//! shares of the plays ourselves.

use alloc::vec::Vec;

use crate::error::ModelError;
use crate::maths::number::{greater, lesser};
use crate::model::reaction::{FenderLaw, check_curve, integral, on_line};

/// The law by which a fender's reaction falls when the hull moves away. Only the coupled method uses this law; the
/// paper's method has restitution instead.
#[derive(Clone, Debug, PartialEq)]
pub enum Unloading {
    /// The fender returns this share of the absorbed energy in a loop from zero to any deflection and back, with any
    /// reaction law. The returned share is between [`Unloading::MIN_RETURNED_SHARE`] and 1. A body that hits such a
    /// fender leaves with the square root of this share of its speed.
    ReturnedEnergy(f64),
    /// The law is given by points (δ (m), R (N)) of the lower curve, from (0, 0) on, with straight lines between them.
    /// The lower curve needs a [`FenderLaw::Curve`] for loading, and lies nowhere above the loading curve. Beyond the
    /// last point, and in the stop, the reaction falls to the same share of the loading curve as at the last point.
    Curve(Vec<[f64; 2]>),
}

/// Number of play operators.
pub(crate) const PLAYS: usize = 3;

/// Width w_i of each play operator in D, as a share of the play's top.
const WIDTHS: [f64; PLAYS] = [1.0 / 10.0, 1.0 / 80.0, 1.0 / 640.0];

/// Share q_i of each play operator in z. The shares of the plays are proportional to their widths, so that each play
/// adds the same stiffness.
const SHARES: [f64; PLAYS] = [
    WIDTHS[0] / (WIDTHS[0] + WIDTHS[1] + WIDTHS[2]),
    WIDTHS[1] / (WIDTHS[0] + WIDTHS[1] + WIDTHS[2]),
    WIDTHS[2] / (WIDTHS[0] + WIDTHS[1] + WIDTHS[2]),
];

/// Share c of the energy D that the plays return.
const RETURNED_BY_PLAYS: f64 =
    0.5 * (SHARES[0] * WIDTHS[0] + SHARES[1] * WIDTHS[1] + SHARES[2] * WIDTHS[2]);

impl Unloading {
    /// The smallest returned share. The smallest share is not 0, because the force needs some distance to fall.
    pub const MIN_RETURNED_SHARE: f64 = 0.05;

    /// The share of the energy ∫ R dδ that a loop to a deflection and back returns, without the stop. For
    /// [`Unloading::ReturnedEnergy`] the returned share does not depend on the deflection.
    #[must_use]
    pub fn returned_share(&self, law: &FenderLaw, deflection_m: f64) -> f64 {
        match self {
            Unloading::ReturnedEnergy(share) => *share,
            Unloading::Curve(points) => {
                let taken_j = law.energy_j(deflection_m);
                let (lower_j, _) = lower_of_curve(points, law, deflection_m);
                if taken_j > 0.0 {
                    (lower_j + RETURNED_BY_PLAYS * (taken_j - lower_j)) / taken_j
                } else {
                    1.0
                }
            }
        }
    }

    /// The reaction of the lower curve at a deflection whose loading reaction is `loading_n`, without the fender's
    /// factors and stop (N).
    #[must_use]
    pub fn reaction_n(&self, law: &FenderLaw, deflection_m: f64, loading_n: f64) -> f64 {
        match self {
            Unloading::ReturnedEnergy(share) => lower_share(*share) * loading_n,
            Unloading::Curve(points) => lower_of_curve(points, law, deflection_m).1,
        }
    }

    /// Finds the first point (δ, R) at which an unloading curve lies above a loading curve by more than rounding. The
    /// first point is a vertex of one of the two curves, because both curves are straight between vertices.
    #[must_use]
    pub fn first_point_above(unloading: &[[f64; 2]], loading: &[[f64; 2]]) -> Option<[f64; 2]> {
        let end_m = unloading.last().map_or(0.0, |p| p[0]);
        let places = unloading.iter().chain(loading.iter().filter(|p| p[0] <= end_m));
        places
            .map(|p| [p[0], on_line(unloading, p[0])])
            .find(|&[at_m, lower_n]| lower_n > on_line(loading, at_m) * (1.0 + 1e-9) + 1e-9)
    }

    /// Checks the values. `name` is the name of the fender for errors, and `law` the loading law of the fender.
    pub(crate) fn check(&self, name: &str, law: &FenderLaw) -> Result<(), ModelError> {
        let bad = |field, value, must| {
            Err(ModelError::OutOfRange { owner: name.into(), field, value, must })
        };
        match self {
            Unloading::ReturnedEnergy(share) => {
                if (Unloading::MIN_RETURNED_SHARE..=1.0).contains(share) {
                    Ok(())
                } else {
                    bad("returned energy", *share, "between 0.05 and 1")
                }
            }
            Unloading::Curve(points) => {
                let field = "deflection of the unloading curve";
                let FenderLaw::Curve(loading) = law else {
                    return bad(field, 0.0, "left out, because the fender has no reaction curve");
                };
                check_curve(name, [field, field], points)?;
                match Unloading::first_point_above(points, loading) {
                    None => Ok(()),
                    Some([_, value]) => {
                        let field = "reaction of the unloading curve";
                        bad(field, value, "nowhere above the loading curve")
                    }
                }
            }
        }
    }

    /// The numbers that distinguish this unloading law from others, for fingerprints of models.
    pub(crate) fn words(&self) -> impl Iterator<Item = f64> + '_ {
        let (share, points): (f64, &[[f64; 2]]) = match self {
            Unloading::ReturnedEnergy(share) => (*share, &[]),
            Unloading::Curve(points) => (-1.0, points),
        };
        core::iter::once(share).chain(points.iter().flatten().copied())
    }
}

/// The factor r in R_u = r R with which a loop returns the share `returned` of the energy.
fn lower_share(returned: f64) -> f64 {
    greater((returned - RETURNED_BY_PLAYS) / (1.0 - RETURNED_BY_PLAYS), 0.0)
}

/// Energy ∫ R_u dδ and reaction R_u of the lower curve at a deflection (J, N).
fn lower_of_curve(points: &[[f64; 2]], law: &FenderLaw, deflection_m: f64) -> (f64, f64) {
    let [end_m, end_n] = points[points.len() - 1];
    let loading_n = law.reaction_n(deflection_m);
    if deflection_m <= end_m {
        return (integral(points, deflection_m), lesser(on_line(points, deflection_m), loading_n));
    }
    let share = share_beyond(law, [end_m, end_n]);
    let beyond_j = law.energy_j(deflection_m) - law.energy_j(end_m);
    (integral(points, end_m) + share * beyond_j, share * loading_n)
}

/// Ratio R_u/R of the lower to the loading reaction at the end of an unloading curve.
fn share_beyond(law: &FenderLaw, [end_m, end_n]: [f64; 2]) -> f64 {
    let loading_n = law.reaction_n(end_m);
    if loading_n > 0.0 { lesser(end_n / loading_n, 1.0) } else { 1.0 }
}

/// Loading force and energy of a fender contact at its deflection, not yet multiplied by the fender's factors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Loading {
    pub(crate) deflection_m: f64,
    /// Force of the fender's reaction curve (N).
    pub(crate) spring_n: f64,
    /// Force of the fender's stop (N).
    pub(crate) stop_n: f64,
    /// Energy U of reaction curve and stop (J).
    pub(crate) stored_j: f64,
}

/// Force and energy of a fender contact by the unloading law of the fender, not yet multiplied by the fender's factors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Unloaded {
    /// Force by the unloading law, divided by the loading force.
    pub(crate) share: f64,
    /// Energy V that the fender can still return (J).
    pub(crate) recoverable_j: f64,
    /// Energy that the fender has dissipated since its play operators had the tops that were given to [`unload`] (J).
    pub(crate) lost_j: f64,
    /// Top T of each play operator (J).
    pub(crate) tops_j: [f64; PLAYS],
}

/// Applies the unloading law to a contact of a fender, starting from the tops that the contact remembers. Tops of
/// `None` mean a new contact, whose loading is not known: the fender counts as having dissipated nothing in this
/// contact.
pub(crate) fn unload(
    unloading: &Unloading,
    law: &FenderLaw,
    loading: &Loading,
    tops_j: Option<&[f64; PLAYS]>,
) -> Unloaded {
    let whole_n = loading.spring_n + loading.stop_n;
    let (lower_n, lower_j) = match unloading {
        Unloading::ReturnedEnergy(returned) => {
            let share = lower_share(*returned);
            (share * whole_n, share * loading.stored_j)
        }
        Unloading::Curve(points) => {
            let deflection_m = loading.deflection_m;
            let (energy_j, reaction_n) = lower_of_curve(points, law, deflection_m);
            let loading_n = law.reaction_n(deflection_m);
            // The share of the reaction is used, not the reaction itself, because a tilted face has a larger force than
            // R.
            let of_spring = if loading_n > 0.0 { reaction_n / loading_n } else { 1.0 };
            let of_stop = share_beyond(law, points[points.len() - 1]);
            let stop_j = greater(loading.stored_j - law.energy_j(deflection_m), 0.0);
            (of_spring * loading.spring_n + of_stop * loading.stop_n, energy_j + of_stop * stop_j)
        }
    };
    let between_j = greater(loading.stored_j - lower_j, 0.0);
    let plays = Plays::moved(between_j, tops_j);
    let share =
        if whole_n > 0.0 { (lower_n + plays.z * (whole_n - lower_n)) / whole_n } else { 1.0 };
    Unloaded {
        share,
        recoverable_j: lower_j + plays.recoverable_j,
        lost_j: plays.lost_j,
        tops_j: plays.tops_j,
    }
}

/// The play operators of an unloading law at a value of the energy D.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Plays {
    z: f64,
    recoverable_j: f64,
    lost_j: f64,
    tops_j: [f64; PLAYS],
}

impl Plays {
    fn moved(between_j: f64, tops_j: Option<&[f64; PLAYS]>) -> Plays {
        let mut plays = Plays::default();
        for index in 0..PLAYS {
            let (width, weight) = (WIDTHS[index], SHARES[index]);
            let before_j = tops_j.map_or(between_j, |tops_j| tops_j[index]);
            let top_j = lesser(greater(before_j, between_j), between_j / (1.0 - width));
            if between_j > before_j {
                plays.lost_j += weight * (1.0 - 0.5 * width) * (between_j - before_j);
            }
            // z is between 0 and 1; it is 1 before any loading.
            let z = if top_j > 0.0 { 1.0 - (top_j - between_j) / (width * top_j) } else { 1.0 };
            let z = greater(z, 0.0);
            plays.z += weight * z;
            plays.recoverable_j += weight * (0.5 * width * top_j) * (z * z);
            plays.tops_j[index] = top_j;
        }
        plays.z = lesser(plays.z, 1.0);
        plays
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    /// A curve that buckles, like that of a cone fender.
    fn cone() -> FenderLaw {
        FenderLaw::Curve(vec![[0.0, 0.0], [0.3, 9e5], [0.5, 8e5], [0.7, 1e6]])
    }

    fn at(law: &FenderLaw, deflection_m: f64) -> Loading {
        Loading {
            deflection_m,
            spring_n: law.reaction_n(deflection_m),
            stored_j: law.energy_j(deflection_m),
            ..Loading::default()
        }
    }

    /// Work absorbed and returned, heat, and the last state, along a path of deflections.
    fn along(unloading: &Unloading, law: &FenderLaw, path: &[f64]) -> (f64, f64, f64, Unloaded) {
        let mut last: Option<(f64, f64, Unloaded)> = None;
        let (mut taken_j, mut given_j, mut lost_j) = (0.0, 0.0, 0.0);
        for &deflection_m in path {
            let touch = at(law, deflection_m);
            let tops = last.as_ref().map(|(_, _, unloaded)| unloaded.tops_j);
            let now = unload(unloading, law, &touch, tops.as_ref());
            let force_n = now.share * touch.spring_n;
            if let Some((before_m, before_n, _)) = last {
                let work_j = 0.5 * (before_n + force_n) * (deflection_m - before_m);
                if work_j > 0.0 { taken_j += work_j } else { given_j -= work_j }
            }
            lost_j += now.lost_j;
            last = Some((deflection_m, force_n, now));
        }
        (taken_j, given_j, lost_j, last.map_or(Unloaded::default(), |(_, _, now)| now))
    }

    fn loop_to(top_m: f64, steps: i32) -> Vec<f64> {
        let up = (0..=steps).map(|i| top_m * f64::from(i) / f64::from(steps));
        let down = (0..steps).rev().map(|i| top_m * f64::from(i) / f64::from(steps));
        up.chain(down).collect()
    }

    #[test]
    fn a_loop_returns_its_share_from_any_deflection_with_any_law() {
        for law in [cone(), FenderLaw::linear(2e6)] {
            for share in [0.05, 0.3, 0.55, 0.8, 1.0] {
                for top_m in [1e-4, 0.05, 0.3, 0.62, 1.1] {
                    let unloading = Unloading::ReturnedEnergy(share);
                    let (taken_j, given_j, lost_j, _) =
                        along(&unloading, &law, &loop_to(top_m, 20_000));
                    let off = given_j / taken_j - share;
                    assert!(off.abs() < 1e-4, "{share} to {top_m} m: {off}");
                    let left_j = taken_j - given_j - lost_j;
                    assert!(left_j.abs() < 1e-4 * taken_j, "{left_j} of {taken_j} J");
                }
            }
        }
    }

    #[test]
    fn a_loop_returns_the_area_under_the_unloading_curve() {
        let points = vec![[0.0, 0.0], [0.1, 0.0], [0.4, 4e5], [0.7, 1e6]];
        let (law, unloading) = (cone(), Unloading::Curve(points.clone()));
        assert_eq!(
            Unloading::first_point_above(
                &points,
                &[[0.0, 0.0], [0.3, 9e5], [0.5, 8e5], [0.7, 1e6]]
            ),
            None
        );
        for top_m in [0.05, 0.3, 0.7, 0.9] {
            let (taken_j, given_j, ..) = along(&unloading, &law, &loop_to(top_m, 20_000));
            let share = unloading.returned_share(&law, top_m);
            assert!((given_j / taken_j - share).abs() < 1e-4, "{top_m}: {given_j} of {taken_j}");
        }
        // Unloading and loading curves that meet at the end of a measured loop coincide beyond it.
        let far = unloading.reaction_n(&law, 0.9, law.reaction_n(0.9));
        assert_eq!(far, law.reaction_n(0.9));
    }

    #[test]
    fn an_unloading_curve_above_the_loading_curve_is_found_between_its_points() {
        let loading = [[0.0, 0.0], [0.3, 9.0], [0.5, 4.0], [0.7, 10.0]];
        assert_eq!(
            Unloading::first_point_above(&[[0.0, 0.0], [0.7, 10.0]], &loading),
            Some([0.5, 10.0 / 1.4])
        );
        assert_eq!(
            Unloading::first_point_above(&[[0.0, 0.0], [0.2, 7.0]], &loading),
            Some([0.2, 7.0])
        );
        assert_eq!(Unloading::first_point_above(&[[0.0, 0.0], [0.7, 5.0]], &loading), None);
    }

    /// On random walks, work equals recoverable energy plus heat, and heat never decreases.
    #[test]
    fn on_any_path_heat_grows_and_energy_balances() {
        let law = cone();
        let mut seed = 7_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        for unloading in [
            Unloading::ReturnedEnergy(0.5),
            Unloading::Curve(vec![[0.0, 0.0], [0.2, 1e5], [0.7, 6e5]]),
        ] {
            let mut place_m = 0.0;
            let mut tops = [0.0; PLAYS];
            let (mut work_j, mut heat_j, mut recoverable_j) = (0.0, 0.0, 0.0);
            for _ in 0..400 {
                let aim_m = 0.8 * random();
                let steps = 500;
                let from_m = place_m;
                for i in 1..=steps {
                    let next_m = from_m + (aim_m - from_m) * f64::from(i) / f64::from(steps);
                    let middle = at(&law, 0.5 * (place_m + next_m));
                    let half = unload(&unloading, &law, &middle, Some(&tops));
                    work_j += half.share * middle.spring_n * (next_m - place_m);
                    let now = unload(&unloading, &law, &at(&law, next_m), Some(&half.tops_j));
                    assert!(now.lost_j >= 0.0 && half.lost_j >= 0.0);
                    heat_j += half.lost_j + now.lost_j;
                    (place_m, tops, recoverable_j) = (next_m, now.tops_j, now.recoverable_j);
                }
                let off_j: f64 = work_j - heat_j - recoverable_j;
                assert!(
                    off_j.abs() < 1e-4 * (work_j + heat_j),
                    "{off_j} J of {work_j} and {heat_j}"
                );
            }
        }
    }

    /// A steady load with gusts. Between the curves, the same oscillation reaches the same force each time.
    #[test]
    fn oscillations_between_the_curves_do_not_ratchet() {
        let (law, unloading) = (cone(), Unloading::ReturnedEnergy(0.55));
        let (.., settled) = along(&unloading, &law, &[0.0, 0.2, 0.19]);
        let mut tops = settled.tops_j;
        let mut first = None;
        for swing in 0..1000 {
            let forces = [0.1902, 0.1898].map(|deflection_m| {
                let touch = at(&law, deflection_m);
                let now = unload(&unloading, &law, &touch, Some(&tops));
                tops = now.tops_j;
                (now.share * touch.spring_n).to_bits()
            });
            if swing > 0 {
                assert_eq!(*first.get_or_insert(forces), forces, "swing {swing}");
            }
        }
    }
}
