//! Wind and current coefficients, ropes and partial factors of the user's own.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::path::Path;

use fenderline_scenario::{Override, Scenario, ScenarioError};
use fenderline_sim::hydro::Force;
use fenderline_sim::{Finding, Simulation, Verdict};

/// A knot (m/s).
const KNOT: f64 = 1852.0 / 3600.0;

/// The text of a file in `scenarios/berth`.
fn file(name: &str) -> Result<String, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/berth");
    std::fs::read_to_string(folder.join(name)).map_err(|why| format!("{name}: {why}"))
}

/// A scenario of `scenarios/berth` with some keys replaced, and some of its files.
fn read(name: &str, sets: &[&str], files: &[(&str, &str)]) -> Result<Scenario, ScenarioError> {
    let overrides: Vec<Override> = sets.iter().map(|set| Override::parse(set).unwrap()).collect();
    Scenario::parse_among(&file(name).unwrap(), name, &overrides, &mut |name| match files
        .iter()
        .find(|(known, _)| *known == name)
    {
        Some((_, text)) => Ok((*text).to_owned()),
        None => file(name),
    })
}

const EXAMPLE: &str = "own_coefficients.toml";

/// Wind force and hull force on the tanker of the example in the first step, at rest.
fn first_forces(sets: &[&str]) -> [Force; 2] {
    let scenario = read(EXAMPLE, sets, &[]).unwrap_or_else(|error| panic!("{error}"));
    let mut simulation = Simulation::new(scenario.setup).unwrap();
    let record = simulation.step().unwrap();
    [record.vessel_forces[0].wind, record.vessel_forces[0].hull]
}

/// The rows of a file of the example as numbers.
fn rows(name: &str) -> Vec<Vec<f64>> {
    let text = file(name).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect()
}

/// OCIMF's coefficients at an angle of 0 to 180 degrees, by hand: the two rows about it.
fn by_hand(table: &[Vec<f64>], angle: f64) -> [f64; 3] {
    let upper = table.iter().position(|row| row[0] >= angle).unwrap();
    let (one, two) = (&table[upper.saturating_sub(1)], &table[upper]);
    let share = if upper == 0 { 0.0 } else { (angle - one[0]) / (two[0] - one[0]) };
    [1, 2, 3].map(|k| one[k] + share * (two[k] - one[k]))
}

/// Twelve bearings from the bow, clockwise (deg), six on each side.
const BEARINGS: [f64; 12] =
    [7.0, 37.0, 67.0, 90.0, 127.0, 180.0, 187.0, 217.0, 247.0, 270.0, 307.0, 337.0];

/// Forces of a flow from a bearing by OCIMF's formulas, in the axes of this program.
fn expected(
    table: &[Vec<f64>],
    bearing: f64,
    pressure: f64,
    areas: [f64; 2],
    length: f64,
) -> Force {
    // OCIMF: 0 from astern, 90 from starboard, 180 from ahead; over port it is the mirror image.
    let (angle, side) =
        if bearing <= 180.0 { (180.0 - bearing, 1.0) } else { (bearing - 180.0, -1.0) };
    let [x, y, n] = by_hand(table, angle);
    // To port and with the bow to port are negative here.
    Force {
        surge_n: pressure * x * areas[0],
        sway_n: -side * pressure * y * areas[1],
        yaw_nm: -side * pressure * n * areas[1] * length,
    }
}

#[track_caller]
fn close(found: Force, expected: Force, relative: f64) {
    let size = expected.surge_n.hypot(expected.sway_n);
    let off = [
        (found.surge_n - expected.surge_n) / size,
        (found.sway_n - expected.sway_n) / size,
        (found.yaw_nm - expected.yaw_nm) / (size * 329.3),
    ];
    assert!(off.iter().all(|off| off.abs() < relative), "{found:?}\n{expected:?}");
}

#[test]
fn wind_forces_at_twelve_angles_are_those_of_a_hand_calculation() {
    let table = rows("own_wind.csv");
    for bearing in BEARINGS {
        let from = format!("environment.wind.from=\"{bearing} deg\"");
        let [wind, _] = first_forces(&["environment.wind.speed=\"30 kn\"", &from]);
        let pressure = 0.5 * 1.28 * (30.0 * KNOT).powi(2);
        close(wind, expected(&table, bearing, pressure, [1130.0, 3225.0], 329.3), 1e-9);
    }
}

