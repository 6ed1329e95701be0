//! Every key of a scenario changes something, or `check` says that it has no effect there.
//!
//! The keys, their kinds and bounds come from the schema. Each key of each table of the cases in `keys/cases`, and each key that such a
//! table may have besides, is set to another legal value, and the case is run again. A key after which nothing changes, and of which
//! nothing is said, is a trap.

#[path = "keys/change.rs"]
mod change;
#[path = "keys/outcome.rs"]
mod outcome;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use change::{Change, changes};
use fenderline_scenario::{Scenario, schema};
use outcome::{Case, Results, json_of};
use serde_json::json;

/// Values of a key that are tried at most, besides those that the reader refuses.
const TRIED: usize = 3;

/// What a change of a key does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Found {
    /// The reader refuses every other value.
    Refused,
    /// A notice says that it has no effect.
    Told,
    /// Summary or tables change, or the run fails.
    Acts,
    /// Nothing but the report changes.
    ReportOnly,
    /// Nothing changes, though the set-up does.
    Nothing,
    /// Not even the set-up changes.
    SameSetup,
}

fn found(case: &Case, base: &(Scenario, Results), change: &Change) -> Found {
    if is_told(&base.0, &change.key()) {
        return Found::Told;
    }
    let (mut worst, mut tried) = (Found::Refused, 0);
    for value in &change.values {
        let document = change.applied(&case.document, value);
        let Some(scenario) = case.read(&document) else { continue };
        if is_told(&scenario, &change.key()) {
            return Found::Told;
        }
        let found = match is_same(&scenario, &base.0) {
            true => Found::SameSetup,
            false => match case.results(&document).map(|results| results.difference(&base.1)) {
                None | Some(Some("summary" | "tables")) => return Found::Acts,
                Some(Some(_)) => Found::ReportOnly,
                Some(None) => Found::Nothing,
            },
        };
        worst = if tried == 0 { found } else { worst.min(found) };
        tried += 1;
        if tried == TRIED {
            break;
        }
    }
    worst
}

fn is_same(one: &Scenario, other: &Scenario) -> bool {
    let plain = |scenario: &Scenario| Scenario { notices: Vec::new(), ..scenario.clone() };
    plain(one) == plain(other)
}

/// Whether a notice about the key, or about a table that holds it, says that it has no effect.
fn is_told(scenario: &Scenario, key: &str) -> bool {
    // The fenders of a row have the path of the row, as errors about them do.
    let of_row = match key.split('.').collect::<Vec<_>>().as_slice() {
        ["fender_row", row, "exception", _, rest @ ..] => {
            format!("fender_row.{row}.{}", rest.join("."))
        }
        _ => key.to_owned(),
    };
    scenario.notices.iter().any(|notice| {
        let is_of_table =
            || key.strip_prefix(&notice.key).is_some_and(|rest| rest.starts_with('.'));
        notice.is_without_effect() && (notice.key == key || notice.key == of_row || is_of_table())
    })
}

/// A TOML file as a case, with the files that lie beside it.
fn case(path: &Path) -> Case {
    let text = fs::read_to_string(path).expect("a file");
    let document = json_of(&text);
    let mut files = BTreeMap::new();
    for entry in fs::read_dir(path.parent().expect("a folder")).expect("a folder") {
        let entry = entry.expect("an entry");
        let name = entry.file_name().to_string_lossy().into_owned();
        if !name.ends_with(".toml") && entry.path().is_file() {
            files.insert(name, fs::read_to_string(entry.path()).expect("a text"));
        }
    }
    // Files of other folders, as the scenario names them.
    let named = text.split('"').filter(|name| name.starts_with("../"));
    for name in named {
        if let Ok(text) = fs::read_to_string(path.with_file_name(name)) {
            files.insert(name.to_owned(), text);
        }
    }
    // Data of the repository under the name that the cases have for it.
    let ship = folder("../../scenarios/berth/container_ship_20m.hydro");
    files.insert("ship.hydro".to_owned(), fs::read_to_string(ship).expect("a text"));
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    Case { name, document, files }
}

