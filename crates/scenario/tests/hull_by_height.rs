//! A wedge-sided ship against a fender: where she touches, and with what force, by hand.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use fenderline_scenario::{Scenario, ScenarioError};
use fenderline_sim::{Finding, Simulation, Verdict};

/// Half of her breadth is 10 m at the keel and 18 m at 16 m: at her draught of 8 m it is 14 m, and her side leans out by
/// 0.5 m a metre. A steady 1 MN presses her on a fender of 4 MN/m, whose face is 1.5 m before the line y = 0. The solid
/// quay is out of the way of her flare.
const WEDGE: &str = r#"
[time]
step = "0.05 s"
duration = "200 s"

[environment]
depth = "60 m"

[body.ship]
outlines = [
  { height = 0, outline = [[-50, -10], [50, -10], [50, 10], [-50, 10]] },
  { height = "16 m", outline = [[-50, -18], [50, -18], [50, 18], [-50, 18]] },
]
draught = "8 m"
mass = "20000 t"
gyradius = "25 m"
position = [0, -15.6]

[body.quay]
fixed = true
outline = [[-120, 20], [120, 20], [120, 30], [-120, 30]]

[material.rubber]
stiffness = "1 MN/m^2"
damping = "2 MN.s/m^2"

[fender.face]
on = "quay"
position = [0, 0]
facing = "-90 deg"
width = "2 m"
projection = "1.5 m"
above_water = 0
stiffness = "4 MN/m"
returned_energy = "100 %"
material = "rubber"

[[pair]]
bodies = ["ship", "quay"]
material = "rubber"

[[load]]
body = "ship"
force = [0, "1 MN"]
"#;

/// The same ship as a vessel with heave, roll and pitch.
const FLOATING: &str = r#"
[vessel.wedge]
length_bp = "100 m"
beam = "28 m"
draught = "8 m"
block_coefficient = 0.85
stability = { gm = "2 m", gravity_above_keel = "9 m", waterplane_area = "2600 m^2" }

[body.ship]
vessel = "wedge"
"#;

/// A part of the text, and what replaces it.
type Change<'a> = (&'a str, &'a str);

fn changed(changes: &[Change]) -> String {
    changes.iter().fold(WEDGE.to_owned(), |text, (part, other)| {
        assert!(text.contains(part), "{part}");
        text.replacen(part, other, 1)
    })
}

fn read(text: &str) -> Result<Scenario, ScenarioError> {
    Scenario::parse_among(text, "wedge.toml", &[], &mut |name| match name {
        "tide.csv" => Ok("t_s,level_m\n0,-3\n100,-3\n700,3\n".to_owned()),
        "quick_tide.csv" => Ok("t_s,level_m\n0,0\n40,0\n100,6\n".to_owned()),
        _ => Err(format!("{name}: there is no such file")),
    })
}

fn simulation(changes: &[(&str, &str)]) -> Simulation {
    let scenario = read(&changed(changes)).unwrap_or_else(|error| panic!("{error}"));
    Simulation::new(scenario.setup).expect("a good set-up")
}

fn run(changes: &[(&str, &str)]) -> Simulation {
    let mut simulation = simulation(changes);
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    simulation
}

/// What does not close in the ledger of the contacts, over the energy turned over.
fn residual(simulation: &Simulation) -> f64 {
    let energy = simulation.energy();
    energy.contact_residual_j.abs().max(energy.residual_j.abs()) / energy.exchanged_j()
}

/// At rest the fender is deflected 0.25 m, and her side is half her breadth at the fender's height: 12 m, 14 m and 17 m.
/// The tolerance is that of a ship that has come to rest.
#[test]
fn a_wedge_touches_fenders_at_three_heights_where_her_lines_say() {
    for (above_m, half_m) in [(-4.0, 12.0), (0.0, 14.0), (6.0, 17.0)] {
        let simulation = run(&[
            ("above_water = 0", &format!("above_water = {above_m}")),
            ("[0, -15.6]", &format!("[0, {}]", -1.6 - half_m)),
        ]);
        let offset_m = simulation.states()[0].position_m.y;
        assert!((offset_m - (-1.5 + 0.25 - half_m)).abs() < 1e-6, "{above_m}: {offset_m}");
        let fender = simulation.fender_summaries().next().expect("touched");
        let hull = fender.hull.expect("a hull by height");
        assert!((hull.height_m - (8.0 + above_m)).abs() < 1e-9);
        assert!((hull.vertical_angle_rad - 0.5_f64.atan()).abs() < 1e-9);
        assert!(residual(&simulation) < 1e-6, "{}", residual(&simulation));
    }
}

