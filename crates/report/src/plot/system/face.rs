//! A drawing of a face (such as a quay's front) with its fenders, in plan and elevation, as seen from the water, from
//! left to right.

use core::fmt::Write as _;

use fenderline_contact::number::{bounded, greater, lesser};
use maud::{Markup, html};

use super::scale::Scale;
use crate::plot::Use;
use crate::plot::axis::{Fitted, nice_step};
use crate::plot::number::{fixed, plain};

/// A face of a body with its fenders.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Printed above the drawing.
    pub title: String,
    /// From left to right.
    pub fenders: Vec<FaceFender>,
    /// Outlines of the bodies that carry the fenders: coordinates along the face, and outwards from the line of
    /// mountings (m).
    pub bodies_m: Vec<Vec<[f64; 2]>>,
    /// The hulls before it.
    pub hulls: Vec<Hull>,
    /// Levels of the elevation.
    pub levels: Vec<Level>,
    /// Name of the level from which heights are measured, such as `datum`.
    pub heights_above: &'static str,
}

/// A fender on a face.
#[derive(Clone, Debug, PartialEq)]
pub struct FaceFender {
    /// Number of the fender in the drawing and the table, counted from 1.
    pub number: usize,
    /// Middle of the fender along the face (m).
    pub along_m: f64,
    /// Height of the middle of the fender's face (m).
    pub height_m: f64,
    /// Width and height of the fender's face (m).
    pub face_m: [f64; 2],
    /// Places of the cones behind the fender's panel, to the right of the panel's middle (m); empty for a fender
    /// without a panel on several cones.
    pub cones_m: Vec<f64>,
    /// Distance from the fender's mounting to its face (m).
    pub projection_m: f64,
    /// Distance outwards from the drawing's line of mountings to the mounting of this fender (m).
    pub mounted_m: f64,
    /// How the fender was used in the run.
    pub used: Use,
}

/// A ship's hull before the face.
#[derive(Clone, Debug, PartialEq)]
pub struct Hull {
    /// Its name.
    pub name: String,
    /// Outline of the hull: coordinates along the face, and outwards (m).
    pub outline_m: Vec<[f64; 2]>,
    /// Height of the hull's keel (m), if its draught is known.
    pub keel_m: Option<f64>,
}

/// The kind of a level, which sets how the level is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LevelKind {
    /// A water level.
    Water,
    /// The seabed.
    Bed,
}

/// A level that the elevation shows, such as the water level.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Its height (m).
    pub height_m: f64,
    /// Printed on it.
    pub text: String,
    /// What it is.
    pub kind: LevelKind,
}

const WIDTH: f64 = 720.0;
const LEFT: f64 = 52.0;
const RIGHT: f64 = 10.0;
/// Heights of the plan (smallest and largest) and of the elevation, and the room between them (px).
const PLAN: [f64; 2] = [70.0, 170.0];
const ELEVATION: f64 = 150.0;
const BETWEEN: f64 = 26.0;
const TOP: f64 = 18.0;
const BOTTOM: f64 = 40.0;
/// Smallest drawn size of a fender (px).
const LEAST: f64 = 4.0;
/// Radius of the circle with a fender's number (px).
const RADIUS: f64 = 7.5;
/// How far the plan reaches behind the fenders' mountings, and out into the water beyond the fenders' faces (m).
const BEHIND_M: f64 = 6.0;
const BEFORE_M: f64 = 26.0;

pub(super) const QUAY: &str = "#b9c0c8";
pub(super) const QUAY_EDGE: &str = "#4a5460";
pub(super) const HULL: &str = "#0072B2";
pub(super) const WATER: &str = "#1f78b4";
pub(super) const BED: &str = "#7F5F3F";

