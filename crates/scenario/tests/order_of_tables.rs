//! The order of the tables in a scenario does not change a bit of its results. It once did for three scenarios, as
//! forces were added in the order of the file.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

/// Number of steps compared. By then most scenarios are over, or all their contacts and lines are active.
const STEPS: u64 = 1500;
/// Number of shuffled orders for each scenario.
const ORDERS: u64 = 2;

#[test]
fn the_order_of_tables_changes_no_bit() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios");
    let mut files = Vec::new();
    scenarios_in(&root, &mut files);
    assert!(files.len() > 20, "only {} scenarios found", files.len());
    let mut differ = Vec::new();
    for file in &files {
        let text = std::fs::read_to_string(file).expect("a readable scenario");
        let as_it_is = played(&text, file);
        for seed in 1..=ORDERS {
            let other = played(&shuffled(&text, seed), file);
            let what = other.iter().find(|(name, bits)| as_it_is.get(*name) != Some(bits));
            if let Some((name, _)) = what {
                differ.push(format!("{}, order {seed}: {name}", file.display()));
            }
            assert_eq!(as_it_is.len(), other.len());
        }
    }
    assert!(differ.is_empty(), "{}", differ.join("\n"));
}

fn scenarios_in(folder: &Path, files: &mut Vec<PathBuf>) {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            scenarios_in(&path, files);
        } else if path.extension().is_some_and(|end| end == "toml") {
            files.push(path);
        }
    }
}

/// All results by name, as bits.
fn played(text: &str, file: &Path) -> BTreeMap<String, Vec<u64>> {
    let name = file.to_str().expect("a name in UTF-8");
    let beside = |other: &str| {
        let path = file.parent().expect("a folder").join(other);
        std::fs::read_to_string(path).map_err(|error| error.to_string())
    };
    let scenario = Scenario::parse_among(text, name, &[], &mut { beside });
    let scenario = scenario.unwrap_or_else(|error| panic!("{error}\n{text}"));
    let mut run = Simulation::new(scenario.setup).expect("a sound set-up");
    for _ in 0..STEPS.min(run.steps_total()) {
        if run.step().is_err() {
            break;
        }
    }
    let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
    let setup = run.setup();
    let mut all = BTreeMap::new();
    for (body, state) in setup.bodies.iter().zip(run.states()) {
        let (at_m, velocity_mps) = (state.position_m, state.velocity_mps);
        let turned = [state.heading_rad, state.yaw_rate_radps];
        let now = [at_m.x, at_m.y, velocity_mps.x, velocity_mps.y, turned[0], turned[1]];
        let now = bits(&now);
        all.insert(format!("body {}", body.name), now);
    }
    for (vessel, state) in setup.world.vessels.iter().zip(run.vessels()) {
        let now = bits(&[state.shaft.value, state.rudder.value]);
        all.insert(format!("vessel of {}", setup.bodies[vessel.body].name), now);
    }
    for (line, now) in setup.world.lines.iter().zip(run.lines()) {
        let length_m = now.line.as_ref().map_or(0.0, |(_, state)| state.length_m);
        all.insert(format!("line {}", line.line.name), bits(&[now.load.tension_n, length_m]));
    }
    for (tug, now) in setup.world.tugs.iter().zip(run.tugs()) {
        all.insert(format!("tug {}", tug.tug.name), bits(&[now.state.force_n]));
    }
    for fender in run.fender_summaries() {
        let name = &setup.fenders[fender.fender].name;
        all.insert(format!("fender {name}"), bits(&[fender.peak_deflection_m]));
    }
    let energy = run.energy();
    let now = [energy.kinetic_j, energy.stored_j, energy.friction_j, energy.load_work_j];
    all.insert("energy".to_owned(), bits(&now));
    all
}

/// The scenario with its tables shuffled. The `[[order]]` tables keep their relative order: of two orders at one time
/// the second counts.
fn shuffled(text: &str, seed: u64) -> String {
    let mut head = String::new();
    let mut groups: Vec<(String, String)> = Vec::new();
    for line in text.lines() {
        let header = line.strip_prefix('[').map(|rest| rest.trim_start_matches('['));
        let starts = header.and_then(|rest| {
            let path = rest.split(']').next().unwrap_or(rest);
            let mut parts = path.splitn(3, '.');
            let (kind, name) = (parts.next()?, parts.next());
            let is_list = line.starts_with("[[");
            let group = match name {
                _ if is_list && name.is_none() => format!("{kind} {}", groups.len()),
                Some(name) => format!("{kind}.{name}"),
                None => kind.to_owned(),
            };
            let goes_on = groups.iter().any(|(of, _)| *of == group);
            let of_a_list =
                groups.last().is_some_and(|(of, _)| of.starts_with(&format!("{kind} ")));
            (!goes_on && (is_list || !of_a_list)).then_some(group)
        });
        match (starts, groups.last_mut()) {
            (Some(group), _) => groups.push((group, format!("{line}\n"))),
            (None, Some((_, text))) => *text += &format!("{line}\n"),
            (None, None) => head += &format!("{line}\n"),
        }
    }
    let orders: Vec<String> = groups
        .iter()
        .filter(|(of, _)| of.starts_with("order "))
        .map(|(_, text)| text.clone())
        .collect();
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    let mut below = |count: usize| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 33) % count as u64) as usize
    };
    for last in (1..groups.len()).rev() {
        groups.swap(last, below(last + 1));
    }
    let mut orders = orders.into_iter();
    for (of, text) in &mut groups {
        if of.starts_with("order ") {
            *text = orders.next().expect("as many as there were");
        }
        head += text;
    }
    head
}