/// With the tide 3 m below datum the fender is 3 m higher on her side, so she lies 1.5 m farther off, and 1.5 m nearer at high
/// water: 3 m in between. The work of the tide is in the ledger.
#[test]
fn a_tide_of_six_metres_moves_her_by_three() {
    let tide = ("depth = \"60 m\"", "depth = \"60 m\"\ntide = { file = \"tide.csv\" }");
    let start = ("[0, -15.6]", "[0, -17.1]");
    let low = run(&[tide, start, ("200 s", "100 s"), ("2 MN.s/m^2", "9 MN.s/m^2")]);
    let high = run(&[tide, start, ("200 s", "750 s"), ("2 MN.s/m^2", "9 MN.s/m^2")]);
    let offset_m = |simulation: &Simulation| simulation.states()[0].position_m.y;
    assert!((offset_m(&low) - (-1.25 - 15.5)).abs() < 1e-4, "{}", offset_m(&low));
    assert!((offset_m(&high) - (-1.25 - 12.5)).abs() < 1e-4, "{}", offset_m(&high));
    // The load pushes her 3 m: 3 MJ go through the fender's flank into the tide.
    let work_j = high.energy().height_work_j;
    assert!((work_j / -3e6 - 1.0).abs() < 0.01, "{work_j}");
    assert!(residual(&high) < 1e-6, "{}", residual(&high));
}

/// Rubber that returns 55 %, friction that holds her, a load along the berth too, and a tide of 6 m in a minute, on two
/// fenders.
#[test]
fn the_ledger_closes_for_rubber_and_friction_in_a_quick_tide() {
    let face = &WEDGE[WEDGE.find("[fender.face]").unwrap()..WEDGE.find("[[pair]]").unwrap()];
    let two = ["first", "second"].map(|name| face.replace("face", name));
    let two = two.join("").replacen("[0, 0]", "[-30, 0]", 1).replacen("[0, 0]", "[30, 0]", 1);
    let rubber = two.replace("100 %", "55 %");
    let friction = "friction_static = 0.3\nfriction_dynamic = 0.2\nshear_stiffness = \"5 MN/m\"";
    let simulation = run(&[
        (face, &rubber),
        ("0.05 s", "0.02 s"),
        ("depth = \"60 m\"", "depth = \"60 m\"\ntide = { file = \"quick_tide.csv\" }"),
        ("damping = \"2 MN.s/m^2\"", friction),
        ("force = [0, \"1 MN\"]", "force = [\"50 kN\", \"1 MN\"]"),
    ]);
    let energy = simulation.energy();
    assert!(energy.height_work_j < -2.5e6 && energy.hysteresis_j > 1e5, "{energy:?}");
    assert!(simulation.states()[0].position_m.x < 0.05, "friction holds her");
    assert!(residual(&simulation) < 1e-6, "{}", residual(&simulation));
}