#[test]
fn current_forces_at_twelve_angles_and_two_depths_are_those_of_a_hand_calculation() {
    let table = rows("own_current.csv");
    let at = |ratio: f64| -> Vec<Vec<f64>> {
        table.iter().filter(|row| row[0] == ratio).map(|row| row[1..].to_vec()).collect()
    };
    let (shallow, middle) = (at(1.1), at(1.5));
    for bearing in BEARINGS {
        let towards = format!("environment.current.towards=\"{} deg\"", (bearing + 180.0) % 360.0);
        let pressure = 0.5 * 1025.0 * (2.0 * KNOT).powi(2);
        let area = 329.3 * 19.2;
        let of = |table: &[Vec<f64>]| expected(table, bearing, pressure, [area, area], 329.3);
        let speed = "environment.current.speed=\"2 kn\"";
        let [_, hull] = first_forces(&[speed, &towards]);
        close(hull, of(&shallow), 1e-9);
        // Half of the way between the two depths.
        let [_, hull] = first_forces(&[speed, &towards, "environment.depth=\"24.96 m\""]);
        close(hull, (of(&shallow) + of(&middle)) * 0.5, 1e-9);
    }
}

#[test]
fn a_current_table_hands_over_to_the_manoeuvring_model_without_a_jump() {
    let hull = |surge: f64, table: bool| {
        let velocity = format!(
            "body.ship.velocity={{ surge = {surge}, sway = {}, yaw = 0.002 }}",
            0.1 * surge
        );
        let mut sets = vec!["environment.current.speed=0", velocity.as_str()];
        if !table {
            sets.push("vessel.tanker.current_coefficients.alone_until=0");
            sets.push("vessel.tanker.current_coefficients.gone_from=0.1");
        }
        first_forces(&sets)[1]
    };
    let size = |force: Force| force.surge_n.abs() + force.sway_n.abs() + force.yaw_nm.abs() / 300.0;
    let (below, above) = (hull(2.4, true), hull(4.3, true));
    assert_eq!(above, hull(4.3, false), "beyond 8 kn the model acts alone");
    assert!(size(below + hull(2.4, false) * -1.0) > 0.2 * size(below), "below 5 kn the table acts");
    // A step of half the size makes half the difference: there is no jump.
    for at in [2.5, 2.56, 2.58, 3.3, 4.08, 4.12] {
        let step = |width: f64| size(hull(at + width, true) + hull(at, true) * -1.0);
        let (whole, half) = (step(0.02), step(0.01));
        assert!(half < 0.6 * whole + 1e-6, "{at}: {half} {whole}");
    }
}

#[test]
fn a_table_of_both_sides_and_of_other_signs_gives_the_same_forces() {
    // The same table in the ship's own convention over both sides, in radians, with semicolons and decimal commas.
    let mut text = "Wind tunnel, run 7;;;\nWinkel;CX;CY;CN\n".to_owned();
    for row in rows("own_wind.csv") {
        let [angle, x, y, n] = row[..] else { panic!("four columns") };
        let bearing = 180.0 - angle;
        let line = |bearing: f64, side: f64| {
            let cells = [bearing.to_radians(), x, -side * y, -side * n];
            cells.map(|cell| format!("{cell}").replace('.', ",")).join(";") + "\n"
        };
        text += &line(bearing, 1.0);
        if bearing > 0.0 && bearing < 180.0 {
            text += &line(-bearing, -1.0);
        }
    }
    let table = "vessel.tanker.wind_coefficients";
    let sets = [
        format!("{table}.convention=\"ship\""),
        format!("{table}.columns=[\"angle_rad\", \"cx\", \"cy\", \"cn\"]"),
        format!("{table}.skip_lines=2"),
        "environment.wind.from=\"37 deg\"".to_owned(),
    ];
    let sets: Vec<&str> = sets.iter().map(String::as_str).collect();
    let scenario = read(EXAMPLE, &sets, &[("own_wind.csv", &text)]).unwrap();
    let ours = read(EXAMPLE, &sets[3..], &[]).unwrap();
    let of = |scenario: Scenario| {
        Simulation::new(scenario.setup).unwrap().step().unwrap().vessel_forces[0].wind
    };
    close(of(scenario), of(ours), 1e-12);
}

