//! The berth of the docking board, and the position of a ship relative to this berth, for pages.

use fenderline_contact::{BodyState, Outline};
use fenderline_sim::Setup;
use fenderline_sim::berth::{Berth, Lie};

use crate::approach::Light;
use crate::cast::Cast;
use crate::message::{BerthEnd, BerthInfo, BerthNow, Lamp};
use crate::pair::pair;

/// The berth of the docking board: the berth with the most fenders. Of several berths with equally many fenders, the
/// docking board takes the nearest to the pilot's own ship at the start. Fenders on the own ship and on tugs do not
/// count. The result is `None` without a ship, or without fenders of a berth.
pub(crate) fn of(setup: &Setup, cast: &Cast) -> Option<Berth> {
    let vessels = &setup.world.vessels;
    let own = vessels[cast.own?].body;
    let is_tug = |body: usize| {
        vessels.iter().zip(&cast.is_tug).any(|(vessel, &tug)| tug && vessel.body == body)
    };
    Berth::of(setup, own, |body| body != own && !is_tug(body))
}

/// The berth as a message for pages.
#[must_use]
pub fn berth_info(berth: &Berth) -> BerthInfo {
    let [from, to, facing] = [berth.from_m, berth.to_m, berth.facing].map(pair);
    BerthInfo { body: berth.body, from, to, facing }
}

/// The position and speed of a ship relative to the berth. `on` is the position and motion of the body that carries the
/// berth. The docking board fills in the lamps, the speed limit and the contact of each end of the ship.
pub(crate) fn seen_from(
    berth: &Berth,
    on: &BodyState,
    outline: &Outline,
    state: &BodyState,
) -> BerthNow {
    let Lie { off_m, closing_mps, ahead_mps, angle_rad, .. } = berth.lie(on, outline, state);
    BerthNow {
        bow: BerthEnd::Off,
        stern: BerthEnd::Off,
        bow_limit_mps: 0.0,
        stern_limit_mps: 0.0,
        bow_lamp: Lamp { light: Light::Ok, text: "", by_speed: false },
        stern_lamp: Lamp { light: Light::Ok, text: "", by_speed: false },
        bow_m: off_m[0],
        stern_m: off_m[1],
        bow_mps: closing_mps[0],
        stern_mps: closing_mps[1],
        along_mps: ahead_mps,
        angle_rad,
    }
}

#[cfg(test)]
mod tests {
    use fenderline_contact::vec2;

    use super::*;

    fn ship() -> Outline {
        let points = [
            vec2(-50.0, -8.0),
            vec2(-40.0, -10.0),
            vec2(30.0, -10.0),
            vec2(50.0, 0.0),
            vec2(30.0, 10.0),
            vec2(-40.0, 10.0),
            vec2(-50.0, 8.0),
        ];
        Outline::new(&points).expect("a hull").0
    }

    #[test]
    fn distances_speeds_and_angle_are_those_of_the_flat_of_the_side() {
        // A quay to the east of the ship. The ship lies 5 m off with her bow 0.1 rad towards the quay, and turns
        // further towards it.
        let quay = BodyState::default();
        let berth = Berth {
            body: 1,
            from_m: vec2(-60.0, 30.0),
            to_m: vec2(60.0, 30.0),
            facing: vec2(0.0, -1.0),
            apart_m: None,
        };
        let state = BodyState {
            position_m: vec2(0.0, 10.0),
            heading_rad: 0.1,
            velocity_mps: vec2(0.0, 0.2),
            yaw_rate_radps: 0.002,
        };
        let now = seen_from(&berth, &quay, &ship(), &state);
        let (sin, cos) = (libm::sin(0.1), libm::cos(0.1));
        let off = |x: f64| 30.0 - (10.0 + x * sin + 10.0 * cos);
        assert!((now.bow_m - off(30.0)).abs() < 1e-12 && (now.stern_m - off(-40.0)).abs() < 1e-12);
        assert!((now.angle_rad - 0.1).abs() < 1e-12);
        // East speed of a point at (x, y): v plus r times the point's distance north of the centre.
        let speed = |x: f64| 0.2 + 0.002 * (x * cos - 10.0 * sin);
        assert!((now.bow_mps - speed(30.0)).abs() < 1e-12);
        assert!((now.stern_mps - speed(-40.0)).abs() < 1e-12);
        // After half a turn the ship's port side faces the quay, and her bow is the farther end.
        let turned = BodyState { heading_rad: 0.1 + core::f64::consts::PI, ..state };
        let now = seen_from(&berth, &quay, &ship(), &turned);
        assert!((now.bow_m - off(-30.0)).abs() < 1e-9 && (now.angle_rad + 0.1).abs() < 1e-9);
        assert!(berth.is_near(&quay, &ship(), &state, 100.0));
        assert!(!berth.is_near(&quay, &ship(), &state, 10.0));
    }

    #[test]
    fn a_berth_on_a_ship_that_moves_is_seen_from_that_ship() {
        // The larger ship heads east at 2 m/s and turns. The smaller ship keeps her place beside her, and drifts
        // towards her.
        let mother = BodyState {
            position_m: vec2(500.0, 200.0),
            heading_rad: core::f64::consts::FRAC_PI_2,
            velocity_mps: vec2(0.0, 2.0),
            yaw_rate_radps: 0.01,
        };
        let berth = Berth {
            body: 0,
            from_m: vec2(-50.0, -25.0),
            to_m: vec2(50.0, -25.0),
            facing: vec2(0.0, -1.0),
            apart_m: None,
        };
        // There are 15 m of water between the fenders on the larger ship's port side and the smaller ship's starboard
        // side.
        let arm_m = vec2(50.0, 0.0);
        let state = BodyState {
            position_m: mother.position_m + arm_m,
            velocity_mps: mother.velocity_mps + arm_m.spun_by(0.01) + vec2(-0.1, 0.3),
            ..mother
        };
        let now = seen_from(&berth, &mother, &ship(), &state);
        assert!((now.bow_m - 15.0).abs() < 1e-9 && (now.stern_m - 15.0).abs() < 1e-9, "{now:?}");
        assert!((now.bow_mps - 0.1).abs() < 1e-9 && (now.stern_mps - 0.1).abs() < 1e-9, "{now:?}");
        assert!((now.along_mps - 0.3).abs() < 1e-9 && now.angle_rad.abs() < 1e-9, "{now:?}");
        assert!(berth.is_near(&mother, &ship(), &state, 50.0));
    }
}