/// Fenders at three heights: at rest she heaves by N tan β / C₃₃ and heels by the moments of both parts of the force. Her side is where the
/// heeled lines have it. Force and moment by hand: 1 MN, and its arm. Her lines are cut anew when the fender's height has moved by a
/// millimetre, which is half of that across and 2 kN at the fender: about that she hovers, 0.2 %, and heave and roll with a quarter of it.
/// Later she would turn off the fender: pushed on one point without friction she is unstable in yaw.
#[test]
fn flare_lifts_and_heels_her_as_by_hand() {
    // Fender over the water, and half of her upright breadth there. Low on her side the fender pushes below the centre of gravity.
    for (fender_m, half_m) in [(-3.0, 12.5), (2.0, 15.0), (5.0, 16.5)] {
        let simulation = run(&floating(&[
            ("200 s", "600 s"),
            ("above_water = 0", &format!("above_water = {fender_m}")),
            ("-15.6", &format!("{}", -1.4 - half_m)),
        ]));
        let setup = simulation.setup();
        let float = setup.world.vessels[0].float.expect("stability data");
        let (heave, roll) = (float.hydrostatics.heave.restoring, float.hydrostatics.roll.restoring);
        let attitude = simulation.vessels()[0].attitude;
        let contact = simulation.contacts()[0];
        let normal_n = contact.normal_force_n;
        assert!((normal_n - 1e6).abs() < 2e3, "{fender_m}: {normal_n}");
        // With her upright side at y = 10 + 0.5 h, h above the keel, and a heel φ, the fender is at h = 8 + fender + heave + y φ, where
        // her side is at y + φ (h − KG). So it leans out by (0.5 + φ)/(1 − 0.5 φ). Heights are rounded to a millimetre.
        let (heave_m, roll_rad) = (attitude.heave.value, attitude.roll.value);
        let height_m = (8.0 + fender_m + heave_m + 10.0 * roll_rad) / (1.0 - 0.5 * roll_rad);
        let (y_m, above_m) = (10.0 + 0.5 * height_m, height_m - 9.0);
        let up_n = normal_n * (0.5 + roll_rad) / (1.0 - 0.5 * roll_rad);
        let moment_nm = -normal_n * above_m - up_n * y_m;
        assert!((heave_m / (-up_n / heave) - 1.0).abs() < 5e-4, "{fender_m}: {attitude:?}");
        assert!((roll_rad / (moment_nm / roll) - 1.0).abs() < 5e-4, "{fender_m}: {attitude:?}");
        assert!(roll_rad < -1e-3 && heave_m < -0.015, "{fender_m}: {attitude:?}");
        let offset_m = simulation.states()[0].position_m.y;
        let by_lines_m = -1.5 + 0.25 - y_m - above_m * roll_rad;
        assert!((offset_m - by_lines_m).abs() < 1e-3, "{fender_m}: {offset_m}");
        let hull = simulation.fender_summaries().next().unwrap().hull.unwrap();
        assert!(hull.peak_vertical_force_n >= up_n);
    }
}

/// She runs on to the fender and swings: what heave, roll and pitch lose to the fender's flank is what the ledger says that
/// they put into it. So flare makes no energy.
#[test]
fn what_the_ledger_books_is_the_work_of_heave_and_roll() {
    for (step, tolerance) in [("0.05 s", 1e-4), ("0.0125 s", 1e-4)] {
        let force = "force = [0, \"1 MN\"]";
        let mut simulation = simulation(&floating(&[
            ("0.05 s", step),
            ("200 s", "40 s"),
            ("above_water = 0", "above_water = 3"),
            ("position = [0, -15.6]", "position = [5, -17.6]\nvelocity = { sway = \"0.3 m/s\" }"),
            (force, "force = [0, \"10 kN\"]"),
            ("damping = \"2 MN.s/m^2\"", ""),
        ]));
        let (mut work_j, mut size_j) = (0.0, 0.0);
        while !simulation.is_done() {
            let (before, place) = (simulation.vessels()[0].attitude, simulation.states()[0]);
            let record = simulation.step().expect("a good step");
            let after = record.vessels[0].attitude;
            for (contact, touch) in record.contacts.iter().zip(record.hull_touches) {
                let touch = touch.expect("a hull by height");
                let own = place.pose().rotation;
                let force_n = own.apply_inverse(contact.force_on_body_1_n());
                let arm_m = touch.place_m;
                let (up_n, above_m) = (contact.normal_force_n * touch.slope, touch.height_m - 9.0);
                let roll_nm = force_n.y * above_m - up_n * arm_m.y;
                let pitch_nm = -force_n.x * above_m + up_n * arm_m.x;
                let done_j = -up_n * (after.heave.value - before.heave.value)
                    + roll_nm * (after.roll.value - before.roll.value)
                    + pitch_nm * (after.pitch.value - before.pitch.value);
                work_j -= done_j;
                size_j += done_j.abs();
            }
        }
        let booked_j = simulation.energy().height_work_j;
        assert!(size_j > 1e4, "{size_j}");
        assert!(
            (booked_j - work_j).abs() < tolerance * size_j,
            "{step}: {booked_j} {work_j} {size_j}"
        );
        assert!(residual(&simulation) < 1e-3);
    }
}