impl Face {
    /// Draws the face as an HTML `figure`.
    pub fn render(&self) -> Markup {
        let along_m = self.along();
        let x = Scale::new(along_m, LEFT, WIDTH - RIGHT);
        let [low_m, high_m] = self.depths();
        let plan_px = bounded((high_m - low_m) * x.px_per_m, PLAN[0], PLAN[1]);
        // Equal scales, cut off on the side of the water.
        let out = Scale::new([low_m, low_m + plan_px / x.px_per_m], TOP, TOP + plan_px);
        let top = TOP + plan_px + BETWEEN;
        let heights_m = self.heights();
        let z = Scale::new(heights_m, top + ELEVATION, top);
        let height = top + ELEVATION + BOTTOM;
        let times = z.px_per_m.abs() / x.px_per_m;
        let ticks = Fitted::new(along_m[0], along_m[1], nice_step(along_m[1] - along_m[0], 9));
        html! {
            figure class="system" {
                figcaption { (self.title) }
                svg viewBox=(format!("0 0 {WIDTH} {height:.1}")) role="img" aria-label=(self.title) {
                    (part(LEFT, TOP, plan_px, &self.plan(&x, &out)))
                    text class="axis" x=(format!("{LEFT}")) y=(format!("{:.1}", TOP - 5.0)) { "Plan" }
                    (part(LEFT, top, ELEVATION, &self.elevation(&x, &z)))
                    text class="axis" x=(format!("{LEFT}")) y=(format!("{:.1}", top - 6.0)) {
                        "Elevation, seen from the water"
                        @if times > 1.05 { ", heights drawn " (plain(times, 2)) " times larger" }
                    }
                    (self.heights_axis(heights_m, &z))
                    (along_axis(&ticks, &x, top + ELEVATION))
                }
                p class="note" { (self.note()) }
            }
        }
    }

    /// The range along the face that the drawing shows (m): all fenders, and only so much of body and hulls that the
    /// fenders do not become too small.
    fn along(&self) -> [f64; 2] {
        let first = self.fenders.iter().map(|f| f.along_m - 0.5 * f.face_m[0]);
        let last = self.fenders.iter().map(|f| f.along_m + 0.5 * f.face_m[0]);
        let (low, high) =
            (first.fold(f64::INFINITY, lesser), last.fold(f64::NEG_INFINITY, greater));
        let room_m = greater(0.2 * (high - low), 12.0);
        let ends = self.bodies_m.iter().map(|body| extent(body));
        let [from_m, to_m] = ends.fold([f64::INFINITY, f64::NEG_INFINITY], |all, [from, to]| {
            [lesser(all[0], from), greater(all[1], to)]
        });
        [
            lesser(low - 2.0, greater(low - room_m, from_m - 3.0)),
            greater(high + 2.0, lesser(high + room_m, to_m + 3.0)),
        ]
    }

    /// The range of distances outwards from the line of mountings that the plan shows (m).
    fn depths(&self) -> [f64; 2] {
        let out = self.fenders.iter().map(|f| f.mounted_m + f.projection_m).fold(0.0, greater);
        let back = self.fenders.iter().map(|f| f.mounted_m).fold(0.0, lesser);
        [back - BEHIND_M, out + BEFORE_M]
    }

    /// The range of heights that the elevation shows (m).
    fn heights(&self) -> [f64; 2] {
        let half = |f: &FaceFender| 0.5 * f.face_m[1];
        let mut low = self.fenders.iter().map(|f| f.height_m - half(f)).fold(f64::INFINITY, lesser);
        let mut high =
            self.fenders.iter().map(|f| f.height_m + half(f)).fold(f64::NEG_INFINITY, greater);
        let levels = self.levels.iter().map(|level| level.height_m);
        let keels = self.hulls.iter().filter_map(|hull| hull.keel_m);
        for height_m in levels.chain(keels) {
            (low, high) = (lesser(low, height_m), greater(high, height_m));
        }
        // Room for the numbers above the fenders and their spacings below.
        let room_m = greater(0.2 * (high - low), 0.8);
        [low - room_m, high + room_m]
    }

    fn plan(&self, x: &Scale, out: &Scale) -> Markup {
        let at = |[along_m, out_m]: [f64; 2]| (x.px(along_m), out.px(out_m));
        html! {
            @for body_m in &self.bodies_m {
                path d=(closed(body_m.iter().map(|p| at(*p)))) fill=(QUAY) fill-opacity="0.55"
                    stroke=(QUAY_EDGE) stroke-width="1.1" {}
            }
            @for hull in &self.hulls {
                path d=(closed(hull.outline_m.iter().map(|p| at(*p)))) fill=(HULL) fill-opacity="0.12"
                    stroke=(HULL) stroke-width="1.3" {}
            }
            @for fender in &self.fenders {
                @let (width, depth) = (greater(x.length(fender.face_m[0]), LEAST), greater(out.length(fender.projection_m), LEAST));
                rect x=(px(x.px(fender.along_m) - 0.5 * width)) y=(px(out.px(fender.mounted_m)))
                    width=(px(width)) height=(px(depth)) fill=(fender.used.fill()) stroke="#222" stroke-width="0.9" {}
            }
            @for hull in &self.hulls {
                @let middle = middle(&hull.outline_m, x);
                text class="halo name" x=(px(middle)) y=(px(out.px(0.0) + 0.72 * (out.length(BEFORE_M)))) text-anchor="middle" { (hull.name) }
            }
        }
    }

