//! `fenderline manoeuvre`: tables, JSON, tracks, refusals.

use crate::support;

use serde_json::Value;
use support::Workplace;

fn json(place: &Workplace, args: &[&str]) -> Value {
    let run = place.run(&[&["manoeuvre"], args, &["--json"]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    serde_json::from_str(&run.stdout).expect("JSON")
}

/// A measure of the section whose title begins with `title`.
fn measure(document: &Value, title: &str, key: &str, side: &str) -> f64 {
    let sections = document["manoeuvres"].as_array().expect("a list");
    let section = sections
        .iter()
        .find(|section| section["title"].as_str().is_some_and(|t| t.starts_with(title)))
        .expect(title);
    section["measures"][key]["values"][side].as_f64().expect(key)
}

/// The independent program's numbers (validation/independent/mmg_standard.py), to 1 % or half of the last digit here.
#[test]
fn kvlcc2s_measures_are_those_of_the_independent_calculation() {
    let place = Workplace::new("manoeuvre_json");
    let document = json(&place, &["kvlcc2"]);
    for (title, key, side, theirs, allowed) in [
        ("Turning circle", "advance", "starboard", 3.03, 0.0303),
        ("Turning circle", "tactical_diameter", "starboard", 3.01, 0.0301),
        ("Turning circle", "advance", "port", 3.05, 0.0305),
        ("Turning circle", "tactical_diameter", "port", 3.02, 0.0302),
        ("Zig-zag 10°/10°", "first_overshoot", "starboard", 5.4, 0.054),
        ("Zig-zag 10°/10°", "second_overshoot", "port", 9.1, 0.091),
        ("Zig-zag 20°/20°", "first_overshoot", "port", 15.3, 0.153),
        // 60 · 1.7785.
        ("Bollard pull", "revolutions", "ahead", 106.71, 0.06),
    ] {
        let ours = measure(&document, title, key, side);
        assert!((ours - theirs).abs() <= allowed, "{title} {key} {side}: {ours} for {theirs}");
    }
    // Nothing in a steady turn but the rate: diameter/L = 2/|r'|.
    let [diameter, rate] = ["steady_diameter", "steady_rate"]
        .map(|key| measure(&document, "Turning circle", key, "port"));
    assert!((diameter * rate.abs() / 2.0 - 1.0).abs() < 1e-12);
    // ½ρLTC_D v² drives her at v = 0.01√(gL); the linear terms and the turn that comes with it take a little.
    let knots = 0.01 * (9.806_65_f64 * 320.0).sqrt() * 3600.0 / 1852.0;
    let across = measure(&document, "Crabbing", "sway", "starboard");
    assert!((across / knots - 1.0).abs() < 0.03, "{across} kn for {knots} kn");
    // L/V = 320 m/7.97 m/s = 40 s: IMO's limits are 20° and 40°.
    let limits = &document["manoeuvres"][1]["measures"];
    assert_eq!(limits["first_overshoot"]["imo_limit"], 20.0);
    assert_eq!(limits["second_overshoot"]["imo_limit"], 40.0);
    assert_eq!(limits["second_overshoot"]["within_imo_limit"], true);
}

#[test]
fn the_table_has_every_measure_limit_and_source() {
    let place = Workplace::new("manoeuvre_table");
    let run = place.run(&["manoeuvre", "kcs"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    for text in [
        "KCS, 230 m: L 230 m",
        "Turning circle, rudder 35°",
        "tactical diameter",
        "≤ 5 L, met",
        "Zig-zag 10°/10°",
        "Zig-zag 20°/20°",
        "≤ 25°, met",
        "Crash stop",
        "track reach",
        "Crabbing",
        "Bollard pull",
        "[found] length_bp, beam",
        "[estimated, derived] hull at low speed",
    ] {
        assert!(run.stdout.contains(text), "{text} is missing:\n{}", run.stdout);
    }
    // Whole words: a source's title may have them within.
    let mut words = run.stdout.split(|c: char| !c.is_alphanumeric());
    assert!(words.all(|word| word != "NaN" && word != "inf"), "{}", run.stdout);
    assert_eq!(place.run(&["manoeuvre", "kcs"]).stdout, run.stdout, "the same again");

    // One manoeuvre alone, under other conditions: no limit of IMO's holds there.
    let run = place.run(&["manoeuvre", "kcs", "turning", "--rudder", "20", "--speed", "10"]);
    assert_eq!(run.code, 0);
    assert!(run.stdout.contains("Turning circle, rudder 20°") && run.stdout.contains("10.0 kn"));
    assert!(!run.stdout.contains("IMO") && !run.stdout.contains("Zig-zag"));
    // Nor of a model.
    assert!(!place.run(&["manoeuvre", "kvlcc2-model", "turning"]).stdout.contains("≤"));
}

/// Every force is of second degree in speed and revolutions together: the circle is the same at half of both.
#[test]
fn the_steady_circle_does_not_depend_on_the_speed_of_approach() {
    let place = Workplace::new("manoeuvre_speed");
    let [full, half] = ["15.5", "7.75"].map(|speed| {
        let document = json(&place, &["kvlcc2", "turning", "--speed", speed]);
        measure(&document, "Turning circle", "steady_diameter", "starboard")
    });
    // The rudder's rate is not halved; what is left of that after two circles is far below a thousandth.
    assert!((full / half - 1.0).abs() < 1e-3, "{full} {half}");
}

#[test]
fn tracks_are_written_whole() {
    let place = Workplace::new("manoeuvre_tracks");
    let run = place.run(&["manoeuvre", "kvlcc2", "turning", "--out", "tracks"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let last = run.stdout.lines().last().unwrap_or_default();
    assert_eq!(last, "in tracks: turning_starboard.csv, turning_port.csv");
    let mut table =
        csv::Reader::from_path(place.path("tracks/turning_starboard.csv")).expect("the track");
    assert_eq!(&table.headers().expect("a header")[3], "heading_rad");
    let rows: Vec<Vec<f64>> = table
        .records()
        .map(|row| row.expect("a row").iter().map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    // The advance is where the heading passes 90°.
    let quarter = rows.iter().find(|row| row[3] >= std::f64::consts::FRAC_PI_2).expect("90°");
    let document = json(&place, &["kvlcc2", "turning"]);
    let advance_m = 320.0 * measure(&document, "Turning circle", "advance", "starboard");
    assert!((quarter[1] - advance_m).abs() < 1.0, "{} for {advance_m}", quarter[1]);
    assert!(rows[0].iter().take(4).all(|value| *value == 0.0) && rows[0][4] > 7.0);
    assert!(!place.exists("tracks/turning_port.csv.part"));
}

/// What she does in shallow water stands beside what she does in deep water, which is what she does without the option.
#[test]
fn a_depth_of_water_is_shown_beside_deep_water() {
    let place = Workplace::new("manoeuvre_depth");
    let run = ["kvlcc2", "--speed", "7"];
    let deep = json(&place, &run);
    let there = json(&place, &[&run[..], &["--depth", "1.2 T"]].concat());
    let metres = json(&place, &[&run[..], &["--depth", "24.96 m"]].concat());
    assert_eq!(there["depth_m"].as_f64().map(|m| (m * 1e6).round()), Some(24_960_000.0));
    assert_eq!(deep["depth_m"], Value::Null);
    for (title, key, side) in [
        ("Turning circle", "tactical_diameter", "starboard"),
        ("Zig-zag 20°/20°", "first_overshoot", "port"),
        ("Crabbing", "sway", "starboard"),
        ("Bollard pull", "pull", "astern"),
    ] {
        let beside = measure(&there, title, key, &format!("{side}, deep"));
        assert_eq!(beside, measure(&deep, title, key, side), "{title} {key}");
        assert_eq!(measure(&there, title, key, side), measure(&metres, title, key, side));
    }
    let ratio = |title: &str, key: &str, side: &str| {
        measure(&there, title, key, side) / measure(&deep, title, key, side)
    };
    let wider = ratio("Turning circle", "tactical_diameter", "starboard");
    assert!((1.3..1.95).contains(&wider), "{wider}");
    assert!(ratio("Turning circle", "steady_drift", "port") < 0.5);
    assert!(ratio("Zig-zag 10°/10°", "first_overshoot", "starboard") < 0.9);
    // The same push at midship against UFC's drag, three times hers in deep water and more.
    assert!(ratio("Crabbing", "sway", "starboard") < 0.62);
    assert_eq!(there["notices"].as_array().map(Vec::len), Some(0));

    let run = place.run(&["manoeuvre", "kcs", "turning", "--depth", "1.15T", "--out", "tracks"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    for said in [
        "still water 12.42 m deep, 1.15 draughts, beside deep water,",
        "note: --depth: 1.15 draughts; corrections are valid from 1.2 on; here the corrections are extrapolated",
        "Froude number of depth of 1.12",
        "port, deep",
        "turning_port_shallow.csv",
    ] {
        assert!(run.stdout.contains(said), "{said}: {}", run.stdout);
    }
    assert!(!run.stdout.contains("IMO asks"), "IMO's limits are for deep water");
    let run = place.run(&["manoeuvre", "kvlcc2", "turning", "--depth", "21"]);
    assert!(run.stdout.contains("constant below 1.1"), "{}", run.stdout);
}

#[test]
fn impossible_manoeuvres_are_refused_by_name() {
    let place = Workplace::new("manoeuvre_refusals");
    for (args, code, said) in [
        (&["kvlc2"][..], 2, "did you mean \"kvlcc2\"?"),
        (&["kcs", "turnign"], 2, "a similar value exists: 'turning'"),
        (&["esso-osaka", "turning", "--rudder", "36"], 2, "stops at 35°"),
        (&["kcs", "turning", "--rudder", "36"], 2, "stops at 35°"),
        (&["kcs", "turning", "--rudder", "-5"], 2, "must be above 0"),
        (&["kcs", "turning", "--rudder", "nan"], 2, "must be above 0"),
        (&["kcs", "turning", "--speed", "900"], 2, "Froude number"),
        (&["kcs", "crabbing", "--rudder", "5"], 2, "--rudder has no effect"),
        (&["kcs", "crabbing", "--speed", "5"], 2, "--speed has no effect"),
        (&["kcs", "turning", "--push", "5"], 2, "--push has no effect"),
        (&["kcs", "crabbing", "--out", "x"], 2, "has a track"),
        (
            &["kcs", "turning", "--depth", "10.8"],
            2,
            "--depth: 10.8 m of water under a draught of 10.8 m",
        ),
        (&["kcs", "turning", "--depth", "0.9 T"], 2, "aground"),
        (&["kcs", "turning", "--depth", "-3"], 2, "must be positive"),
        (&["kcs", "turning", "--depth", "12 ft"], 2, "a number of metres or of draughts"),
        (&["kcs", "turning", "--out", "tug.toml"], 2, "cannot write tug.toml"),
    ] {
        let run = place.run(&[&["manoeuvre"], args].concat());
        assert_eq!(run.code, code, "{args:?}: {}{}", run.stdout, run.stderr);
        assert!(run.stderr.contains(said), "{args:?}: {}", run.stderr);
    }
}

#[test]
fn every_vessel_carries_out_every_manoeuvre() {
    let place = Workplace::new("manoeuvre_all");
    for vessel in ["kvlcc2", "kvlcc2-model", "kcs", "esso-osaka"] {
        let run = place.run(&["manoeuvre", vessel]);
        assert_eq!(run.code, 0, "{vessel}: {}", run.stderr);
        for manoeuvre in
            ["Turning circle", "Zig-zag 10", "Zig-zag 20", "Crash stop", "Crabbing", "Bollard pull"]
        {
            assert!(run.stdout.contains(manoeuvre), "{vessel} has no {manoeuvre}");
        }
        assert!(!run.stdout.contains("NaN"), "{}", run.stdout);
        assert_eq!(
            run.stdout.contains("no conformity is claimed"),
            !vessel.contains("model") && vessel != "esso-osaka"
        );
    }
}

/// A tanker was stopped within 8 lengths, by the friction of her 7 m model.
#[test]
fn a_ship_stops_later_with_her_own_friction_than_with_that_of_her_model() {
    let place = Workplace::new("manoeuvre_friction");
    let document = json(&place, &["kvlcc2", "crash-stop"]);
    let reach = |column: &str| measure(&document, "Crash stop", "track_reach", column);
    let (tested, own) = (reach("as tested"), reach("ship's friction"));
    assert!(own > 1.2 * tested && own < 20.0, "{tested} {own}");
}

/// With every estimated ship stands by how much such estimates are off, as computed from ships with references; of a ship with
/// tests of her own nothing is said.
#[test]
fn the_error_of_an_estimate_is_reported_by_measure() {
    let place = Workplace::new("manoeuvre_accuracy");
    let heading = "How far these estimates are to be relied on";
    let told = |args: &[&str]| {
        let run = place.run(args);
        assert_eq!(run.code, 0, "{}", run.stderr);
        let (_, after) = run.stdout.split_once(heading)?;
        Some(after.to_owned())
    };
    for args in [["manoeuvre", "bulk-carrier", "turning"].as_slice(), &["vessels", "bulk-carrier"]]
    {
        let said = told(args).expect("she is estimated");
        for measure in ["advance at 35°: off by", "tactical diameter", "10°/10°", "20°/20°", "bias"]
        {
            assert!(said.contains(measure), "{measure}: {said}");
        }
        assert!(!said.contains("outside"), "she is within the range: {said}");
    }
    let container = told(&["vessels", "container-ship"]).expect("she is estimated");
    assert!(container.contains("beam over draught is 5.111, outside 2.2 to 3.3"), "{container}");
    let tug = told(&["vessels", "asd-tug"]).expect("she is estimated");
    assert!(tug.contains("their error is not known") && !tug.contains("off by"), "{tug}");
    assert_eq!(told(&["vessels", "kvlcc2"]), None);

    let document = json(&place, &["s175", "turning"]);
    let errors = document["estimate"]["errors"].as_array().expect("a list");
    let advance = errors.iter().find(|error| error["measure"] == "advance").expect("told");
    assert!(advance["mean_size"].as_f64().is_some_and(|size| size > 0.0 && size <= 0.15));
    assert_eq!(json(&place, &["kcs", "turning"])["estimate"], Value::Null);
}
