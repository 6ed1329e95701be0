//! Passing ships from scenarios: their force on a moored ship, and mistakes that are refused.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use fenderline_contact::{Pose, Wrench, vec2};
use fenderline_scenario::{Scenario, ScenarioError};
use fenderline_sim::passing::{Berth, FlowHull, PassingShip, factors, force};
use fenderline_sim::{Setup, Simulation};

const KNOT_MPS: f64 = 1852.0 / 3600.0;

/// The worked case of the design notes: a moored ship 243.5 × 39 × 15.3 m, one of 185.4 × 25.8 × 6.8 m that passes 110 m off.
const WORKED: &str = r#"
[time]
step = "0.5 s"
duration = "300 s"

[environment]
depth = "20 m"

[vessel.tanker]
length_bp = 243.5
beam = 39
draught = 15.3
block_coefficient = 0.8
rudder = { area = "60 m^2", span = "9 m" }
propeller = { diameter = "7 m", full = "90 rpm" }

[body.ship]
vessel = "tanker"
outline = [[-121.75, -19.5], [121.75, -19.5], [121.75, 19.5], [-121.75, 19.5]]

[body.quay]
fixed = true
outline = [[-200, 30], [200, 30], [200, 50], [-200, 50]]

[passing.coaster]
length = 185.4
beam = 25.8
draught = 6.8
position = [0, -110]
heading = 0
speed = "10 kn"
time = "150 s"
depth_factors = "kriebel"
"#;

fn with(from: &str, to: &str) -> Result<Scenario, ScenarioError> {
    assert!(WORKED.contains(from), "{from}");
    Scenario::parse(&WORKED.replacen(from, to, 1), "worked.toml")
}

fn refused(from: &str, to: &str, key: &str, says: &str) {
    let error = with(from, to).expect_err(to);
    let text = error.to_string();
    assert!(text.contains(says) && error.key() == Some(key), "{to}: {text} at {:?}", error.key());
    assert!(error.line().is_some(), "{text}");
}

fn noted(from: &str, to: &str, says: &str) {
    let scenario = with(from, to).unwrap();
    let notices: Vec<String> = scenario.notices.iter().map(ToString::to_string).collect();
    assert!(notices.iter().any(|notice| notice.contains(says)), "{to}: {notices:?}");
}

/// The largest force in a run with a ship too heavy to move.
fn peaks_of_a_run(mut setup: Setup, step_s: f64) -> [f64; 3] {
    setup.step_s = step_s;
    setup.world.vessels[0].ship.particulars.volume_m3 = 1e11;
    let mut simulation = Simulation::new(setup).unwrap();
    let mut most = [0.0_f64; 3];
    while !simulation.is_done() {
        let force = simulation.step().unwrap().vessel_forces[0].passing;
        for (most, part) in most.iter_mut().zip([force.surge_n, force.sway_n, force.yaw_nm]) {
            *most = most.max(part.abs());
        }
    }
    most
}

/// Coefficients of the integrals by Gauss's rule (validation/independent/passing_ships.py) with the factors of the depth: 1 %.
/// The step does not matter: peaks of steps of 0.1 and 1 s differ by less than 0.2 %, as a step of 1 s, 5 m,
/// may miss a peak by 2.5 m.
#[test]
fn the_worked_case_in_a_run_has_the_peaks_of_the_integrals_at_any_step() {
    let scenario = with("", "").unwrap();
    let areas_m2 = [0.98 * 39.0 * 15.3, 0.98 * 25.8 * 6.8];
    let speed_mps = 10.0 * KNOT_MPS;
    let unit_n = 1025.0 * speed_mps * speed_mps * areas_m2[0] * areas_m2[1] / (185.4 * 185.4);
    let mean_beam_m = 0.5 * (39.0 + 25.8);
    let by = factors(15.3 / 20.0, (110.0 - mean_beam_m) / mean_beam_m, Berth::Open).unwrap();
    let wanted =
        [0.34337 * unit_n * by[0], 1.07253 * unit_n * by[1], 0.22222 * unit_n * by[2] * 243.5];
    let fine = peaks_of_a_run(scenario.setup.clone(), 0.1);
    for (found, wanted) in fine.iter().zip(wanted) {
        assert!((found / wanted - 1.0).abs() < 0.01, "{found} of {wanted}");
    }
    let coarse = peaks_of_a_run(scenario.setup, 1.0);
    for (fine, coarse) in fine.iter().zip(coarse) {
        assert!((coarse / fine - 1.0).abs() < 2e-3, "{coarse} of {fine}");
    }
}

