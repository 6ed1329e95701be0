//! The engine and the simulation against `validation/independent/paper_method.py`: an independent implementation of the
//! paper's method, by another author, in another language and with other geometry. Its rows are in
//! `validation/independent/oblique_hit/`; `cargo xtask test all` computes them again.
//!
//! Tolerance: 1e-9 of the largest magnitude in each column. A run of 300 steps amplifies rounding errors of the first
//! state about a thousand times (a relative change of one coordinate by 1e-13 moves the script's columns by up to
//! 4e-11), so agreement to 1e-9 means that every formula agrees.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::path::{Path, PathBuf};

use fenderline_contact::{Friction, Vec2};
use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

const TOLERANCE: f64 = 1e-9;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: &str) -> String {
    let path = root().join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Rows as text cells, with the header apart.
fn table(path: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let text = read(path);
    let mut rows = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let header = rows.next().expect("a header");
    (header, rows.collect())
}

fn cells(numbers: &[f64]) -> impl Iterator<Item = String> + '_ {
    numbers.iter().map(f64::to_string)
}

/// Our rows in the columns of `interfaces.md`.
fn our_rows() -> (Vec<Vec<String>>, Vec<Vec<String>>) {
    let file = "scenarios/oblique_hit.toml";
    let scenario = Scenario::parse(&read(file), file).expect("a good scenario");
    let names: Vec<String> = scenario.setup.bodies.iter().map(|b| b.name.clone()).collect();
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    let (mut contacts, mut bodies) = (Vec::new(), Vec::new());
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        for c in record.contacts {
            let mut row = vec![record.t_s.to_string()];
            row.extend([c.body_1, c.body_2].map(|b| names[b.0 as usize].clone()));
            row.extend(cells(&[
                c.area_m2,
                c.depth_m,
                c.point_m.x,
                c.point_m.y,
                c.normal.x,
                c.normal.y,
                c.v_normal_mps,
                c.v_tangential_mps,
                c.shear_m,
                c.normal_force_n,
                c.tangential_force_n,
            ]));
            row.push(if c.friction == Friction::Stick { "stick" } else { "slip" }.into());
            row.push(c.limited.to_string());
            contacts.push(row);
        }
        for (body, (state, wrench)) in record.states.iter().zip(record.wrenches).enumerate() {
            let uv: Vec2 = state.pose().rotation.apply_inverse(state.velocity_mps);
            let mut row = vec![record.t_s.to_string(), names[body].clone()];
            row.extend(cells(&[
                state.position_m.x,
                state.position_m.y,
                state.heading_rad,
                uv.x,
                uv.y,
                state.yaw_rate_radps,
                wrench.force_n.x,
                wrench.force_n.y,
                wrench.moment_nm,
            ]));
            bodies.push(row);
        }
    }
    // The engine sorts by key (the names' order), the script by the scenario's order.
    let order = |row: &[String]| {
        let place = |name: &str| names.iter().position(|n| n == name).expect("a body");
        (place(&row[1]), place(&row[2]))
    };
    contacts.sort_by(|a: &Vec<String>, b| {
        let t = |row: &[String]| row[0].parse::<f64>().expect("a time");
        t(a).total_cmp(&t(b)).then(order(a).cmp(&order(b)))
    });
    (contacts, bodies)
}

fn compare(what: &str, ours: &[Vec<String>], header: &[String], theirs: &[Vec<String>]) {
    assert_eq!(ours.len(), theirs.len(), "{what}: number of rows");
    let mut worst = (0.0, String::new());
    for (column, name) in header.iter().enumerate() {
        let number = |row: &[String]| row[column].parse::<f64>();
        let numbers = number(&theirs[0]).is_ok();
        let size = if numbers {
            theirs.iter().map(|r| number(r).expect("a number").abs()).fold(0.0, f64::max)
        } else {
            0.0
        };
        for (line, (our, their)) in ours.iter().zip(theirs).enumerate() {
            if !numbers {
                assert_eq!(our[column], their[column], "{what}, line {}: {name}", line + 2);
                continue;
            }
            let (our, their) = (number(our).expect("a number"), number(their).expect("a number"));
            let error = if size > 0.0 { (our - their).abs() / size } else { our.abs() };
            assert!(
                error <= TOLERANCE,
                "{what}, line {}: {name} is {our}, theirs {their}: {error:e} of {size}",
                line + 2
            );
            if error > worst.0 {
                worst = (error, format!("{name}, line {}", line + 2));
            }
        }
    }
    println!("{what}: {} rows, largest difference {:e} ({})", ours.len(), worst.0, worst.1);
}

#[test]
fn an_oblique_hit_with_friction_matches_the_independent_implementation_in_every_column() {
    let (contacts, bodies) = our_rows();
    let (header, theirs) = table("validation/independent/oblique_hit/contacts.csv");
    // Every state of the law occurs in the run.
    for (column, value) in [(14, "stick"), (14, "slip"), (15, "true"), (15, "false")] {
        assert!(theirs.iter().any(|row| row[column] == value), "no row is `{value}`");
    }
    compare("contacts", &contacts, &header, &theirs);
    let (header, theirs) = table("validation/independent/oblique_hit/bodies.csv");
    compare("bodies", &bodies, &header, &theirs);
}
