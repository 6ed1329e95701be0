//! Checks whether the signs in a table of coefficients make sense: wind or current must push the ship in the direction
//! in which it flows.

use fenderline_contact::number::greater;
use fenderline_sim::environment::Sides;

use super::angles::Angles;
use super::row::{Flow, Row};
use crate::assemble::assembly::Checked;
use fenderline_keys::csv::Csv;
use fenderline_keys::keys::coefficients::Convention;

/// Largest permitted side force or moment for angles straight ahead or astern, as a share of the largest value of the
/// table.
const AT_THE_ENDS: f64 = 0.05;
/// A larger difference between the two sides of the ship gets a warning; a share of the largest value of the table.
const ASYMMETRY: f64 = 0.3;
/// A larger moment of unusual sign gets a warning; a share of the largest moment of the table.
const AGAINST: f64 = 0.1;

/// Checks the signs of the rows at one depth and draught. Returns the warnings, each with the row to which it points.
///
/// # Errors
/// Fails if a force at 0, 90, 180 or −90 degrees points against the flow, or if a mirrored table has a side force or
/// moment for angles straight ahead or astern.
pub(super) fn check(
    csv: &Csv<'_>,
    column: usize,
    angles: &Angles,
    (flow, convention): (Flow, &Convention),
    at: &str,
) -> Checked<Vec<(usize, String)>> {
    let most = |k: usize| angles.rows.iter().map(|row| row.value[k].abs()).fold(0.0, greater);
    let nearest = |degrees: f64| {
        let off = |row: &Row| libm::remainder(row.angle_deg - degrees, 360.0).abs();
        let row = angles.rows.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        row.filter(|row| off(row) < 20.0)
    };
    let given =
        |row: &Row| fenderline_keys::printable::printable_number(csv.plain(row.row, column));
    // In our axes a flow from ahead pushes aft, and a flow from port pushes to starboard.
    for (degrees, part, pushes, from) in [
        (0.0, 0, -1.0, "ahead"),
        (180.0, 0, 1.0, "astern"),
        (90.0, 1, 1.0, "port"),
        (-90.0, 1, -1.0, "starboard"),
    ] {
        let Some(row) = nearest(degrees) else { continue };
        if row.value[part] * pushes >= 0.0 {
            continue;
        }
        let (force, keys) = match part {
            0 => ("surge force", "`angle_zero` and `surge_positive`"),
            _ => ("side force", "`angle_side` and `sway_positive`"),
        };
        let message = format!(
            "the {force} at {}{at} points against the flow, which by the given convention comes \
             from {from}",
            given(row)
        );
        let error = csv.cell_error(row.row, column, message);
        return Err(error.with_help(format!(
            "the table has another convention: describe it with `convention = \"own\"` by {keys}"
        )));
    }
    let mut odd = Vec::new();
    if angles.sides == Sides::Mirrored {
        for row in [&angles.rows[0], &angles.rows[angles.rows.len() - 1]] {
            for (k, name) in [(1, "side force"), (2, "yaw moment")] {
                let share = row.value[k].abs() / greater(most(k), f64::MIN_POSITIVE);
                if share > AT_THE_ENDS {
                    let message = format!(
                        "a table for one side of the ship must have no {name} at {}{at}, but this \
                         table has {:.0} % of its largest value there",
                        given(row),
                        100.0 * share
                    );
                    let error = csv.cell_error(row.row, column, message);
                    return Err(error.with_help(
                        "give the angles of both sides of the ship, or check from which direction \
                         the angles are counted",
                    ));
                }
                if row.value[k] != 0.0 {
                    odd.push((
                        row.row,
                        format!(
                            "the {name} at {}{at} is {:.2} % of its largest value; the program \
                             takes it as zero, because the other side is the mirror image",
                            given(row),
                            100.0 * share
                        ),
                    ));
                }
            }
        }
    } else {
        odd.extend(asymmetry(angles, most, given, at));
    }
    odd.extend(moment(angles, (flow, convention), most, given, at));
    Ok(odd)
}

/// The warning about the two rows that differ most between the sides, for a table that covers both sides of the ship.
fn asymmetry(
    angles: &Angles,
    most: impl Fn(usize) -> f64,
    given: impl Fn(&Row) -> String,
    at: &str,
) -> Option<(usize, String)> {
    let mut worst: Option<(f64, &Row, &'static str)> = None;
    for row in &angles.rows {
        let Some(other) = angles.rows.iter().find(|o| (o.angle_deg + row.angle_deg).abs() < 0.01)
        else {
            continue;
        };
        for (k, sign, name) in
            [(0, 1.0, "surge force"), (1, -1.0, "side force"), (2, -1.0, "yaw moment")]
        {
            let largest = greater(most(k), f64::MIN_POSITIVE);
            let share = (row.value[k] - sign * other.value[k]).abs() / largest;
            if worst.is_none_or(|(least, ..)| share > least) {
                worst = Some((share, row, name));
            }
        }
    }
    let (share, row, name) = worst.filter(|(share, ..)| *share > ASYMMETRY)?;
    Some((
        row.row,
        format!(
            "at {}{at} the {name} differs from the other side by {:.0} % of its largest value: is \
             a sign wrong on one side?",
            given(row),
            100.0 * share
        ),
    ))
}

/// The warning about a moment of unusual sign: a current on the bow usually turns a hull broadside to the current.
fn moment(
    angles: &Angles,
    (flow, convention): (Flow, &Convention),
    most: impl Fn(usize) -> f64,
    given: impl Fn(&Row) -> String,
    at: &str,
) -> Option<(usize, String)> {
    if flow == Flow::Wind {
        return None;
    }
    let off = |row: &&Row| (row.angle_deg - 45.0).abs();
    let row = angles
        .rows
        .iter()
        .min_by(|a, b| off(a).total_cmp(&off(b)))
        .filter(|row| off(row) < 20.0)?;
    (row.value[2] < -AGAINST * most(2)).then(|| {
        let words = if convention.yaw_to_starboard { "starboard" } else { "port" };
        (
            row.row,
            format!(
                "the moment at {}{at} turns the bow into the current, which is rare for hulls: is \
                 the moment positive with the bow to {words}?",
                given(row)
            ),
        )
    })
}
