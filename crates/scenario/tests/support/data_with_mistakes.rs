//! Mistakes in hydrodynamic data, made in the barge's data of the repository.

use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

use fenderline_scenario::{Scenario, ScenarioError};

/// The step of the runs (s).
pub(crate) const STEP_S: f64 = 0.2;

const RUN: &str = r#"
[time]
step = "STEP s"
duration = "1 h"

[environment]
depth = "20 m"
waves = { height = 1, period = 9, from = "220 deg", seed = 4 }

[vessel.barge]
length_bp = "80 m"
beam = "20 m"
draught = "5 m"
block_coefficient = 1.0
gyradius = "20 m"
hydrodynamics = "barge_20m.hydro"

[body.ship]
vessel = "barge"
outline = [[-40, -10], [40, -10], [40, 10], [-40, 10]]
"#;

/// What the reader must say.
pub(crate) enum Answer {
    /// An error with these parts in its text.
    Refused(&'static [&'static str]),
    /// A notice with these parts.
    WarnedOf(&'static [&'static str]),
    /// Nothing: it changes the data by less than what the fit of the memory leaves.
    WithinTheFit,
}

/// A mistake.
pub(crate) struct Mistake {
    pub(crate) name: &'static str,
    /// The file with the mistake, from the file without.
    pub(crate) make: fn(&str) -> String,
    pub(crate) answer: Answer,
}

/// One row of a table.
pub(crate) struct Row<'a> {
    columns: &'a [&'a str],
    pub(crate) numbers: Vec<f64>,
    /// From 0.
    pub(crate) index: usize,
    is_kept: bool,
}

impl Row<'_> {
    pub(crate) fn of(&self, column: &str) -> f64 {
        self.numbers[self.place(column)]
    }

    pub(crate) fn change(&mut self, column: &str, by: impl Fn(f64) -> f64) {
        let place = self.place(column);
        self.numbers[place] = by(self.numbers[place]);
    }

    /// Changes all columns whose names begin with a letter and end with a digit.
    pub(crate) fn change_all(&mut self, letters: &[&str], by: impl Fn(f64) -> f64) {
        for (column, number) in self.columns.iter().zip(&mut self.numbers) {
            if letters.iter().any(|letter| column.starts_with(letter)) && *column != "omega_radps" {
                *number = by(*number);
            }
        }
    }

    pub(crate) fn leave_out(&mut self) {
        self.is_kept = false;
    }

    fn place(&self, column: &str) -> usize {
        self.columns.iter().position(|known| *known == column).expect(column)
    }
}

pub(crate) fn data_file() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../hydrodynamics/barge_20m.hydro");
    fs::read_to_string(path).expect("a file of the repository")
}

/// The scenario with data of this text.
pub(crate) fn read(data: &str, step_s: f64) -> Result<Scenario, ScenarioError> {
    let text = RUN.replace("STEP", &step_s.to_string());
    let mut files = |_: &str| Ok(data.to_owned());
    Scenario::parse_among(&text, "barge.toml", &[], &mut files)
}

/// A file in which the rows of one table are changed.
pub(crate) fn edited(text: &str, table: &str, change: impl Fn(&mut Row)) -> String {
    let mut columns: Option<Vec<&str>> = None;
    let (mut is_inside, mut index) = (false, 0);
    let mut out = String::new();
    for line in text.lines() {
        if let Some(name) = line.strip_prefix("= ") {
            is_inside = name == table;
            columns = None;
        } else if is_inside && !line.is_empty() && !line.starts_with('#') {
            if let Some(columns) = &columns {
                let numbers = line.split(',').map(|cell| cell.parse().expect("a number")).collect();
                let mut row = Row { columns, numbers, index, is_kept: true };
                change(&mut row);
                index += 1;
                if row.is_kept {
                    let cells: Vec<String> = row.numbers.iter().map(f64::to_string).collect();
                    out += &(cells.join(",") + "\n");
                }
                continue;
            }
            columns = Some(line.split(',').collect());
        }
        out += &(line.to_owned() + "\n");
    }
    out
}

