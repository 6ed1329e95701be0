//! Where the fenders and bollards of a row stand along a quay line of the chart.

use fenderline_contact::{Pose, Vec2};
use fenderline_sim::BodySetup;
use fenderline_sim::chart::{Chart, SHORE};

use super::written::{rounded, shown};
use crate::assemble::assembly::{Assembly, Checked};
use crate::assemble::edge::direction_rad;
use fenderline_charts::chart::solid_words;
use fenderline_charts::quay::{QuayLine, Refusal, Request, face_m, has_water, is_in};
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::TableOf;
use fenderline_keys::keys::bollard_row::RowKey;
use fenderline_keys::keys::chart::ChartKey;
use fenderline_keys::keys::fender_row::MOST_IN_ROW;
use fenderline_keys::keys::quay_line::{NEAR_LINE_M, QuayLineKey, WaterSide};
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;

/// How far from the line of the chart the face of the body may lie (m); our choice.
const NEAR_FACE_M: f64 = 0.5;
/// Beyond the face of a strip, the distance at which charted water is looked for (m); our choice.
const WATER_M: f64 = 2.0;
/// A turn of the line by more than this is a corner, beyond which no face of a fender should reach (rad); our choice.
const CORNER_RAD: f64 = 0.1;

/// The chart of a scenario, with its table in the file.
#[derive(Clone, Copy)]
pub(in crate::assemble) struct ChartOf<'c> {
    pub(in crate::assemble) chart: &'c Chart,
    pub(in crate::assemble) table: Option<Of<'c, ChartKey>>,
}

/// What stands along a line.
#[derive(Clone, Copy)]
pub(super) struct Kind {
    /// In words: a fender or a bollard.
    pub(super) word: &'static str,
    /// Width along the line (m).
    pub(super) width_m: f64,
}

/// The place of one fender or bollard on the face of a body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mount {
    /// Forward and to starboard of the body's origin (m).
    pub(super) position_m: Vec2,
    /// Unit vector towards the water, in the body's axes.
    pub(super) to_water: Vec2,
}

impl Mount {
    pub(super) fn facing_rad(self) -> f64 {
        direction_rad(self.to_water)
    }
}

/// A body with its outline, asked for places of the scenario.
struct Ashore<'b> {
    body: &'b BodySetup,
    pose: Pose,
    /// Half of the width of the strips that lines of the shore have become (m).
    half_strip_m: f64,
}

impl Ashore<'_> {
    fn is_solid(&self, at_m: Vec2) -> bool {
        is_in(self.body.outline.polygons(), self.pose.apply_inverse(at_m))
    }

    fn reach_m(&self) -> f64 {
        self.half_strip_m + NEAR_FACE_M
    }

    /// The side of a line on which the water lies at a place, with the unit vector to the right of the line; `Err` has
    /// the reason why it is not known.
    fn water(&self, at_m: Vec2, right: Vec2, chart: &Chart) -> Result<WaterSide, &'static str> {
        let mut is_near = false;
        for off_m in [NEAR_FACE_M, self.reach_m()] {
            let sides = [-off_m, off_m].map(|off_m| self.is_solid(at_m + right * off_m));
            match sides {
                [true, false] => return Ok(WaterSide::Right),
                [false, true] => return Ok(WaterSide::Left),
                [is_solid, _] => is_near |= is_solid,
            }
        }
        if !is_near {
            return Err("the body has no face there");
        }
        let off_m = self.reach_m() + WATER_M;
        let sides = [-off_m, off_m].map(|off_m| {
            let at_m = at_m + right * off_m;
            has_water(chart, at_m) && !self.is_solid(at_m)
        });
        match sides {
            [true, false] => Ok(WaterSide::Left),
            [false, true] => Ok(WaterSide::Right),
            [true, true] => Err("the chart has water on both sides"),
            [false, false] => Err("the chart has no depth area on either side"),
        }
    }
}

