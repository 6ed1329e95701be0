//! The table that `manoeuvre` prints.

use core::fmt::Write as _;

use fenderline_sim::constants::{KNOT_MPS, STANDARD_GRAVITY_MPS2};
use fenderline_sim::hydro::vessels::Vessel;

use super::conditions::{Conditions, Sea};
use super::section::{Row, Section, Unit};
use crate::cli::{Manoeuvre, ManoeuvreChoice};
use crate::vessels::accuracy_text;
use fenderline_report::plot::{fixed, plain, significant};

/// Width of the column of names (characters).
const NAMES: usize = 38;
/// Smallest width of a column of values (characters).
const VALUES: usize = 20;
/// Smallest distance between two columns (characters).
const GAP: usize = 2;

/// Vessel, measures and sources.
pub(super) fn text(
    asked: ManoeuvreChoice,
    chosen: &[Manoeuvre],
    vessel: &Vessel,
    sea: &Sea,
    conditions: &Conditions,
    sections: &[Section],
) -> String {
    let mut text = heading(chosen, vessel, sea, conditions);
    for section in sections {
        text.push('\n');
        text.push_str(&table(section, vessel.ship.particulars.length_m));
    }
    if asked == ManoeuvreChoice::All && vessel.ship.propulsion.is_none() {
        text.push_str(
            "\nThe data have no propeller and no rudder: the other manoeuvres are left out.\n",
        );
    } else if asked == ManoeuvreChoice::All && chosen.len() == 1 {
        text.push_str("\nThe data have no speed of approach: the other manoeuvres need --speed.\n");
    }
    if sections.iter().flat_map(|section| &section.rows).any(|row| row.imo_limit.is_some()) {
        text.push_str(
            "\nIMO: resolution MSC.137(76), annex, 5.3, as reproduced by a third party, for the test speed \
             in deep water; no conformity is claimed.\nA large ship may be allowed a track reach of up to 20 L.\n",
        );
    } else if conditions.shallow.is_some() {
        text.push_str(
            "\nIMO's limits (MSC.137(76)) are for deep water: run without --depth to see these limits.\n",
        );
    } else if sea.is_model {
        text.push_str("\nIMO's limits (MSC.137(76)) are for ships, not for models.\n");
    }
    text.push_str("\nSources of the coefficients:\n");
    for source in &vessel.origin.sources {
        let _ = writeln!(text, "  [{}] {}: {}", source.word(), source.group, source.source);
    }
    text.push_str(&accuracy_text(&vessel.origin));
    text
}

fn heading(chosen: &[Manoeuvre], vessel: &Vessel, sea: &Sea, conditions: &Conditions) -> String {
    let hull = &vessel.ship.particulars;
    let mut text = format!(
        "{}: L {} m, B {} m, T {} m, Cb {}\n{} of {} kg/m³",
        vessel.origin.title,
        plain(hull.length_m, 4),
        plain(hull.beam_m, 4),
        plain(hull.draught_m, 4),
        fixed(hull.block_coefficient(), 3),
        water(conditions),
        plain(sea.water.density_kgpm3, 4),
    );
    if chosen.iter().any(|manoeuvre| manoeuvre.has_approach()) {
        let froude = conditions.speed_mps / (STANDARD_GRAVITY_MPS2 * hull.length_m).sqrt();
        let _ = write!(
            text,
            "; approach at {} kn, Fn {}; rudder {}°/s",
            significant(conditions.speed_mps / KNOT_MPS, 3),
            fixed(froude, 3),
            plain(vessel.steering.rate_per_s.to_degrees(), 3),
        );
    }
    text.push('\n');
    if let Some(shallow) = &conditions.shallow {
        for notice in shallow.notices(vessel, conditions.speed_mps) {
            let _ = writeln!(text, "note: {notice}");
        }
    }
    text
}

/// The water in words.
fn water(conditions: &Conditions) -> String {
    match &conditions.shallow {
        None => "deep still water".to_owned(),
        Some(shallow) => format!(
            "still water {} m deep, {} draughts, beside deep water,",
            plain(shallow.depth_m, 4),
            plain(shallow.ratio, 4)
        ),
    }
}

fn table(section: &Section, length_m: f64) -> String {
    let has_limits = section.rows.iter().any(|row| row.imo_limit.is_some());
    let mut text = format!("{}\n", section.title);
    let longest = section.columns.iter().map(|column| column.chars().count() + GAP).max();
    let width = longest.unwrap_or(0).max(VALUES);
    let mut head = format!("  {:<NAMES$}", "");
    for column in &section.columns {
        let _ = write!(head, "{column:>width$}");
    }
    if has_limits {
        head.push_str("  IMO asks");
    }
    let _ = writeln!(text, "{}", head.trim_end());
    for row in &section.rows {
        let mut line = format!("  {:<NAMES$}", row.label);
        for value in &row.values {
            let _ = write!(line, "{:>width$}", cell(*value, row.unit, length_m));
        }
        line.push_str(&limit(row));
        let _ = writeln!(text, "{}", line.trim_end());
    }
    for note in &section.notes {
        let _ = writeln!(text, "  {note}");
    }
    text
}

/// A value with its unit; a value in ship lengths is given in metres too.
fn cell(value: f64, unit: Unit, length_m: f64) -> String {
    // A value that rounds to zero has no sign.
    let shown = |value: f64, decimals: usize| {
        let text = fixed(value, decimals);
        let is_zero = !text.bytes().any(|b| b.is_ascii_digit() && b != b'0');
        if is_zero { fixed(0.0, decimals) } else { text }
    };
    match unit {
        Unit::Lengths => {
            let digits = significant(value * length_m, 3);
            let metres =
                if value * length_m >= 100.0 { fixed(value * length_m, 0) } else { digits };
            format!("{} L {metres:>6} m", shown(value, 2))
        }
        Unit::Kilonewtons if value.abs() < 1.0 => format!("{} N", significant(value * 1e3, 4)),
        Unit::Kilonewtons => format!("{} kN", significant(value, 4)),
        Unit::Degrees => format!("{}°", shown(value, unit.decimals())),
        Unit::Seconds if value < 100.0 => format!("{} s", shown(value, 1)),
        Unit::One => shown(value, unit.decimals()),
        _ => format!("{} {}", shown(value, unit.decimals()), unit.text()),
    }
}

/// Text that gives IMO's limit and says whether the limit is met.
fn limit(row: &Row) -> String {
    let (Some(limit), Some(is_within)) = (row.imo_limit, row.is_within()) else {
        return String::new();
    };
    let verdict = if is_within { "met" } else { "NOT MET" };
    let blank = if row.unit == Unit::Degrees { "" } else { " " };
    format!("  ≤ {}{blank}{}, {verdict}", plain(limit, 3), row.unit.text())
}
