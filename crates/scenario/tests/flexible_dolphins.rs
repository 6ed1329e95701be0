//! Flexible dolphins in whole runs: keys, hand calculation, ledger, yield, and what is refused.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::path::Path;

use fenderline_scenario::{Override, Scenario};
use fenderline_sim::{DolphinSummary, Energy, FenderSummary, Finding, SetupError, Simulation};

/// A barge of 5,000 t, side on, 0.2 m off a linear fender on a dolphin; the same numbers are easy to follow by hand.
const SCENE: &str = r#"
[time]
step = "0.1 s"
duration = "20 s"

[material.m]
stiffness = "10 MN/m^2"

[body.barge]
outline = [[-30, -10], [30, -10], [30, 10], [-30, 10]]
mass = "5000 t"
gyradius = "17 m"
velocity = { sway = "0.3 m/s" }

[body.dolphin]
outline = [[-2, 0], [2, 0], [2, 4], [-2, 4]]
position = [0, 12.2]
dolphin = { stiffness = "4 MN/m", mass = "60 t", damping = 0 }

[fender.f]
on = "dolphin"
position = [0, 0]
facing = "-90 deg"
width = "3 m"
projection = "2 m"
stiffness = "2 MN/m"
returned_energy = "90 %"
material = "m"

[[pair]]
bodies = ["barge", "dolphin"]
material = "m"
"#;

struct Run {
    fenders: Vec<FenderSummary>,
    dolphins: Vec<DolphinSummary>,
    energy: Energy,
    findings: Vec<Finding>,
    setup: fenderline_sim::Setup,
}

fn run(text: &str, overrides: &[&str]) -> Run {
    let overrides: Vec<Override> =
        overrides.iter().map(|text| Override::parse(text).expect("an override")).collect();
    let scenario =
        Scenario::parse_with(text, "x.toml", &overrides).unwrap_or_else(|error| panic!("{error}"));
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    Run {
        fenders: simulation.fender_summaries().cloned().collect(),
        dolphins: simulation.dolphin_summaries().to_vec(),
        energy: simulation.energy(),
        findings: simulation.findings(),
        setup: simulation.setup().clone(),
    }
}

/// The barge's energy, of which the pile's swing has little, in springs of 2 and 4 MN/m in series: E_pile/E_fender = 2/4,
/// F = v √(m K), K = 1/(1/2 + 1/4) MN/m. The pile of 60 t swings by some per cent beside that: 3 % of the force and 6 % of
/// its energy; the engine's own tests have both masses.
#[test]
fn pile_and_fender_in_series_share_a_berthing() {
    let Run { fenders, dolphins, .. } = run(SCENE, &[]);
    let ([fender], [dolphin]) = (&fenders[..], &dolphins[..]) else { panic!("one of each") };
    let force_n = 0.3 * (5e6_f64 * 4e6 / 3.0).sqrt();
    let deflections_m = [force_n / 2e6, force_n / 4e6];
    for (got, wanted) in [
        (fender.peak_reaction_n, force_n),
        (dolphin.peak_load_n, force_n),
        (fender.peak_deflection_m, deflections_m[0]),
        (dolphin.peak_deflection_m, deflections_m[1]),
    ] {
        assert!((got / wanted - 1.0).abs() < 0.03, "{got} for {wanted}");
    }
    let share = dolphin.peak_energy_j / fender.peak_energy_j;
    assert!((share / 0.5 - 1.0).abs() < 0.06, "{share}");
    assert_eq!((dolphin.share_of_yield_load, dolphin.offset_m), (None, 0.0));
}

/// A barge that leans on the fender and has settled: R/K at the end. Later she would turn: on one fender that is not stable.
#[test]
fn a_dolphin_at_rest_bends_by_load_over_stiffness() {
    let lean = "[[load]]\nbody = \"barge\"\nforce = [0, \"600 kN\"]\n";
    let Run { fenders, dolphins, energy, setup, .. } = run(
        &format!("{SCENE}{lean}"),
        &[
            "body.barge.velocity.sway=0",
            "body.dolphin.dolphin.damping=0.9",
            "fender.f.returned_energy=\"5 %\"",
            "time.duration=\"4 min\"",
        ],
    );
    assert!((fenders[0].last_reaction_n / 600e3 - 1.0).abs() < 1e-6, "{fenders:?}");
    // R²/2K.
    assert!((energy.pile_stored_j / 45e3 - 1.0).abs() < 1e-6, "{energy:?}");
    assert!(dolphins[0].peak_load_n > 600e3);
    assert!((setup.bodies[1].dolphin.unwrap().period_s() - 0.769_530).abs() < 1e-6);
}