impl Assembly<'_, '_> {
    /// The places of a row along a quay line of the chart.
    pub(super) fn along_quay_line(
        &mut self,
        row: Of<'_, RowKey>,
        item: Entry<'_, TableOf<QuayLineKey>>,
        kind: Kind,
        body: &BodySetup,
        of: ChartOf<'_>,
    ) -> Checked<Vec<Mount>> {
        let table = item.table();
        if !body.is_fixed() {
            let on = row.given(RowKey::ON);
            let path = row.path_of(RowKey::ON);
            let message =
                format!("`{path}`: a row along a line of the chart stands on a fixed body");
            return Err(self.sources.error(&on.span, &path, message));
        }
        let line = self.quay_line(table, of)?;
        let (reaches_m, is_given) = self.reaches(row, &line, kind)?;
        let ashore = Ashore {
            body,
            pose: Pose::new(body.position_m, body.heading_rad),
            half_strip_m: match of.table.and_then(|table| table.item(ChartKey::SOLID_WIDTH)) {
                Some(width) if body.name == SHORE => 0.5 * width.number(),
                _ => 0.0,
            },
        };
        let complain = |at_m: Vec2, why: &str| {
            let path = row.path_of(RowKey::QUAY_LINE);
            let message = format!(
                "`{path}`: {why} at {} north and east, where a {} of the row would stand",
                shown(at_m),
                kind.word
            );
            self.sources.error(&item.key_span, &path, message)
        };
        let side = match table.item(QuayLineKey::WATER).map(|item| item.choice()) {
            Some(side) => side,
            None => {
                let mut found: Option<(WaterSide, Vec2)> = None;
                for reach_m in &reaches_m {
                    let (at_m, along) = line.at(*reach_m);
                    let side =
                        ashore.water(at_m, along.quarter_turn(), of.chart).map_err(|why| {
                            let why = format!(
                                "on which side of the line the water lies is not known: {why}"
                            );
                            complain(at_m, &why).with_help(format!(
                                "give `water`, or a line on the border of {}",
                                quoted(&body.name)
                            ))
                        })?;
                    match found {
                        Some((other, other_m)) if other != side => {
                            let why = format!(
                                "the water lies on another side of the line than at {}",
                                shown(other_m)
                            );
                            return Err(complain(at_m, &why)
                                .with_help("make a row for each part of the line"));
                        }
                        _ => found = Some((side, at_m)),
                    }
                }
                found.map_or(WaterSide::Right, |(side, _)| side)
            }
        };
        let mut mounts = Vec::new();
        for reach_m in &reaches_m {
            let (at_m, along) = line.at(*reach_m);
            let to_water = match side {
                WaterSide::Right => along.quarter_turn(),
                WaterSide::Left => along.quarter_turn_back(),
            };
            let in_body_m = ashore.pose.apply_inverse(at_m);
            let to_water = ashore.pose.rotation.apply_inverse(to_water);
            let outline = &body.outline;
            let reach_m = ashore.reach_m();
            let off_m = face_m(in_body_m, to_water, reach_m, outline.edges(), outline.polygons());
            let Some(off_m) = off_m else {
                let why = format!(
                    "body {} has no face towards the water within {} m of the line",
                    quoted(&body.name),
                    rounded(ashore.reach_m())
                );
                let help = match table.item(QuayLineKey::WATER) {
                    Some(_) => "the key `water` may name the wrong side of the line",
                    None => "the line must be the border of the body",
                };
                return Err(complain(at_m, &why).with_help(help));
            };
            mounts.push(Mount { position_m: in_body_m + to_water * off_m, to_water });
        }
        let half_m = 0.5 * kind.width_m;
        let length_m = line.length_m();
        let is_past = |reach_m: &&f64| {
            **reach_m - half_m < -1e-6
                || **reach_m + half_m > length_m + 1e-6
                || line.turns().any(|(corner_m, turn_rad)| {
                    turn_rad > CORNER_RAD && (corner_m - **reach_m).abs() < half_m - 1e-6
                })
        };
        if let Some(reach_m) = reaches_m.iter().find(is_past).filter(|_| kind.width_m > 0.0) {
            let message = format!(
                "the face of a fender of the row reaches beyond a corner or the end of the line, at {} north and east",
                shown(line.at(*reach_m).0)
            );
            let key = if is_given { RowKey::NUMBER.any() } else { RowKey::QUAY_LINE.any() };
            let span = row.item(key).map_or(row.span.clone(), |item| item.span.clone());
            self.note_at(&span, row.path_of(key), message);
        }
        Ok(mounts)
    }