/// The changes that make the ship a vessel with heave, roll and pitch, and these.
fn floating<'a>(changes: &[(&'a str, &'a str)]) -> Vec<(&'a str, &'a str)> {
    let mut all = vec![
        ("[body.ship]\n", FLOATING),
        ("draught = \"8 m\"\nmass = \"20000 t\"\ngyradius = \"25 m\"\n", ""),
    ];
    all.extend_from_slice(changes);
    all
}

/// A hull of three equal outlines is a hull of one: the same bits, on fenders with friction and rubber, at an angle.
#[test]
fn three_equal_outlines_give_the_bits_of_one() {
    let one = "outline = [[-50, -14], [50, -14], [50, 14], [-50, 14]]";
    let level =
        |height: &str| one.replacen("outline", &format!("{{ height = {height}, outline"), 1);
    let three = ["0", "6", "16"].map(|height| level(height) + " }").join(", ");
    let lines = &WEDGE[WEDGE.find("outlines = [").unwrap()..WEDGE.find("mass =").unwrap()];
    let play = |hull: &str| {
        let mut simulation = simulation(&[
            (lines, hull),
            ("100 %", "60 %"),
            ("damping = \"2 MN.s/m^2\"", "friction_static = 0.3\nshear_stiffness = \"5 MN/m\""),
            (
                "position = [0, -15.6]",
                "position = [0, -18]\nheading = \"2 deg\"\nvelocity = { surge = 0.1 }",
            ),
        ]);
        let mut bits = Vec::new();
        while !simulation.is_done() {
            let record = simulation.step().expect("a good step");
            let state = record.states_after[0];
            let forces = record.contacts.iter().map(|contact| contact.normal_force_n);
            bits.extend([state.position_m.x, state.position_m.y, state.heading_rad]);
            bits.extend(forces);
        }
        assert!(simulation.fender_summaries().next().is_some(), "touched");
        bits.into_iter().map(f64::to_bits).collect::<Vec<_>>()
    };
    let by_height = format!("outlines = [{three}]\ndraught = \"8 m\"\n");
    assert!(play(&format!("{one}\n")) == play(&by_height));
}

/// Outlines with different numbers of vertices are resampled at common stations: the same hull, with a vertex more in one of its
/// lines, touches at the same place.
#[test]
fn outlines_with_different_numbers_of_vertices_are_one_hull() {
    let given = "[[-50, -18], [50, -18], [50, 18], [-50, 18]]";
    let more = "[[-50, -18], [0, -18.5], [50, -18], [50, 18], [20, 18], [-50, 18]]";
    let offset_m = |outline: &str| run(&[(given, outline)]).states()[0].position_m.y;
    assert!((offset_m(given) - offset_m(more)).abs() < 1e-6);
}

/// The catalogue's factor for an angle of 26.6 degrees is that beyond its last point, 20 degrees: 0.80. With a heading of
/// 10 degrees and tan β = 0.1 the angle is atan √(tan² 10° + 0.1²) = 11.4 degrees, and the factor 0.986.
#[test]
fn the_angle_factor_takes_the_vertical_angle() {
    let cone = "type = \"cone\"\nheight = \"1.5 m\"\nvelocity_factor = false";
    let factor = |top: &str, heading: &str| {
        let simulation = run(&[
            ("stiffness = \"4 MN/m\"\nreturned_energy = \"100 %\"", cone),
            ("200 s", "30 s"),
            ("[[-50, -18], [50, -18], [50, 18], [-50, 18]]", top),
            (
                "position = [0, -15.6]",
                &format!("position = [0, -24]\nheading = \"{heading}\"\nvelocity = {{ sway = 1 }}"),
            ),
        ]);
        let summary = simulation.fender_summaries().next().expect("touched").clone();
        (summary.factor, summary.hull.expect("by height").vertical_angle_rad.to_degrees())
    };
    let wide = "[[-50, -18], [50, -18], [50, 18], [-50, 18]]";
    let (of_flare, degrees) = factor(wide, "0 deg");
    assert!(
        (of_flare - 0.80).abs() < 1e-9 && (degrees - 26.565).abs() < 1e-3,
        "{of_flare} {degrees}"
    );
    let slight = "[[-50, -11.6], [50, -11.6], [50, 11.6], [-50, 11.6]]";
    let (of_both, _) = factor(slight, "10 deg");
    let degrees = (10_f64.to_radians().tan().hypot(0.1)).atan().to_degrees();
    let by_hand = 1.0 - 0.05 * (degrees - 10.0) / 5.0;
    assert!((of_both - by_hand).abs() < 2e-3, "{of_both} {by_hand}");
}