/// The file without the frequencies of the radiation for which this is so.
fn without(text: &str, is_left_out: impl Fn(f64) -> bool) -> String {
    edited(text, "radiation", |row| {
        if is_left_out(row.of("omega_radps")) {
            row.leave_out();
        }
    })
}

/// The file with numbers of a table times a factor.
fn times(text: &str, table: &str, letters: &[&str], factor: f64) -> String {
    edited(text, table, |row| row.change_all(letters, |number| factor * number))
}

/// The file with a factor on the coupling of two motions, in damping and added mass.
fn coupled(text: &str, pair: &str, factor: f64) -> String {
    let once = edited(text, "radiation", |row| {
        for letter in ["a", "b"] {
            row.change(&format!("{letter}{pair}"), |number| factor * number);
        }
    });
    edited(&once, "infinite", |row| row.change(&format!("a{pair}"), |number| factor * number))
}

macro_rules! mistake {
    ($name:literal, $make:expr, $answer:ident $($fragments:tt)?) => {
        Mistake { name: $name, make: $make, answer: Answer::$answer $($fragments)? }
    };
}

/// The mistakes of the issue that asked for these checks, each in several forms.
pub(crate) const MISTAKES: &[Mistake] = &[
    // Negative damping.
    mistake!(
        "negative damping of heave at one frequency",
        |text| edited(text, "radiation", |row| if row.index == 8 {
            row.change("b33", |b| -0.2 * b)
        }),
        Refused(&["damping of heave is negative", "finer mesh"])
    ),
    mistake!(
        "noise in the damping of sway",
        |text| edited(text, "radiation", |row| if row.index == 2 {
            row.change("b22", |_| -2e4)
        }),
        WarnedOf(&["sway and roll together is negative"])
    ),
    mistake!(
        "damping of sway and roll together a little negative",
        |text| edited(text, "radiation", |row| row.change("b24", |b| 1.05 * b)),
        WarnedOf(&["sway and roll together is negative"])
    ),
    mistake!(
        "damping of sway and roll together negative",
        |text| edited(text, "radiation", |row| row.change("b24", |b| 2.0 * b)),
        Refused(&["sway and roll together is negative", "coupling"])
    ),
    mistake!(
        "signs of all damping turned",
        |text| times(text, "radiation", &["b"], -1.0),
        Refused(&["is negative"])
    ),
    // Retardation that does not decay.
    mistake!(
        "damping of sway that does not fade",
        |text| edited(text, "radiation", |row| if row.of("omega_radps") > 1.0 {
            row.change("b22", |_| 4.4e6);
        }),
        Refused(&["sway"])
    ),
    mistake!(
        "frequencies end at 1.2 rad/s",
        |text| without(text, |w| w > 1.25),
        Refused(&["does not decay", "add higher frequencies"])
    ),
    mistake!("frequencies end at 2.3 rad/s", |text| without(text, |w| w > 2.35), WithinTheFit),
    // Gaps.
    mistake!(
        "a gap about the peaks",
        |text| without(text, |w| w > 0.57 && w < 1.25),
        Refused(&["rad/s"])
    ),
    mistake!(
        "one frequency is missing",
        |text| without(text, |w| (w - 0.7).abs() < 0.01),
        WithinTheFit
    ),
    mistake!("an empty cell", |text| text.replacen(",1.0", ",,1.0", 1), Refused(&["columns"])),
    mistake!(
        "a row of the excitation is missing",
        |text| edited(text, "excitation", |row| if row.index == 12 {
            row.leave_out()
        }),
        Refused(&["no row for"])
    ),
    // Too coarse, too late.
    mistake!(
        "every seventh frequency",
        |text| edited(text, "radiation", |row| if row.index % 7 != 0 {
            row.leave_out()
        }),
        Refused(&["8 frequencies"])
    ),
    mistake!(
        "every sixth frequency",
        |text| edited(text, "radiation", |row| if row.index % 6 != 0 {
            row.leave_out()
        }),
        Refused(&["too far apart"])
    ),
    mistake!(
        "every second frequency",
        |text| edited(text, "radiation", |row| if row.index % 2 == 1 {
            row.leave_out()
        }),
        WithinTheFit
    ),
    mistake!(
        "frequencies begin at 0.9 rad/s",
        |text| without(text, |w| w < 0.85),
        Refused(&["add lower frequencies"])
    ),
    // Wrong units.
    mistake!(
        "added mass in tonnes",
        |text| times(&times(text, "radiation", &["a"], 1e-3), "infinite", &["a"], 1e-3),
        Refused(&["units"])
    ),
    mistake!("damping in kilonewtons", |text| times(text, "radiation", &["b"], 1e-3), Refused(&[])),
    mistake!(
        "frequencies in hertz",
        |text| edited(text, "radiation", |row| row.change("omega_radps", |w| w / TAU)),
        Refused(&[])
    ),
    mistake!(
        "exciting forces in kilonewtons",
        |text| times(text, "excitation", &["re", "im"], 1e-3),
        Refused(&["Haskind", "1 m amplitude"])
    ),
    mistake!(
        "exciting forces in tonnes-force",
        |text| times(text, "excitation", &["re", "im"], 1.0 / 9806.65),
        Refused(&["Haskind"])
    ),
    mistake!(
        "drift of forces in newtons taken for kilonewtons",
        |text| times(text, "drift", &["surge", "sway", "yaw"], 1e3),
        Refused(&["mean drift", "units"])
    ),
    mistake!(
        "restoring in kilonewtons",
        |text| times(text, "ship", &["c3", "c4", "c5"], 1e-3),
        Refused(&["restoring in heave", "units"])
    ),
    mistake!(
        "the arm of a coupling in millimetres",
        |text| coupled(text, "24", 1e3),
        Refused(&["sway and roll together"])
    ),
    mistake!(
        "added mass of a coupling in millimetres, damping left out",
        |text| {
            let once = edited(text, "radiation", |row| {
                row.change("a15", |a| 1e3 * a);
                row.change("b15", |_| 0.0);
            });
            edited(&once, "infinite", |row| row.change("a15", |a| 1e3 * a))
        },
        Refused(&["mass of surge and pitch together is negative"])
    ),
    mistake!(
        "restoring couples heave and pitch too much",
        |text| edited(text, "ship", |row| row.change("c35", |_| 5e8)),
        Refused(&["restoring of heave and pitch together is negative"])
    ),
    mistake!(
        "added mass of heave at infinite frequency 30 % too large",
        |text| edited(text, "infinite", |row| row.change("a33", |a| 1.3 * a)),
        WithinTheFit
    ),
    mistake!(
        "added mass of heave at infinite frequency twice too large",
        |text| edited(text, "infinite", |row| row.change("a33", |a| 2.0 * a)),
        WarnedOf(&["contradict each other"])
    ),
    mistake!(
        "added mass of heave at infinite frequency three times too large",
        |text| edited(text, "infinite", |row| row.change("a33", |a| 3.0 * a)),
        Refused(&["contradict each other"])
    ),
    // Headings.
    mistake!(
        "headings end at 90 degrees",
        |text| {
            let left_out = |row: &mut Row<'_>| {
                if row.of("heading_deg") > 91.0 {
                    row.leave_out()
                }
            };
            edited(&edited(text, "excitation", left_out), "drift", left_out)
        },
        Refused(&["headings leave a gap"])
    ),
    mistake!(
        "headings 60 degrees apart",
        |text| {
            let left_out = |row: &mut Row<'_>| {
                if row.of("heading_deg") % 60.0 > 1.0 {
                    row.leave_out()
                }
            };
            edited(&edited(text, "excitation", left_out), "drift", left_out)
        },
        Refused(&["headings leave a gap"])
    ),
    mistake!(
        "headings in radians",
        |text| {
            let radians = |row: &mut Row<'_>| row.change("heading_deg", f64::to_radians);
            edited(&edited(text, "excitation", radians), "drift", radians)
        },
        Refused(&["headings leave a gap"])
    ),
];