    /// The distances along the line at which the row stands (m), and whether the file gives their number.
    fn reaches(
        &self,
        row: Of<'_, RowKey>,
        line: &QuayLine,
        Kind { word, width_m }: Kind,
    ) -> Checked<(Vec<f64>, bool)> {
        let path = row.path_of(RowKey::QUAY_LINE);
        let length_m = line.length_m();
        let refuse = |message: String| {
            let item = row.given(RowKey::QUAY_LINE);
            self.sources.error(&item.key_span, &path, format!("`{path}`: {message}"))
        };
        if length_m < width_m {
            return Err(refuse(format!(
                "the line is {} m long, shorter than one {word} of {} m",
                rounded(length_m),
                rounded(width_m)
            )));
        }
        let spacing_m = *row.given(RowKey::SPACING).number();
        let from_m = row.item(RowKey::FROM_CORNER).map(|item| *item.number());
        let room_m = match from_m {
            Some(from_m) => length_m - from_m - 0.5 * width_m,
            None => length_m - width_m,
        };
        if room_m < 0.0 {
            let path = row.path_of(RowKey::FROM_CORNER);
            let item = row.given(RowKey::FROM_CORNER);
            let message = format!(
                "`{path}`: a {word} of {} m does not fit there on a line that is {} m long",
                rounded(width_m),
                rounded(length_m)
            );
            return Err(self.sources.error(&item.span, &path, message));
        }
        let fits = 1 + libm::floor(room_m / spacing_m + 1e-9) as usize;
        let given = row.item(RowKey::NUMBER);
        let number = match given {
            None if fits > MOST_IN_ROW => {
                return Err(refuse(format!(
                    "on {} m there is room for {fits} at a spacing of {} m, more than {MOST_IN_ROW}",
                    rounded(room_m),
                    rounded(spacing_m)
                )));
            }
            None => fits,
            Some(item) => {
                let number = self.whole_number(row, item)?;
                let ends_m = from_m.unwrap_or(0.0) + spacing_m * (number - 1) as f64;
                if ends_m > length_m + 1e-6 {
                    let path = row.path_of(RowKey::NUMBER);
                    let message = format!(
                        "`{path}`: the row of {number} is longer than the line, which is {} m long",
                        rounded(length_m)
                    );
                    let error = self.sources.error(&item.span, &path, message);
                    return Err(error.with_help(format!(
                        "there is room for {fits} at a spacing of {} m",
                        rounded(spacing_m)
                    )));
                }
                number
            }
        };
        let row_m = spacing_m * (number - 1) as f64;
        let start_m = from_m.unwrap_or(0.5 * (length_m - row_m));
        let reaches_m = (0..number).map(|index| start_m + spacing_m * index as f64).collect();
        Ok((reaches_m, given.is_some()))
    }

