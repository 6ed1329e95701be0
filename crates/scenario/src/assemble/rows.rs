//! Turns the table of a row of fenders into the tables of the single fenders of the row. The tables of the single
//! fenders keep the path of the row, so that errors and warnings name the row, its key and its line.

mod bollards;
pub(super) mod keys;
mod places;
mod quay;
mod written;

use std::collections::BTreeSet;

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::BodySetup;

use self::places::Line;
pub(super) use self::quay::ChartOf;
use self::quay::Kind;
pub(super) use self::written::rounded;
use self::written::shown;
use super::assembly::{Assembly, Checked, Names};
use super::edge::{direction_rad, edges_with, facing_rad};
use fenderline_keys::checked::{Entry, Item, Of, Table, Value};
use fenderline_keys::held::Points;
use fenderline_keys::keys::fender::FenderKey;
use fenderline_keys::keys::fender_row::FenderRowKey;
use fenderline_keys::keys::{FENDER, ScenarioKey};
use fenderline_keys::overrides::pattern::fits;
use fenderline_keys::row_names::name_in_row;
use fenderline_keys::sources::{Span, quoted};
use fenderline_keys::typed_key::AnyKey;
use fenderline_keys::{any_keys, reader};

/// The place at which one fender of a row stands.
struct Stand {
    body: String,
    position_m: Vec2,
    facing_rad: f64,
}

impl Assembly<'_, '_> {
    /// The tables of all fenders, including the fenders of rows, in the order of the file.
    pub(super) fn fender_tables(
        &mut self,
        file: Of<'_, ScenarioKey>,
        bodies: &[BodySetup],
        chart: ChartOf<'_>,
        names: &Names,
    ) -> Checked<Vec<(String, Table)>> {
        let mut fenders = file.given(ScenarioKey::FENDER).named().to_vec();
        let rows = file.given(ScenarioKey::FENDER_ROW).named();
        if rows.is_empty() {
            return Ok(fenders);
        }
        let mut known: BTreeSet<String> = fenders.iter().map(|(name, _)| name.clone()).collect();
        for (name, row) in rows {
            for (name, fender) in self.row(name, row, bodies, chart, names)? {
                if !known.insert(name.clone()) {
                    let message = format!(
                        "`{}`: there is a fender named {} already",
                        row.path,
                        quoted(&name)
                    );
                    let error = self.sources.error(&row.span, &row.path, message);
                    return Err(error.with_help("take another name for the row"));
                }
                fenders.push((name, fender));
            }
        }
        fenders.sort_by_key(|(_, table)| table.span.start);
        Ok(fenders)
    }

    fn row(
        &mut self,
        name: &str,
        row: Of<'_, FenderRowKey>,
        bodies: &[BodySetup],
        chart: ChartOf<'_>,
        names: &Names,
    ) -> Checked<Vec<(String, Table)>> {
        let stands = match row.item(FenderRowKey::DOLPHINS) {
            Some(dolphins) => self.on_dolphins(name, row, dolphins, bodies, names)?,
            None => self.on_a_line(row, bodies, chart, names)?,
        };
        let count = stands.len();
        let fender = |(index, stand): (usize, Stand)| {
            let name = name_in_row(name, index + 1);
            let table = self.fender_of_row(&name, row, stand)?;
            Ok((name, table))
        };
        let fenders: Vec<_> = stands.into_iter().enumerate().map(fender).collect::<Checked<_>>()?;
        for (pattern, exception) in row.given(FenderRowKey::EXCEPTION).named() {
            if !fenders.iter().any(|(name, _)| fits(pattern, name)) {
                let (first, last) = (name_in_row(name, 1), name_in_row(name, count));
                let path = &exception.path;
                let message = format!(
                    "`{path}`: the row has the fenders {} to {}",
                    quoted(&first),
                    quoted(&last)
                );
                let at = exception.items.iter().find(|item| !item.is_default);
                let span = at.map_or(&exception.span, |item| &item.span);
                return Err(self.sources.error(span, path, message));
            }
        }
        Ok(fenders)
    }

