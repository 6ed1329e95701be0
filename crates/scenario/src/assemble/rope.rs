//! Reads the ropes of mooring lines and of their tails, which are of a built-in material or stretch as the user says.

use fenderline_sim::mooring::{Rope, RopeCurve};

use super::assembly::{Assembly, Checked};
use fenderline_keys::any_keys;
use fenderline_keys::checked::Of;
use fenderline_keys::csv::Csv;
use fenderline_keys::error::Notice;
use fenderline_keys::keys::mooring::{BuiltIn, RopeKey};
use fenderline_keys::printable::printable_number;

/// The largest extension of a rope (%).
const LONGEST_PERCENT: f64 = 1000.0;

impl Assembly<'_, '_> {
    /// Reads the rope in the table of a mooring line or of its tail.
    pub(super) fn rope(&mut self, table: Of<'_, RopeKey>) -> Checked<Rope> {
        let break_load_n = *table.given(RopeKey::BREAK_LOAD).number();
        let material = table.given(RopeKey::ROPE);
        let built_in: BuiltIn = material.choice();
        let (stiffness, file) =
            (table.item(RopeKey::AXIAL_STIFFNESS), table.item(RopeKey::LOAD_EXTENSION));
        if let Some(curve) = built_in {
            return match table.first_of(any_keys![RopeKey: AXIAL_STIFFNESS, LOAD_EXTENSION]) {
                None => Ok(Rope { break_load_n, curve: curve() }),
                Some(item) => {
                    let path = table.path_to(item);
                    let word = material.word();
                    let message = format!("`{path}` does not go together with `rope = \"{word}\"`");
                    let error = self.sources.error(&item.key_span, &path, message);
                    Err(error.with_help("remove it, or write rope = \"own\""))
                }
            };
        }
        let curve = match (stiffness, file) {
            (Some(item), None) => {
                RopeCurve::of_stiffness(*item.number(), break_load_n).map_err(|_| {
                    self.refused(
                        table,
                        item,
                        &"the rope would only break when stretched to more than ten times its \
                          length",
                    )
                })?
            }
            (None, Some(_)) => self.load_extension(table, break_load_n)?,
            (Some(_), Some(item)) => {
                let path = table.path_to(item);
                let message = format!("`{path}` does not go together with `axial_stiffness`");
                let error = self.sources.error(&item.key_span, &path, message);
                return Err(error.with_help("keep only one of the two keys"));
            }
            (None, None) => {
                let path = table.path_of(RopeKey::AXIAL_STIFFNESS);
                let message = format!("`{path}` is missing; `rope = \"own\"` needs it");
                let error = self.sources.error(&material.span, &path, message);
                return Err(
                    error.with_help("give `axial_stiffness`, or a curve in `load_extension`")
                );
            }
        };
        Ok(Rope { break_load_n, curve })
    }

    /// Reads a load-extension curve from a file.
    fn load_extension(&mut self, table: Of<'_, RopeKey>, break_load_n: f64) -> Checked<RopeCurve> {
        let (item, key) =
            (table.given(RopeKey::LOAD_EXTENSION), table.path_of(RopeKey::LOAD_EXTENSION));
        let known = ["extension_percent", "load_kn", "load_percent"];
        let csv = Csv::parse(self.files.text(item.text()), item.text(), &key, &known)?;
        let extension = csv.column("extension_percent")?;
        let (load, unit) = match (csv.has("load_kn"), csv.has("load_percent")) {
            (true, true) => {
                return Err(csv.header_error(
                    "the columns `load_kn` and `load_percent` give the same quantity",
                ));
            }
            (false, true) => (csv.column("load_percent")?, 0.01),
            _ => (csv.column("load_kn")?, 1e3 / break_load_n),
        };
        let mut points: Vec<[f64; 2]> = Vec::with_capacity(csv.row_count());
        for row in 0..csv.row_count() {
            let percent = csv.number(row, extension, [0.0, LONGEST_PERCENT])?;
            let share = unit * csv.number(row, load, [0.0, 1e7])?;
            if row == 0 && (percent, share) != (0.0, 0.0) {
                let error = csv.cell_error(row, extension, "the curve begins here".to_owned());
                return Err(error.with_help(
                    "the first row of the curve must be 0, 0, for a rope without load",
                ));
            }
            if share > 10.0 {
                let message = "the load is more than ten times the break load".to_owned();
                return Err(csv.cell_error(row, load, message));
            }
            if let Some([last_strain, last_share]) = points.last() {
                if 0.01 * percent <= *last_strain {
                    let message = format!(
                        "the extension must rise from row to row, but the next value is {percent}"
                    );
                    return Err(csv.cell_error(row, extension, message));
                }
                if share <= *last_share {
                    let message = format!(
                        "the load must rise with the extension, but falls or stays the same in \
                         this row, at {}",
                        printable_number(csv.plain(row, load))
                    );
                    return Err(csv.cell_error(row, load, message));
                }
            }
            points.push([0.01 * percent, share]);
        }
        if points.len() < 2 {
            return Err(csv.header_error("the load-extension curve needs two rows or more"));
        }
        let curve = RopeCurve::new(points).map_err(|error| csv.header_error(error.to_string()))?;
        let last = curve.last_share();
        if last < 1.0 {
            self.notices.push(Notice {
                place: csv.place_of(Some((csv.row_count() - 1, load))),
                key,
                message: format!(
                    "the curve ends at {} % of the break load; beyond its end the curve goes on \
                     with the last slope",
                    printable_number((1e3 * last).round() / 10.0)
                ),
            });
        }
        Ok(curve)
    }
}