    /// The line of the chart that a table names.
    fn quay_line(&self, table: Of<'_, QuayLineKey>, of: ChartOf<'_>) -> Checked<QuayLine> {
        let text = |key| table.item(key).map(|item| item.text());
        let (class, name) = (text(QuayLineKey::CLASS), text(QuayLineKey::NAME));
        let ends_m = match (table.item(QuayLineKey::FROM), table.item(QuayLineKey::TO)) {
            (Some(from), Some(to)) => Some([*from.vector(), *to.vector()]),
            (None, None) => None,
            (from, _) => {
                let missing = if from.is_some() { QuayLineKey::TO } else { QuayLineKey::FROM };
                return Err(self.missing(
                    table,
                    missing,
                    "give both ends of the berth, or neither",
                ));
            }
        };
        if ends_m.is_none() && name.is_none() {
            let help = "name a line of the chart, or give the ends of the berth in `from` and `to`";
            return Err(self.missing(table, QuayLineKey::NAME, help));
        }
        if let (Some(item), Some(class)) = (table.item(QuayLineKey::CLASS), class)
            && !solid_words().any(|word| word == class)
        {
            let path = table.path_of(QuayLineKey::CLASS);
            let message = format!("`{path}`: {} is not a class of quays and shores", quoted(class));
            let error = self.sources.error(&item.span, &path, message);
            let words: Vec<&str> = solid_words().collect();
            return Err(error.with_help(match nearest(class, words.iter().copied()) {
                Some(near) => format!("did you mean \"{near}\"?"),
                None => format!("the classes are {}", words.join(", ")),
            }));
        }
        let request = Request { chart: of.chart, class, name, ends_m, near_m: NEAR_LINE_M };
        QuayLine::find(&request).map_err(|refusal| self.no_line(table, of, &request, &refusal))
    }

    fn no_line(
        &self,
        table: Of<'_, QuayLineKey>,
        of: ChartOf<'_>,
        request: &Request<'_>,
        refusal: &Refusal,
    ) -> ScenarioError {
        let refuse = |key: fenderline_keys::typed_key::AnyKey<QuayLineKey>, message: String| {
            let path = table.path_of(key);
            let span = table.item(key).map_or(table.span.clone(), |item| item.span.clone());
            self.sources.error(&span, &path, format!("`{path}`: {message}"))
        };
        let named = |feature: usize| match of.table {
            Some(table) => self.in_words(table, of.chart, feature),
            None => of.chart.features[feature].class.to_owned(),
        };
        let key = match (request.name, request.class) {
            (Some(_), _) => QuayLineKey::NAME.any(),
            (None, Some(_)) => QuayLineKey::CLASS.any(),
            (None, None) => QuayLineKey::FROM.any(),
        };
        match *refusal {
            Refusal::NoFeature => {
                let of_class = match request.class {
                    Some(class) => format!("line or area of {class}"),
                    None => "quay or shore".to_owned(),
                };
                let of_name = request.name.map_or(String::new(), |name| format!(" named {}", quoted(name)));
                let error = refuse(key, format!("the chart has no {of_class}{of_name}"));
                let names = of.chart.features.iter().map(|feature| feature.name.as_str());
                let names = names.filter(|name| !name.is_empty());
                match request.name.and_then(|name| nearest(name, names)) {
                    Some(near) => error.with_help(format!("the chart has \"{near}\"")),
                    None if of.chart.features.is_empty() => {
                        error.with_help("the scenario has no [chart] with files")
                    }
                    None => error.with_help("`check` prints the classes of the chart"),
                }
            }
            Refusal::Lines(0) => refuse(key, "it is not a line of the chart, but an area or a point".to_owned())
                .with_help("give the part of its border in `from` and `to`"),
            Refusal::Lines(count) => refuse(key, format!("the chart has {count} lines of this name"))
                .with_help("give the ends of the berth in `from` and `to`"),
            Refusal::Far(end, feature, distance_m) => {
                let key = [QuayLineKey::FROM, QuayLineKey::TO][end].any();
                refuse(
                    key,
                    format!(
                        "no such line within {NEAR_LINE_M} m: the nearest, {}, is {distance_m:.1} m off",
                        named(feature)
                    ),
                )
                .with_help("positions are north, then east of the scenario's origin")
            }
            Refusal::Apart([one, other]) => refuse(
                QuayLineKey::TO.any(),
                format!(
                    "the two places lie on different lines: {} and {}",
                    named(one),
                    named(other)
                ),
            )
            .with_help("make a row for each line, or name the class of an area whose border is the whole quay"),
            Refusal::Same(feature) => refuse(
                if request.ends_m.is_some() { QuayLineKey::TO.any() } else { key },
                format!("the part of {} between its ends has no length", named(feature)),
            ),
        }
    }
}