#[test]
fn forces_at_the_perpendiculars_and_forces_at_a_speed_give_the_same() {
    let mut at_perpendiculars = "angle_deg,cx,cyf,cya\n".to_owned();
    let mut forces = "angle_deg x_kn y_kn n_knm\n".to_owned();
    let pressure_kpa = 0.5 * 1.28 * 25.0 * 25.0 / 1e3;
    for row in rows("own_wind.csv") {
        let [angle, x, y, n] = row[..] else { panic!("four columns") };
        // Y = F + A, N = (F − A) L/2.
        at_perpendiculars += &format!("{angle},{x},{},{}\n", 0.5 * y + n, 0.5 * y - n);
        let [side, moment] = [y * 3225.0, n * 3225.0 * 329.3].map(|value| value * pressure_kpa);
        forces += &format!("{angle}   {} {side}\t{moment}\n", x * 1130.0 * pressure_kpa)
            .replace('\t', " ");
    }
    let table = "vessel.tanker.wind_coefficients";
    let at = [
        format!("{table}.quantity=\"forces\""),
        format!("{table}.at_speed=\"25 m/s\""),
        format!("{table}.at_density=\"1.28 kg/m^3\""),
    ];
    let at: Vec<&str> = at.iter().map(String::as_str).collect();
    let of = |sets: &[&str], text: &str| {
        let scenario =
            read(EXAMPLE, sets, &[("own_wind.csv", text)]).unwrap_or_else(|e| panic!("{e}"));
        Simulation::new(scenario.setup).unwrap().step().unwrap().vessel_forces[0].wind
    };
    let ours = of(&[], &file("own_wind.csv").unwrap());
    close(of(&[], &at_perpendiculars), ours, 1e-12);
    close(of(&at, &forces), ours, 1e-12);
}

#[track_caller]
fn refused(sets: &[&str], files: &[(&str, &str)], fragments: &[&str]) {
    let shown = match read(EXAMPLE, sets, files) {
        Ok(_) => panic!("accepted, not {fragments:?}"),
        Err(error) => error.to_string(),
    };
    for fragment in fragments {
        assert!(shown.contains(fragment), "{fragment}: {shown}");
    }
}

/// The wind table with one text in place of another.
#[track_caller]
fn wind_with(from: &str, to: &str) -> String {
    let text = file("own_wind.csv").unwrap();
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1)
}

#[test]
fn each_mistake_in_a_table_is_told_with_its_row_and_column() {
    let rest = "\n180,-0.930,0.000,0.000";
    for (text, fragments) in [
        (
            wind_with("90,-0.060,0.640,0.055\n", "90,-0.060,,0.055\n"),
            ["own_wind.csv:10:11", "`cy` is empty here"],
        ),
        (wind_with("90,-0.060", "90,-0.06O"), ["own_wind.csv:10:4", "\"-0.06O\""]),
        (
            wind_with(rest, ""),
            ["own_wind.csv:15:1", "do not cover a side: they reach from 0 to 165"],
        ),
        (
            wind_with(rest, "\n180,-0.930,0.000,0.000\n360,0.7,0,0"),
            ["own_wind.csv:17:1", "a second row for one angle"],
        ),
        (wind_with("75,0.049", "60,0.049"), ["own_wind.csv:9:1", "a second row for one angle: 60"]),
        (wind_with("105,", "1050,"), ["own_wind.csv:11:1", "between -720 and 720"]),
        (wind_with("cx,cy,cxy", "cx,cyy,cxy"), ["own_wind.csv:3:14", "did you mean `cy`?"]),
        (wind_with("cx,cy,cxy", "cx,cy,cya"), ["own_wind.csv:3:1", "moment twice"]),
        (wind_with("cy,cxy", "cy,cy"), ["own_wind.csv:3:17", "`cy` is given twice"]),
        (
            wind_with("90,-0.060,0.640", "90,-0.060,64.0"),
            ["own_wind.csv:10:11", "between -20 and 20"],
        ),
    ] {
        refused(&[], &[("own_wind.csv", &text)], &fragments);
    }
    let radians: String = rows("own_wind.csv")
        .iter()
        .map(|row| format!("{},{},{},{}\n", row[0].to_radians(), row[1], row[2], row[3]))
        .collect();
    let radians = format!("angle_deg,cx,cy,cn\n{radians}");
    refused(
        &[],
        &[("own_wind.csv", &radians)],
        &["own_wind.csv:14:1", "this column are radians", "`angle_rad`"],
    );
    let degrees = wind_with("angle_deg", "angle_rad");
    refused(&[], &[("own_wind.csv", &degrees)], &["are degrees", "`angle_deg`"]);
    let few = "angle_deg,cx,cy,cn\n0,0.8,0,0\n90,0,0.7,0\n180,-0.9,0,0\n";
    refused(
        &[],
        &[("own_wind.csv", few)],
        &["own_wind.csv:3:1", "no row between 90 and 180, which are 90 degrees apart"],
    );
    let turned = wind_with("0,0.810,0.000,", "0,0.810,0.300,");
    refused(&[], &[("own_wind.csv", &turned)], &["own_wind.csv:4:1", "has 47 % of its largest"]);
}