/// A ship at rest on a solid quay: in each step the force is that of the function for a ship at rest, times the factors of the quay.
#[test]
fn each_step_has_the_force_of_the_flow_at_that_time() {
    let text = "depth_factors = \"none\"\nberth = \"quay\"";
    let scenario = with("depth_factors = \"kriebel\"", text).unwrap();
    let own = FlowHull::new([243.5, 39.0, 15.3], 0.98, None).unwrap();
    let other = FlowHull::new([185.4, 25.8, 6.8], 0.98, None).unwrap();
    let mut simulation = Simulation::new(scenario.setup).unwrap();
    for step in 0..300 {
        let record = simulation.step().unwrap();
        let state = record.states[0];
        let passing = PassingShip {
            sections: &other.sections,
            pose: Pose::new(vec2((record.t_s - 150.0) * 10.0 * KNOT_MPS, -110.0), 0.0),
            velocity_mps: vec2(10.0 * KNOT_MPS, 0.0),
        };
        let [surge_n, sway_n, yaw_nm] =
            force(&own.sections, state.pose(), &passing, 1025.0, 0.5 * (39.0 + 25.8));
        let found = record.vessel_forces[0].passing;
        let near = |found: f64, wanted: f64, unit: f64| (found - wanted).abs() < 5e-3 * unit;
        // She drifts a little by now, which the flow at rest does not know: 0.5 % of the peaks.
        assert!(near(found.surge_n, 1.4 * surge_n, 4e4), "{step}: {found:?}");
        assert!(near(found.sway_n, 0.4 * sway_n, 5e4), "{step}: {found:?}");
        assert!(near(found.yaw_nm, 0.5 * yaw_nm, 3e6), "{step}: {found:?}");
    }
}

/// The impulse of the flow is the momentum that a free ship gains, and its work her kinetic energy, but for the drag of her hull,
/// which the ledger has beside it.
#[test]
fn the_work_of_a_passing_ship_is_in_the_ledger() {
    let mut simulation = Simulation::new(with("", "").unwrap().setup).unwrap();
    while !simulation.is_done() {
        simulation.step().unwrap();
    }
    let energy = simulation.energy();
    assert!(energy.loads.passing_j.abs() > 1e3, "{:?}", energy.loads);
    assert!(energy.residual_j.abs() < 1e-3 * energy.exchanged_j(), "{}", energy.residual_j);
    // Nothing else drives her: hull, rudder and propeller take from her.
    let parts: Vec<_> = energy.loads.parts().collect();
    assert!(parts.iter().all(|(name, work_j)| *name == "passing" || *work_j <= 0.0), "{parts:?}");
    let named = parts.iter().find(|(name, _)| *name == "passing").unwrap().1;
    assert_eq!(named, energy.loads.passing_j);
}

#[test]
fn a_library_vessel_on_waypoints_with_speeds_by_time_is_a_passing_ship() {
    let track = "waypoints = [[-900, -200], [0, -110], [900, -110]]\nturning_radius = \"400 m\"";
    let text = WORKED
        .replace(
            "length = 185.4\nbeam = 25.8\ndraught = 6.8",
            "vessel = \"kcs\"\nsections = \"outline\"",
        )
        .replace("position = [0, -110]\nheading = 0", track)
        .replace("speed = \"10 kn\"", "speeds = [[0, \"8 kn\"], [\"2 min\", \"5 kn\"]]");
    let scenario = Scenario::parse(&text, "track.toml").unwrap();
    let ship = &scenario.setup.world.flow.passing[0];
    assert_eq!(ship.hull.length_m, 230.0);
    assert!((ship.track.at(60.0).speed_mps - 6.5 * KNOT_MPS).abs() < 1e-12);
    // Block coefficient over midship coefficient is the prismatic coefficient; an outline is fuller than the sections below.
    let prismatic = ship.hull.sections.volume_m3() / (0.98 * 32.2 * ship.hull.draught_m * 230.0);
    assert!((0.6..1.0).contains(&prismatic), "{prismatic}");
}

