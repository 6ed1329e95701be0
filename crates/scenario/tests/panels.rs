//! Panels on several cones in whole runs: keys, ledger, convergence, and agreement with `count`.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::path::Path;

use fenderline_contact::Unloading;
use fenderline_scenario::Scenario;
use fenderline_sim::{Energy, FenderSummary, Simulation};

fn example() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    std::fs::read_to_string(root.join("scenarios/berth/two_cones_behind_one_panel.toml")).unwrap()
}

fn run(text: &str) -> (Vec<FenderSummary>, Energy) {
    let scenario = Scenario::parse(text, "x.toml").unwrap_or_else(|error| panic!("{error}"));
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    (simulation.fender_summaries().cloned().collect(), simulation.energy())
}

fn replaced(text: &str, parts: &[(&str, &str)]) -> String {
    parts.iter().fold(text.to_owned(), |text, (part, other)| {
        assert!(text.contains(part), "{part}");
        text.replace(part, other)
    })
}

/// The forward panel turns to the ship's side, and its cone nearer to her bow governs.
#[test]
fn the_most_compressed_cone_governs() {
    let (fenders, energy) = run(&example());
    let forward = fenders.iter().find(|fender| fender.fender == 1).expect("it is touched");
    let panel = forward.panel.as_ref().expect("a panel");
    println!("{panel:?}\n{:?}", forward.governing());
    // Her bow is in the north: to the left of one who looks at the face from the west.
    assert!(panel.peak_tilt_rad < -0.02 && panel.peak_tilt_rad > -0.06, "{panel:?}");
    let deepest_m = panel.cones.iter().fold(0.0_f64, |most, cone| most.max(cone.peak_deflection_m));
    assert_eq!(deepest_m, forward.peak_deflection_m);
    assert!(panel.cones[0].peak_deflection_m > panel.cones[1].peak_deflection_m);
    let whole = forward.peak_energy_j / forward.capacity_j.unwrap();
    assert!(forward.share_of_rated_energy.unwrap() > whole, "{whole}");
    // The ledger closes to rounding; a contact's residual is the error of the sub-steps.
    let exchanged_j = energy.exchanged_j();
    println!("ledger {:e}", energy.residual_j / exchanged_j);
    assert!(energy.residual_j.abs() < 1e-6 * exchanged_j, "{energy:?}");
    assert!(energy.contact_residual_j.abs() < 2e-3 * exchanged_j, "{energy:?}");
    assert_eq!(energy.contact_gained_j, 0.0);
}

/// Peaks of long steps against those of a short one: 2 per mille by the phase of the sub-steps. The moment is a difference
/// of reactions that passes a sharp peak while one cone buckles and the other begins to bear: sub-steps of 0.1 rad miss up to
/// 4 % of it.
#[test]
fn a_long_step_has_the_peaks_of_a_short_one() {
    let peaks = |step: &str| {
        let text = replaced(&example(), &[("step = \"0.1 s\"", step), ("2 min", "40 s")]);
        let (fenders, _) = run(&text);
        let forward = fenders.into_iter().find(|fender| fender.fender == 1).expect("it is touched");
        let panel = forward.panel.expect("a panel");
        let moment_nm = panel.peak_moment_nm;
        ([forward.peak_deflection_m, forward.peak_energy_j, panel.peak_tilt_rad], moment_nm)
    };
    let (best, best_nm) = peaks("step = \"0.005 s\"");
    for step in ["0.02 s", "0.1 s", "0.5 s", "1 s"] {
        let (now, now_nm) = peaks(&format!("step = \"{step}\""));
        for (now, best) in now.iter().zip(best) {
            assert!((now / best - 1.0).abs() < 2e-3, "{step}: {now} for {best}");
        }
        assert!((now_nm / best_nm - 1.0).abs() < 5e-2, "{step}: {now_nm} for {best_nm} N m");
    }
}