    fn on_dolphins(
        &self,
        name: &str,
        row: Of<'_, FenderRowKey>,
        dolphins: Entry<'_, Points>,
        bodies: &[BodySetup],
        names: &Names,
    ) -> Checked<Vec<Stand>> {
        let position_m =
            row.item(FenderRowKey::FIRST).map_or(vec2(0.0, 0.0), |item| *item.vector());
        let stand = |index: usize| {
            let body = name_in_row(name, index + 1);
            let outline = &bodies[names.bodies[&body]].outline;
            let facing = row.item(FenderRowKey::FACING).map(|item| *item.number());
            let Some(facing_rad) = facing.or_else(|| facing_rad(outline, position_m)) else {
                let help = "the fender is not on an edge of its dolphin: give the direction of the \
                            fender in `facing`";
                return Err(self.missing(row, FenderRowKey::FACING, help));
            };
            Ok(Stand { body, position_m, facing_rad })
        };
        (0..dolphins.outline().len()).map(stand).collect()
    }

    fn on_a_line(
        &mut self,
        row: Of<'_, FenderRowKey>,
        bodies: &[BodySetup],
        chart: ChartOf<'_>,
        names: &Names,
    ) -> Checked<Vec<Stand>> {
        let Some(on) = row.item(FenderRowKey::ON) else {
            return Err(self.missing(
                row,
                FenderRowKey::ON,
                "name the body that carries the row, or give `dolphins`",
            ));
        };
        let body = &bodies[self.body_named(row, on, on.name(), names)?];
        let outline = &body.outline;
        let placed = row.read_as();
        if let Some(item) = row.item(FenderRowKey::QUAY_LINE) {
            let width_m = *row.given(FenderRowKey::WIDTH).number();
            self.refuse_overlap(row, None, *row.given(FenderRowKey::SPACING).number())?;
            let kind = Kind { word: "fender", width_m };
            let mounts = self.along_quay_line(placed, item, kind, body, chart)?;
            let stand = |mount: quay::Mount| Stand {
                body: on.name().to_owned(),
                position_m: mount.position_m,
                facing_rad: mount.facing_rad(),
            };
            return Ok(mounts.into_iter().map(stand).collect());
        }
        let facing = row.item(FenderRowKey::FACING).map(|item| *item.number());
        let line = match row.item(FenderRowKey::WALL) {
            Some(wall) => self.line_along_wall(placed, wall, outline)?,
            None => self.line_from_first(placed, facing, outline)?,
        };
        self.refuse_overlap(row, Some(line.number), line.spacing_m)?;
        let places_m: Vec<Vec2> = line.places_m().collect();
        let ends_m = [places_m[0], places_m[places_m.len() - 1]];
        let facing_rad = match (row.item(FenderRowKey::FACING), line.edge) {
            (Some(item), _) => *item.number(),
            (None, Some(edge)) => direction_rad(edge.outward),
            (None, None) => match edges_with(outline, &ends_m).as_slice() {
                [edge] => direction_rad(edge.outward),
                _ => {
                    let help = "the row does not stand along one edge of its body's outline: give \
                                the direction in which the row faces in `facing`, or places on an \
                                edge";
                    return Err(self.missing(row, FenderRowKey::FACING, help));
                }
            },
        };
        self.check_ends(row, &line)?;
        let stand = |position_m| Stand { body: on.name().to_owned(), position_m, facing_rad };
        Ok(places_m.into_iter().map(stand).collect())
    }

    /// Refuses faces that overlap; the number of fenders is `None` if the length of the line decides on the number.
    fn refuse_overlap(
        &self,
        row: Of<'_, FenderRowKey>,
        number: Option<usize>,
        spacing_m: f64,
    ) -> Checked<()> {
        let width = row.given(FenderRowKey::WIDTH);
        let width_m = *width.number();
        if number.is_some_and(|number| number < 2) || width_m <= spacing_m {
            return Ok(());
        }
        let path = row.path_of(FenderRowKey::WIDTH);
        let message = format!(
            "`{path}`: faces that are {width_m} m wide overlap at a spacing of {} m",
            rounded(spacing_m)
        );
        let error = self.sources.error(&width.span, &path, message);
        Err(error.with_help(
            "give the width of one panel; the spacing is measured from the middle \
                             of one fender to the middle of the next",
        ))
    }

