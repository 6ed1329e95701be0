//! Bad input is named with file and line, and other berthings are kept.

use fenderline_measured::{Berthings, Flag, Lie, Mapping, Motion, Weight};

use crate::support::{
    Approach, Laser, Random, SENSORS, START_S, berth, docking_log, found, run, time_of, track_log,
};

const QUIET: Laser = Laser { noise_m: 0.005, lost: 0.0, outliers: 0.0, pause_s: 0.0 };

/// The run of a ship that comes with 12 cm/s from 10 m off.
fn approach_of(angle_rad: f64, turn_radps: f64) -> Approach {
    let lie = Lie { along_m: 0.0, off_m: 26.0, angle_rad };
    let nearest = berth().axes.nearest(&lie).expect("abreast");
    let lie = Lie { off_m: lie.off_m + 10.0 - nearest.gap_m, ..lie };
    run(&Motion { lie, rates: [0.0, -0.12, turn_radps] })
}

/// An approach 1.5° bow in.
fn approach() -> Approach {
    approach_of(0.026, 0.0)
}

fn log() -> (Approach, String) {
    let approach = approach();
    let text = docking_log(&approach, QUIET, &mut Random::new(7));
    (approach, text)
}

/// The rows of a log with the cells changed, without the head.
fn changed(text: &str, change: impl Fn(usize, Vec<String>) -> Vec<String>) -> String {
    let row = |(index, line): (usize, &str)| {
        change(index, line.split(',').map(str::to_owned).collect()).join(",") + "\n"
    };
    text.lines().skip(1).enumerate().map(row).collect()
}

fn head(text: &str) -> String {
    text.lines().next().expect("a head").to_owned() + "\n"
}

/// A day later.
fn later(text: &str, days: u32) -> String {
    changed(text, |_, mut cells| {
        cells[0] = cells[0].replace("2025-06-01", &format!("2025-06-{:02}", 1 + days));
        cells
    })
}

fn refused(found: &Berthings) -> Vec<String> {
    let refused = found.remarks.iter().filter(|remark| remark.weight == Weight::Refused);
    refused.map(ToString::to_string).collect()
}

fn one_refused(found: &Berthings, kept: usize, words: &str) {
    let refused = refused(found);
    assert_eq!(found.all.len(), kept, "{:?}", found.remarks);
    assert_eq!(refused.len(), 1, "{refused:?}");
    assert!(refused[0].contains(words), "{refused:?}");
    assert!(refused[0].starts_with("log.csv:"), "{refused:?}");
}

#[test]
fn swapped_sensors_are_refused_by_their_speeds_and_other_berthings_are_kept() {
    // She turns, so that the speeds of bow and stern differ.
    let text = docking_log(&approach_of(-0.01, 4e-4), QUIET, &mut Random::new(8));
    let swapped = changed(&text, |_, mut cells| {
        cells.swap(1, 2);
        cells
    });
    let both = text.clone() + &later(&(head(&text) + &swapped), 1);
    let line = text.lines().count() + 1;
    let found = found(&[("log.csv", &both)], SENSORS);
    one_refused(
        &found,
        1,
        &format!("log.csv:{line}: a berthing is left out: the sensors are swapped"),
    );
}

#[test]
fn swapped_sensors_are_refused_by_the_angle_that_the_mapping_states() {
    let (_, text) = log();
    let with_angle =
        "Time,Stern distance (m),Bow distance (m),Bow speed (cm/s),Stern speed (cm/s),Angle (deg)\n"
            .to_owned() + &changed(&text, |_, mut cells| {
            cells.push("1.5".to_owned());
            cells
        });
    let stated = format!("{SENSORS}angle_positive = \"bow in\"\n");
    let refused = found(&[("log.csv", &with_angle)], &stated);
    one_refused(&refused, 0, "the sensors are swapped");
    let flagged = found(&[("log.csv", &with_angle)], SENSORS);
    assert!(flagged.all[0].flags.contains(&Flag::AngleOpposite));
}

#[test]
fn feet_for_metres_are_refused() {
    let (_, text) = log();
    let feet = head(&text)
        + &changed(&text, |_, mut cells| {
            for cell in &mut cells[1..3] {
                *cell = format!("{:.2}", cell.parse::<f64>().expect("a number") / 0.3048);
            }
            cells
        });
    let both = feet.clone() + &later(&text, 1);
    one_refused(&found(&[("log.csv", &both)], SENSORS), 1, "3.28 times");
    // With the unit in the head, all is well.
    let good = feet.replace("distance (m)", "distance (ft)");
    let found = found(&[("log.csv", &good)], SENSORS);
    assert_eq!((found.all.len(), refused(&found).len()), (1, 0), "{:?}", found.remarks);
}

#[test]
fn days_out_of_order_are_told_and_read() {
    let (_, text) = log();
    let both = head(&text) + &later(&text, 4) + &later(&text, 1);
    let found = found(&[("log.csv", &both)], SENSORS);
    assert_eq!(found.all.len(), 2);
    assert!(found.all[0].touch.t_s < found.all[1].touch.t_s);
    let line = text.lines().count() + 1;
    let told = found.remarks.iter().find(|remark| remark.text.contains("out of order"));
    assert_eq!(told.expect("told").line, Some(line));
}