fn toml_files(folder: &Path) -> Vec<PathBuf> {
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            all.extend(toml_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "toml") {
            all.push(path);
        }
    }
    all.sort();
    all
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// Keys, or kinds of keys, that may change nothing in a case, and why `check` cannot say so. A `*` at the end stands for any rest.
const MAY_BE_IDLE: &[(&str, &str)] = &[
    ("anchor.*.brake", "it renders above that tension"),
    ("anchor.*.chain_length", "the chain is not veered to its end"),
    ("body.*.added_mass.*", "the paper's method takes the smaller of two"),
    ("body.*.chart_outline", "its shape is not met everywhere"),
    ("body.*.outline*", "a shape is not met everywhere; a vessel alone has it for the plan"),
    ("bollard.*.lines", "fewer lines come to it"),
    ("bollard_row.*.lines", "fewer lines come to them"),
    ("bollard_row.*.number", "more bollards beyond the one that is used"),
    ("chart*", "drawn on pages"),
    ("environment.visibility", "of live pages"),
    ("environment.rain", "of live pages"),
    ("environment.start_time", "of live pages"),
    ("environment.place*", "of live pages"),
    ("vessel.*.conning*", "of live pages"),
    ("vessel.*.kind", "of live pages"),
    ("vessel.*.model", "of live pages"),
    ("event.at", "of a change of the visibility, which is of live pages"),
    ("event.visibility*", "of live pages"),
    ("environment.depth", "without vessels `check` uses it: no fender is under the seabed"),
    ("environment.water_density", "without vessels `check` uses it: masses that fit the outline"),
    ("exercise.view_marks", "of live pages"),
    ("exercise.limit.*", "a limit that is not exceeded"),
    ("exercise.time_limit", "the goal is reached before"),
    ("fender.*.above_water", "plain hulls have a side at any height; `check` uses it"),
    ("fender.*.cones.height", "as the height of the face"),
    ("fender.*.face_height", "of a fender without a panel it is a height, as that of the face"),
    ("fender.*.facing", "the value of an edge's own direction"),
    ("fender.*.stop", "the fender is not compressed that far"),
    ("fender_row.*.above_water", "plain hulls have a side at any height; `check` uses it"),
    (
        "fender_row.*.exception.*.above_water",
        "plain hulls have a side at any height; `check` uses it",
    ),
    ("fender_row.*.exception.*.facing", "the value of an edge's own direction"),
    ("fender_row.*.exception.*.hull", "the value of the row"),
    ("fender_row.*.exception.*.stop", "the fender is not compressed that far"),
    ("fender_row.*.exception.*.type", "the value of the row"),
    ("fender_row.*.facing", "the value of an edge's own direction"),
    ("material.*.friction_static", "the shear spring stays below the limit of friction"),
    ("fender_row.*.outline", "a shape is not met everywhere"),
    ("fender_row.*.quay_line.class", "the line is found without it"),
    ("fender_row.*.quay_line.name", "the line is found without it"),
    ("fender_row.*.quay_line.to", "the row ends before the end of the line"),
    ("fender_row.*.quay_line.water", "the side on which the body is not"),
    ("fender_row.*.stop", "the fender is not compressed that far"),
    ("limit.*.vessel", "the first vessel is meant without it"),
    ("line.*.on_deck", "a line that stays slack does not stretch"),
    ("line.*.constant_tension.heaving_speed", "the line does not slacken"),
    ("line.*.rope_length", "orders of a live session can send a line again"),
    ("line.*.tail", "a line on board may be slack until the end"),
    ("line.*.winch", "its brake renders above 60 % of the break load"),
    ("material.concrete.*", "of a pair whose bodies touch with fenders between them alone"),
    ("material.steel.*", "of a pair whose bodies do not touch, or with a fender between them"),
    ("material.timber.friction_static", "she slides from the first moment on"),
    ("order.at", "a line is handled by the next gang anyway"),
    ("order.push_ship.speed", "she is nearer than the way that takes this speed"),
    ("exercise.mark.*", "shown on the docking board alone"),
    ("plan.*", "drawn on pages and in reports, and compared with the way of the ship"),
    ("pair.*", "the other body's name, or a material that is not struck"),
    ("tug.*.beam", "the ship is at rest"),
    ("tug.*.draught", "the ship is at rest"),
    ("tug.*.length", "the ship is at rest"),
    ("tug.*.pull_at", "orders of a live session can make her pull"),
    ("vessel.*.propeller.reversal", "orders of a live session can reverse the engine"),
    ("vessel.*.windage.centroid_height", "must be given, and heels a vessel with `stability`"),
    (
        "vessel.*.windage.superstructure_area",
        "Isherwood's regression has it at some angles of the wind",
    ),
];

/// Whether a pattern fits the key, or its kind.
fn may_be_idle(key: &str, kind: &str) -> bool {
    let fits = |pattern: &str, text: &str| match pattern.strip_suffix('*') {
        Some(start) => text.starts_with(start),
        None => text == pattern,
    };
    MAY_BE_IDLE.iter().any(|(pattern, _)| fits(pattern, key) || fits(pattern, kind))
}

/// Keys of one kind that the quick form tries.
const OF_A_KIND: usize = 2;

/// Each key of the cases acts, is refused or is told; or its kind may be idle, with the reason.
#[track_caller]
fn assert_no_trap(rows: &[(String, String, String, Found)]) {
    let is_trap = |(_, key, kind, found): &&(String, String, String, Found)| {
        let is_idle = matches!(found, Found::ReportOnly | Found::Nothing | Found::SameSetup);
        is_idle && !may_be_idle(key, kind)
    };
    let traps: Vec<_> = rows.iter().filter(is_trap).collect();
    assert!(traps.is_empty(), "keys without effect, of which nothing is said: {traps:#?}");
}