#[test]
fn ways_that_no_ship_can_take_are_refused() {
    // Through the moored ship, and through the quay.
    refused(
        "position = [0, -110]",
        "position = [0, -20]",
        "passing.coaster",
        "go through \"ship\" at",
    );
    refused(
        "position = [0, -110]",
        "position = [0, 60]",
        "passing.coaster",
        "go through \"quay\" at",
    );
    // Faster than long waves in 20 m of water, 14 m/s.
    refused(
        "speed = \"10 kn\"",
        "speed = \"30 kn\"",
        "passing.coaster.speed",
        "faster than long waves",
    );
    refused("draught = 6.8", "draught = 21", "passing.coaster", "draws 21 m");
    refused("depth_factors = \"kriebel\"", "", "passing.coaster.depth_factors", "is missing");
    refused("length = 185.4\n", "", "passing.coaster.length", "is missing");
    refused("length = 185.4", "vessel = \"kcs\"", "passing.coaster.beam", "`vessel`");
    let unknown = "vessel = \"kc\"";
    refused(
        "length = 185.4\nbeam = 25.8\ndraught = 6.8",
        unknown,
        "passing.coaster.vessel",
        "no vessel",
    );
    refused("heading = 0\n", "", "passing.coaster.heading", "is missing");
    refused("speed = \"10 kn\"\n", "", "passing.coaster.speed", "is missing");
    let back = "waypoints = [[0, -110], [900, -110], [0, -110]]";
    refused("position = [0, -110]\nheading = 0", back, "passing.coaster.waypoints", "turns back");
    refused(
        "vessel = \"tanker\"\n",
        "mass = 1e8\ngyradius = 60\n",
        "passing.coaster",
        "act on vessels",
    );
}

#[test]
fn what_the_flow_leaves_out_is_noted() {
    noted("", "", "from memory (Kriebel 2005, which we could not read)");
    noted(
        "depth_factors = \"kriebel\"",
        "depth_factors = \"none\"",
        "depth is not taken into account",
    );
    noted(
        "time = \"150 s\"",
        "time = \"150 s\"\nberth = \"quay\"",
        "factors for a quay are estimated",
    );
    noted("depth = \"20 m\"", "", "the water is deep");
    noted("length = 185.4", "length = 90", "beams long");
    noted("speed = \"10 kn\"", "speed = \"17 kn\"", "no waves");
    noted("time = \"150 s\"", "time = \"600 s\"", "the run ends before the ship has passed");
    noted("time = \"150 s\"", "time = \"10 s\"", "the force begins suddenly");
    noted("step = \"0.5 s\"", "step = \"5 s\"", "twentieth of her length");
    noted("heading = 0", "heading = \"30 deg\"", "at an angle of 30 degrees");
}

/// A ship of 10⁵ t on linear springs and dampers in deep water, passed at 10 knots: surge, sway and yaw over time beside an independent
/// integration with the integrals of the paper by Gauss's rule (validation/independent/moored_under_passing.py). 1 % of the largest
/// motion: the drag of the hull, which only the simulation has, is a third of that.
#[test]
fn a_moored_ship_moves_as_in_an_independent_integration() {
    let text = "depth_factors = \"none\"";
    let mut setup = with("depth_factors = \"kriebel\"", text).unwrap().setup;
    setup.step_s = 0.05;
    // Round numbers, which both have.
    let ship = &mut setup.world.vessels[0].ship;
    ship.particulars.volume_m3 = 1e8 / 1025.0;
    ship.particulars.yaw_gyradius_ratio = 0.25;
    (ship.added_mass.surge_m3, ship.added_mass.sway_m3) = (5e6 / 1025.0, 8e7 / 1025.0);
    ship.added_mass.yaw_m5 = 3e11 / 1025.0;
    let mut simulation = Simulation::new(setup).unwrap();
    let mut expected = INDEPENDENT.iter();
    let mut next = expected.next();
    while let Some(&[at_s, surge_m, sway_m, yaw_rad]) = next {
        let state = simulation.states()[0];
        if simulation.time_s() >= at_s - 1e-9 {
            let position = state.position_m;
            assert!((position.x - surge_m).abs() < 0.01 * 0.0276, "{at_s}: {position:?} {surge_m}");
            assert!((position.y - sway_m).abs() < 0.01 * 0.0713, "{at_s}: {position:?} {sway_m}");
            assert!(
                (state.heading_rad - yaw_rad).abs() < 0.01 * 5.4e-04,
                "{at_s}: {state:?} {yaw_rad}"
            );
            next = expected.next();
        }
        let damping_n = vec2(3e6 * state.velocity_mps.x, 5e6 * state.velocity_mps.y);
        simulation.set_external(&[
            Wrench {
                force_n: state.position_m * -2e6 - damping_n,
                moment_nm: -1.5e10 * state.heading_rad - 4e10 * state.yaw_rate_radps,
            },
            Wrench::default(),
        ]);
        simulation.step().unwrap();
    }
}

