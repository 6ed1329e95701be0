//! Recordings that are large, cut off, damaged or absurd.

use crate::damage;
use crate::support;

use std::time::{Duration, Instant};

use damage::{damaged, forged, objects, sealed};
use fenderline_live::{Ending, RecordingFault, Session, copy_kept};
use support::{command, engine, go, harbour, outline, replay, rudder, saved};

/// Longest time to refuse a damaged recording.
const LONGEST: Duration = Duration::from_secs(10);

/// A number from an environment variable, for longer attacks.
fn parameter(name: &str, default: u64) -> u64 {
    let text = std::env::var(name);
    text.map_or(default, |text| text.parse().unwrap_or_else(|e| panic!("{name}={text}: {e}")))
}

/// A session of some minutes with two branches and commands of several people, and its recording.
fn recorded() -> (Session, String) {
    let mut session = harbour();
    for turn in 0..12 {
        let who = if turn % 3 == 0 { "pilot 2" } else { "master of forward 3" };
        let at_ms = 1_790_000_000_000 + 4000 * turn;
        let angle_rad = 0.05 * turn as f64;
        session.command(who, at_ms, rudder(angle_rad)).expect("a good command");
        go(&mut session, 37);
    }
    session.rewind(123).expect("it is there");
    session.branch().expect("a branch");
    command(&mut session, engine(-0.3));
    go(&mut session, 95);
    let text = saved(&mut session);
    (session, text)
}

/// The fault of a recording that is refused before its replay.
fn fault(text: &[u8]) -> (usize, RecordingFault) {
    let error = fenderline_live::Outline::read(text, |_| Ok(())).expect_err("it is refused");
    (error.line, error.fault)
}

#[test]
fn an_ended_recording_is_complete_and_replays_to_the_same_bits() {
    let (session, text) = recorded();
    let outline = outline(&text).expect("sound");
    assert_eq!(outline.ending, Ending::Whole);
    assert_eq!((outline.branches, outline.commands), (2, 13));
    assert_eq!(outline.ticks, 12 * 37 + 95);
    let end = session.end_line().len();
    assert_eq!(outline.kept_bytes as usize, text.len() - end);
    assert_eq!(session.recorded_bytes() as usize, text.len() - end);
    let again = replay(&text).expect("the same bits");
    assert_eq!(again.session.bits(), session.bits());
    assert!(again.same > 50, "{}", again.same);
}

#[test]
fn a_torn_last_line_is_reported_and_dropped_and_the_session_continues() {
    let (_, text) = recorded();
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let all = lines.len();
    // The recording is cut off within the last line, and within the line before it.
    for (torn, part) in [(all - 1, 1), (all - 1, 30), (all - 2, 1), (all - 2, 50)] {
        let kept: String = lines[..torn].concat();
        for part in [part, lines[torn].len() - 1] {
            let cut = kept.clone() + &lines[torn][..part];
            let outline_of_cut = outline(&cut).expect("its whole lines are sound");
            assert_eq!(outline_of_cut.ending, Ending::Torn { bytes: part as u64 });
            assert_eq!(outline_of_cut.kept_bytes as usize, kept.len());
            // The kept lines and the new lines form one recording.
            let mut again = replay(&cut).expect("the same bits").session;
            go(&mut again, 25);
            let mut more = Vec::new();
            copy_kept(cut.as_bytes(), &outline_of_cut, &mut more).expect("copied");
            assert_eq!(more, kept.as_bytes());
            let more = kept.clone() + &saved(&mut again);
            assert_eq!(outline(&more).expect("sound").ending, Ending::Whole);
            assert_eq!(replay(&more).expect("the same bits").session.bits(), again.bits());
        }
    }
    // The first line must be complete.
    assert_eq!(fault(&text.as_bytes()[..50]), (1, RecordingFault::NoFirstLine));
}

#[test]
fn a_file_of_another_type_or_format_is_refused_with_the_reason() {
    let (_, text) = recorded();
    let first = text.lines().next().expect("a first line");
    let png = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR";
    for other in
        [&b""[..], b"\n", b"title = \"a scenario\"\n", b"{\"fenderline_links\":1}\n", b"\0\0\n"]
    {
        assert_eq!(fault(other), (1, RecordingFault::NoRecording), "{other:?}");
    }
    // This file is not text at all.
    assert_eq!(fault(png), (1, RecordingFault::Damaged));
    for number in ["2", "4", "31", "99999999999999"] {
        let other = text.replacen(
            "{\"fenderline_session\":3",
            &format!("{{\"fenderline_session\":{number}"),
            1,
        );
        let shown = &number[..number.len().min(10)];
        assert_eq!(fault(other.as_bytes()), (1, RecordingFault::Format(shown.to_owned())));
    }
    // A recording by another version of the program is read, because only its bits may differ. The bits are compared.
    let mut header = objects(first).remove(0);
    let version = format!("\"version\":\"{}\"", env!("CARGO_PKG_VERSION"));
    assert!(header.contains(&version), "{header:.200}");
    header = header.replacen(&version, "\"version\":\"0.0.7\"", 1);
    let other = sealed([header.as_str()]);
    let reader = fenderline_live::RecordingReader::open(other.as_bytes()).expect("it is sound");
    assert_eq!(reader.version(), "0.0.7");
}