/// Kinetic energy, works of piles and contacts: to rounding. What the pile took: its bending, damping and yield.
#[test]
fn the_ledger_closes_at_all_steps() {
    for pile in ["damping = 0", "damping = 0.05", "damping = 0.05, yield_load = \"400 kN\""] {
        for step in ["0.01 s", "0.1 s", "1 s", "2 s"] {
            let text = SCENE.replace("damping = 0", pile).replace("0.1 s", step);
            let Run { energy, .. } = run(&text, &[]);
            let exchanged_j = energy.exchanged_j();
            let pile_j = energy.pile_stored_j + energy.pile_damping_j + energy.pile_yield_j;
            let off_j = energy.loads.piles_j + pile_j;
            assert!(energy.residual_j.abs() < 1e-9 * exchanged_j, "{pile}, {step}: {energy:?}");
            assert!(off_j.abs() < 1e-9 * exchanged_j, "{pile}, {step}: {energy:?}");
            assert!(energy.contact_residual_j.abs() < 2e-3 * exchanged_j, "{pile}, {step}");
            assert_eq!(energy.contact_gained_j, 0.0, "{pile}, {step}");
            assert_eq!(energy.pile_yield_j > 0.0, pile.contains("yield"), "{pile}, {step}");
        }
    }
}

#[test]
fn a_pile_that_yields_is_a_finding() {
    let text = SCENE.replace("damping = 0", "yield_load = \"600 kN\"");
    let Run { dolphins, findings, setup, .. } = run(&text, &[]);
    let dolphin = &dolphins[0];
    assert!(dolphin.yielded_at_s.is_some() && dolphin.offset_m > 0.01, "{dolphin:?}");
    assert!((dolphin.share_of_yield_load.unwrap() - 1.0).abs() < 1e-9, "{dolphin:?}");
    assert_eq!(findings[0].verdict().key(), "pile_yielded");
    let sentence = findings[0].sentence(&setup);
    assert!(sentence.starts_with("The pile of dolphin yielded at"), "{sentence}");
    assert!(sentence.contains("under 600.0 kN"), "{sentence}");
    // Below its yield load it has a share, and is no finding.
    let Run { dolphins, findings, .. } = run(&text.replace("600 kN", "3 MN"), &[]);
    assert!(dolphins[0].share_of_yield_load.unwrap() < 0.5 && findings.is_empty(), "{findings:?}");
}

#[test]
fn a_row_stands_on_flexible_dolphins() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let text =
        std::fs::read_to_string(root.join("scenarios/berth/flexible_dolphins.toml")).unwrap();
    let Run { dolphins, energy, setup, .. } =
        run(&text, &["fender_row.bd.dolphin.length=\"30 m\"", "time.duration=\"20 s\""]);
    assert_eq!(dolphins.len(), 2);
    for dolphin in &dolphins {
        let of = setup.bodies[dolphin.body].dolphin.expect("it is flexible");
        // 3EI/L³ of π/64 (2⁴ − 1.928⁴) m⁴ and 210 GPa.
        assert!((of.stiffness_npm / 2.499_84e6 - 1.0).abs() < 1e-4, "{of:?}");
        assert!(setup.bodies[dolphin.body].is_fixed());
    }
    assert!(energy.residual_j.abs() < 1e-6 * energy.exchanged_j());
}

/// A line of 200 kN from a barge 60 m off. Made fast at once, it bends the pile by up to twice its static deflection.
#[test]
fn a_line_bends_a_dolphin() {
    let line = "[line.l]\nfrom = \"barge\"\nfairlead = [0, 10]\nto = \"dolphin\"\nbollard = [0, 1]\n\
                rope = \"nylon\"\nbreak_load = \"1500 kN\"\npretension = \"200 kN\"\n";
    let Run { dolphins, energy, .. } = run(
        &format!("{SCENE}{line}"),
        &["body.barge.position=[0, -60]", "body.barge.velocity.sway=0", "time.duration=\"5 s\""],
    );
    let load_n = dolphins[0].peak_load_n;
    assert!((300e3..420e3).contains(&load_n), "{load_n}");
    assert!(energy.loads.lines_j != 0.0 && energy.residual_j.abs() < 1e-9 * energy.exchanged_j());
}

#[test]
fn the_papers_method_and_hosts_are_refused() {
    for (part, other) in [
        ("[time]", "[contact]\nmethod = \"paper\"\n\n[time]"),
        ("[time]\n", "[time]\nintegrator = \"rk4\"\n"),
    ] {
        let setup = Scenario::parse(&SCENE.replace(part, other), "x.toml").unwrap().setup;
        let error = Simulation::new(setup).expect_err("a dolphin needs the engine");
        assert_eq!(error, SetupError::DolphinNeedsEngine { body: "dolphin".to_owned() });
    }
    let setup = Scenario::parse(SCENE, "x.toml").unwrap().setup;
    let error = setup.contact_model().expect_err("a host does not move a dolphin");
    assert_eq!(error, SetupError::DolphinOfHost { body: "dolphin".to_owned() });
    assert!(error.to_string().contains("make the dolphin a fixed body"));
}

