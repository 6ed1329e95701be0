//! Summaries of runs as tables, with one row per run for each pair of bodies and each fender.

use fenderline_results::{
    Amount, Catalogue, DOLPHINS, FENDERS, KeptColumn, KeptTable, KeptValues, PAIRS, Taken,
};
use fenderline_sim::berthing::BerthingOutcome;
use fenderline_sim::{
    DolphinSummary, FenderSummary, Finding, PairSummary, Setup, Simulation, Verdict,
};

use crate::tables::Words;

/// The summary of one run.
pub(crate) struct Summary {
    pub(crate) pairs: Vec<PairSummary>,
    pub(crate) fenders: Vec<FenderSummary>,
    pub(crate) dolphins: Vec<DolphinSummary>,
    pub(crate) findings: Vec<Finding>,
    /// One or none.
    pub(crate) berthings: Vec<BerthingOutcome>,
}

impl Summary {
    pub(crate) fn of(simulation: &Simulation) -> Summary {
        Summary {
            pairs: simulation.pair_summaries().to_vec(),
            fenders: simulation.fender_summaries().cloned().collect(),
            dolphins: simulation.dolphin_summaries().to_vec(),
            findings: simulation.findings(),
            berthings: simulation.berthing().and_then(Result::ok).cloned().into_iter().collect(),
        }
    }
}

/// The summaries of runs with consecutive numbers, and the number of the first run.
#[derive(Clone, Copy)]
struct Runs<'s> {
    first: usize,
    summaries: &'s [Summary],
}

impl<'s> Runs<'s> {
    /// Each summary with the number of its run.
    fn each(self) -> impl Iterator<Item = (usize, &'s Summary)> {
        (self.first..).zip(self.summaries)
    }