/// A ship that comes parallel finds two cones at equal distances from the middle as `count = 2`. The numbers of sub-steps
/// differ in a long step, not in a short one.
#[test]
fn a_parallel_ship_finds_two_cones_as_count_2() {
    let parallel = [
        ("heading = \"3 deg\"", "heading = 0"),
        ("step = \"0.1 s\"", "step = \"0.005 s\""),
        ("2 min", "40 s"),
        ("{ at = \"-1 m\" }, { at = \"1.4 m\" }", "{ at = \"-1.2 m\" }, { at = \"1.2 m\" }"),
    ];
    let two = replaced(&example(), &parallel);
    let one = replaced(
        &two,
        &[(
            "cones = [{ at = \"-1.2 m\" }, { at = \"1.2 m\" }]",
            "count = 2\nreturned_energy = 0.5",
        )],
    );
    let two = replaced(
        &two,
        &[(
            "material = \"facing\"\nhull_pressure_limit",
            "material = \"facing\"\nreturned_energy = 0.5\nhull_pressure_limit",
        )],
    );
    let ((two, _), (one, _)) = (run(&two), run(&one));
    assert_eq!((two.len(), one.len()), (2, 2));
    for (two, one) in two.iter().zip(&one) {
        let of = |f: &FenderSummary| {
            [
                f.peak_deflection_m,
                f.peak_reaction_n,
                f.peak_energy_j,
                f.share_of_rated_energy.unwrap(),
            ]
        };
        for (two, one) in of(two).iter().zip(of(one)) {
            assert!((two / one - 1.0).abs() < 1e-7, "{two} for {one}");
        }
        let panel = two.panel.as_ref().expect("a panel");
        // She turns a little on her unequal ends.
        assert!(panel.peak_tilt_rad.abs() < 1e-2, "{panel:?}");
    }
}

/// By the paper's method a panel is the same spring.
#[test]
fn the_papers_method_takes_a_panel() {
    let text = replaced(
        &example(),
        &[
            ("[time]", "[contact]\nmethod = \"paper\"\n\n[time]"),
            ("2 min", "40 s"),
            ("0.1 s", "0.02 s"),
        ],
    );
    let (fenders, _) = run(&text);
    let (coupled, _) = run(&replaced(&example(), &[("2 min", "40 s"), ("0.1 s", "0.02 s")]));
    let peak_m =
        |all: &[FenderSummary]| all.iter().find(|f| f.fender == 1).unwrap().peak_deflection_m;
    // One added mass in all directions, and no sub-steps.
    assert!((peak_m(&fenders) / peak_m(&coupled) - 1.0).abs() < 0.3);
}

#[test]
fn a_curve_of_unloading_counts_by_its_share() {
    let own = "curve = [[0, 0], [\"0.3 m\", \"600 kN\"], [\"0.7 m\", \"600 kN\"]]\n\
               unloading = [[0, 0], [\"0.3 m\", \"300 kN\"], [\"0.7 m\", \"300 kN\"]]\n";
    let part = "type = \"cone\"\nheight = \"1 m\"\nrated_reaction = \"600 kN\"\n";
    let setup = Scenario::parse(&replaced(&example(), &[(part, own)]), "x.toml").unwrap().setup;
    let Some(Unloading::ReturnedEnergy(share)) = setup.fenders[0].unloading else {
        panic!("a share")
    };
    // Half, and the little that the plays return.
    assert!((share - 0.5).abs() < 0.03, "{share}");
    let rated = setup.fenders[0].rated.unwrap();
    assert_eq!((rated.deflection_m, rated.reaction_n), (0.7, 1200e3));
    assert!((rated.energy_j - 2.0 * (90e3 + 240e3)).abs() < 1e-6);
}

#[test]
fn heights_move_the_reaction() {
    let cones =
        "cones = [{ at = \"-1 m\", height = \"0.5 m\" }, { at = \"1 m\", height = \"1 m\" }]";
    let text = replaced(&example(), &[("cones = [{ at = \"-1 m\" }, { at = \"1.4 m\" }]", cones)]);
    let setup = Scenario::parse(&text, "x.toml").unwrap().setup;
    assert_eq!(setup.fenders[0].above_water_m, 2.5 + 0.75);
    assert_eq!(setup.fenders[0].source.as_ref().unwrap().designation.split(' ').next(), Some("2"));
}

const CHAINS: &str = r#"cones = [{ at = "-1 m" }, { at = "1.4 m" }]
panel_mass = "4 t"
chains = [
  { kind = "tension", at = "1.8 m", length = "1.42 m", span = "1.4 m", stiffness = "30 MN/m", break_load = "400 kN" },
  { kind = "shear", slack = "5 mm", stiffness = "30 MN/m", break_load = "400 kN" },
  { kind = "weight", break_load = "150 kN" },
]"#;

fn chained(parts: &[(&str, &str)]) -> String {
    let text = example();
    let at = text.find("[fender.forward]").expect("the fender");
    let (before, after) = text.split_at(at);
    let cones = "cones = [{ at = \"-1 m\" }, { at = \"1.4 m\" }]";
    format!("{before}{}", replaced(&replaced(after, &[(cones, CHAINS)]), parts))
}

