//! Rows of bollards.

use std::collections::BTreeSet;

use fenderline_sim::{BodySetup, BollardSetup};

use super::quay::{ChartOf, Kind};
use super::written::shown;
use crate::assemble::assembly::{Assembly, Checked, Names};
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Of, Tables};
use fenderline_keys::keys::bollard_row::{BollardRowKey, RowKey};
use fenderline_keys::keys::mooring::BollardKey;
use fenderline_keys::row_names::name_in_row;
use fenderline_keys::sources::quoted;
use fenderline_keys::typed_key::AnyKey;

impl Assembly<'_, '_> {
    /// All bollards: those of the file, and then those of rows.
    pub(in crate::assemble) fn all_bollards(
        &mut self,
        (single, rows): (Tables<'_, BollardKey>, Tables<'_, BollardRowKey>),
        bodies: &[BodySetup],
        chart: ChartOf<'_>,
        names: &Names,
    ) -> Checked<Vec<BollardSetup>> {
        let mut bollards = self.bollards(single, names)?;
        let mut known: BTreeSet<String> = bollards.iter().map(|of| of.name.clone()).collect();
        for (name, row) in rows.iter() {
            for bollard in self.bollard_row(name, row, bodies, chart, names)? {
                if !known.insert(bollard.name.clone()) {
                    let message = format!(
                        "`{}`: there is a bollard named {} already",
                        row.path,
                        quoted(&bollard.name)
                    );
                    let error = self.sources.error(&row.span, &row.path, message);
                    return Err(error.with_help("take another name for the row"));
                }
                bollards.push(bollard);
            }
        }
        Ok(bollards)
    }

    fn bollard_row(
        &mut self,
        name: &str,
        row: Of<'_, BollardRowKey>,
        bodies: &[BodySetup],
        chart: ChartOf<'_>,
        names: &Names,
    ) -> Checked<Vec<BollardSetup>> {
        self.check_bollard_row(row)?;
        let on = row.given(BollardRowKey::ON);
        let body = self.body_named(row, on, on.name(), names)?;
        let outline = &bodies[body].outline;
        let placed = row.read_as::<RowKey>();
        let behind_m = *row.given(BollardRowKey::BEHIND).number();
        let places_m = if let Some(item) = row.item(BollardRowKey::QUAY_LINE) {
            let kind = Kind { word: "bollard", width_m: 0.0 };
            let mounts = self.along_quay_line(placed, item, kind, &bodies[body], chart)?;
            mounts.iter().map(|mount| mount.position_m - mount.to_water * behind_m).collect()
        } else if let Some(wall) = row.item(BollardRowKey::WALL) {
            let line = self.line_along_wall(placed, wall, outline)?;
            let mut places_m = Vec::new();
            for place_m in line.places_m() {
                let Some(edge) = line.edge.filter(|edge| edge.holds(place_m)) else {
                    let path = row.path_of(BollardRowKey::NUMBER);
                    let span = &row.given(BollardRowKey::NUMBER).span;
                    let message =
                        format!("`{path}`: a bollard at {} is beyond the wall", shown(place_m));
                    let error = self.sources.error(span, &path, message);
                    return Err(match line.edge {
                        Some(edge) => error.with_help(line.what_fits(&edge)),
                        None => error,
                    });
                };
                places_m.push(place_m - edge.outward * behind_m);
            }
            places_m
        } else {
            self.line_from_first(placed, None, outline)?.places_m().collect::<Vec<_>>()
        };
        let most_lines = self.count(row, BollardRowKey::LINES)?;
        let above_water_m = *row.given(BollardRowKey::HEIGHT).number();
        let bollard = |(index, at_m)| BollardSetup {
            name: name_in_row(name, index + 1),
            body,
            at_m,
            above_water_m,
            most_lines,
        };
        Ok(places_m.into_iter().enumerate().map(bollard).collect())
    }

    /// Refuses a row whose keys place the row in two ways, or do not suffice to place the row.
    fn check_bollard_row(&self, row: Of<'_, BollardRowKey>) -> Checked<()> {
        let ways = any_keys![BollardRowKey: QUAY_LINE, WALL, FIRST];
        let others: [&[AnyKey<BollardRowKey>]; 3] = [
            any_keys![BollardRowKey: WALL, FIRST, LAST],
            any_keys![BollardRowKey: FIRST, LAST],
            any_keys![BollardRowKey: FROM_CORNER, BEHIND],
        ];
        let needs: [&[AnyKey<BollardRowKey>]; 3] = [
            any_keys![BollardRowKey: SPACING],
            any_keys![BollardRowKey: SPACING, NUMBER],
            any_keys![BollardRowKey: LAST],
        ];
        let Some(way) = ways.iter().position(|key| row.item(*key).is_some()) else {
            let help = "give `quay_line`, `wall`, or `first` and `last`";
            return Err(self.missing(row, BollardRowKey::FIRST, help));
        };
        let given = others[way].iter().find_map(|key| row.item(*key).filter(|of| !of.is_default));
        if let Some(item) = given {
            let message =
                format!("`{}` does not go together with `{}`", row.path_to(item), ways[way]);
            let error = self.sources.error(&item.key_span, &row.path_to(item), message);
            return Err(error.with_help("keep only one of the two keys"));
        }
        match needs[way].iter().find(|key| row.item(**key).is_none()) {
            Some(missing) => {
                let help = format!("a row with `{}` needs `{missing}`", ways[way]);
                Err(self.missing(row, *missing, &help))
            }
            None => Ok(()),
        }
    }
}