    /// The rows of all runs, each row with the number of its run.
    fn rows<S>(self, of: impl Fn(&'s Summary) -> &'s Vec<S>) -> Vec<(usize, &'s S)> {
        let mut rows = Vec::new();
        for (run, summary) in self.each() {
            rows.extend(of(summary).iter().map(|row| (run, row)));
        }
        rows
    }
}

fn column<S>(
    rows: &[(usize, &S)],
    (name, unit, meaning): (&'static str, &'static str, &'static str),
    value: impl Fn(&S) -> f64,
) -> KeptColumn {
    let values = rows.iter().map(|(_, row)| value(row)).collect();
    KeptColumn { name, unit, meaning, values: KeptValues::Floats(values) }
}

fn names<S>(
    rows: &[(usize, &S)],
    name: &'static str,
    meaning: &'static str,
    words: Vec<String>,
    index: impl Fn(&S) -> usize,
) -> KeptColumn {
    let codes = rows.iter().map(|(_, row)| index(row) as i32).collect();
    KeptColumn { name, unit: "-", meaning, values: KeptValues::Texts { codes, words } }
}

fn flags<S>(
    rows: &[(usize, &S)],
    name: &'static str,
    meaning: &'static str,
    flag: impl Fn(&S) -> bool,
) -> KeptColumn {
    let values = rows.iter().map(|(_, row)| flag(row)).collect();
    KeptColumn { name, unit: "-", meaning, values: KeptValues::Flags(values) }
}

fn runs<S>(rows: &[(usize, &S)]) -> KeptColumn {
    let values = KeptValues::Counts(rows.iter().map(|(run, _)| *run as u32).collect());
    KeptColumn {
        name: "run",
        unit: "1",
        meaning: "number of the run; the first run has the number 0",
        values,
    }
}

/// Makes a column of texts, in which each different text is stored once.
fn texts(
    name: &'static str,
    meaning: &'static str,
    values: impl Iterator<Item = String>,
) -> KeptColumn {
    let mut words = Words::default();
    let codes = values.map(|value| words.code(value)).collect();
    let values = KeptValues::Texts { codes, words: words.list };
    KeptColumn { name, unit: "-", meaning, values }
}

/// Makes a column for each quantity of the catalogue, with truth values last. A missing number becomes NaN, and a
/// missing word becomes an empty text.
fn quantities<'s, S: 's, T>(
    rows: &[(usize, &T)],
    catalogue: &Catalogue<S, T>,
    setup: impl Fn(&T) -> &'s S,
) -> Vec<KeptColumn> {
    let mut columns = Vec::new();
    let mut truths = Vec::new();
    for of in catalogue.quantities {
        let amount = |row: &T| of.amount(setup(row), Some(row));
        match of.value {
            Taken::Flag(_) => truths
                .push(flags(rows, of.name, of.meaning, |row| amount(row) == Amount::Flag(true))),
            Taken::Word(_) => {
                let word = |row: &T| match amount(row) {
                    Amount::Word(word) => word.to_owned(),
                    _ => String::new(),
                };
                let words = rows.iter().map(|(_, row)| word(row));
                columns.push(texts(of.name, of.meaning, words));
            }
            _ => columns.push(column(rows, (of.name, of.unit, of.meaning), |row| {
                amount(row).number().unwrap_or(f64::NAN)
            })),
        }
    }
    columns.extend(truths);
    columns
}

/// All summary tables of runs with consecutive numbers; `first` is the number of the first run.
pub(crate) fn all_tables(setup: &Setup, first: usize, summaries: &[Summary]) -> Vec<KeptTable> {
    let runs = Runs { first, summaries };
    vec![
        pairs_table(setup, runs),
        fenders_table(setup, runs),
        dolphins_table(setup, runs),
        berthings_table(runs),
        verdicts_table(runs),
        findings_table(setup, runs),
    ]
}

/// Flexible dolphins, by run.
fn dolphins_table(setup: &Setup, all: Runs<'_>) -> KeptTable {
    let rows = all.rows(|summary| &summary.dolphins);
    let bodies = setup.bodies.iter().map(|body| body.name.clone()).collect();
    let mut columns = vec![
        runs(&rows),
        names(&rows, "dolphin", "name of the body that is the dolphin", bodies, |d| d.body),
    ];
    columns.extend(quantities(&rows, &DOLPHINS, |d| &setup.bodies[d.body]));
    KeptTable { name: "dolphins", columns }
}

/// The table of the berthing energy in each run whose ship touched a fender, if the scenario has a `[berthing]`.
fn berthings_table(all: Runs<'_>) -> KeptTable {
    let rows = all.rows(|summary| &summary.berthings);
    let columns = vec![
        runs(&rows),
        column(
            &rows,
            ("first_touch_s", "s", "start of the step in which the ship first touches a fender"),
            |b| b.first_touch_s,
        ),
        column(
            &rows,
            ("speed_mps", "m/s", "speed of the ship square to the quay face at the first touch"),
            |b| b.speed_mps,
        ),
        column(
            &rows,
            (
                "formula_speed_mps",
                "m/s",
                "speed in the formula: that of the approach if the scenario gives one, else that at the touch",
            ),
            |b| b.formula_speed_mps(),
        ),
        column(
            &rows,
            (
                "angle_rad",
                "rad",
                "angle of the ship to the berth, positive with the bow towards the berth",
            ),
            |b| b.angle_rad,
        ),
        column(
            &rows,
            ("along_m", "m", "place of the contact, positive forward of the centre of gravity"),
            |b| b.along_m,
        ),
        column(&rows, ("fenders", "1", "number of fenders that the hull meets at once"), |b| {
            b.fenders.len() as f64
        }),
        column(&rows, ("added_mass", "1", "the chosen Cm"), |b| b.chosen_added_mass),
        column(&rows, ("eccentricity", "1", "Ce by the formula"), |b| b.eccentricity),
        column(
            &rows,
            ("energy_j", "J", "berthing energy by the formula, with the chosen Cm"),
            |b| b.energy_j,
        ),
        column(
            &rows,
            (
                "energy_at_touch_j",
                "J",
                "berthing energy by the formula, with the speed at the touch",
            ),
            |b| b.energy_at_touch_j,
        ),
        column(
            &rows,
            (
                "abnormal_energy_j",
                "J",
                "energy of the abnormal berthing; NaN if the scenario has no factor for it",
            ),
            |b| b.abnormal_energy_j.unwrap_or(f64::NAN),
        ),
        column(
            &rows,
            (
                "kinetic_j",
                "J",
                "kinetic energy of the ship's motion square to the quay face in the \
                                          run",
            ),
            |b| b.kinetic_j,
        ),
        column(
            &rows,
            ("fender_energy_j", "J", "energy that the fenders took in the first hit"),
            |b| b.fender_energy_j,
        ),
        column(
            &rows,
            ("pile_energy_j", "J", "energy that the piles of dolphins took in the first hit"),
            |b| b.pile_energy_j,
        ),
        column(
            &rows,
            (
                "eccentricity_measured",
                "1",
                "energy that fenders and piles took, divided by the kinetic energy",
            ),
            |b| b.eccentricity_measured,
        ),
        column(
            &rows,
            (
                "later_energy_j",
                "J",
                "energy that the fenders took in the largest later hit; 0 if there is none",
            ),
            |b| b.later.map_or(0.0, |later| later.energy_j),
        ),
        column(
            &rows,
            ("later_at_s", "s", "start of the step of the largest later hit; NaN if there is none"),
            |b| b.later.map_or(f64::NAN, |later| later.at_s),
        ),
        column(
            &rows,
            (
                "later_hit",
                "1",
                "number of the largest later hit, 2 for the second hit; 0 if there is none",
            ),
            |b| b.later.map_or(0.0, |later| f64::from(later.number)),
        ),
    ];
    KeptTable { name: "berthings", columns }
}

/// The table of the verdict on each run.
fn verdicts_table(all: Runs<'_>) -> KeptTable {
    let rows: Vec<(usize, Verdict)> =
        all.each().map(|(run, summary)| (run, Verdict::of(&summary.findings))).collect();
    let shown: Vec<(usize, &Verdict)> = rows.iter().map(|(run, verdict)| (*run, verdict)).collect();
    let of = |text: fn(&Verdict) -> &'static str| rows.iter().map(move |(_, v)| text(v).to_owned());
    let columns = vec![
        runs(&shown),
        texts("verdict", "the worst finding of the run", of(|v| v.key())),
        texts(
            "gravity",
            "gravity of the verdict: ok, note, attention or failed",
            of(|v| v.gravity().key()),
        ),
    ];
    KeptTable { name: "verdicts", columns }
}

/// The table of what was found in each run, the worst first.
fn findings_table(setup: &Setup, all: Runs<'_>) -> KeptTable {
    let rows = all.rows(|summary| &summary.findings);
    let of = |text: fn(&Finding) -> &'static str| rows.iter().map(move |(_, f)| text(f).to_owned());
    let columns = vec![
        runs(&rows),
        texts("finding", "what was found", of(|f| f.verdict().key())),
        texts(
            "gravity",
            "gravity of the finding: ok, note, attention or failed",
            of(|f| f.verdict().gravity().key()),
        ),
        texts(
            "subjects",
            "names of the bodies, fenders, lines or vessels that the finding is about, separated by commas",
            rows.iter().map(|(_, f)| f.names(setup).join(", ")),
        ),
        texts("text", "the finding in one sentence", rows.iter().map(|(_, f)| f.sentence(setup))),
        texts(
            "law",
            "the law or data whose range the run left, as in summary.json; empty for other findings",
            rows.iter().map(|(_, f)| f.departure().map_or("", |d| d.law.row().key).to_owned()),
        ),
        column(
            &rows,
            (
                "from_s",
                "s",
                "when the run first left the range of the law or data; NaN for other \
            findings",
            ),
            |f| f.departure().map_or(f64::NAN, |d| d.first_s),
        ),
        column(
            &rows,
            (
                "lasting_s",
                "s",
                "total time outside the range of the law or data; NaN for other \
            findings",
            ),
            |f| f.departure().map_or(f64::NAN, |d| d.lasting_s),
        ),
        column(
            &rows,
            (
                "share_of_run",
                "1",
                "time outside the range of the law or data, divided by the time of the run; NaN for \
                other findings",
            ),
            |f| f.departure().map_or(f64::NAN, |d| d.share_of_run),
        ),
    ];
    KeptTable { name: "findings", columns }
}

/// The table of the pairs of bodies that touched, by run.
fn pairs_table(setup: &Setup, all: Runs<'_>) -> KeptTable {
    let rows = all.rows(|summary| &summary.pairs);
    let bodies = || setup.bodies.iter().map(|body| body.name.clone()).collect();
    let mut columns = vec![
        runs(&rows),
        names(&rows, "body_1", "name of one body", bodies(), |p| p.bodies[0]),
        names(&rows, "body_2", "name of the other", bodies(), |p| p.bodies[1]),
    ];
    columns.extend(quantities(&rows, &PAIRS, |_| &()));
    KeptTable { name: "pairs", columns }
}

/// The table of the fenders that were touched, by run.
fn fenders_table(setup: &Setup, all: Runs<'_>) -> KeptTable {
    let rows = all.rows(|summary| &summary.fenders);
    let fenders = setup.fenders.iter().map(|fender| fender.name.clone()).collect();
    let mut columns =
        vec![runs(&rows), names(&rows, "fender", "name of the fender", fenders, |f| f.fender)];
    columns.extend(quantities(&rows, &FENDERS, |f| &setup.fenders[f.fender]));
    KeptTable { name: "fenders", columns }
}