#[test]
fn a_recording_without_its_last_lines_is_not_reported_as_complete() {
    let (_, text) = recorded();
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    for count in 1..lines.len() {
        let cut: String = lines[..count].concat();
        assert_eq!(outline(&cut).expect("its lines are sound").ending, Ending::Open);
    }
}

#[test]
fn a_flipped_bit_in_a_title_a_name_or_a_time_is_detected() {
    let (_, text) = recorded();
    for place in ["title = ", "\"who\":\"pilot", "\"at_ms\":17", "\"version\":\"", "\"file\":"] {
        let start = text.find(place).unwrap_or_else(|| panic!("{place} in {text}"));
        for at in start..start + place.len() {
            for bit in 0..8 {
                let mut bytes = text.clone().into_bytes();
                bytes[at] ^= 1 << bit;
                let (_, fault) = fault(&bytes);
                assert_eq!(fault, RecordingFault::Damaged, "{place}: byte {at} bit {bit}");
            }
        }
    }
}

/// `cargo test -p fenderline-live --test all recordings::damaged`. `FENDERLINE_DAMAGED=100000` makes more recordings,
/// and `FENDERLINE_SEED=7` makes other recordings.
#[test]
fn a_thousand_damaged_recordings_are_all_detected() {
    let (_, text) = recorded();
    let sound = text.as_bytes();
    let (count, first) = (parameter("FENDERLINE_DAMAGED", 1000), parameter("FENDERLINE_SEED", 1));
    let (mut refused, mut cut, mut slowest) = (0, 0, Duration::ZERO);
    for seed in first..first + count {
        let (what, bytes) = damaged(sound, seed);
        let start = Instant::now();
        let told = fenderline_live::Outline::read(bytes.as_slice(), |_| Ok(()));
        slowest = slowest.max(start.elapsed());
        match told {
            Err(_) => refused += 1,
            Ok(outline) => {
                assert_ne!(outline.ending, Ending::Whole, "seed {seed}, {what}: called sound");
                let kept = outline.kept_bytes as usize;
                assert_eq!(bytes[..kept], sound[..kept], "seed {seed}, {what}: other lines");
                cut += 1;
            }
        }
    }
    println!("{count} damaged from seed {first}: {refused} refused, {cut} told as cut off or torn");
    println!("the slowest took {slowest:?}");
    assert!(slowest < LONGEST, "{slowest:?}");
}

/// `FENDERLINE_FORGED=10000` makes more recordings.
#[test]
fn recordings_with_absurd_numbers_and_correct_check_sums_are_refused_or_replayed_in_time() {
    let (_, text) = recorded();
    let (count, first) = (parameter("FENDERLINE_FORGED", 60), parameter("FENDERLINE_SEED", 1));
    let (mut refused, mut slowest) = (0, Duration::ZERO);
    for seed in first..first + count {
        let forged = forged(&text, seed);
        let start = Instant::now();
        refused += u64::from(replay(&forged).is_err());
        slowest = slowest.max(start.elapsed());
    }
    println!("{count} forged from seed {first}: {refused} refused; the slowest took {slowest:?}");
    assert!(slowest < LONGEST, "{slowest:?}");
}

/// A recording whose first line is followed by these lines.
fn with_lines(lines: &[&str]) -> String {
    let header = objects(&harbour().take_lines()).remove(0);
    sealed([header.as_str()].into_iter().chain(lines.iter().copied()))
}

fn refused(lines: &[&str]) -> (usize, String) {
    match fault(with_lines(lines).as_bytes()) {
        (line, RecordingFault::Invalid(why)) => (line, why),
        (line, other) => panic!("line {line}: {other}"),
    }
}

#[test]
fn a_reached_line_at_a_far_tick_is_refused_before_the_replay() {
    let reached =
        r#"{"line":"reached","branch":0,"tick":1000000000000000000,"bits":"0000000000000000"}"#;
    let (line, why) = refused(&[reached]);
    assert!(line == 2 && why.contains("from tick 0 to 1000000000000000000"), "{why}");
    let command = r#"{"line":"command","branch":0,"tick":11,"who":"","at_ms":0,"action":{"do":"hands","vessel":"ship"}}"#;
    let (line, why) = refused(&[command]);
    assert!(line == 2 && why.contains("from tick 0 to 11"), "{why}");
    let last = u64::MAX;
    let far =
        format!("{{\"line\":\"reached\",\"branch\":0,\"tick\":{last},\"bits\":\"{:016x}\"}}", 0);
    assert_eq!(refused(&[&far]).0, 2);
}