/// Time (s), surge (m), sway (m), yaw (rad): what `python3 validation/independent/moored_under_passing.py` prints.
const INDEPENDENT: [[f64; 4]; 31] = [
    [0.0, 0.000000e+00, 0.000000e+00, 0.000000e+00],
    [10.0, 5.852557e-05, 2.291546e-05, -9.970015e-08],
    [20.0, 1.543463e-04, 7.603856e-05, -2.590003e-07],
    [30.0, 1.884128e-04, 1.309545e-04, -3.681586e-07],
    [40.0, 1.938759e-04, 1.803223e-04, -5.387967e-07],
    [50.0, 2.682513e-04, 2.516817e-04, -9.433460e-07],
    [60.0, 4.397366e-04, 3.995605e-04, -1.750940e-06],
    [70.0, 6.782223e-04, 7.037400e-04, -3.359273e-06],
    [80.0, 1.006063e-03, 1.312758e-03, -6.867292e-06],
    [90.0, 1.517196e-03, 2.581833e-03, -1.503100e-05],
    [100.0, 2.162134e-03, 5.367364e-03, -3.375630e-05],
    [110.0, 1.984108e-03, 1.117004e-02, -6.585898e-05],
    [120.0, -2.062878e-03, 1.963798e-02, -6.339652e-05],
    [130.0, -1.196655e-02, 2.164748e-02, 9.550123e-05],
    [140.0, -1.993063e-02, 1.735249e-03, 3.538146e-04],
    [150.0, -1.198558e-02, -3.965623e-02, 3.186611e-04],
    [160.0, 1.135011e-02, -7.131501e-02, -1.692991e-04],
    [170.0, 2.760143e-02, -5.607177e-02, -5.371588e-04],
    [180.0, 1.810286e-02, 3.778520e-03, -2.722925e-04],
    [190.0, -5.319504e-03, 5.907940e-02, 2.087742e-04],
    [200.0, -1.462268e-02, 6.247281e-02, 2.584836e-04],
    [210.0, -3.424279e-03, 1.799489e-02, -9.953807e-06],
    [220.0, 7.456153e-03, -2.763882e-02, -1.116401e-04],
    [230.0, 3.468926e-03, -3.587906e-02, 2.579448e-06],
    [240.0, -5.500927e-03, -9.445005e-03, 6.863095e-05],
    [250.0, -5.198247e-03, 1.945456e-02, 1.262914e-05],
    [260.0, 1.876021e-03, 2.446175e-02, -3.405030e-05],
    [270.0, 4.208952e-03, 6.827093e-03, -1.126317e-05],
    [280.0, -2.152530e-04, -1.244257e-02, 1.758734e-05],
    [290.0, -3.413311e-03, -1.596307e-02, 9.307961e-06],
    [300.0, -1.135219e-03, -4.468416e-03, -8.003005e-06],
];

/// Two ships that meet: each is drawn to the other abreast. A tug beside a ship is left out, and the notice says so.
#[test]
fn vessels_under_way_push_each_other_where_the_flow_holds() {
    let other = "[body.other]\nvessel = \"tanker\"\nposition = [100, -80]\nheading = \"180 deg\"\nvelocity = { surge = 4 }\n\
                 outline = [[-121, -19], [121, -19], [121, 19], [-121, 19]]\n[body.tug]\nvessel = \"asd-tug\"\nposition = [0, -35]";
    let text = WORKED.replace("[body.quay]", &format!("{other}\n\n[body.quay]"));
    let text = text.replace("depth = \"20 m\"", "interaction = { between_vessels = true }");
    let text = text.split("[passing.coaster]").next().unwrap();
    let scenario = Scenario::parse(text, "meeting.toml").unwrap();
    let notices: Vec<String> = scenario.notices.iter().map(ToString::to_string).collect();
    assert!(
        notices.iter().any(|notice| notice.contains("no such force for \"tug\"")),
        "{notices:?}"
    );
    let mut simulation = Simulation::new(scenario.setup).unwrap();
    let mut most = [[0.0_f64; 2]; 3];
    for _ in 0..100 {
        let record = simulation.step().unwrap();
        for (most, forces) in most.iter_mut().zip(record.vessel_forces) {
            most[0] = most[0].max(forces.passing.sway_n);
            most[1] = most[1].min(forces.passing.sway_n);
        }
    }
    // The moored one to her port side; the other one, which heads south, to her own port side too.
    assert!(most[0][1] < -1e4 && most[1][1] < -1e2, "{most:?}");
    assert_eq!(most[2], [0.0; 2], "the tug is too short");
}