    /// Refuses a row with fenders beyond the end of the edge, and warns of panels that reach beyond the end of the
    /// edge.
    fn check_ends(&mut self, row: Of<'_, FenderRowKey>, line: &Line) -> Checked<()> {
        let Some(edge) = line.edge else { return Ok(()) };
        let at = |key: AnyKey<FenderRowKey>| {
            row.item(key).map_or(row.span.clone(), |item| item.span.clone())
        };
        let ends = [line.first_m, line.place_m(line.number - 1)];
        let reaches = ends.map(|end| edge.reach_m(end));
        let [from, to] = [edge.from_m, edge.end_m()].map(shown);
        let key = match row.item(FenderRowKey::LAST) {
            Some(_) => FenderRowKey::LAST.any(),
            None => FenderRowKey::NUMBER.any(),
        };
        if let Some(end) = ends.iter().find(|end| !edge.holds(**end)) {
            let path = row.path_of(key);
            let (number, place) = (line.number, shown(*end));
            let message = format!(
                "`{path}`: the row of {number} hangs over the end of the quay: a fender at {place} is not on the edge \
                 from {from} to {to}"
            );
            let error = self.sources.error(&at(key), &path, message);
            return Err(error.with_help(line.what_fits(&edge)));
        }
        let half_m = 0.5 * row.given(FenderRowKey::WIDTH).number();
        let beyond = |reach: f64| reach - half_m < -1e-6 || reach + half_m > edge.length_m + 1e-6;
        if reaches.iter().any(|reach| beyond(*reach)) {
            let message = format!(
                "the face of a fender of the row reaches beyond the edge from {from} to {to}"
            );
            self.note_at(&at(key), row.path_of(key), message);
        }
        Ok(())
    }

    /// Makes the table of one fender from the keys of the row, the keys of the exceptions for this fender, and the
    /// fender's place.
    fn fender_of_row(&self, name: &str, row: Of<'_, FenderRowKey>, stand: Stand) -> Checked<Table> {
        let placed = |key: AnyKey<FenderRowKey>, value: Value| {
            let of_row = row.item(key).map_or((row.span.clone(), row.span.clone()), |item| {
                (item.key_span.clone(), item.span.clone())
            });
            let (key_span, span) = of_row;
            Item { name: key.name(), key_span, span, is_default: false, value }
        };
        let mut items = vec![
            placed(FenderRowKey::ON.any(), Value::Name(stand.body)),
            Item {
                name: FenderKey::POSITION.name(),
                ..placed(FenderRowKey::FIRST.any(), Value::Vector(stand.position_m))
            },
            placed(FenderRowKey::FACING.any(), Value::Number(stand.facing_rad)),
        ];
        let shared = |item: &&Item| {
            let placed = any_keys![FenderKey: ON, POSITION, FACING];
            let is_placed = placed.iter().any(|key| item.is(*key));
            !is_placed && FENDER.key(item.name).is_some()
        };
        items.extend(row.items.iter().filter(shared).cloned());
        let mut ranks: Vec<Rank> = items.iter().map(|item| self.rank(false, item)).collect();
        for (pattern, exception) in row.given(FenderRowKey::EXCEPTION).named() {
            if !fits(pattern, name) {
                continue;
            }
            for item in exception.items.iter().filter(|item| !item.is_default) {
                let rank = self.rank(true, item);
                match items.iter().position(|other| other.name == item.name) {
                    None => {
                        items.push(item.clone());
                        ranks.push(rank);
                    }
                    Some(at) if ranks[at] < rank => {
                        items[at] = item.clone();
                        ranks[at] = rank;
                    }
                    Some(_) => {}
                }
            }
        }
        reader::with_defaults(self.sources, &FENDER, &row.path, &row.span, items)
    }

    /// The rank of a key's value, by which one of several values counts. A value on the command line ranks before a
    /// value in the file, and a later option before an earlier option; in the file, an exception ranks before the row.
    fn rank(&self, is_exception: bool, item: &Item) -> Rank {
        let start = if item.is_default { 0 } else { item.span.start };
        let is_override = start > self.sources.text.len();
        (is_override, is_override || is_exception, start)
    }

    pub(super) fn note_at(&mut self, span: &Span, key: String, message: String) {
        let place = self.sources.place(span);
        self.notices.push(fenderline_keys::error::Notice { place, key, message });
    }
}

type Rank = (bool, bool, usize);