#[test]
fn another_convention_is_caught_by_its_signs() {
    let own = |zero: &str, side: &str, surge: &str, sway: &str| {
        let table = "vessel.tanker.wind_coefficients";
        vec![
            format!("{table}.convention=\"own\""),
            format!("{table}.angle_zero=\"{zero}\""),
            format!("{table}.angle_side=\"{side}\""),
            format!("{table}.surge_positive=\"{surge}\""),
            format!("{table}.sway_positive=\"{sway}\""),
            format!("{table}.yaw_positive=\"bow_to_port\""),
        ]
    };
    for (sets, fragments) in [
        (own("ahead", "from_starboard", "forward", "to_port"), ["surge force", "from ahead"]),
        (own("astern", "from_port", "forward", "to_port"), ["side force at 90", "from port"]),
        (own("astern", "from_starboard", "aft", "to_port"), ["surge force", "against the flow"]),
        (
            own("astern", "from_starboard", "forward", "to_starboard"),
            ["side force at 90", "own_wind.csv:10:1"],
        ),
    ] {
        let sets: Vec<&str> = sets.iter().map(String::as_str).collect();
        refused(&sets, &[], &fragments);
    }
    let right = own("astern", "from_starboard", "forward", "to_port");
    let right: Vec<&str> = right.iter().map(String::as_str).collect();
    assert!(read(EXAMPLE, &right, &[]).is_ok());
}

#[test]
fn what_is_odd_about_a_table_is_told() {
    let notices = |files: &[(&str, &str)], sets: &[&str]| -> String {
        let scenario = read(EXAMPLE, sets, files).unwrap_or_else(|error| panic!("{error}"));
        scenario.notices.iter().map(|notice| format!("{notice}\n")).collect()
    };
    let plain = notices(&[], &[]);
    assert!(plain.contains("own_wind.csv:3:1") && plain.contains("mirror image"), "{plain}");
    let gap = wind_with("120,-0.315,0.589,0.087\n", "");
    let told = notices(&[("own_wind.csv", &gap)], &[]);
    assert!(told.contains("own_wind.csv:11:1") && told.contains("a gap of 30 degrees"), "{told}");
    let small = wind_with("0,0.810,0.000,", "0,0.810,0.010,");
    let told = notices(&[("own_wind.csv", &small)], &[]);
    assert!(told.contains("takes it as zero"), "{told}");
    let told = notices(&[], &["environment.depth=\"20 m\""]);
    assert!(told.contains("down to 1.042 draughts deep, but the table begins at 1.1"), "{told}");
    // A current that turns the bow into itself.
    let turned: String = rows("own_current.csv")
        .iter()
        .map(|row| format!("{},{},{},{},{}\n", row[0], row[1], row[2], row[3], -row[4]))
        .collect();
    let turned = format!("depth_ratio,angle_deg,cx,cy,cn\n{turned}");
    let told = notices(&[("own_current.csv", &turned)], &[]);
    assert!(told.contains("turns the bow into the current"), "{told}");
}

/// Tensions of the six lines at the end of the run (kN).
fn six(sets: &[&str]) -> Vec<f64> {
    let scenario =
        read("six_lines_exercise.toml", sets, &[]).unwrap_or_else(|error| panic!("{error}"));
    let mut simulation = Simulation::new(scenario.setup).unwrap();
    while !simulation.is_done() {
        simulation.step().unwrap();
    }
    simulation.lines().iter().take(6).map(|line| line.load.tension_n / 1e3).collect()
}

/// The tensions of the exercise's solution, by `validation/independent/six_lines.py`.
#[test]
fn a_published_exercise_of_six_lines_has_its_line_loads() {
    let published = [156.7093, 106.2468, 120.2389, 107.0505, 71.4881, 98.1129];
    for (found, expected) in six(&[]).iter().zip(published) {
        println!("{found:.4} kN for {expected} kN: {:+.3} %", 100.0 * (found / expected - 1.0));
        assert!((found / expected - 1.0).abs() < 5e-3, "{found} kN for {expected}");
    }
}