/// A fender higher than her highest outline does not touch her: the run and the check say so.
#[test]
fn a_fender_above_her_side_meets_no_side() {
    let text = changed(&[("above_water = 0", "above_water = \"9.5 m\""), ("200 s", "15 s")]);
    let scenario = read(&text).expect("a good scenario");
    let notice = scenario.notices.iter().find(|notice| notice.message.contains("highest"));
    assert!(notice.is_some_and(|notice| notice.key == "fender.face.above_water"));
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    while !simulation.is_done() {
        assert!(simulation.step().expect("a good step").contacts.is_empty());
    }
    let findings = simulation.findings();
    let off_m = findings.iter().find_map(|finding| match finding {
        Finding::NoSideAtFender { off_m, .. } => Some(*off_m),
        _ => None,
    });
    assert!((off_m.expect("found") - 1.5).abs() < 1e-9, "{findings:?}");
    assert_eq!(simulation.verdict(), Verdict::NoSideAtFender);
    // Half of its face of 2 m is enough to touch her topmost outline.
    let edge = run(&[("above_water = 0", "above_water = \"8.9 m\""), ("-15.6", "-20")]);
    assert!((edge.states()[0].position_m.y - (-1.25 - 18.0)).abs() < 1e-6);
    assert!(edge.fender_summaries().next().unwrap().hull.unwrap().vertical_angle_rad == 0.0);
}

/// A ship's own fender against a quay that leans back by 1 in 4: heights of the quay are above datum.
#[test]
fn a_fender_of_the_ship_meets_a_battered_quay() {
    let quay = "[body.quay]\nfixed = true\noutlines = [\n\
        { height = -10, outline = [[-120, 20], [120, 20], [120, 40], [-120, 40]] },\n\
        { height = 10, outline = [[-120, 25], [120, 25], [120, 40], [-120, 40]] },\n]\n";
    let whole = &WEDGE[WEDGE.find("[body.quay]").unwrap()..WEDGE.find("[material").unwrap()];
    for tide_m in [-2.0, 3.0] {
        let simulation = run(&[
            (whole, quay),
            (
                "[[-50, -10], [50, -10], [50, 10], [-50, 10]]",
                "[[-50, -14], [50, -14], [50, 14], [-50, 14]]",
            ),
            (
                "[[-50, -18], [50, -18], [50, 18], [-50, 18]]",
                "[[-50, -14], [50, -14], [50, 14], [-50, 14]]",
            ),
            ("on = \"quay\"", "on = \"ship\""),
            ("position = [0, 0]\nfacing = \"-90 deg\"", "position = [0, 14]\nfacing = \"90 deg\""),
            ("above_water = 0", "above_water = 1"),
            ("[0, -15.6]", "[0, 6]"),
            ("depth = \"60 m\"", &format!("depth = \"60 m\"\ntide = {{ level = {tide_m} }}")),
        ]);
        let face_m = 22.5 + 0.25 * (tide_m + 1.0);
        let offset_m = simulation.states()[0].position_m.y;
        assert!((offset_m - (face_m - 14.0 - 1.25)).abs() < 1e-6, "{tide_m}: {offset_m}");
        let hull = simulation.fender_summaries().next().unwrap().hull.unwrap();
        assert!((hull.vertical_angle_rad - (-0.25_f64).atan()).abs() < 1e-9, "{hull:?}");
    }
}

