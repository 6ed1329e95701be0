//! The table of berthings: a row a berthing.

use fenderline_campaign::{Cell, Head, Row};

use crate::berthing::{Berthing, Berthings};
use crate::estimate::Uncertain;
use crate::run::Rerun;

/// Seconds of a day.
const DAY_S: f64 = 86_400.0;

/// The time of a berthing as text: in UTC, or the time of day for a log without dates.
#[must_use]
pub fn time_text(berthing: &Berthing) -> String {
    let t_s = libm::round(berthing.touch.t_s * 10.0) / 10.0;
    let moment = fenderline_nautical::Moment::from_unix(t_s);
    let tenths = libm::round(moment.seconds * 10.0) as u64;
    let clock = format!(
        "{:02}:{:02}:{:02}.{}",
        tenths / 36_000,
        tenths / 600 % 60,
        tenths / 10 % 60,
        tenths % 10
    );
    match berthing.is_dated {
        true => format!("{:04}-{:02}-{:02}T{clock}Z", moment.year, moment.month, moment.day),
        false => {
            let days = libm::floor(t_s / DAY_S) as u64;
            if days == 0 { clock } else { format!("{clock}, day {}", days + 1) }
        }
    }
}

/// A function that gives the cell of a berthing.
type CellOf = Box<dyn Fn(&Berthings, &Berthing) -> Cell>;

/// A column of the table.
struct Column {
    head: Head,
    cell: CellOf,
}

fn text(
    name: &str,
    meaning: &str,
    of: impl Fn(&Berthings, &Berthing) -> String + 'static,
) -> Column {
    Column {
        head: Head::of_text(name, meaning),
        cell: Box::new(move |all, own| Cell::Text(of(all, own))),
    }
}

fn number(
    name: &str,
    unit: &str,
    meaning: &str,
    of: impl Fn(&Berthings, &Berthing) -> f64 + 'static,
) -> Column {
    Column {
        head: Head::new(name, unit, meaning),
        cell: Box::new(move |all, own| Cell::of_number(of(all, own))),
    }
}

/// A column of a number and one of its standard deviation.
fn uncertain(
    name: &str,
    unit: &str,
    meaning: &str,
    factor: f64,
    of: impl Fn(&Berthing) -> Option<Uncertain> + Copy + 'static,
) -> [Column; 2] {
    let value = move |own: &Berthing| of(own).map_or(f64::NAN, |value| value.value * factor);
    let sd = move |own: &Berthing| of(own).map_or(f64::NAN, |value| value.sd * factor);
    [
        number(name, unit, meaning, move |_, own| value(own)),
        number(
            &format!("{name}_sd"),
            unit,
            &format!("standard deviation of {name}"),
            move |_, own| sd(own),
        ),
    ]
}

fn run_of(own: &Berthing) -> Option<&Rerun> {
    own.run.as_ref().ok()
}

/// The fender whose share of its rating is largest: index, quantity, share.
pub(crate) fn most_used(run: &Rerun) -> Option<(usize, &'static str, f64)> {
    let known = run.fenders.iter().filter_map(|own| {
        let (quantity, share) = own.governing?;
        Some((own.fender, quantity, share))
    });
    known.max_by(|one, other| one.2.total_cmp(&other.2))
}

