//! Summaries of runs as tables, with one row per run for each pair of bodies and each fender.

use fenderline_results::{KeptColumn, KeptTable, KeptValues};
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

/// The summaries of runs that follow each other, and the number of the first.
#[derive(Clone, Copy)]
struct Runs<'s> {
    first: usize,
    summaries: &'s [Summary],
}

impl<'s> Runs<'s> {
    /// Each summary with its run's number.
    fn each(self) -> impl Iterator<Item = (usize, &'s Summary)> {
        (self.first..).zip(self.summaries)
    }

    /// The rows of all runs, each with its run's number.
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
    KeptColumn { name: "run", unit: "1", meaning: "number of the run, from 0", values }
}

/// A column of texts, each word stored once.
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

/// All summary tables of runs that follow each other; `first` is the number of the first.
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

/// Flexible dolphins, by run; the share of the yield load is NaN where that is not known.
fn dolphins_table(setup: &Setup, all: Runs<'_>) -> KeptTable {
    let rows = all.rows(|summary| &summary.dolphins);
    let bodies = setup.bodies.iter().map(|body| body.name.clone()).collect();
    let columns = vec![
        runs(&rows),
        names(&rows, "dolphin", "name of the dolphin's body", bodies, |d| d.body),
        column(&rows, ("peak_deflection_m", "m", "largest deflection of the head"), |d| {
            d.peak_deflection_m
        }),
        column(&rows, ("peak_load_n", "N", "largest load on the pile"), |d| d.peak_load_n),
        column(&rows, ("peak_energy_j", "J", "largest energy in the pile's bending"), |d| {
            d.peak_energy_j
        }),
        column(
            &rows,
            ("share_of_yield_load", "1", "largest load over the yield load; NaN where not known"),
            |d| d.share_of_yield_load.unwrap_or(f64::NAN),
        ),
        column(&rows, ("offset_m", "m", "permanent deflection"), |d| d.offset_m),
        column(&rows, ("yield_j", "J", "energy lost to yielding"), |d| d.yield_j),
        column(&rows, ("damping_j", "J", "energy lost to damping of the pile"), |d| d.damping_j),
        flags(&rows, "yielded", "whether the pile yielded", |d| d.yielded_at_s.is_some()),
    ];
    KeptTable { name: "dolphins", columns }
}

/// The berthing energy of each run whose ship touched a fender, if the scenario has a `[berthing]`.
fn berthings_table(all: Runs<'_>) -> KeptTable {
    let rows = all.rows(|summary| &summary.berthings);
    let columns = vec![
        runs(&rows),
        column(&rows, ("first_touch_s", "s", "start of the step of the first touch"), |b| {
            b.first_touch_s
        }),
        column(&rows, ("speed_mps", "m/s", "speed square to the face at the first touch"), |b| {
            b.speed_mps
        }),
        column(
            &rows,
            (
                "formula_speed_mps",
                "m/s",
                "speed in the formula: the speed of the approach; without an approach, the speed \
                 at the touch",
            ),
            |b| b.formula_speed_mps(),
        ),
        column(
            &rows,
            ("angle_rad", "rad", "berthing angle, positive with the bow towards the berth"),
            |b| b.angle_rad,
        ),
        column(
            &rows,
            ("along_m", "m", "point of contact from the centre of gravity, positive forward"),
            |b| b.along_m,
        ),
        column(&rows, ("fenders", "1", "number of fenders that the hull meets at once"), |b| {
            b.fenders.len() as f64
        }),
        column(&rows, ("added_mass", "1", "the chosen Cm"), |b| b.chosen_added_mass),
        column(&rows, ("eccentricity", "1", "Ce by the formula"), |b| b.eccentricity),
        column(&rows, ("energy_j", "J", "energy by the formula, with the chosen Cm"), |b| {
            b.energy_j
        }),
        column(
            &rows,
            (
                "energy_at_touch_j",
                "J",
                "energy by the formula with the speed at the \
            touch",
            ),
            |b| b.energy_at_touch_j,
        ),
        column(
            &rows,
            ("abnormal_energy_j", "J", "energy of the abnormal berthing; NaN without a factor"),
            |b| b.abnormal_energy_j.unwrap_or(f64::NAN),
        ),
        column(&rows, ("kinetic_j", "J", "kinetic energy square to the face in the run"), |b| {
            b.kinetic_j
        }),
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
                "energy in fenders and piles over the kinetic \
            energy",
            ),
            |b| b.eccentricity_measured,
        ),
        column(
            &rows,
            (
                "later_energy_j",
                "J",
                "energy that the fenders took in the largest later hit; 0: none",
            ),
            |b| b.later.map_or(0.0, |later| later.energy_j),
        ),
        column(&rows, ("later_at_s", "s", "start of the step of this energy; NaN: none"), |b| {
            b.later.map_or(f64::NAN, |later| later.at_s)
        }),
        column(
            &rows,
            ("later_hit", "1", "number of this later hit, 2 for the second; 0: none"),
            |b| b.later.map_or(0.0, |later| f64::from(later.number)),
        ),
    ];
    KeptTable { name: "berthings", columns }
}

