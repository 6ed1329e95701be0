//! Reads the user's wind and current coefficients: turns a file and its sign convention into forces divided by dynamic
//! pressure in the program's own axes.

mod angles;
mod row;
mod sense;

use core::f64::consts::PI;
use std::sync::Arc;

use fenderline_sim::environment::wind::{OwnWindTable, ShipWindage, WindMethod};
use fenderline_sim::environment::{LoadTable, Sides};
use fenderline_sim::hydro::Particulars;
use fenderline_sim::{CurrentTable, Environment};

use self::angles::{Angles, angles};
use self::row::{Flow, Row};
use super::assembly::{Assembly, Checked};
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::csv::{Csv, Layout};
use fenderline_keys::error::Notice;
use fenderline_keys::held::{Number, OneOf};
use fenderline_keys::keys::coefficients::{
    CoefficientsKey, Convention, CurrentCoefficientsKey, Held, OF_FORCES, OF_OWN,
    WindCoefficientsKey,
};
use fenderline_keys::keys::vessel::VesselKey;
use fenderline_keys::typed_key::{AnyKey, Key};

/// Bounds of coefficients, wider than the coefficients of any ship.
const COEFFICIENT: [f64; 2] = [-20.0, 20.0];
/// Bounds of the forces in a table of wind or current forces, in the unit of the column.
const FORCE: [f64; 2] = [-1e12, 1e12];
/// Units of force and of moment as they stand in the names of columns, with the size of the unit in N and N m.
const UNITS: [(&str, &str, f64); 3] =
    [("n", "nm", 1.0), ("kn", "knm", 1e3), ("tf", "tfm", 9806.65)];

/// The columns of a file that hold the numbers of a table of wind or current coefficients.
struct Columns {
    angle: usize,
    /// Number of degrees in one unit of the column of angles.
    degrees: f64,
    depth: Option<usize>,
    draught: Option<usize>,
    surge: (usize, f64),
    across: Across,
}

/// Columns of side force and yaw moment, each with the factor that turns its numbers into SI units.
enum Across {
    ForceAndMoment([(usize, f64); 2]),
    AtPerpendiculars([(usize, f64); 2]),
}

impl Assembly<'_, '_> {
    /// The windage of a vessel from the user's wind coefficients; `None` if the vessel's table has no wind
    /// coefficients.
    pub(super) fn own_wind(
        &mut self,
        vessel: Of<'_, VesselKey>,
        ship: &Particulars,
        windage: Option<&ShipWindage>,
    ) -> Checked<Option<ShipWindage>> {
        let Some(item) = vessel.item(VesselKey::WIND_COEFFICIENTS) else { return Ok(None) };
        let of = item.table();
        let shared = of.read_as::<CoefficientsKey>();
        let loads = self.load_table(shared, ship, Flow::Wind)?;
        let number = |name: Key<_, Number>| *shared.given(name).number();
        let (length_m, lateral_m2) =
            (number(CoefficientsKey::YAW_LENGTH), number(CoefficientsKey::SWAY_AREA));
        let height_m = match (of.item(WindCoefficientsKey::CENTROID_HEIGHT), windage) {
            (Some(item), _) => *item.number(),
            (None, Some(windage)) => windage.centroid_height_m,
            (None, None) => 0.5 * lateral_m2 / length_m,
        };
        if let Some(other) = vessel.item(VesselKey::WINDAGE) {
            self.notices.push(Notice {
                place: self.sources.place(&other.key_span),
                key: vessel.path_of(VesselKey::WINDAGE),
                message: "only the height of the centroid in `windage` is used: areas and \
                          coefficients come from `wind_coefficients`"
                    .to_owned(),
            });
        }
        let windage = ShipWindage {
            length_m,
            beam_m: ship.beam_m,
            frontal_m2: number(CoefficientsKey::SURGE_AREA),
            lateral_m2,
            centroid_forward_m: 0.0,
            centroid_height_m: height_m,
            method: WindMethod::Own(OwnWindTable {
                loads: Arc::new(loads),
                reference_height_m: *of.given(WindCoefficientsKey::REFERENCE_HEIGHT).number(),
                source: shared.given(CoefficientsKey::SOURCE).text().into(),
            }),
        };
        windage.check().map_err(|error| self.refused(vessel, item, &error))?;
        Ok(Some(windage))
    }

