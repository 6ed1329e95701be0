//! The pull of a straight wall, or of the bank of a bottom by place, on a ship that goes along it. The ship's image behind
//! the wall gives the flow.

use fenderline_contact::number::greater;
use fenderline_contact::{Pose, Vec2, vec2};
use fenderline_ship::environment::{Bank, BankMethod, BankWater};
use fenderline_ship::hydro::Force;
use fenderline_ship::passing::{FlowSetup, PassingShip, force_of_wall};

use super::act::{Afloat, Vessels, smooth};
use crate::world::{Environment, Soundings, Walls};

/// Sines of the angles between ship and wall (15 and 30 degrees) at which the force begins to fade, and at which the
/// force is zero; our choice.
const ASKEW: [f64; 2] = [0.258_8, 0.5];
/// Clear gap between the ship's side and the wall, divided by the ship's beam. Below the first value the theory of
/// slender ships does not hold; from the second value on, the model uses the full flow of this theory. The values are
/// half the values for two vessels, because the image is twice as far away as the wall; our choice.
const TOO_NEAR: [f64; 2] = [0.125, 0.25];
/// Distance between ship and image, divided by the ship's length, at which the force begins to fade, and at which the
/// force is zero.
const FADES: [f64; 2] = [8.0, 10.0];

/// Sets the force of all banks that act by an image on each vessel, about midship.
pub fn act_of_banks(
    flow: &FlowSetup,
    Vessels { setups, states }: Vessels<'_>,
    environment: &Environment,
    soundings: &[Soundings],
    t_s: f64,
    into: &mut [Force],
) {
    into.fill(Force::default());
    let by_image = |bank: &&Bank| bank.method() == BankMethod::Image;
    let bottom = environment.bottom.as_ref();
    let of_bottom = bottom.filter(|bottom| bottom.banks == Some(BankMethod::Image));
    let is_needed = of_bottom.is_some() || environment.banks.iter().any(|bank| by_image(&bank));
    if flow.hulls.is_empty() || !is_needed {
        return;
    }
    let depths = soundings.iter().zip(into);
    for ((hull, setup), (soundings, into)) in flow.hulls.iter().zip(setups).zip(depths) {
        if !hull.is_slender() {
            continue;
        }
        let own = Afloat::of_vessel(hull, setup, states, environment, t_s);
        // For a ship aground the bottom is at the keel.
        let depth_m = soundings.mean_m.map(|depth_m| greater(depth_m, hull.draught_m));
        for bank in environment.banks.iter().filter(by_image) {
            let share = share_of(&own, bank.ends_m());
            if share == 0.0 {
                continue;
            }
            let [surge_n, sway_n, yaw_nm] = force_of_wall(
                &own.in_flow(),
                bank.ends_m(),
                environment.water_density_kgpm3,
                depth_m,
                hull.beam_m,
            );
            *into = *into + Force { surge_n, sway_n, yaw_nm } * share;
        }
        if let (Some(bottom), Some(mean_m)) = (of_bottom, soundings.mean_m) {
            let level_m = environment.level_m(t_s);
            let (hull, state) = (&setup.ship.particulars, &states[setup.body]);
            let walls = Walls::beside(hull, state, bottom, level_m, mean_m);
            let water = BankWater { density_kgpm3: environment.water_density_kgpm3, depth_m };
            *into = *into + between(&own, &walls, &water);
        }
    }
}

/// The force of the two walls that stand for the sections of a bottom. The walls lie along the ship, however she heads,
/// so that she feels no moment but that of her form.
fn between(own: &Afloat<'_>, walls: &Walls, water: &BankWater) -> Force {
    let &BankWater { density_kgpm3, depth_m } = water;
    let flow = own.in_flow();
    let ahead_mps = flow.pose.rotation.apply_inverse(flow.velocity_mps).x;
    // In the ship's axes, so that ship and harbour may be turned or mirrored together.
    let own_axes = PassingShip {
        pose: Pose::new(Vec2::ZERO, 0.0),
        velocity_mps: vec2(ahead_mps, 0.0),
        ..flow
    };
    let sides = [-1.0, 1.0].into_iter().zip(walls.per_m2);
    sides.fold(Force::default(), |sum, (side, per_m2)| {
        let off_m = 1.0 / per_m2.sqrt();
        let gap = off_m / own.hull.beam_m - 0.5;
        let share = match off_m.is_finite() {
            true => smooth(gap, TOO_NEAR) * (1.0 - smooth(2.0 * off_m / own.hull.length_m, FADES)),
            false => 0.0,
        };
        if share == 0.0 || ahead_mps == 0.0 {
            return sum;
        }
        let wall = [vec2(-1.0, side * off_m), vec2(1.0, side * off_m)];
        let [surge_n, sway_n, yaw_nm] =
            force_of_wall(&own_axes, wall, density_kgpm3, depth_m, own.hull.beam_m);
        sum + Force { surge_n, sway_n, yaw_nm } * share
    })
}

/// The share of the image's flow that the model uses. The share depends on the ship's angle to the wall, on the clear
/// gap, and on how much of the ship is abreast of the wall.
fn share_of(own: &Afloat<'_>, [from_m, to_m]: [Vec2; 2]) -> f64 {
    let length_m = (to_m - from_m).length();
    let along = (to_m - from_m) * (1.0 / length_m);
    let ends_m = own.ends_m().map(|end_m| end_m - from_m);
    let [stern_m, bow_m] = ends_m.map(|end_m| along.cross(end_m));
    if stern_m * bow_m <= 0.0 {
        return 0.0;
    }
    let nearest_m = if stern_m.abs() < bow_m.abs() { stern_m.abs() } else { bow_m.abs() };
    let gap = (nearest_m - 0.5 * own.hull.beam_m) / own.hull.beam_m;
    let askew = along.cross(ends_m[1] - ends_m[0]).abs() / own.hull.length_m;
    if askew >= ASKEW[1] {
        return 0.0;
    }
    let [aft_m, fore_m] = ends_m.map(|end_m| along.dot(end_m));
    let (low_m, high_m) = if aft_m < fore_m { (aft_m, fore_m) } else { (fore_m, aft_m) };
    let last_m = if high_m < length_m { high_m } else { length_m };
    let abreast = greater(last_m - greater(low_m, 0.0), 0.0) / (high_m - low_m);
    let image_m = (stern_m + bow_m).abs();
    smooth(gap, TOO_NEAR)
        * (1.0 - smooth(askew, ASKEW))
        * (1.0 - smooth(image_m / own.hull.length_m, FADES))
        * abreast
}