/// The verdict on each run.
fn verdicts_table(all: Runs<'_>) -> KeptTable {
    let rows: Vec<(usize, Verdict)> =
        all.each().map(|(run, summary)| (run, Verdict::of(&summary.findings))).collect();
    let shown: Vec<(usize, &Verdict)> = rows.iter().map(|(run, verdict)| (*run, verdict)).collect();
    let of = |text: fn(&Verdict) -> &'static str| rows.iter().map(move |(_, v)| text(v).to_owned());
    let columns = vec![
        runs(&shown),
        texts("verdict", "the worst finding of the run", of(|v| v.key())),
        texts("gravity", "ok, note, attention or failed", of(|v| v.gravity().key())),
    ];
    KeptTable { name: "verdicts", columns }
}

/// What was found in each run, the worst first.
fn findings_table(setup: &Setup, all: Runs<'_>) -> KeptTable {
    let rows = all.rows(|summary| &summary.findings);
    let of = |text: fn(&Finding) -> &'static str| rows.iter().map(move |(_, f)| text(f).to_owned());
    let columns = vec![
        runs(&rows),
        texts("finding", "what was found", of(|f| f.verdict().key())),
        texts("gravity", "ok, note, attention or failed", of(|f| f.verdict().gravity().key())),
        texts(
            "subjects",
            "names of the bodies, fenders, lines or vessels, separated by commas",
            rows.iter().map(|(_, f)| f.names(setup).join(", ")),
        ),
        texts("text", "the finding in one sentence", rows.iter().map(|(_, f)| f.sentence(setup))),
        texts(
            "law",
            "the law or data that the run left, as in summary.json; empty for other findings",
            rows.iter().map(|(_, f)| f.departure().map_or("", |d| d.law.row().key).to_owned()),
        ),
        column(
            &rows,
            (
                "from_s",
                "s",
                "when the run first left the law or data; NaN for other \
            findings",
            ),
            |f| f.departure().map_or(f64::NAN, |d| d.first_s),
        ),
        column(
            &rows,
            (
                "lasting_s",
                "s",
                "time outside the law or data in all; NaN for other \
            findings",
            ),
            |f| f.departure().map_or(f64::NAN, |d| d.lasting_s),
        ),
        column(
            &rows,
            (
                "share_of_run",
                "1",
                "time outside the law or data over the time of the run; NaN for \
                other findings",
            ),
            |f| f.departure().map_or(f64::NAN, |d| d.share_of_run),
        ),
    ];
    KeptTable { name: "findings", columns }
}