#[test]
fn branches_from_far_ticks_and_too_many_branches_are_refused_before_the_replay() {
    let far = r#"{"line":"branch","id":1,"parent":0,"from_tick":1000000000000000000}"#;
    assert!(refused(&[far]).1.contains("ends at tick 0"));
    let command = r#"{"line":"command","branch":0,"tick":1,"who":"","at_ms":0,"action":{"do":"hands","vessel":"ship"}}"#;
    let branches: Vec<String> = (1..=200_000)
        .map(|id| format!("{{\"line\":\"branch\",\"id\":{id},\"parent\":0,\"from_tick\":0}}"))
        .collect();
    let lines: Vec<&str> =
        [command].into_iter().chain(branches.iter().map(String::as_str)).collect();
    let start = Instant::now();
    let (line, why) = refused(&lines);
    assert!(line == 1002 && why.contains("more than 1000 branches"), "line {line}: {why}");
    assert!(start.elapsed() < LONGEST);
    // The same for branches without a parent or with a wrong number.
    for bad in [
        r#"{"line":"branch","id":2,"parent":0,"from_tick":0}"#,
        r#"{"line":"branch","id":1,"parent":1,"from_tick":0}"#,
        r#"{"line":"branch","id":1,"parent":0,"from_tick":1}"#,
        r#"{"line":"reached","branch":1,"tick":1,"bits":"0000000000000000"}"#,
        r#"{"line":"reached","branch":0,"tick":0,"bits":"0000000000000000"}"#,
        r#"{"line":"reached","branch":0,"tick":1,"bits":"x"}"#,
        r#"{"line":"reached","branch":0,"tick":-1,"bits":"0000000000000000"}"#,
        r#"{"line":"fly"}"#,
    ] {
        assert_eq!(refused(&[command, bad]).0, 3, "{bad}");
    }
}

#[test]
fn a_forged_recording_is_refused_at_the_forged_line() {
    let (_, text) = recorded();
    let forge = |from: &str, to: &str| {
        let objects: Vec<String> =
            objects(&text).iter().map(|object| object.replace(from, to)).collect();
        replay(&sealed(objects.iter().map(String::as_str)))
    };
    let why = forge("\"angle_rad\":0.25", "\"angle_rad\":0.35").expect_err("other bits");
    assert!(why.contains("but the recording has"), "{why}");
    let why = forge("\"vessel\":\"ship\"", "\"vessel\":\"shop\"").expect_err("no such ship");
    assert!(why.contains("line 2: there is no vessel `shop`"), "{why}");
    let why = forge("\"angle_rad\":", "\"angle\":").expect_err("no such field");
    assert!(why.contains("line 2: the line is invalid"), "{why}");
    let why = forge("\"fenderline_session\":3", "\"fenderline_session\":2").expect_err("old");
    assert!(why.contains("format 2, but this program reads format 3"), "{why}");
    let more = text.clone() + "{}";
    assert_eq!(fault(more.as_bytes()).1, RecordingFault::AfterEnd);
    let long = text.lines().next().expect("a line").to_owned() + "\n" + &"x".repeat(100_000);
    assert_eq!(fault(long.as_bytes()), (2, RecordingFault::TooLong(65_536)));
}

#[test]
fn four_users_for_fifteen_minutes_are_recorded_and_replayed() {
    let mut session = harbour();
    let mut text = String::new();
    // Each person gives thirty commands a second, as the server permits.
    for tick in 0..9000_u32 {
        for hand in 0..12 {
            let share = f64::from((tick * 12 + hand) % 1999) / 1999.0;
            let action =
                fenderline_live::NamedOrder::new(fenderline_sim::OrderName::Thruster, "ship")
                    .name("name", "bow")
                    .number("power", 0.7 * share)
                    .into();
            let who = format!("master of forward {hand}");
            session.command(&who, 1_790_000_000_000, action).expect("a good command");
        }
        go(&mut session, 1);
        text += &session.take_lines();
    }
    text += &saved(&mut session);
    assert!(text.len() > 16 << 20, "{} bytes", text.len());
    let again = replay(&text).expect("the same bits");
    assert_eq!(again.session.bits(), session.bits());
    assert_eq!(outline(&text).expect("sound").commands, 108_000);
}

#[test]
fn changes_between_branches_are_not_repeated_in_a_replay() {
    let mut session = harbour();
    go(&mut session, 400);
    session.rewind(100).expect("it is there");
    session.branch().expect("a branch");
    go(&mut session, 300);
    for _ in 0..40 {
        session.go_to_branch(0).expect("it is there");
        session.go_to_branch(1).expect("it is there");
    }
    let text = saved(&mut session);
    let again = replay(&text).expect("the same bits");
    assert_eq!(again.session.bits(), session.bits());
    assert_eq!((again.session.current_branch(), again.session.tick()), (1, 400));
    assert!(again.same > 100, "each mark was held against the state: {}", again.same);
}