fn forward(text: &str) -> (FenderSummary, Energy, bool) {
    let scenario = Scenario::parse(text, "x.toml").unwrap_or_else(|error| panic!("{error}"));
    let setup = scenario.setup.clone();
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    let parted = simulation
        .findings()
        .iter()
        .any(|finding| finding.sentence(&setup).contains("chain of fender forward parted"));
    let summary = simulation.fender_summaries().find(|f| f.fender == 1).expect("touched").clone();
    (summary, simulation.energy(), parted)
}

/// The bow compresses the left cone first, and the panel's right end moves out: the tension chain there holds it.
#[test]
fn chains_bear_what_they_hold() {
    let (free, ..) = forward(&example());
    let (held, energy, parted) = forward(&chained(&[]));
    println!("{held:?} {energy:?}");
    let [tension, shear, weight] = held.chains[..] else { panic!("three chains") };
    assert!(!parted);
    assert!(tension.peak_tension_n > 50e3 && tension.share_of_break_load < 1.0, "{tension:?}");
    // The stretch of the right cone is less with the chain.
    let stretch_m = |f: &FenderSummary| f.panel.as_ref().unwrap().cones[1].peak_stretch_m;
    assert!(stretch_m(&held) < 0.9 * stretch_m(&free), "{} {}", stretch_m(&held), stretch_m(&free));
    // By hand from the largest tangential force, which friction limits.
    let most_n = 0.2 * held.peak_reaction_n;
    let most_n = 30e6 * (most_n + 0.0 - 3e6 * 0.005) / 33e6;
    assert!(
        shear.peak_tension_n > 0.0 && shear.peak_tension_n < most_n * 1.01,
        "{shear:?} {most_n}"
    );
    // A body without heave: the weight alone.
    assert!((weight.peak_tension_n - 9.80665 * 4000.0).abs() < 1e-6, "{weight:?}");
    assert!(energy.residual_j.abs() < 1e-6 * energy.exchanged_j(), "{energy:?}");
    assert!(energy.contact_residual_j.abs() < 2e-3 * energy.exchanged_j(), "{energy:?}");
    assert_eq!(energy.contact_gained_j, 0.0);
}

#[test]
fn weak_chains_part_and_lose_their_energy() {
    let (parts, energy, parted) = forward(&chained(&[("400 kN", "40 kN"), ("150 kN", "30 kN")]));
    println!("{:?} {energy:?}", parts.chains);
    assert!(parted);
    let [tension, _, weight] = parts.chains[..] else { panic!("three chains") };
    assert!(tension.parted_at_s.is_some() && tension.share_of_break_load >= 1.0, "{tension:?}");
    assert!(weight.parted_at_s.is_some(), "{weight:?}");
    assert!(energy.residual_j.abs() < 1e-6 * energy.exchanged_j(), "{energy:?}");
    assert!(energy.contact_residual_j.abs() < 2e-3 * energy.exchanged_j(), "{energy:?}");
    assert_eq!(energy.contact_gained_j, 0.0);
    // What follows is the run without the chain.
    let (free, ..) = forward(&example());
    assert!((parts.peak_energy_j / free.peak_energy_j - 1.0).abs() < 0.02);
}

/// 28 mm of grade 2: 13.73e-3 · 784 · (44 − 2.24) = 449.5 kN; 0.854e8 · 0.028² / 1.42 = 47.15 MN/m.
#[test]
fn a_chain_by_its_diameter() {
    let by_size = "diameter = \"28 mm\", grade = \"u2\"";
    let text = chained(&[
        (
            "stiffness = \"30 MN/m\", break_load = \"400 kN\" },\n  { kind = \"shear\"",
            "X },\n  { kind = \"shear\"",
        ),
        ("X }", &format!("{by_size} }}")),
        ("break_load = \"150 kN\"", "diameter = \"16 mm\", grade = \"g80\""),
    ]);
    let setup = Scenario::parse(&text, "x.toml").unwrap_or_else(|error| panic!("{error}")).setup;
    let [tension, _, weight] = setup.fenders[1].chains[..] else { panic!("three chains") };
    assert!((tension.break_load_n / 449.5e3 - 1.0).abs() < 1e-3, "{tension:?}");
    assert!((tension.stiffness_npm / 47.15e6 - 1.0).abs() < 1e-3, "{tension:?}");
    // 800 N/mm² over two bars of 201.06 mm².
    assert!((weight.break_load_n / 321.7e3 - 1.0).abs() < 1e-3, "{weight:?}");
}

