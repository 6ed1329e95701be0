//! Where the fenders of a row stand: on a straight line, equally far apart.

use fenderline_contact::{Outline, Rotation, Vec2, vec2};

use super::written::{one_of_two, rounded, shown};
use crate::assemble::assembly::{Assembly, Checked};
use crate::assemble::edge::{Edge, edges_with};
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::held::{Number, Points, Vector};
use fenderline_keys::keys::bollard_row::RowKey;
use fenderline_keys::keys::fender_row::MOST_IN_ROW;

/// The places of the fenders of a row on a straight line.
pub(super) struct Line {
    pub(super) first_m: Vec2,
    /// Unit vector from the first fender to the last.
    along: Vec2,
    pub(super) spacing_m: f64,
    pub(super) number: usize,
    /// The edge of the body's outline along which the row of fenders runs.
    pub(super) edge: Option<Edge>,
    /// True if the row of fenders stands in the middle of its wall, and does not begin at a given first fender.
    is_in_the_middle: bool,
}

impl Line {
    pub(super) fn place_m(&self, index: usize) -> Vec2 {
        self.first_m + self.along * (self.spacing_m * index as f64)
    }

    pub(super) fn places_m(&self) -> impl Iterator<Item = Vec2> {
        (0..self.number).map(|index| self.place_m(index))
    }

    /// Says which number of fenders or which spacing would fit on an edge, for the help of an error.
    pub(super) fn what_fits(&self, edge: &Edge) -> String {
        let spacing_m = rounded(self.spacing_m);
        let room_m = if self.is_in_the_middle {
            edge.length_m
        } else {
            // From the first fender to the end of the edge towards which the row runs.
            let reach_m = edge.reach_m(self.first_m);
            let is_along = self.along.dot(edge.along) > 0.0;
            if is_along { edge.length_m - reach_m } else { reach_m }
        };
        if !self.is_in_the_middle && !edge.holds(self.first_m) {
            return "the first fender of the row is not on this edge itself".to_owned();
        }
        let number = 1 + libm::floor(room_m / self.spacing_m + 1e-9) as usize;
        let gaps = (self.number - 1) as f64;
        let least_m = libm::floor(room_m / gaps * 1000.0) / 1000.0;
        format!(
            "on {} m there is room for {number} at a spacing of {spacing_m} m, or for {} at a \
             spacing of {least_m} m",
            rounded(room_m),
            self.number
        )
    }
}

/// Whether an edge runs along a direction or opposite to it.
fn is_along(edge: &Edge, direction: Vec2) -> bool {
    edge.along.cross(direction).abs() < 1e-6
}

/// Returns the given direction or its opposite, whichever runs forward; if the direction runs straight across the body,
/// whichever runs to starboard.
fn forward(direction: Vec2) -> Vec2 {
    let is_across = direction.x.abs() < 1e-9;
    let is_back = if is_across { direction.y < 0.0 } else { direction.x < 0.0 };
    if is_back { -direction } else { direction }
}

impl Assembly<'_, '_> {
    /// The places of the fenders in a row that begins at the place of the key `first`.
    pub(super) fn line_from_first(
        &self,
        row: Of<'_, RowKey>,
        facing_rad: Option<f64>,
        outline: &Outline,
    ) -> Checked<Line> {
        let Some(first) = row.item(RowKey::FIRST) else {
            let help = "give the place of the first one in `first`, or give a `wall`, a `quay_line` or `dolphins`";
            return Err(self.missing(row, RowKey::FIRST, help));
        };
        let first_m = *first.vector();
        match (row.item(RowKey::SPACING), row.item(RowKey::NUMBER), row.item(RowKey::LAST)) {
            (Some(spacing), Some(number), None) => {
                let (along, edge) = self.direction(row, facing_rad, first, outline)?;
                let number = self.whole_number(row, number)?;
                let spacing_m = *spacing.number();
                Ok(Line { first_m, along, spacing_m, number, edge, is_in_the_middle: false })
            }
            (Some(_), None, Some(last)) | (None, Some(_), Some(last)) => {
                self.line_to_last(row, first_m, last, outline)
            }
            (Some(_), Some(_), Some(last)) => {
                let path = row.path_of(RowKey::LAST);
                let message = format!("`{path}` does not go together with `spacing` and `number`");
                Err(one_of_two(self.sources.error(&last.key_span, &path, message)))
            }
            (spacing, _, _) => {
                let missing = match spacing {
                    Some(_) => RowKey::NUMBER,
                    None => RowKey::SPACING,
                };
                Err(one_of_two(self.missing(row, missing, "")))
            }
        }
    }

