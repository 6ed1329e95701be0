//! Crabbing: the motion of the ship under a steady side force.

use fenderline_sim::constants::{KNOT_MPS, STANDARD_GRAVITY_MPS2};
use fenderline_sim::hydro::manoeuvres::{ManoeuvreError, crabbing};
use fenderline_sim::hydro::{Force, Model3};

use super::section::{Row, Section, Unit};

/// Froude number at which cross-flow drag alone balances the usual side force (1.1 knots for a ship of 320 m). The
/// usual side force is used if the user gives no force.
const FROUDE: f64 = 0.01;
/// Duration of the side force, in time constants of the speed across.
const DURATION: f64 = 40.0;
/// Number of time steps within one time constant.
const STEPS: f64 = 200.0;

/// Simulates crabbing: a steady force at midship pushes the ship to starboard.
///
/// # Errors
/// Fails if [`crabbing`] fails.
pub(super) fn crabbing_section(
    name: &str,
    model: &Model3,
    push_n: Option<f64>,
) -> Result<Section, ManoeuvreError> {
    let push_n = push_n.unwrap_or_else(|| usual_push_n(model));
    let time_constant_s = time_constant_s(model, push_n);
    let push = Force { sway_n: push_n, ..Force::default() };
    let crab = crabbing(model, push, DURATION * time_constant_s, time_constant_s / STEPS)?;
    let length_m = model.ship().particulars.length_m;
    let turned = (crab.yaw_radps * length_m / crab.sway_mps.abs(), crab.surge_mps / KNOT_MPS);
    let rows = vec![
        Row::new("push", "push", Unit::Kilonewtons, vec![push_n / 1e3]),
        Row::new("sway", "speed across", Unit::Knots, vec![crab.sway_mps / KNOT_MPS]),
        Row::new("rise", "time to 90 % of speed across", Unit::Seconds, vec![crab.rise_s]),
        Row::new("surge", "resulting speed ahead", Unit::Knots, vec![turned.1]),
        Row::new("rate", "resulting rate of turn rL/v", Unit::One, vec![turned.0]),
    ];
    Ok(Section {
        manoeuvre: name.to_owned(),
        title: "Crabbing under a push at midship, engine stopped".to_owned(),
        columns: vec!["starboard".to_owned()],
        rows,
        notes: vec![],
        tracks: Vec::new(),
    })
}

/// The side force that is used if the user gives none: ½ρLTC_D v² at v = 0.01√(gL) (N).
pub(super) fn usual_push_n(model: &Model3) -> f64 {
    let length_m = model.ship().particulars.length_m;
    let speed_squared = FROUDE * FROUDE * STANDARD_GRAVITY_MPS2 * length_m;
    drag_npm2s2(model) * speed_squared
}

/// Time constant of the speed across (s): (m + m_y)/√(½ρLTC_D F), which is the mass divided by the ratio of drag to
/// speed at the final speed.
fn time_constant_s(model: &Model3, push_n: f64) -> f64 {
    let ship = model.ship();
    let mass_kg =
        model.water().density_kgpm3 * (ship.particulars.volume_m3 + ship.added_mass.sway_m3);
    mass_kg / (drag_npm2s2(model) * push_n).sqrt()
}

/// Cross-flow drag in pure sway divided by the square of the speed (N s²/m²): ½ρLTC_D.
fn drag_npm2s2(model: &Model3) -> f64 {
    let ship = model.ship();
    let side_m2 = ship.particulars.length_m * ship.particulars.draught_m;
    let coefficient = ship.hull.low_speed.cross_flow.drag_coefficient;
    0.5 * model.water().density_kgpm3 * side_m2 * coefficient
}