    /// The user's current coefficients of a vessel; `None` if the vessel's table has no current coefficients.
    pub(super) fn own_current(
        &mut self,
        vessel: Of<'_, VesselKey>,
        ship: &Particulars,
        environment: &Environment,
    ) -> Checked<Option<CurrentTable>> {
        let Some(item) = vessel.item(VesselKey::CURRENT_COEFFICIENTS) else { return Ok(None) };
        let of = item.table();
        let shared = of.read_as::<CoefficientsKey>();
        let loads = self.load_table(shared, ship, Flow::Current)?;
        self.note_depths(shared, &loads, ship, environment);
        let number = |name: Key<_, Number>| *of.given(name).number();
        let speeds_mps = [
            number(CurrentCoefficientsKey::ALONE_UNTIL),
            number(CurrentCoefficientsKey::GONE_FROM),
        ];
        CurrentTable::new(loads, speeds_mps, shared.given(CoefficientsKey::SOURCE).text())
            .map(Some)
            .map_err(|error| self.refused(vessel, item, &error))
    }

    /// Adds warnings if the depths of the water in the run are outside the depths of the table.
    fn note_depths(
        &mut self,
        of: Of<'_, CoefficientsKey>,
        loads: &LoadTable,
        ship: &Particulars,
        environment: &Environment,
    ) {
        let ratios = loads.depth_ratios();
        let (least, most) = (ratios[0], ratios[ratios.len() - 1]);
        if least == most {
            return;
        }
        let mut note = |words: String| {
            self.notices.push(Notice {
                place: self.sources.place(&of.given(CoefficientsKey::FILE).span),
                key: of.path_of(CoefficientsKey::FILE),
                message: words,
            });
        };
        if environment.bottom.is_some() {
            note(format!(
                "the depth of the water depends on the place: where it is less than {least} or more \
                 than {most} draughts, the run uses the forces at {least} or {most} draughts"
            ));
            return;
        }
        let run = environment.depth_range_m().map(|depths_m| depths_m.map(|m| m / ship.draught_m));
        match run {
            None => note(format!(
                "the water is deep: the run uses the table's forces at the greatest depth of the \
                 table, {most} draughts"
            )),
            Some([low, high]) => {
                if low < least {
                    note(format!(
                        "the water is down to {low:.3} draughts deep, but the table begins at \
                         {least}: in shallower water the run uses the forces at {least}"
                    ));
                }
                if high > most {
                    note(format!(
                        "the water is up to {high:.3} draughts deep, but the table ends at {most}: \
                         in deeper water the run uses the forces at {most}"
                    ));
                }
            }
        }
    }