    fn elevation(&self, x: &Scale, z: &Scale) -> Markup {
        let (left, right) = (LEFT, WIDTH - RIGHT);
        let [low_m, high_m] = self.heights();
        html! {
            @for body_m in &self.bodies_m {
                @let [from, to] = extent(body_m).map(|end_m| bounded(x.px(end_m), left, right));
                rect x=(px(from)) y=(px(z.px(high_m))) width=(px(to - from))
                    height=(px(z.length(high_m - low_m))) fill=(QUAY) fill-opacity="0.3" {}
            }
            @for hull in &self.hulls {
                @if let Some(keel_m) = hull.keel_m {
                    @let [from, to] = extent(&hull.outline_m).map(|m| bounded(x.px(m), left - 2.0, right + 2.0));
                    rect x=(px(from)) y=(px(z.px(high_m) - 2.0)) width=(px(to - from))
                        height=(px(z.px(keel_m) - z.px(high_m) + 2.0)) fill=(HULL) fill-opacity="0.10" stroke=(HULL)
                        stroke-width="1.2" stroke-dasharray="7 3" {}
                    text class="halo" x=(px(bounded(0.5 * (from + to), left + 60.0, right - 60.0))) y=(px(z.px(keel_m) - 4.0))
                        text-anchor="middle" { "keel of " (hull.name) " " (signed(keel_m)) " m" }
                }
            }
            @for level in &self.levels {
                @let y = px(z.px(level.height_m));
                @let (colour, dash) = match level.kind { LevelKind::Water => (WATER, "9 4"), LevelKind::Bed => (BED, "") };
                path d=(format!("M{left},{y}H{right}")) stroke=(colour) stroke-width="1.2" stroke-dasharray=(dash) fill="none" {}
                text class="halo" x=(px(right - 5.0)) y=(px(z.px(level.height_m) - 3.0)) text-anchor="end" style=(format!("fill:{colour}")) { (level.text) }
            }
            @for fender in &self.fenders { (self.front(fender, x, z)) }
            (self.numbers(x, z))
        }
    }

    /// Draws a fender as seen from the front.
    fn front(&self, fender: &FaceFender, x: &Scale, z: &Scale) -> Markup {
        let [width, height] =
            [x.length(fender.face_m[0]), z.length(fender.face_m[1])].map(|l| greater(l, LEAST));
        html! {
            rect x=(px(x.px(fender.along_m) - 0.5 * width)) y=(px(z.px(fender.height_m) - 0.5 * height))
                width=(px(width)) height=(px(height)) fill=(fender.used.fill()) stroke="#222" stroke-width="1" {}
            @for cone_m in &fender.cones_m {
                circle cx=(px(x.px(fender.along_m + cone_m))) cy=(px(z.px(fender.height_m)))
                    r=(px(lesser(greater(0.12 * height, 1.5), 0.4 * width))) fill="none" stroke="#222"
                    stroke-width="0.8" stroke-dasharray="2 1.5" {}
            }
        }
    }

    /// Draws the numbers above the fenders, as many as there is room for, and the spacings of the fenders.
    fn numbers(&self, x: &Scale, z: &Scale) -> Markup {
        let [low_m, high_m] = self.heights();
        let mut last = f64::NEG_INFINITY;
        let mut shown = Vec::new();
        for fender in &self.fenders {
            let at = x.px(fender.along_m);
            if at - last >= 2.2 * RADIUS {
                let above = z.px(fender.height_m + 0.5 * fender.face_m[1]) - RADIUS - 3.0;
                shown.push((fender, at, greater(above, z.px(high_m) + RADIUS)));
                last = at;
            }
        }
        let spacings = self.fenders.windows(2).filter_map(|pair| {
            let [one, two] = [pair[0].along_m, pair[1].along_m];
            let text = plain(two - one, 4);
            let room = x.length(two - one);
            (room > 7.0 * text.chars().count() as f64 + 6.0)
                .then(|| (x.px(0.5 * (one + two)), x.px(one), x.px(two), text))
        });
        let y = z.px(low_m) - 7.0;
        html! {
            @for (middle, from, to, text) in spacings {
                path d=(format!("M{from:.1},{:.1}v6M{to:.1},{:.1}v6M{from:.1},{:.1}H{to:.1}", y - 3.0, y - 3.0, y)) stroke="#5b6675" stroke-width="0.8" fill="none" {}
                text class="halo value" x=(px(middle)) y=(px(y - 3.0)) text-anchor="middle" { (text) }
            }
            @for (fender, at, above) in shown {
                circle cx=(px(at)) cy=(px(above)) r=(format!("{RADIUS}")) fill="#fff" stroke="#222" stroke-width="0.8" {}
                text class="value" x=(px(at)) y=(px(above + 3.6)) text-anchor="middle" { (fender.number) }
            }
        }
    }