#[test]
fn outlines_by_height_that_are_no_hull_are_refused_at_their_place() {
    let upper = "{ height = \"16 m\", outline = [[-50, -18], [50, -18], [50, 18], [-50, 18]] },";
    let with = |other: &'static str| vec![(upper, other)];
    let both = "outline = [[-50, -14], [50, -14], [50, 14], [-50, 14]]\noutlines";
    let cases: [(Vec<Change>, &str, &str); 13] = [
        (with(""), "body.ship.outlines", "two heights or more"),
        (
            with("{ height = 0, outline = [[-50, -18], [50, -18], [50, 18], [-50, 18]] },"),
            "body.ship.outlines.1.height",
            "must rise",
        ),
        (
            with("{ height = -3, outline = [[-50, -18], [50, -18], [50, 18], [-50, 18]] },"),
            "body.ship.outlines.1.height",
            "must rise",
        ),
        (
            with("{ height = 7, outline = [[-50, -18], [50, -18], [50, 18], [-50, 18]] },"),
            "body.ship.outlines",
            "so the waterline at 8 m is outside",
        ),
        // The same polygon, with another vertex first: on the way up the hull would turn inside out.
        (
            with("{ height = 16, outline = [[50, 18], [-50, 18], [-50, -18], [50, -18]] },"),
            "body.ship.outlines.0.outline",
            "between outlines 0 and 1",
        ),
        (
            with("{ height = 16, outline = [[-50, -18], [50, 18], [50, -18], [-50, 18]] },"),
            "body.ship.outlines.1.outline",
            "outline 1",
        ),
        (
            with(
                "{ height = 16, outline = [[-50, -18], [50, -18], [50, 18], [-20, 18], [-10, 12], [-50, 12]] },",
            ),
            "body.ship.outlines.1.outline",
            "does not run forward",
        ),
        (with("{ height = 16 },"), "body.ship.outlines.1.outline", "missing"),
        (
            with("{ height = \"900 m\", outline = [[-50, -18], [50, -18], [50, 18], [-50, 18]] },"),
            "body.ship.outlines.1.height",
            "at most 200 m",
        ),
        (vec![("outlines", both)], "body.ship.outline", "does not go together"),
        (vec![("draught = \"8 m\"\n", "")], "body.ship.draught", "missing"),
        (
            vec![("fixed = true\n", "fixed = true\ndraught = 3\n")],
            "body.quay.draught",
            "is for a body with `outlines`",
        ),
        (
            vec![("[body.ship]\n", FLOATING), ("mass = \"20000 t\"\ngyradius = \"25 m\"\n", "")],
            "body.ship.draught",
            "does not go together with `vessel`",
        ),
    ];
    for (changes, key, fragment) in cases {
        let Err(error) = read(&changed(&changes)) else { panic!("{changes:?} is accepted") };
        assert_eq!(error.key(), Some(key), "{error}");
        assert!(error.to_string().contains(fragment), "{error}");
    }
    let many = (0..51).map(|height| upper.replace("\"16 m\"", &height.to_string()));
    let many = format!("outlines = [{}]\n", many.collect::<String>());
    let lines = &WEDGE[WEDGE.find("outlines = [").unwrap()..WEDGE.find("draught").unwrap()];
    let error = read(&changed(&[(lines, &many)])).map(drop).expect_err("51 outlines");
    assert!(error.to_string().contains("at most 50 outlines"), "{error}");
    let points = (0..1001).map(|n| format!("[{}, {}],", n, n * n));
    let fine = format!("{{ height = 16, outline = [{}] }},", points.collect::<String>());
    let error = read(&changed(&[(upper, &fine)])).map(drop).expect_err("1001 vertices");
    assert_eq!(error.key(), Some("body.ship.outlines.1.outline"));
    assert!(error.to_string().contains("has 1001 vertices"), "{error}");
    let paper = read(&changed(&[("[body.ship]", "[contact]\nmethod = \"paper\"\n\n[body.ship]")]));
    let refused = Simulation::new(paper.expect("a good file").setup).map(drop);
    assert!(refused.is_err_and(|error| error.to_string().contains("outlines at several heights")));
}