#[test]
fn bad_chains_name_the_key() {
    for (part, mistake, key, fragment) in [
        (
            "length = \"1.42 m\"",
            "length = \"1.38 m\"",
            "fender.forward.chains.0.length",
            "shorter than the `span` of 1.4 m",
        ),
        (
            "at = \"1.8 m\", length",
            "at = \"2.2 m\", length",
            "fender.forward.chains.0.at",
            "between -2 and 2 m",
        ),
        ("at = \"1.8 m\", ", "", "fender.forward.chains.0.at", "is missing"),
        (", break_load = \"150 kN\"", "", "fender.forward.chains.2.break_load", "is missing"),
        (
            "stiffness = \"30 MN/m\", break_load = \"400 kN\" },\n  { kind = \"shear\"",
            "break_load = \"400 kN\" },\n  { kind = \"shear\"",
            "fender.forward.chains.0.stiffness",
            "is missing",
        ),
        (
            "break_load = \"150 kN\"",
            "diameter = \"28 mm\"",
            "fender.forward.chains.2.grade",
            "is missing",
        ),
        (
            "break_load = \"150 kN\"",
            "break_load = \"150 kN\", grade = \"u2\"",
            "fender.forward.chains.2.grade",
            "is for chains with a `diameter`",
        ),
        (
            "break_load = \"150 kN\"",
            "break_load = \"150 kN\", diameter = \"28 mm\"",
            "fender.forward.chains.2.break_load",
            "does not go together with `diameter`",
        ),
        (
            "break_load = \"150 kN\"",
            "diameter = \"28 mm\", grade = \"g80\", link = \"stud\"",
            "fender.forward.chains.2.link",
            "have no studs",
        ),
        (
            "break_load = \"150 kN\"",
            "diameter = \"28 m\", grade = \"u2\"",
            "fender.forward.chains.2.diameter",
            "must be",
        ),
        ("slack = \"5 mm\"", "length = 1", "fender.forward.chains.1.span", "is missing"),
        (
            "slack = \"5 mm\"",
            "slack = \"5 mm\", span = 1",
            "fender.forward.chains.1.span",
            "does not go together with `slack`",
        ),
        ("slack = \"5 mm\"", "slack = \"-5 mm\"", "fender.forward.chains.1.slack", "must be"),
        (
            "kind = \"weight\",",
            "kind = \"weight\", slack = 1,",
            "fender.forward.chains.2.slack",
            "is not for weight chains",
        ),
        (
            "kind = \"shear\",",
            "kind = \"shear\", at = 1,",
            "fender.forward.chains.1.at",
            "is not for shear chains",
        ),
        ("panel_mass = \"4 t\"\n", "", "fender.forward.panel_mass", "is missing"),
        (
            "cones = [{ at = \"-1 m\" }, { at = \"1.4 m\" }]\npanel",
            "count = 2\npanel",
            "fender.forward.chains",
            "has no `cones`",
        ),
    ] {
        let error = Scenario::parse(&chained(&[(part, mistake)]), "x.toml").expect_err(fragment);
        let shown = error.to_string();
        assert_eq!(error.key(), Some(key), "{shown}");
        assert!(shown.contains(fragment), "{shown}");
        assert!(error.line().is_some_and(|line| line >= 60), "{shown}");
    }
}

#[test]
fn bad_cones_name_key_and_line() {
    for (cones, key, fragment) in [
        ("[{ at = \"1 m\" }]", "fender.aft.cones", "must be 2 to 8 cones, but has 1"),
        ("[{ at = 0 }, { at = 0 }]", "fender.aft.cones", "write `count` instead"),
        ("[{ at = 0 }, { at = \"2.1 m\" }]", "fender.aft.cones.1.at", "between -2 and 2 m"),
        (
            "[{ at = 0 }, { at = 1, height = 2 }]",
            "fender.aft.cones.1.height",
            "between -1.5 and 1.5 m",
        ),
        ("[{ height = 1 }, { at = 1 }]", "fender.aft.cones.0.at", "is missing"),
        (
            "[{ at = 0 }, { at = 1 }]\ncount = 2",
            "fender.aft.cones",
            "does not go together with `count`",
        ),
    ] {
        let text = example().replacen("[{ at = \"-1 m\" }, { at = \"1.4 m\" }]", cones, 1);
        let error = Scenario::parse(&text, "x.toml").expect_err(fragment);
        let shown = error.to_string();
        assert_eq!(error.key(), Some(key), "{shown}");
        assert!(shown.contains(fragment), "{shown}");
        assert_eq!(error.line(), Some(56), "{shown}");
    }
}
