//! A row of several steps agrees with the rows of those steps.

use std::collections::BTreeMap;

use fenderline_contact::number::greater;
use fenderline_results::{InMemory, KeptTable, KeptValues, Tables};
use fenderline_scenario::{Override, Scenario};
use fenderline_sim::{OutputPlan, OutputTable, Simulation};

/// The moored ship for 100 s: 1000 steps of 0.1 s, 20 of which make a row.
fn scenario(output: &[&str]) -> Scenario {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scenarios/berth/moored_three_hours_in_gusts.toml"
    );
    let set = ["time.duration=100 s"].into_iter().chain(output.iter().copied());
    let set: Vec<Override> = set.map(|set| Override::parse(set).unwrap()).collect();
    Scenario::load(file.as_ref(), &set).unwrap()
}

fn tables_of(output: &[&str]) -> BTreeMap<&'static str, KeptTable> {
    let Scenario { setup, output, .. } = scenario(output);
    let mut simulation = Simulation::new(setup).unwrap();
    let energy = simulation.energy();
    let mut tables = Tables::start(&InMemory, simulation.setup(), energy, &output).unwrap();
    while !simulation.is_done() {
        tables.write(&simulation.step().unwrap()).unwrap();
    }
    tables.finish().unwrap().into_iter().map(|table| (table.name, table)).collect()
}

/// The numbers of a column, as (row's start, subject, value).
fn column(table: &KeptTable, subject: &str, name: &str) -> Vec<(f64, String, f64)> {
    let values = |name: &str| &table.columns.iter().find(|c| c.name == name).unwrap().values;
    let KeptValues::Floats(at_s) = values("t_s") else { panic!("t_s") };
    let subjects: Vec<String> = match values(subject) {
        KeptValues::Texts { codes, words } => {
            codes.iter().map(|&code| words[code as usize].clone()).collect()
        }
        _ => vec![String::new(); at_s.len()],
    };
    let numbers: Vec<f64> = match values(name) {
        KeptValues::Floats(numbers) => numbers.clone(),
        KeptValues::Flags(flags) => flags.iter().map(|&flag| f64::from(u8::from(flag))).collect(),
        _ => panic!("{name} holds no numbers"),
    };
    at_s.iter().zip(subjects).zip(numbers).map(|((t, s), v)| (*t, s, v)).collect()
}

/// The steps of each row: key is the number of the interval of 2 s, and the subject.
fn by_row(table: &KeptTable, subject: &str, name: &str) -> BTreeMap<(u64, String), Vec<f64>> {
    let mut rows: BTreeMap<_, Vec<f64>> = BTreeMap::new();
    for (at_s, subject, value) in column(table, subject, name) {
        // The start of a step is a product with Δt; half a step is far from its rounding.
        rows.entry((((at_s + 0.05) / 2.0) as u64, subject)).or_default().push(value);
    }
    rows
}