    fn heights_axis(&self, heights_m: [f64; 2], z: &Scale) -> Markup {
        let [low_m, high_m] = heights_m;
        let ticks = Fitted::new(low_m, high_m, nice_step(high_m - low_m, 5));
        let middle = z.px(0.5 * (low_m + high_m));
        html! {
            @for (value, label) in ticks.ticks() {
                text x=(px(LEFT - 5.0)) y=(px(z.px(value) + 3.8)) text-anchor="end" { (label) }
                path class="grid" d=(format!("M{:.1},{:.1}h4", LEFT - 4.0, z.px(value))) style="stroke:#5b6675" {}
            }
            text class="axis" text-anchor="middle" transform=(format!("translate(12 {middle:.1}) rotate(-90)")) {
                "above " (self.heights_above) " [m]"
            }
        }
    }

    fn note(&self) -> String {
        let mut text = String::from("The fenders have the same colours as in the plan views. ");
        if self.hulls.is_empty() {
            text.push_str("No hull lay at this face.");
        } else {
            text.push_str("Hulls are shown at the moment of the largest force. ");
            if self.hulls.iter().any(|hull| hull.keel_m.is_none()) {
                text.push_str("A hull without known draught is left out of the elevation. ");
            }
            text.push_str(
                "The upper edges of quay and hull are not in the scenario and are drawn open.",
            );
        }
        text
    }
}

/// Draws a part of the drawing with its frame, and clips what lies outside the frame.
fn part(left: f64, top: f64, height: f64, inner: &Markup) -> Markup {
    let width = WIDTH - left - RIGHT;
    html! {
        svg x=(px(left)) y=(px(top)) width=(px(width)) height=(px(height)) overflow="hidden"
            viewBox=(format!("{left:.1} {top:.1} {width:.1} {height:.1}")) { (inner) }
        rect class="frame" x=(px(left)) y=(px(top)) width=(px(width)) height=(px(height)) {}
    }
}

fn along_axis(ticks: &Fitted, x: &Scale, base: f64) -> Markup {
    html! {
        @for (value, label) in ticks.ticks() {
            path class="grid" d=(format!("M{:.1},{base:.1}v4", x.px(value))) style="stroke:#5b6675" {}
            text x=(px(x.px(value))) y=(px(base + 15.0)) text-anchor="middle" { (label) }
        }
        text class="axis" x=(px(0.5 * (LEFT + WIDTH - RIGHT))) y=(px(base + BOTTOM - 7.0)) text-anchor="middle" {
            "along the face, from the origin of its body [m]"
        }
    }
}

pub(super) fn px(value: f64) -> String {
    format!("{value:.1}")
}

/// The text of a height with its sign.
pub(super) fn signed(height_m: f64) -> String {
    if height_m > 0.0 { format!("+{}", fixed(height_m, 2)) } else { fixed(height_m, 2) }
}

fn closed(points: impl Iterator<Item = (f64, f64)>) -> String {
    let mut path = String::new();
    for (index, (x, y)) in points.enumerate() {
        let _ = write!(path, "{}{x:.1},{y:.1}", if index == 0 { 'M' } else { 'L' });
    }
    path.push('Z');
    path
}

/// The ends of an outline along the face (m).
fn extent(outline_m: &[[f64; 2]]) -> [f64; 2] {
    let along = outline_m.iter().map(|p| p[0]);
    [along.clone().fold(f64::INFINITY, lesser), along.fold(f64::NEG_INFINITY, greater)]
}

/// The middle of the visible part of an outline (px).
fn middle(outline_m: &[[f64; 2]], x: &Scale) -> f64 {
    let [from, to] = extent(outline_m).map(|m| bounded(x.px(m), LEFT, WIDTH - RIGHT));
    bounded(0.5 * (from + to), LEFT + 40.0, WIDTH - RIGHT - 40.0)
}