fn columns(berthings: &Berthings) -> Vec<Column> {
    const DEG: f64 = 57.295_779_513_082_32;
    let mut all = vec![
        text("time", "time of the first touch, in UTC if the log has dates", |_, own| {
            time_text(own)
        }),
        text("ship", "name of the ship in the log", |_, own| own.ship.clone()),
        text("log", "name of the log", |_, own| own.file.clone()),
        number("line", "", "line of the log at the touch", |_, own| own.line as f64),
        text("source", "kind of the log", |_, own| own.kind.words().to_owned()),
        number("displacement", "t", "displacement of the ship in the scenario", |all, own| {
            all.berths[own.berth].displacement_t()
        }),
    ];
    all.extend(uncertain(
        "speed",
        "m/s",
        "speed of the point of contact towards the quay, square to it, at the first touch",
        1.0,
        |own| Some(own.touch.speed_mps),
    ));
    all.extend(uncertain(
        "angle",
        "deg",
        "angle between ship and quay at the first touch, positive with the bow towards the quay",
        DEG,
        |own| Some(own.touch.angle_rad),
    ));
    all.extend(uncertain(
        "turn",
        "deg/min",
        "rate of turn, positive to starboard",
        60.0 * DEG,
        |own| Some(own.touch.turn_radps),
    ));
    all.extend(uncertain(
        "place_on_ship",
        "m",
        "place of the contact forward of the ship's centre of gravity",
        1.0,
        |own| Some(own.touch.forward_m),
    ));
    all.extend(uncertain(
        "place_on_quay",
        "m",
        "place of the contact along the quay, from the middle of the fenders towards the scenario's bow",
        1.0,
        |own| Some(own.touch.along_m),
    ));
    all.push(text("first_fender", "fender that is touched first", |all, own| {
        all.berths[own.berth].fender(own.touch.fender).to_owned()
    }));
    all.extend(uncertain(
        "longitudinal_speed",
        "m/s",
        "speed of the ship along the quay at the first touch, positive ahead",
        1.0,
        |own| Some(own.touch.ahead_mps),
    ));
    all.extend(uncertain(
        "centre_speed",
        "m/s",
        "speed of the ship's centre of gravity towards the quay at the first touch",
        1.0,
        |own| Some(own.touch.centre_mps),
    ));
    all.extend([
        number("time_sd", "s", "standard deviation of the time of the touch", |_, own| {
            own.touch.t_sd_s
        }),
        number(
            "bandwidth",
            "s",
            "time before the touch through which parabolas are laid",
            |_, own| own.touch.bandwidth_s,
        ),
        number("readings", "", "fewest readings of a channel in that time", |_, own| {
            own.touch.readings as f64
        }),
        number("left_out", "", "readings in that time that lie far from the others", |_, own| {
            own.touch.left_out as f64
        }),
        number(
            "moved",
            "m",
            "how far a track was moved so that the ship lies at the fenders",
            |_, own| own.zero_m.unwrap_or(0.0),
        ),
        text("flags", "what limits the quality of the row; empty if nothing does", |_, own| {
            own.flags.iter().map(|flag| flag.word()).collect::<Vec<_>>().join(" ")
        }),
    ]);
    all.extend(uncertain(
        "formula_energy",
        "kJ",
        "berthing energy by the formula of the scenario's [berthing], with centre_speed",
        1e-3,
        |own| run_of(own).map(|run| run.formula_j),
    ));
    all.extend(uncertain(
        "energy",
        "kJ",
        "energy of all fenders in the first hit of the run from the measured state",
        1e-3,
        |own| run_of(own).map(|run| run.energy_j),
    ));
    all.extend([
        number("run_from", "m", "distance from the fenders at which the run begins", |_, own| {
            run_of(own).map_or(f64::NAN, |run| run.from_m)
        }),
        number("run_speed", "m/s", "speed at the first touch in the run", |_, own| {
            run_of(own).map_or(f64::NAN, |run| run.speed_mps)
        }),
        text("run_first_fender", "fender that is touched first in the run", |all, own| {
            run_of(own)
                .map_or_else(String::new, |run| all.berths[own.berth].fender(run.fender).to_owned())
        }),
        text("run_verdict", "the worst finding of the run, as a word", |_, own| {
            run_of(own).map_or_else(|| "no_run".to_owned(), |run| run.verdict.key().to_owned())
        }),
        text("exceeded", "what was exceeded in the run, in sentences", |_, own| match &own.run {
            Ok(run) => run.exceeded.join("; "),
            Err(why) => why.clone(),
        }),
        text("most_used_fender", "fender with the largest share of its rating", |all, own| {
            let most = run_of(own).and_then(most_used);
            most.map_or_else(String::new, |most| all.berths[own.berth].fender(most.0).to_owned())
        }),
        text(
            "most_used_quantity",
            "the quantity of that fender that is nearest to its rating",
            |_, own| {
                run_of(own).and_then(most_used).map_or_else(String::new, |most| most.1.to_owned())
            },
        ),
        number("most_used_share", "%", "share of the rating of that quantity", |_, own| {
            run_of(own).and_then(most_used).map_or(f64::NAN, |most| 100.0 * most.2)
        }),
    ]);
    if berthings.all.iter().any(|own| own.followed.is_some()) {
        all.extend(of_followed());
    }
    all.extend(of_fenders(berthings));
    all
}