#[test]
fn a_row_of_twenty_steps_has_their_means_peaks_sums_and_first_states() {
    let steps = tables_of(&["output.interval=0"]);
    let rows = tables_of(&["output.tables=[\"bodies\", \"contacts\", \"fenders\", \"vessels\", \
                           \"thrusters\", \"lines\", \"energy\"]"]);
    assert_eq!((steps["bodies"].rows(), rows["bodies"].rows()), (2 * 1000, 2 * 50));
    let mean = |of: &[f64]| of.iter().sum::<f64>() / 20.0;
    let mean_fast = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
    let sum = |of: &[f64]| of.iter().sum::<f64>();
    let most = |of: &[f64]| of.iter().copied().fold(f64::NEG_INFINITY, greater);
    let first = |of: &[f64]| of[0];
    let last = |of: &[f64]| of[of.len() - 1];
    type Rule<'r> = &'r dyn Fn(&[f64]) -> f64;
    let cases: [(&str, &str, &str, Rule<'_>); 16] = [
        ("bodies", "body", "y_m", &first),
        ("bodies", "body", "v_mps", &first),
        ("bodies", "body", "force_y_n", &mean),
        ("bodies", "body", "moment_z_nm", &mean),
        ("bodies", "body", "peak_force_n", &most),
        ("fenders", "fender", "reaction_n", &mean),
        ("fenders", "fender", "peak_reaction_n", &most),
        ("fenders", "fender", "peak_deflection_m", &most),
        ("fenders", "fender", "hull_pressure_npm2", &most),
        ("contacts", "fender", "normal_work_j", &sum),
        ("contacts", "fender", "normal_force_n", &most),
        ("vessels", "vessel", "wind_sway_n", &mean),
        ("vessels", "vessel", "roll_rad", &last),
        ("lines", "line", "tension_n", &mean_fast),
        ("lines", "line", "peak_tension_n", &most),
        ("lines", "line", "rendered_m", &sum),
    ];
    for (table, subject, name, rule) in cases {
        let (steps, rows) = (&steps[table], &rows[table]);
        let expected = by_row(steps, subject, name);
        let ours = by_row(rows, subject, name);
        assert_eq!(expected.len(), ours.len(), "{table}.{name}");
        for ((at, of_steps), (key, of_row)) in expected.iter().zip(&ours) {
            assert_eq!((at, of_row.len()), (key, 1), "{table}.{name}");
            let expected = rule(of_steps);
            // Rounding: sums in another order.
            let tolerance = 1e-12 * of_steps.iter().fold(0.0, |sum, v| sum + v.abs());
            assert!((of_row[0] - expected).abs() <= tolerance, "{table}.{name} {at:?}");
        }
    }
}

/// A fender that is first touched within an interval was at rest at its start.
#[test]
fn a_fender_touched_within_an_interval_had_no_deflection_at_its_start() {
    let rows = tables_of(&[]);
    let deflections = column(&rows["fenders"], "fender", "deflection_m");
    assert_eq!((deflections[0].0, deflections[0].2), (0.0, 0.0), "touched at 1.7 s");
    let peaks = column(&rows["fenders"], "fender", "peak_deflection_m");
    assert!(peaks[0].2 > 0.0, "{:?}", peaks[0]);
}

/// The ledger has the same rows at the ends of intervals, to the bit.
#[test]
fn the_ledger_has_a_row_at_the_end_of_each_interval() {
    let (steps, rows) = (tables_of(&["output.interval=0"]), tables_of(&[]));
    let of = |table: &KeptTable| -> BTreeMap<u64, u64> {
        let rows = column(table, "t_s", "kinetic_j").into_iter();
        rows.map(|(at_s, _, value)| (at_s.to_bits(), value.to_bits())).collect()
    };
    let (steps, rows) = (of(&steps["energy"]), of(&rows["energy"]));
    assert_eq!((steps.len(), rows.len()), (1001, 51));
    assert!(rows.iter().all(|(at, value)| steps.get(at) == Some(value)));
}

/// 6.1 s are 61 steps: with 30 steps a row the third row has one.
#[test]
fn an_interval_that_the_end_cuts_short_is_written() {
    let rows = tables_of(&["time.duration=6.1 s", "output.interval=3 s"]);
    assert_eq!(rows["vessels"].rows(), 3);
    let last = column(&rows["energy"], "t_s", "kinetic_j").last().map(|row| row.0);
    assert!((last.unwrap() - 6.1).abs() < 1e-9, "{last:?}");
    // A mean over the one step that was taken, not over thirty.
    let steps = tables_of(&["time.duration=6.1 s", "output.interval=0"]);
    let wind = |tables: &BTreeMap<&str, KeptTable>| {
        column(&tables["vessels"], "vessel", "wind_sway_n").last().unwrap().2
    };
    assert_eq!(wind(&rows).to_bits(), wind(&steps).to_bits());
}

#[test]
fn only_the_tables_of_the_plan_are_kept() {
    let rows = tables_of(&["output.tables=[\"lines\", \"fenders\"]"]);
    assert_eq!(rows.keys().copied().collect::<Vec<_>>(), ["fenders", "lines"]);
    assert!(tables_of(&["output.tables=[]"]).is_empty());
}

#[test]
fn a_plan_names_every_table_of_the_reference() {
    let known: Vec<&str> = fenderline_results::reference().iter().map(|t| t.name).collect();
    assert_eq!(OutputTable::ALL.map(OutputTable::name).to_vec(), known);
    assert_eq!(OutputPlan::every_step().tables.len(), known.len());
}