    fn load_table(
        &mut self,
        of: Of<'_, CoefficientsKey>,
        ship: &Particulars,
        flow: Flow,
    ) -> Checked<LoadTable> {
        let convention = self.convention(of)?;
        self.only_with(of, CoefficientsKey::QUANTITY, "forces", OF_FORCES)?;
        let held: Held = of.given(CoefficientsKey::QUANTITY).choice();
        let file = of.given(CoefficientsKey::FILE);
        let key = of.path_of(CoefficientsKey::FILE);
        let known = known(held, flow);
        let known: Vec<&str> = known.iter().map(String::as_str).collect();
        let skip_lines = of.item(CoefficientsKey::SKIP_LINES).map_or(0.0, |item| *item.number());
        if let Some(item) =
            of.item(CoefficientsKey::SKIP_LINES).filter(|_| skip_lines.fract() != 0.0)
        {
            return Err(self.refused(
                of,
                item,
                &format!("the number of lines to skip must be a whole number, but is {skip_lines}"),
            ));
        }
        let layout = Layout {
            skip_lines: skip_lines as usize,
            columns: of.item(CoefficientsKey::COLUMNS).map(Entry::texts),
        };
        let text = self.files.text(file.text());
        let csv = Csv::parse_laid_out(text, file.text(), &key, &known, layout)?;
        let columns = columns(&csv, held)?;
        if let Across::AtPerpendiculars(_) = columns.across {
            let about = of.given(CoefficientsKey::MOMENT_ABOUT);
            if !about.is_default {
                let path = of.path_of(CoefficientsKey::MOMENT_ABOUT);
                let message = format!(
                    "`{path}` does nothing: forces at the perpendiculars have no separate moment"
                );
                return Err(self.sources.error(&about.key_span, &path, message));
            }
        }
        check_unit_of_angles(&csv, &columns)?;
        let draughts = match columns.draught {
            Some(column) => axis(&csv, column, [0.05, 60.0])?,
            None => vec![ship.draught_m],
        };
        let depths = match columns.depth {
            Some(column) => axis(&csv, column, [1.0, 1e4])?,
            None => vec![1.0],
        };
        let scales = scales(of, held);
        let mut rows = Vec::with_capacity(csv.row_count());
        for row in 0..csv.row_count() {
            rows.push(own_row(&csv, &columns, row, (&convention, held, scales), of, ship)?);
        }
        let at = |row: usize, column: Option<usize>, axis: &[f64]| {
            let number = column.map_or(axis[0], |column| csv.plain(row, column));
            axis.iter().position(|value| *value == number).unwrap_or(0)
        };
        let mut groups: Vec<Vec<Row>> = vec![Vec::new(); draughts.len() * depths.len()];
        for row in rows {
            let index = at(row.row, columns.draught, &draughts) * depths.len();
            groups[index + at(row.row, columns.depth, &depths)].push(row);
        }
        let place = |group: usize| {
            let mut words = Vec::new();
            if columns.draught.is_some() {
                words.push(format!("draught_m = {}", draughts[group / depths.len()]));
            }
            if columns.depth.is_some() {
                words.push(format!("depth_ratio = {}", depths[group % depths.len()]));
            }
            if words.is_empty() { String::new() } else { format!(" at {}", words.join(", ")) }
        };
        let mut of_first: Option<Angles> = None;
        let mut tables = Vec::with_capacity(groups.len());
        for (group, rows) in groups.into_iter().enumerate() {
            let found = angles(&csv, columns.angle, rows, &place(group))?;
            match &of_first {
                Some(first) if first.degrees != found.degrees || first.sides != found.sides => {
                    return Err(csv.header_error(format!(
                        "the rows{} have other angles than the rows{}",
                        place(group),
                        place(0)
                    )));
                }
                Some(_) => {}
                None => of_first = Some(Angles { rows: Vec::new(), ..found.clone() }),
            }
            let words =
                sense::check(&csv, columns.angle, &found, (flow, &convention), &place(group))?;
            for (row, message) in words {
                let place = csv.place_of(Some((row, columns.angle)));
                self.notices.push(Notice { place, key: key.clone(), message });
            }
            tables.push(found.values());
        }
        let Some(Angles { degrees, sides, gaps, .. }) = of_first else {
            unreachable!("a file without rows is refused")
        };
        for (row, message) in gaps {
            let place = csv.place_of(Some((row, columns.angle)));
            self.notices.push(Notice { place, key: key.clone(), message });
        }
        if sides == Sides::Mirrored {
            self.notices.push(Notice {
                place: csv.place_of(None),
                key: key.clone(),
                message: "the angles cover one side of the ship: the other side is taken as the \
                          mirror image"
                    .to_owned(),
            });
        }
        let values = self.at_draught(of, &draughts, depths.len(), tables, ship);
        let angles_rad = degrees.iter().map(|degrees| degrees / 180.0 * PI).collect();
        LoadTable::new(depths, angles_rad, values, sides)
            .map_err(|error| csv.header_error(error.to_string()))
    }