/// Pairs that touched, by run.
fn pairs_table(setup: &Setup, all: Runs<'_>) -> KeptTable {
    let rows = all.rows(|summary| &summary.pairs);
    let bodies = || setup.bodies.iter().map(|body| body.name.clone()).collect();
    let columns = vec![
        runs(&rows),
        names(&rows, "body_1", "name of one body", bodies(), |p| p.bodies[0]),
        names(&rows, "body_2", "name of the other", bodies(), |p| p.bodies[1]),
        column(
            &rows,
            ("first_touch_s", "s", "start of the first step in which the two bodies touched"),
            |p| p.first_touch_s,
        ),
        column(
            &rows,
            (
                "last_touch_s",
                "s",
                "start of the last step in which the two bodies \
            touched",
            ),
            |p| p.last_touch_s,
        ),
        column(
            &rows,
            ("approach_speed_mps", "m/s", "closing speed along the normal at first touch"),
            |p| p.approach_speed_mps,
        ),
        column(
            &rows,
            ("final_speed_mps", "m/s", "separation speed along the normal after the last touch"),
            |p| p.final_speed_mps,
        ),
        column(&rows, ("peak_normal_force_n", "N", "largest normal force of all patches"), |p| {
            p.peak_normal_force_n
        }),
        column(&rows, ("peak_normal_force_at_s", "s", "time of that force"), |p| {
            p.peak_normal_force_at_s
        }),
        column(&rows, ("peak_depth_m", "m", "largest depth of a patch"), |p| p.peak_depth_m),
        column(&rows, ("peak_depth_at_s", "s", "time of that depth"), |p| p.peak_depth_at_s),
        column(&rows, ("impulse_ns", "N·s", "impulse of the normal force"), |p| p.impulse_ns),
        column(&rows, ("normal_work_j", "J", "work of normal forces on the two bodies"), |p| {
            p.normal_work_j
        }),
        column(&rows, ("tangential_work_j", "J", "work of friction on the two bodies"), |p| {
            p.tangential_work_j
        }),
        flags(&rows, "touching_at_end", "whether the two bodies touch in the last step", |p| {
            p.touching_at_end
        }),
    ];
    KeptTable { name: "pairs", columns }
}

/// Fenders that were touched, by run; shares are NaN where a fender has no rating.
fn fenders_table(setup: &Setup, all: Runs<'_>) -> KeptTable {
    let rows = all.rows(|summary| &summary.fenders);
    let fenders = setup.fenders.iter().map(|fender| fender.name.clone()).collect();
    let share = |share: Option<f64>| share.unwrap_or(f64::NAN);
    let columns = vec![
        runs(&rows),
        names(&rows, "fender", "name of the fender", fenders, |f| f.fender),
        column(
            &rows,
            ("first_touch_s", "s", "start of the first step in which the fender was touched"),
            |f| f.first_touch_s,
        ),
        column(
            &rows,
            ("approach_speed_mps", "m/s", "closing speed along the normal at first touch"),
            |f| f.approach_speed_mps,
        ),
        column(
            &rows,
            ("approach_angle_rad", "rad", "angle between face and hull at first touch"),
            |f| f.approach_angle_rad,
        ),
        column(&rows, ("peak_deflection_m", "m", "largest deflection"), |f| f.peak_deflection_m),
        column(&rows, ("peak_reaction_n", "N", "largest reaction along the fender's axis"), |f| {
            f.peak_reaction_n
        }),
        column(&rows, ("peak_energy_j", "J", "largest energy absorbed"), |f| f.peak_energy_j),
        column(&rows, ("peak_energy_at_s", "s", "start of the step of the largest energy"), |f| {
            f.peak_energy_at_s
        }),
        column(
            &rows,
            ("share_of_rated_energy", "1", "largest energy over the rated energy"),
            |f| share(f.share_of_rated_energy),
        ),
        column(&rows, ("share_of_rated_reaction", "1", "reaction over the rated reaction"), |f| {
            share(f.share_of_rated_reaction)
        }),
        column(
            &rows,
            (
                "share_of_catalogue_energy",
                "1",
                "largest energy over the rated energy without the run's factors",
            ),
            |f| share(f.share_of_catalogue_energy(&setup.fenders[f.fender])),
        ),
        column(
            &rows,
            (
                "share_of_catalogue_reaction",
                "1",
                "reaction over the rated reaction without the run's factors",
            ),
            |f| share(f.share_of_catalogue_reaction()),
        ),
        column(
            &rows,
            ("share_of_rated_deflection", "1", "deflection over the rated deflection"),
            |f| share(f.share_of_rated_deflection),
        ),
        column(&rows, ("share_of_hull_pressure", "1", "pressure over the hull's limit"), |f| {
            share(f.share_of_hull_pressure)
        }),
        flags(&rows, "failed", "whether the fender was deflected beyond its travel", |f| f.failed),
    ];
    KeptTable { name: "fenders", columns }
}