    fn line_to_last(
        &self,
        row: Of<'_, RowKey>,
        first_m: Vec2,
        last: Entry<'_, Vector>,
        outline: &Outline,
    ) -> Checked<Line> {
        let whole_m = *last.vector() - first_m;
        let length_m = whole_m.length();
        let path = row.path_of(RowKey::LAST);
        if length_m <= 0.0 {
            let message = format!("`{path}` is at the place of the first fender");
            return Err(self.sources.error(&last.span, &path, message));
        }
        let (spacing_m, number) = match row.item(RowKey::NUMBER) {
            Some(item) => {
                let number = self.whole_number(row, item)?;
                if number < 2 {
                    let path = row.path_of(RowKey::NUMBER);
                    let message =
                        format!("`{path}` must be at least 2 for a row from `first` to `last`");
                    return Err(self.sources.error(&item.span, &path, message));
                }
                (length_m / (number - 1) as f64, number)
            }
            None => {
                let spacing_m = *row.given(RowKey::SPACING).number();
                let gaps = libm::round(length_m / spacing_m);
                if (gaps * spacing_m - length_m).abs() > 0.01 || gaps + 1.0 > MOST_IN_ROW as f64 {
                    let message = format!(
                        "`{path}`: the row is {} m long, which is not a multiple of the spacing of \
                         {} m, or would have more than {MOST_IN_ROW} fenders",
                        rounded(length_m),
                        rounded(spacing_m)
                    );
                    let help = format!(
                        "a length of {} m would be nearest; or give `number`",
                        rounded(gaps * spacing_m)
                    );
                    return Err(self.sources.error(&last.span, &path, message).with_help(help));
                }
                (spacing_m, gaps as usize + 1)
            }
        };
        let along = whole_m * (1.0 / length_m);
        let edge = edges_with(outline, &[first_m]).into_iter().find(|edge| is_along(edge, along));
        Ok(Line { first_m, along, spacing_m, number, edge, is_in_the_middle: false })
    }

    /// The direction of a row of fenders without the key `last`, and the edge along which the row runs.
    fn direction(
        &self,
        row: Of<'_, RowKey>,
        facing_rad: Option<f64>,
        first: Entry<'_, Vector>,
        outline: &Outline,
    ) -> Checked<(Vec2, Option<Edge>)> {
        let facing = facing_rad.map(|rad| Rotation::from_angle(rad).apply(vec2(1.0, 0.0)));
        let edges = edges_with(outline, &[*first.vector()]);
        let edge = match (edges.as_slice(), facing) {
            ([edge], _) => Some(*edge),
            (_, Some(facing)) => {
                edges.iter().copied().find(|edge| is_along(edge, facing.quarter_turn()))
            }
            _ => None,
        };
        if let Some(edge) = edge {
            return Ok((forward(edge.along), Some(edge)));
        }
        if let Some(facing) = facing {
            return Ok((forward(facing.quarter_turn()), None));
        }
        let path = row.path_of(RowKey::FIRST);
        let message = match edges.len() {
            0 => format!(
                "`{path}`: {} is not on the outline of the body, so the direction of the row is \
                 not known",
                shown(*first.vector())
            ),
            _ => format!(
                "`{path}`: {} is a corner of the body, so the edge of the row is not known",
                shown(*first.vector())
            ),
        };
        let error = self.sources.error(&first.span, &path, message);
        Err(error.with_help("give `last` or `facing`, or a place of `first` on an edge"))
    }

    /// The places of the fenders in a row along a wall.
    pub(super) fn line_along_wall(
        &self,
        row: Of<'_, RowKey>,
        wall: Entry<'_, Points>,
        outline: &Outline,
    ) -> Checked<Line> {
        let [from_m, to_m] = [wall.outline()[0], wall.outline()[1]];
        let path = row.path_of(RowKey::WALL);
        let edges = edges_with(outline, &[from_m, to_m]);
        let length_m = (to_m - from_m).length();
        let (Some(edge), true) = (edges.first(), length_m > 0.02) else {
            let message = format!(
                "`{path}`: there is no edge of the body's outline with {} and {} on it",
                shown(from_m),
                shown(to_m)
            );
            let error = self.sources.error(&wall.span, &path, message);
            return Err(
                error.with_help("give two corners of the body's outline, in the axes of the body")
            );
        };
        let along = (to_m - from_m) * (1.0 / length_m);
        let spacing_m = *row.given(RowKey::SPACING).number();
        let number = self.whole_number(row, row.given(RowKey::NUMBER))?;
        let row_m = spacing_m * (number - 1) as f64;
        let start_m =
            row.item(RowKey::FROM_CORNER).map_or(0.5 * (length_m - row_m), |item| *item.number());
        // The wall may be a part of the edge: the row must not reach beyond the wall.
        let edge = Edge { along, length_m, from_m, ..*edge };
        Ok(Line {
            first_m: from_m + along * start_m,
            along,
            spacing_m,
            number,
            edge: Some(edge),
            is_in_the_middle: row.item(RowKey::FROM_CORNER).is_none(),
        })
    }

    pub(super) fn whole_number<T>(
        &self,
        row: Of<'_, T>,
        item: Entry<'_, Number>,
    ) -> Checked<usize> {
        let number = *item.number();
        if libm::trunc(number) == number {
            // The key table bounds the number.
            return Ok(number as usize);
        }
        let path = row.path_to(item);
        let message = format!("`{path}` must be a whole number, but is {number}");
        Err(self.sources.error(&item.span, &path, message))
    }
}