/// Columns of the run along the measured path.
fn of_followed() -> Vec<Column> {
    let of = |own: &Berthing| own.followed.as_ref()?.as_ref().ok().cloned();
    let mut all = vec![
        number(
            "followed_from",
            "m",
            "distance from the fenders at which the run along the measured path begins",
            move |_, own| of(own).map_or(f64::NAN, |run| run.from_m),
        ),
        number(
            "followed_for",
            "s",
            "duration of the run along the measured path",
            move |_, own| of(own).map_or(f64::NAN, |run| run.duration_s),
        ),
    ];
    for (index, (name, unit, factor, meaning)) in [
        (
            "along",
            "kN",
            1e-3,
            "mean force along the quay, positive ahead, of tugs, thrusters and wind together",
        ),
        ("across", "kN", 1e-3, "mean force towards the quay of tugs, thrusters and wind together"),
        (
            "moment",
            "MN m",
            1e-6,
            "mean moment about the centre of gravity, positive with the bow towards the quay",
        ),
    ]
    .into_iter()
    .enumerate()
    {
        let mean = move |own: &Berthing| Some(of(own)?.mean()[index]);
        all.extend(uncertain(&format!("followed_{name}"), unit, meaning, factor, mean));
    }
    all
}

/// Three columns for each fender of the scenario.
fn of_fenders(berthings: &Berthings) -> Vec<Column> {
    let Some(berth) = berthings.berths.first() else { return Vec::new() };
    let mut all = Vec::new();
    for (index, fender) in berth.setup.fenders.iter().enumerate() {
        let used = move |own: &Berthing| run_of(own).map(|run| use_of(run, index));
        for (what, unit, factor, meaning, at) in [
            ("reaction", "kN", 1e-3, "largest reaction", 0_usize),
            ("deflection", "mm", 1e3, "largest deflection", 1),
            ("energy", "kJ", 1e-3, "largest energy", 2),
        ] {
            all.push(number(
                &format!("fender.{}.{what}", fender.name),
                unit,
                &format!("{meaning} of this fender in the run; 0 if it is not touched"),
                move |_, own| used(own).map_or(f64::NAN, |values| factor * values[at]),
            ));
        }
    }
    all
}

/// Reaction (N), deflection (m) and energy (J) of a fender in a run; zeros if it is not touched.
fn use_of(run: &Rerun, fender: usize) -> [f64; 3] {
    let own = run.fenders.iter().find(|own| own.fender == fender);
    own.map_or([0.0; 3], |own| [own.reaction_n, own.deflection_m, own.energy_j])
}

/// Heads and rows of the table.
#[must_use]
pub fn table(berthings: &Berthings) -> (Vec<Head>, Vec<Row>) {
    let columns = columns(berthings);
    let mut heads: Vec<Head> = columns.iter().map(|column| column.head.clone()).collect();
    let mut rows: Vec<Row> = berthings
        .all
        .iter()
        .enumerate()
        .map(|(index, own)| Row {
            run: index as u64,
            cells: columns.iter().map(|column| (column.cell)(berthings, own)).collect(),
        })
        .collect();
    for (place, name) in berthings.kept.iter().enumerate() {
        let values = berthings.all.iter().map(|own| own.kept.get(place).map_or("", String::as_str));
        let values: Vec<&str> = values.collect();
        let is_number =
            |value: &&str| value.is_empty() || value.parse::<f64>().is_ok_and(f64::is_finite);
        let are_numbers =
            values.iter().all(is_number) && values.iter().any(|value| !value.is_empty());
        let name = free_name(&heads, name);
        let meaning = "column of the log, at the touch";
        heads.push(match are_numbers {
            true => Head::new(&name, "", meaning),
            false => Head::of_text(&name, meaning),
        });
        for (row, value) in rows.iter_mut().zip(values) {
            row.cells.push(match value.parse::<f64>() {
                Ok(number) if are_numbers => Cell::of_number(number),
                _ if are_numbers => Cell::Empty,
                _ => Cell::Text(value.to_owned()),
            });
        }
    }
    (heads, rows)
}

/// A name that no column has yet.
fn free_name(heads: &[Head], name: &str) -> String {
    match heads.iter().any(|head| head.name == name) {
        true => format!("log.{name}"),
        false => name.to_owned(),
    }
}