/// The lines of the exercise as they are, without its linear approximations, by the same script.
#[test]
fn the_lines_of_the_exercise_as_they_are_have_the_loads_of_an_independent_solution() {
    let exact = [185.2500, 75.3911, 99.6505, 86.3291, 51.0420, 124.6487];
    // Where the chocks and bollards of the exercise are, from midship.
    let places = [
        (-50, -4.0, -50),
        (-42, -5.0, -35),
        (-10, -5.5, -5),
        (17, -5.5, 12),
        (49, -5.0, 42),
        (57, -4.0, 57),
    ];
    let mut as_they_are = Vec::new();
    for (line, (along, across, bollard)) in places.into_iter().enumerate() {
        let line = format!("line.{}", line + 1);
        let at = |along: i32| f64::from(along) - 3.5;
        as_they_are.push(format!("{line}.axial_stiffness=\"11.25 MN\""));
        as_they_are.push(format!("{line}.fairlead=[{}, {across}]", at(along)));
        as_they_are.push(format!("{line}.bollard=[{}, -10]", at(bollard)));
    }
    let mut sets: Vec<&str> = as_they_are.iter().map(String::as_str).collect();
    sets.push("time.duration=\"150 s\"");
    for (found, expected) in six(&sets).iter().zip(exact) {
        println!("{found:.4} kN for {expected} kN: {:+.3} %", 100.0 * (found / expected - 1.0));
        assert!((found / expected - 1.0).abs() < 5e-3, "{found} kN for {expected}");
    }
}

#[test]
fn a_rope_of_ones_own_needs_one_curve_that_rises() {
    let line = "line.\"head 1\"";
    for (text, fragments) in [
        (
            "extension_percent,load_percent\n0,0\n2,30\n4,25\n",
            ["own_rope.csv:4:3", "falls or stays the same in this row, at 25"],
        ),
        (
            "extension_percent,load_percent\n0,0\n2,30\n2,35\n",
            ["own_rope.csv:4:1", "extension must rise"],
        ),
        (
            "extension_percent,load_percent\n1,5\n2,30\n",
            ["own_rope.csv:2:1", "first row of the curve must be 0, 0"],
        ),
        ("extension_percent,load\n0,0\n", ["own_rope.csv:1:19", "\"load\" is not a column"]),
        (
            "extension_percent,load_kn,load_percent\n0,0,0\n1,1,1\n",
            ["own_rope.csv:1:1", "same quantity"],
        ),
        ("extension_percent,load_kn\n0,0\n", ["own_rope.csv:1:1", "two rows or more"]),
    ] {
        refused(&[], &[("own_rope.csv", text)], &fragments);
    }
    let short = "extension_percent,load_kn\n0,0\n5,600\n";
    let scenario = read(EXAMPLE, &[], &[("own_rope.csv", short)]).unwrap();
    let told = scenario
        .notices
        .iter()
        .any(|notice| notice.message.contains("ends at 50 % of the break load"));
    assert!(told, "{:?}", scenario.notices);
    refused(
        &[&format!("{line}.axial_stiffness=\"20 MN\"")],
        &[],
        &["does not go together with `axial_stiffness`"],
    );
    refused(
        &[&format!("{line}.rope=\"hmpe\"")],
        &[],
        &["does not go together with `rope = \"hmpe\"`"],
    );
    refused(&["factors={ source = \"x\" }"], &[], &["has no factor"]);
}

#[test]
fn partial_factors_are_found_with_their_source() {
    let verdict = |sets: &[&str]| {
        let scenario = read(EXAMPLE, sets, &[]).unwrap();
        let mut simulation = Simulation::new(scenario.setup).unwrap();
        for _ in 0..8 {
            simulation.step().unwrap();
        }
        let setup = simulation.setup().clone();
        let found = simulation.findings();
        let with: Vec<String> = found
            .iter()
            .filter(|finding| matches!(finding, Finding::AboveWithFactor { .. }))
            .map(|finding| finding.sentence(&setup))
            .collect();
        (simulation.verdict(), with)
    };
    let (_, none) = verdict(&[]);
    assert!(none.is_empty(), "{none:?}");
    // A pretension of 80 kN, 13 % of the working load, times 10.
    let (verdict, found) = verdict(&["factors.line_load=10"]);
    assert_eq!(verdict, Verdict::LimitExceeded);
    assert!(
        found[0].contains("of its working load with the partial factor 10 of the example's own"),
        "{found:?}"
    );
}