#[test]
fn every_kind_of_key_acts_or_is_told() {
    let rows = survey(&cases(""), OF_A_KIND);
    assert!(rows.len() > 400, "{} keys", rows.len());
    assert_no_trap(&rows);
}

#[test]
#[ignore = "every key of every case: a minute"]
fn every_key_acts_or_is_told() {
    let rows = survey(&cases(&std::env::var("FENDERLINE_CASES").unwrap_or_default()), usize::MAX);
    print(&rows);
    assert_no_trap(&rows);
}

/// Each kind acts in one of the cases at least, where it is not one that pages or live sessions have.
#[test]
#[ignore = "every key of every case: a minute"]
fn every_kind_of_key_acts_somewhere() {
    let rows = survey(&cases(""), usize::MAX);
    let acting: BTreeSet<&str> =
        rows.iter().filter(|row| row.3 == Found::Acts).map(|row| row.2.as_str()).collect();
    let never: BTreeSet<&str> =
        rows.iter().map(|row| row.2.as_str()).filter(|kind| !acting.contains(kind)).collect();
    println!("kinds that never act in the cases: {never:#?}");
}

fn cases(only: &str) -> Vec<Case> {
    let all = toml_files(&folder("tests/keys/cases"));
    all.iter().map(|path| case(path)).filter(|case| case.name.contains(only)).collect()
}

/// What each key of these cases does, of each kind so many keys at most: case, key, its kind, what was found.
fn survey(cases: &[Case], of_a_kind: usize) -> Vec<(String, String, String, Found)> {
    let schema = schema();
    let (next, all) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let mut work: Vec<(usize, Change)> = Vec::new();
    let mut counts: BTreeMap<(String, bool), usize> = BTreeMap::new();
    let bases: Vec<(Scenario, Results)> = cases
        .iter()
        .map(|case| {
            let read = case.read(&case.document);
            let results = case.results(&case.document);
            let why = || panic!("{}: {}", case.name, case.why());
            (read.unwrap_or_else(why), results.unwrap_or_else(|| panic!("{} fails", case.name)))
        })
        .collect();
    for (index, case) in cases.iter().enumerate() {
        for change in changes(&schema, &case.document) {
            // What the case gives is tried in full before what it could have.
            let tried = counts.entry((change.kind(&schema), change.is_given)).or_default();
            *tried += 1;
            if *tried <= of_a_kind {
                work.push((index, change));
            }
        }
    }
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some((index, change)) = work.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let case = &cases[*index];
                    let found = found(case, &bases[*index], change);
                    let row = (case.name.clone(), change.key(), change.kind(&schema), found);
                    all.lock().expect("no panic").push(row);
                }
            });
        }
    });
    let mut all = all.into_inner().expect("no panic");
    all.sort();
    all
}

/// The scenarios of the repository, each for a hundred steps.
#[test]
#[ignore = "a survey that is read by people: many minutes"]
fn survey_of_the_repository() {
    let only = std::env::var("FENDERLINE_CASES").unwrap_or_default();
    let all = toml_files(&folder("../../scenarios"));
    let mut cases: Vec<Case> =
        all.iter().map(|path| case(path)).filter(|case| case.name.contains(&only)).collect();
    cases.retain(|case| case.document.get("provider").is_none());
    for case in &mut cases {
        let scenario =
            case.read(&case.document).unwrap_or_else(|| panic!("{}: {}", case.name, case.why()));
        let (step_s, duration_s) = (scenario.setup.step_s, scenario.setup.duration_s);
        case.document["time"]["duration"] =
            json!(if 100.0 * step_s < duration_s { 100.0 * step_s } else { duration_s });
    }
    print(&survey(&cases, usize::MAX));
}

/// By kind of key: what was found, and where nothing was.
fn print(rows: &[(String, String, String, Found)]) {
    let mut by_kind: BTreeMap<&str, (BTreeMap<Found, usize>, BTreeSet<String>)> = BTreeMap::new();
    for (case, key, kind, found) in rows {
        let entry = by_kind.entry(kind).or_default();
        *entry.0.entry(*found).or_default() += 1;
        if matches!(found, Found::ReportOnly | Found::Nothing | Found::SameSetup) {
            entry.1.insert(format!("{found:?} {case}: {key}"));
        }
    }
    for (kind, (counts, idle)) in &by_kind {
        println!("{kind}: {counts:?}");
        idle.iter().take(12).for_each(|line| println!("    {line}"));
    }
    println!("{} keys tried in {} kinds", rows.len(), by_kind.len());
}
