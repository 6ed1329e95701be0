//! Checks the angles of a table of coefficients: which side of the ship the angles cover, and whether there are gaps or
//! repeated rows.

use fenderline_contact::number::{greater, lesser};
use fenderline_sim::environment::Sides;

use super::row::Row;
use crate::assemble::assembly::Checked;
use fenderline_keys::csv::Csv;

/// Angles nearer to each other than this difference count as equal (deg); an end nearer than this to 0 or 180 degrees
/// counts as 0 or 180.
const SAME_DEG: f64 = 0.01;
/// The widest gap between angles over which the table is interpolated (deg).
const WIDEST_DEG: f64 = 60.0;
/// A step between two angles counts as a gap if it is this many times as wide as the median step.
const GAP: f64 = 1.6;

/// The rows of a table at one depth and one draught.
#[derive(Clone, Debug)]
pub(super) struct Angles {
    pub(super) sides: Sides,
    /// Angles of the table (deg), in rising order.
    pub(super) degrees: Vec<f64>,
    /// The row of each angle. If the table covers one side of the ship, its rows are those of that side, turned to
    /// port.
    pub(super) rows: Vec<Row>,
    /// The rows before a gap between angles, each with the warning about the gap.
    pub(super) gaps: Vec<(usize, String)>,
}

impl Angles {
    /// The values X, Y and N for each angle.
    pub(super) fn values(&self) -> Vec<[f64; 3]> {
        self.rows.iter().map(|row| row.value).collect()
    }
}

/// Puts the rows of a table in the order of their angles. Rows for starboard alone are mirrored to port.
///
/// # Errors
/// Fails if two rows at one angle have different values, if the angles do not cover a side or the whole turn, or if a
/// gap between angles is too wide.
pub(super) fn angles(
    csv: &Csv<'_>,
    column: usize,
    mut rows: Vec<Row>,
    at: &str,
) -> Checked<Angles> {
    if rows.is_empty() {
        return Err(csv.header_error(format!("the file has no rows{at}")));
    }
    let ends = |row: &Row| row.angle_deg.abs() < SAME_DEG || row.angle_deg > 180.0 - SAME_DEG;
    let has =
        |side: f64, rows: &[Row]| rows.iter().any(|row| !ends(row) && row.angle_deg * side > 0.0);
    let (port, starboard) = (has(1.0, &rows), has(-1.0, &rows));
    let sides = if port && starboard { Sides::Both } else { Sides::Mirrored };
    if starboard && !port {
        for row in &mut rows {
            let [surge, sway, yaw] = row.value;
            (row.angle_deg, row.value) = (row.angle_deg.abs(), [surge, -sway, -yaw]);
        }
    }
    if sides == Sides::Mirrored {
        for row in &mut rows {
            if row.angle_deg.abs() < SAME_DEG {
                row.angle_deg = 0.0;
            }
            if row.angle_deg > 180.0 - SAME_DEG {
                row.angle_deg = 180.0;
            }
        }
    }
    rows.sort_by(|one, other| {
        one.angle_deg.total_cmp(&other.angle_deg).then(one.row.cmp(&other.row))
    });
    let mut kept: Vec<Row> = Vec::with_capacity(rows.len());
    for row in rows {
        match kept.last() {
            Some(last) if row.angle_deg - last.angle_deg < SAME_DEG => {
                // A row of 360 degrees with the same values as the row of 0 degrees closes a table and adds nothing.
                if (0..3).any(|k| !is_near(row.value[k], last.value[k])) {
                    return Err(second(csv, column, (last, &row), at));
                }
            }
            _ => kept.push(row),
        }
    }
    let degrees: Vec<f64> = kept.iter().map(|row| row.angle_deg).collect();
    let gaps = covered(csv, column, (&kept, &degrees), sides, at)?;
    Ok(Angles { sides, degrees, rows: kept, gaps })
}

fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * (a.abs() + b.abs())
}

fn second(
    csv: &Csv<'_>,
    column: usize,
    (one, other): (&Row, &Row),
    at: &str,
) -> fenderline_keys::error::ScenarioError {
    let (first, later) = (one.row.min(other.row), one.row.max(other.row));
    let given = |row: usize| fenderline_keys::printable::printable_number(csv.plain(row, column));
    csv.cell_error(
        later,
        column,
        format!(
            "the file has a second row for one angle{at}: {} is the angle {} of {}, with other \
             values",
            given(later),
            given(first),
            csv.place_of(Some((first, column)))
        ),
    )
}

/// Checks that the angles cover one side of the ship or the whole turn, and finds gaps between the angles.
fn covered(
    csv: &Csv<'_>,
    column: usize,
    (rows, degrees): (&[Row], &[f64]),
    sides: Sides,
    at: &str,
) -> Checked<Vec<(usize, String)>> {
    let count = degrees.len();
    if sides == Sides::Mirrored && (count < 3 || degrees[0] != 0.0 || degrees[count - 1] != 180.0) {
        let given = |row: &Row| csv.plain(row.row, column);
        let (first, last) = (given(&rows[0]), given(&rows[count - 1]));
        let end = if degrees[0] == 0.0 { &rows[count - 1] } else { &rows[0] };
        let message = format!(
            "the angles do not cover a side{at}: they reach from {} to {}, in {count} rows",
            lesser(first, last),
            greater(first, last)
        );
        return Err(csv.cell_error(end.row, column, message).with_help(
            "a table for one side of the ship needs angles from straight ahead to \
                        straight astern, and some in between",
        ));
    }
    let mut steps: Vec<(f64, usize)> =
        (1..count).map(|k| (degrees[k] - degrees[k - 1], k - 1)).collect();
    if sides == Sides::Both {
        steps.push((degrees[0] + 360.0 - degrees[count - 1], count - 1));
    }
    let mut widths: Vec<f64> = steps.iter().map(|step| step.0).collect();
    widths.sort_by(f64::total_cmp);
    let middle = widths[widths.len() / 2];
    let mut gaps = Vec::new();
    for (width, before) in steps {
        let two = [&rows[before], &rows[(before + 1) % count]];
        // As the file has them.
        let [one, two] = if two[0].row < two[1].row { two } else { [two[1], two[0]] };
        let [from, to] = [one, two].map(|row| csv.plain(row.row, column));
        if width > WIDEST_DEG + SAME_DEG {
            let message = format!(
                "the angles do not cover the whole turn{at}: there is no row between {from} and \
                 {to}, which are {width} degrees apart"
            );
            let error = csv.cell_error(one.row, column, message);
            return Err(error.with_help(format!(
                "the program interpolates over gaps of at most {WIDEST_DEG} degrees"
            )));
        }
        if width > GAP * middle {
            gaps.push((
                one.row,
                format!(
                    "the angles have a gap of {width} degrees{at}: between the rows of {from} and \
                     {to} the forces are interpolated"
                ),
            ));
        }
    }
    Ok(gaps)
}