#[test]
fn two_ships_at_once_are_refused() {
    let (_, text) = log();
    let other = changed(&text, |_, mut cells| {
        for cell in &mut cells[1..3] {
            *cell = format!("{:.2}", cell.parse::<f64>().expect("a number") + 20.0);
        }
        cells
    });
    let rows: Vec<&str> = text.lines().skip(1).collect();
    let others: Vec<&str> = other.lines().collect();
    let mixed: String = rows.iter().zip(&others).map(|(a, b)| format!("{a}\n{b}\n")).collect();
    let without_names = head(&text) + &mixed + &later(&text, 1);
    one_refused(&found(&[("log.csv", &without_names)], SENSORS), 1, "log.csv:3: two ships at once");
    let named: String = rows
        .iter()
        .enumerate()
        .map(|(index, row)| format!("{row},{}\n", if index % 40 < 20 { "Ada" } else { "Bea" }))
        .collect();
    let named = head(&text).trim_end().to_owned() + ",Ship\n" + &named;
    one_refused(
        &found(&[("log.csv", &named)], SENSORS),
        0,
        "two ships at once: the rows of Ada and Bea",
    );
}

#[test]
fn logs_of_another_berth_are_refused() {
    let (approach, text) = log();
    // The readings begin 3 m behind the fenders, which the mapping does not say.
    let far = head(&text)
        + &changed(&text, |_, mut cells| {
            for cell in &mut cells[1..3] {
                *cell = format!("{:.2}", cell.parse::<f64>().expect("a number") + 3.0);
            }
            cells
        });
    one_refused(
        &found(&[("log.csv", &far)], SENSORS),
        0,
        "no touch: the hull comes no nearer than",
    );
    let track = track_log(&approach, 0.01, &mut Random::new(3)).replace(",51.9", ",52.1");
    one_refused(&found(&[("log.csv", &track)], ""), 0, "the track is of another berth");
    let named = head(&text).trim_end().to_owned() + ",Berth\n";
    let two = named
        + &changed(&text, |index, mut cells| {
            cells.push(if index % 2 == 0 { "4" } else { "5" }.to_owned());
            cells
        });
    one_refused(&found(&[("log.csv", &two)], SENSORS), 0, "the log has rows of the berths 4, 5");
    let chosen = found(&[("log.csv", &two)], &format!("{SENSORS}berth = \"4\"\n"));
    assert_eq!(chosen.all.len(), 1, "{:?}", chosen.remarks);
    assert!(
        chosen.remarks.iter().any(|remark| remark.text.contains("rows of another berth than 4"))
    );
}

#[test]
fn a_jump_of_the_clock_is_mended_and_told() {
    let (approach, text) = log();
    let truth = &approach.truth;
    for by_s in [-40.0, 180.0] {
        let jumped = head(&text)
            + &changed(&text, |index, mut cells| {
                if index > 50 {
                    let time = cells[0].split_once(' ').expect("a time").1.to_owned();
                    let parts: Vec<f64> =
                        time.split(':').map(|part| part.parse().expect("a number")).collect();
                    let of_day_s = 3600.0 * parts[0] + 60.0 * parts[1] + parts[2];
                    cells[0] = time_of(START_S - 36_000.0, of_day_s + by_s);
                }
                cells
            });
        let found = found(&[("log.csv", &jumped)], SENSORS);
        assert_eq!(found.all.len(), 1, "{by_s}: {:?}", found.remarks);
        let own = &found.all[0];
        assert!(own.flags.contains(&Flag::ClockJump), "{by_s}: {:?}", own.flags);
        assert!((own.touch.speed_mps.value - truth.speed_mps).abs() < 0.01);
        assert!(found.remarks.iter().any(|remark| remark.text.starts_with("the clock jumps") && remark.line == Some(53)));
    }
}

#[test]
fn a_mapping_with_a_mistake_is_refused_with_file_line_and_key() {
    for (text, line, key, words) in [
        ("time_zone = \"CET\"", 1, "time_zone", "is no time zone"),
        ("kind = \"docking\"\nbow_senor = { place = 1 }", 2, "bow_senor", "did you mean"),
        ("bow_sensor = { place = \"4 kn\" }", 1, "bow_sensor.place", "length"),
        ("bow_sensor = { place = 4 }", 1, "bow_sensor", "needs both"),
        (
            "bow_sensor = { place = 4 }\nstern_sensor = { place = 9 }",
            2,
            "stern_sensor",
            "nearer to the ship's bow",
        ),
        ("[units]\nspeed = \"m\"", 2, "units.speed", "`m` is a length"),
        ("[columns]\nbow = \"A\"", 2, "columns.bow", "is not a key"),
        ("[ships.Ada]\nset = [\"mass\"]", 2, "", ""),
    ] {
        let error = Mapping::parse(text, "mapping.toml").expect_err(text);
        assert_eq!(error.line(), Some(line), "{error}");
        let shown = error.to_string();
        assert!(shown.contains("mapping.toml:"), "{shown}");
        assert!(shown.contains(words), "{shown}");
        assert!(key.is_empty() || error.key() == Some(key), "{shown}");
    }
}

#[test]
fn no_bytes_of_a_log_make_a_panic() {
    let (approach, text) = log();
    let track = track_log(&approach, 0.01, &mut Random::new(3));
    let mut random = Random::new(11);
    for seed in 0..60 {
        let source = if seed % 2 == 0 { &text } else { &track };
        let mut bytes = source.as_bytes()[..source.len() / 8].to_vec();
        for _ in 0..1 + seed {
            let at = (random.share() * bytes.len() as f64) as usize;
            bytes[at] = b"0123456789.,;:-e\n\"#$!*T "[(random.share() * 24.0) as usize];
        }
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let _ = found(&[("log.csv", &text)], SENSORS);
    }
    for text in [
        "",
        "\n\n",
        "Time",
        "Time,Bow distance,Stern distance\n",
        "$GPGGA*",
        "!AIVDM,1,1,,A,,0*26\n",
    ] {
        let found = found(&[("log.csv", text)], SENSORS);
        assert!(found.all.is_empty() && !refused(&found).is_empty(), "{text}: {:?}", found.remarks);
    }
}