    /// Interpolates the tables of all depths to the draught of the vessel.
    fn at_draught(
        &mut self,
        of: Of<'_, CoefficientsKey>,
        draughts: &[f64],
        depths: usize,
        tables: Vec<Vec<[f64; 3]>>,
        ship: &Particulars,
    ) -> Vec<[f64; 3]> {
        let draught_m = ship.draught_m;
        let last = draughts.len() - 1;
        if draughts.len() > 1 && (draught_m < draughts[0] || draught_m > draughts[last]) {
            self.notices.push(Notice {
                place: self.sources.place(&of.given(CoefficientsKey::FILE).span),
                key: of.path_of(CoefficientsKey::FILE),
                message: format!(
                    "the vessel's draught of {draught_m} m is outside the draughts of the table, \
                     which go from {} to {} m: the nearest draught of the table is used",
                    draughts[0], draughts[last]
                ),
            });
        }
        let upper = draughts.iter().position(|m| *m >= draught_m).unwrap_or(last);
        let lower = if upper > 0 && draught_m < draughts[upper] { upper - 1 } else { upper };
        let share = match upper == lower {
            true => 0.0,
            false => (draught_m - draughts[lower]) / (draughts[upper] - draughts[lower]),
        };
        let of_draught = |index: usize| tables[index * depths..(index + 1) * depths].concat();
        let (low, high) = (of_draught(lower), of_draught(upper));
        let mixed = |(one, two): (&[f64; 3], &[f64; 3])| {
            core::array::from_fn(|k| one[k] + share * (two[k] - one[k]))
        };
        low.iter().zip(&high).map(mixed).collect()
    }

    fn convention(&self, of: Of<'_, CoefficientsKey>) -> Checked<Convention> {
        self.only_with(of, CoefficientsKey::CONVENTION, "own", OF_OWN)?;
        let is = |key: Key<_, OneOf<bool>>| of.given(key).choice();
        Ok(of.given(CoefficientsKey::CONVENTION).choice().unwrap_or_else(|| Convention {
            zero_is_ahead: is(CoefficientsKey::ANGLE_ZERO),
            side_is_port: is(CoefficientsKey::ANGLE_SIDE),
            surge_forward: is(CoefficientsKey::SURGE_POSITIVE),
            sway_to_starboard: is(CoefficientsKey::SWAY_POSITIVE),
            yaw_to_starboard: is(CoefficientsKey::YAW_POSITIVE),
        }))
    }

    /// Checks that the keys `keys` are given if the key `key` has the word `word`, and are not given otherwise.
    fn only_with<T, C>(
        &self,
        of: Of<'_, T>,
        key: Key<T, OneOf<C>>,
        word: &str,
        keys: &[AnyKey<T>],
    ) -> Checked<()> {
        let given = of.given(key);
        for &other in keys {
            let path = of.path_of(other);
            match (of.item(other), given.word() == word) {
                (None, true) => {
                    let message = format!("`{path}` is missing; `{key} = \"{word}\"` needs it");
                    return Err(self.sources.error(&given.span, &path, message));
                }
                (Some(item), false) => {
                    let message = format!(
                        "`{path}` does not go together with `{key} = \"{}\"`",
                        given.word()
                    );
                    let error = self.sources.error(&item.key_span, &path, message);
                    return Err(error.with_help(format!("remove it, or write {key} = \"{word}\"")));
                }
                _ => {}
            }
        }
        Ok(())
    }
}

