//! Computes the pull of a wall on a ship that goes along it, from the flow of her mirror image, and the walls that stand for
//! sections of a bottom.

use std::sync::Arc;

use fenderline_contact::number::bounded;
use fenderline_contact::{BodyState, Pose, Vec2, vec2};
use fenderline_sim::environment::{Bank, BankMethod, BankWater, DepthField, ShipAtBank};
use fenderline_sim::hydro::Particulars;
use fenderline_sim::passing::{PassingShip, Sections, force_of_wall};
use fenderline_sim::{Bottom, Outside, Walls};

use super::Values;

const LENGTH_M: f64 = 200.0;
const AREA_M2: f64 = 300.0;

/// Computes the side force Y on a ship with parabolic sections, divided by ρu²S²/L².
///
/// # Panics
/// Panics if the sections of the ship are out of range, which would be a bug.
pub(super) fn compute(values: &mut Values) {
    let sections = Sections::parabola(LENGTH_M, AREA_M2).expect("a good ship");
    let own = PassingShip {
        sections: &sections,
        pose: Pose::new(Vec2::ZERO, 0.0),
        velocity_mps: vec2(1.0, 0.0),
    };
    for (depth_m, depth) in [(None, "deep"), (Some(20.0), "20"), (Some(13.0), "13")] {
        for wall_m in [20.0, 30.0, 45.0, 60.0, 90.0] {
            let wall = [vec2(-500.0, wall_m), vec2(500.0, wall_m)];
            let [_, pull, _] = force_of_wall(&own, wall, 1.0, depth_m, 1.0);
            let unit = AREA_M2 * AREA_M2 / (LENGTH_M * LENGTH_M);
            values.put(format!("bank/{depth}/{wall_m}"), pull / unit, "");
        }
    }
    by_depth(values, &sections);
    walls(values);
}

/// The side force of a wall 45 m off in 1.2 draughts of water over that in 1.5.
fn by_depth(values: &mut Values, sections: &Sections) {
    let bank = Bank::new(vec2(-500.0, 45.0), vec2(500.0, 45.0), BankMethod::Norrbin);
    let bank = bank.expect("a good bank");
    let ship = ShipAtBank {
        length_m: LENGTH_M,
        beam_m: 30.0,
        draught_m: 10.0,
        position_m: Vec2::ZERO,
        heading_rad: 0.0,
        surge_mps: 1.0,
    };
    let norrbin = |depth_m: f64| {
        bank.force(&ship, &BankWater { density_kgpm3: 1.0, depth_m: Some(depth_m) })[1]
    };
    let own =
        PassingShip { sections, pose: Pose::new(Vec2::ZERO, 0.0), velocity_mps: vec2(1.0, 0.0) };
    let image = |depth_m: f64| force_of_wall(&own, bank.ends_m(), 1.0, Some(depth_m), 1.0)[1];
    values.put("bank/shallow/norrbin", norrbin(12.0) / norrbin(15.0), "");
    values.put("bank/shallow/image", image(12.0) / image(15.0), "");
}

/// The walls that stand for a flank of 1 in 5 from 60 to 120 m off, and for a vertical bank 60 m off to half of 12 m of water.
fn walls(values: &mut Values) {
    const CELL_M: f64 = 0.5;
    const SIDE: usize = 1001;
    let hull = Particulars::from_block(LENGTH_M, 30.0, 10.0, 0.8).expect("a good ship");
    let state = BodyState::default();
    let flank = |east_m: f64| 12.0 - bounded((east_m - 60.0) / 5.0, 0.0, 12.0);
    let half = |east_m: f64| if east_m > 60.0 { 6.0 } else { 12.0 };
    let both: [(&str, &dyn Fn(f64) -> f64); 2] = [("flank", &flank), ("half", &half)];
    for (name, depth_m) in both {
        // The submerged bank is the cell from 59.75 to 60.25 m.
        let corner_m = -CELL_M * ((SIDE / 2) as f64 + 0.5);
        let east_m = |node: usize| corner_m + CELL_M * (node / SIDE) as f64;
        let depths_m = (0..SIDE * SIDE).map(|node| depth_m(east_m(node)) as f32).collect();
        let field = DepthField::new(vec2(corner_m, corner_m), CELL_M, SIDE, SIDE, depths_m);
        let field = Arc::new(field.expect("a good field"));
        let bottom = Bottom { field, outside: Outside::Depth(12.0), banks: None };
        let walls = Walls::beside(&hull, &state, &bottom, 0.0, 12.0);
        values.put(format!("bank/walls/{name}/per_m"), 1e3 * walls.per_m[1], "1/km");
        values.put(format!("bank/walls/{name}/per_m2"), 1e6 * walls.per_m2[1], "1/km²");
    }
}