#[test]
fn bad_dolphins_name_key_and_line() {
    const GOOD: &str = "{ stiffness = \"4 MN/m\", mass = \"60 t\", damping = 0 }";
    const TUBE: &str = "diameter = \"2 m\", wall = \"36 mm\"";
    for (dolphin, key, fragment) in [
        ("{ stiffness = \"4 MN/m\" }", "mass", "is missing"),
        ("{ mass = \"60 t\" }", "stiffness", "is missing"),
        (&format!("{{ {TUBE} }}"), "length", "is missing"),
        (
            &format!("{{ {TUBE}, length = 28, stiffness = \"4 MN/m\", mass = 60000 }}"),
            "diameter",
            "does not go together with `stiffness`",
        ),
        (&format!("{{ {TUBE}, length = 28, mass = 60000 }}"), "mass", "does not go together"),
        (
            &format!("{{ {TUBE}, length = 28, yield_load = \"1 MN\" }}"),
            "yield_load",
            "does not go together",
        ),
        ("{ diameter = \"36 mm\", wall = \"2 m\", length = 28 }", "diameter", "must be"),
        (
            "{ diameter = \"2 m\", wall = \"1.2 m\", length = 28 }",
            "wall",
            "is more than half of the `diameter`",
        ),
        (&format!("{{ {TUBE}, length = 28, piles = 1.5 }}"), "piles", "must be a whole number"),
        ("{ stiffness = \"4 MN/m\", mass = 0 }", "mass", "must be"),
        ("{ stiffness = 5, mass = 60000 }", "stiffness", "must be"),
        ("{ stiffness = \"4 MN\", mass = 60000 }", "stiffness", "a stiffness"),
        ("{ stiffness = \"4 MN/m\", mass = 60000, damping = 1 }", "damping", "must be"),
    ] {
        assert!(SCENE.contains(GOOD));
        let error = Scenario::parse(&SCENE.replace(GOOD, dolphin), "x.toml").expect_err(fragment);
        let shown = error.to_string();
        assert_eq!(error.key(), Some(format!("body.dolphin.dolphin.{key}").as_str()), "{shown}");
        assert!(shown.contains(fragment), "{shown}");
        assert_eq!(error.line(), Some(18), "{shown}");
    }
    for (part, other, key, fragment) in [
        (
            "position = [0, 12.2]",
            "fixed = true",
            "body.dolphin.fixed",
            "go together with `dolphin`",
        ),
        ("position = [0, 12.2]", "mass = 5", "body.dolphin.mass", "but this body stands on piles"),
        (
            "on = \"dolphin\"\n",
            "on = \"dolphin\"\n\n[fender_row.r]\non = \"barge\"\nfirst = [0, 0]\nnumber = 2\n\
             spacing = 3\nwidth = 1\nprojection = 1\nmaterial = \"m\"\ndolphin = { stiffness = 5e6, mass = 60000 }\n",
            "fender_row.r.dolphin",
            "is for rows with `dolphins`",
        ),
    ] {
        let text = match part.starts_with("on") {
            false => SCENE.replace(part, other),
            // A table of its own at the end.
            true => format!("{SCENE}{}", other.trim_start_matches(part)),
        };
        let error = Scenario::parse(&text, "x.toml").expect_err(fragment);
        let shown = error.to_string();
        assert_eq!(error.key(), Some(key), "{shown}");
        assert!(shown.contains(fragment), "{shown}");
    }
}

#[test]
fn nonsense_is_noticed() {
    let notices = |dolphin: &str| -> Vec<String> {
        let text = SCENE.replace("stiffness = \"4 MN/m\", mass = \"60 t\"", dolphin);
        let scenario = Scenario::parse(&text, "x.toml").unwrap_or_else(|error| panic!("{error}"));
        let of_dolphin =
            |notice: &&fenderline_scenario::Notice| notice.key.starts_with("body.dolphin.dolphin");
        scenario.notices.iter().filter(of_dolphin).map(|n| n.message.clone()).collect()
    };
    assert!(notices("stiffness = \"4 MN/m\", mass = \"60 t\"").is_empty());
    // 5000 kN/m without its unit.
    let soft = notices("stiffness = 5000, mass = \"60 t\"");
    assert!(soft[0].contains("kN/m in place of N/m?"), "{soft:?}");
    // 60 t without its unit: 24 ms.
    let light = notices("stiffness = \"4 MN/m\", mass = 60");
    assert!(light[0].contains("has a period of 0.0243 s"), "{light:?}");
}