/// The columns that a file of coefficients may have.
fn known(held: Held, flow: Flow) -> Vec<String> {
    let mut known: Vec<String> =
        ["angle_deg", "angle_rad", "draught_m"].map(str::to_owned).to_vec();
    if flow == Flow::Current {
        known.push("depth_ratio".to_owned());
    }
    match held {
        Held::Coefficients => {
            known.extend(["cx", "cy", "cn", "cxy", "cyf", "cya"].map(str::to_owned));
        }
        Held::Forces => {
            for (force, moment, _) in UNITS {
                known.extend(["x", "y", "yf", "ya"].map(|name| format!("{name}_{force}")));
                known.push(format!("n_{moment}"));
            }
        }
    }
    known
}

fn columns(csv: &Csv<'_>, held: Held) -> Checked<Columns> {
    let (angle, degrees) = match (csv.has("angle_deg"), csv.has("angle_rad")) {
        (true, true) => {
            return Err(
                csv.header_error("the file gives the angles twice, in degrees and in radians")
            );
        }
        (false, true) => (csv.column("angle_rad")?, 180.0 / PI),
        _ => (csv.column("angle_deg")?, 1.0),
    };
    // The one column among several names.
    let one = |names: &[(String, f64)]| -> Checked<Option<(usize, f64)>> {
        let mut there = names.iter().filter(|(name, _)| csv.has(name));
        match (there.next(), there.next()) {
            (Some((name, _)), Some((other, _))) => Err(csv.header_error(format!(
                "the columns `{name}` and `{other}` give the same quantity"
            ))),
            (Some((name, scale)), None) => Ok(Some((csv.column(name)?, *scale))),
            (None, _) => Ok(None),
        }
    };
    let names = |coefficients: &[&str], force: &str| -> Vec<(String, f64)> {
        match held {
            Held::Coefficients => {
                coefficients.iter().map(|name| ((*name).to_owned(), 1.0)).collect()
            }
            Held::Forces => UNITS
                .iter()
                .map(|(of_force, of_moment, scale)| {
                    let unit = if force == "n" { of_moment } else { of_force };
                    (format!("{force}_{unit}"), *scale)
                })
                .collect(),
        }
    };
    let needed = |names: Vec<(String, f64)>, found: Option<(usize, f64)>| {
        found.ok_or_else(|| {
            let names: Vec<&str> = names.iter().map(|(name, _)| name.as_str()).collect();
            csv.header_error(format!("a column is missing: {}", names.join(" or ")))
        })
    };
    let [sway, yaw] = [names(&["cy"], "y"), names(&["cn", "cxy"], "n")];
    let [fore, aft] = [names(&["cyf"], "yf"), names(&["cya"], "ya")];
    let [of_sway, of_yaw] = [one(&sway)?, one(&yaw)?];
    let [of_fore, of_aft] = [one(&fore)?, one(&aft)?];
    let across = match (of_sway.or(of_yaw), of_fore.or(of_aft)) {
        (Some(_), Some(_)) => {
            return Err(csv.header_error(
                "the file gives side force and moment twice: keep either side force and moment, or \
                 the forces at the two perpendiculars",
            ));
        }
        (None, Some(_)) => Across::AtPerpendiculars([needed(fore, of_fore)?, needed(aft, of_aft)?]),
        _ => Across::ForceAndMoment([needed(sway, of_sway)?, needed(yaw, of_yaw)?]),
    };
    let surge = names(&["cx"], "x");
    let of_surge = one(&surge)?;
    let any = |name: &str| csv.has(name).then(|| csv.column(name)).transpose();
    Ok(Columns {
        angle,
        degrees,
        depth: any("depth_ratio")?,
        draught: any("draught_m")?,
        surge: needed(surge, of_surge)?,
        across,
    })
}

/// Refuses angles in radians in a column named for degrees, and angles in degrees in a column named for radians.
fn check_unit_of_angles(csv: &Csv<'_>, columns: &Columns) -> Checked<()> {
    let is_rad = columns.degrees != 1.0;
    let (mut most, mut at) = (0.0, 0);
    for row in 0..csv.row_count() {
        let angle = csv.number(row, columns.angle, [-720.0, 720.0])?.abs();
        if angle > most {
            (most, at) = (angle, row);
        }
    }
    let (found, other) = match (is_rad, most > 6.3) {
        (true, true) => ("degrees", "angle_deg"),
        (false, false) if csv.row_count() > 2 && most > 0.0 => ("radians", "angle_rad"),
        _ => return Ok(()),
    };
    let message = format!("the largest angle is {most}: the angles of this column are {found}");
    Err(csv.cell_error(at, columns.angle, message).with_help(format!("name the column `{other}`")))
}

/// The different values of a column in rising order, each value once.
fn axis(csv: &Csv<'_>, column: usize, bounds: [f64; 2]) -> Checked<Vec<f64>> {
    let numbers: Checked<Vec<f64>> =
        (0..csv.row_count()).map(|row| csv.number(row, column, bounds)).collect();
    let mut numbers = numbers?;
    numbers.sort_by(f64::total_cmp);
    numbers.dedup();
    Ok(numbers)
}

/// The factors by which the numbers of the table are multiplied, to get X, Y and N divided by dynamic pressure (m², m²,
/// m³).
fn scales(of: Of<'_, CoefficientsKey>, held: Held) -> [f64; 3] {
    let number = |name: Key<_, Number>| *of.given(name).number();
    match held {
        Held::Coefficients => {
            let lateral_m2 = number(CoefficientsKey::SWAY_AREA);
            [
                number(CoefficientsKey::SURGE_AREA),
                lateral_m2,
                lateral_m2 * number(CoefficientsKey::YAW_LENGTH),
            ]
        }
        Held::Forces => {
            let speed_mps = number(CoefficientsKey::AT_SPEED);
            [1.0 / (0.5 * number(CoefficientsKey::AT_DENSITY) * speed_mps * speed_mps); 3]
        }
    }
}

/// Turns a row of the file into the program's own axes.
fn own_row(
    csv: &Csv<'_>,
    columns: &Columns,
    row: usize,
    (convention, held, scales): (&Convention, Held, [f64; 3]),
    of: Of<'_, CoefficientsKey>,
    ship: &Particulars,
) -> Checked<Row> {
    let bounds = if held == Held::Coefficients { COEFFICIENT } else { FORCE };
    let number = |(column, unit): (usize, f64)| Ok(unit * csv.number(row, column, bounds)?);
    let sign = |positive: bool| if positive { 1.0 } else { -1.0 };
    let to_starboard = sign(convention.sway_to_starboard);
    let surge = sign(convention.surge_forward) * scales[0] * number(columns.surge)?;
    let (sway, yaw) = match columns.across {
        Across::ForceAndMoment([sway, yaw]) => {
            let sway = to_starboard * scales[1] * number(sway)?;
            let yaw = sign(convention.yaw_to_starboard) * scales[2] * number(yaw)?;
            // From the table's point to midship.
            (sway, yaw + of.given(CoefficientsKey::MOMENT_ABOUT).number() * sway)
        }
        Across::AtPerpendiculars([fore, aft]) => {
            let [fore, aft] = [number(fore)?, number(aft)?].map(|y| to_starboard * scales[1] * y);
            (fore + aft, 0.5 * ship.length_m * (fore - aft))
        }
    };
    let degrees = columns.degrees * csv.number(row, columns.angle, [-720.0, 720.0])?;
    Ok(Row { row, angle_deg: own_angle(convention, degrees), value: [surge, sway, yaw] })
}

/// Turns an angle of the table into the angle γ, which is 0 from ahead, positive over port, and above −180 and up to
/// 180 degrees.
fn own_angle(convention: &Convention, degrees: f64) -> f64 {
    let from_ahead = if convention.zero_is_ahead { degrees } else { 180.0 - degrees };
    let over_port = if convention.side_is_port { from_ahead } else { -from_ahead };
    let wrapped = libm::remainder(over_port, 360.0);
    if wrapped <= -180.0 { 180.0 } else { wrapped + 0.0 }
}
