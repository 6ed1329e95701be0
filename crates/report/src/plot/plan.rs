//! Plan views: bodies seen from above, north up, one scale both ways.

mod fenders;
mod furniture;
mod harbour;
mod labels;

use core::fmt::Write as _;

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{Vec2, vec2};
use maud::{Markup, html};

use super::axis::{Axis, Fitted, nice_step};
use super::{colour, dash};
pub use fenders::{FenderBox, Use, fenders_legend};
use furniture::{grid, north_arrow, scale_bar};
pub use harbour::{Harbour, LineDrawn, TugDrawn, Weather, harbour_legend};
use labels::label_places;

/// A plan view to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Printed above the view.
    pub title: String,
    /// What part of the plane it shows.
    pub frame: Frame,
    /// Outlines, drawn first to last.
    pub outlines: Vec<Outlined>,
    /// Fenders, drawn upon the outlines.
    pub fenders: Vec<FenderBox>,
    /// Lines, tugs, wind and current.
    pub harbour: Harbour,
    /// Paths of bodies.
    pub tracks: Vec<Track>,
    /// Forces and the like, and points where they act.
    pub arrows: Vec<Arrow>,
    /// Names.
    pub labels: Vec<Label>,
    /// Printed small below the view; empty for none.
    pub note: String,
}

/// When an outline is shown, which sets how it is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Does not move.
    Fixed,
    /// At the start of the run.
    Start,
    /// At the peak force.
    Peak,
    /// At the end of the run.
    End,
}

/// The outline of a body, earth-fixed (m).
#[derive(Clone, Debug, PartialEq)]
pub struct Outlined {
    /// Its corners (m).
    pub vertices_m: Vec<Vec2>,
    /// When in the run.
    pub stage: Stage,
    /// Number of the colour; fixed bodies are grey.
    pub style: usize,
}

/// The path of a body's centre of gravity, earth-fixed (m).
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// Its points (m).
    pub points_m: Vec<Vec2>,
    /// Number of the body's colour.
    pub style: usize,
}

/// An arrow from a point, with a text at its head.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrow {
    /// Where it starts; a dot is drawn there (m).
    pub from_m: Vec2,
    /// Which way it points, of length 1; zero: the dot alone.
    pub direction: Vec2,
    /// Printed at the head.
    pub label: String,
}

/// A text at a point (m).
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// Where (m).
    pub at_m: Vec2,
    /// Half the size of the named thing (m): the text is placed beside it.
    pub reach_m: f64,
    /// The side on which the text stands first, of length 1; zero: wherever there is room.
    pub side: Vec2,
    /// The text.
    pub text: String,
}

/// A rectangle of the plane (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// South-west corner (m).
    pub low: Vec2,
    /// North-east corner (m).
    pub high: Vec2,
}

impl Frame {
    /// The smallest frame round `points`; `None` where there are none.
    pub fn around(points: impl IntoIterator<Item = Vec2>) -> Option<Frame> {
        points.into_iter().filter(|p| p.is_finite()).fold(None, |frame, p| {
            let point = Frame { low: p, high: p };
            Some(frame.map_or(point, |f: Frame| f.with(point)))
        })
    }

    /// A frame about `centre` with the proportions of a view that goes twice on a page of A4.
    pub fn about(centre: Vec2, half_height_m: f64) -> Frame {
        let half = vec2(half_height_m, half_height_m * 1.65);
        Frame { low: centre - half, high: centre + half }
    }

    /// The smallest frame round both.
    pub fn with(self, other: Frame) -> Frame {
        Frame {
            low: vec2(lesser(self.low.x, other.low.x), lesser(self.low.y, other.low.y)),
            high: vec2(greater(self.high.x, other.high.x), greater(self.high.y, other.high.y)),
        }
    }

    /// North and east extent (m).
    pub fn size(self) -> Vec2 {
        self.high - self.low
    }

    fn centre(self) -> Vec2 {
        self.low + self.size() * 0.5
    }
}

const WIDTH: f64 = 720.0;
/// Room for the northern axis' title, its labels apart, and round the rest (px).
const LEFT: f64 = 32.0;
const RIGHT: f64 = 12.0;
const TOP: f64 = 8.0;
const BOTTOM: f64 = 40.0;
const DIGIT: f64 = 6.4;
/// Least and greatest height of the drawn area (px).
const HEIGHTS: (f64, f64) = (230.0, 540.0);
/// Room round what is shown, as a share of its size.
const MARGIN: f64 = 0.06;
/// Vertices closer than this to the one before are not drawn (px).
const FINEST: f64 = 0.15;
const ARROW: f64 = 64.0;

/// The map from the plane to the drawn area, whose own origin is its upper left corner.
struct Map {
    centre: Vec2,
    px_per_m: f64,
    width: f64,
    height: f64,
    left: f64,
    north: Fitted,
    east: Fitted,
}

impl Map {
    fn of(frame: Frame) -> Map {
        let size = frame.size();
        // No frame is so small that doubles at its place could not tell its ends apart.
        let far = greater(frame.centre().x.abs(), frame.centre().y.abs());
        let least = greater(far * 1e-12, 1e-6);
        let (tall, wide) = (greater(size.x, least), greater(size.y, least));
        let room = 1.0 + 2.0 * MARGIN;
        // The labels of the northern axis set the left margin, and so the scale; their length
        // hardly depends on it.
        let longest = Axis::new("", "")
            .tight()
            .fit([frame.low.x, frame.low.x + tall].into_iter(), 6)
            .ticks()
            .iter()
            .map(|(_, label)| label.chars().count())
            .max();
        let left =
            LEFT + DIGIT * longest.and_then(|n| u32::try_from(n).ok()).map_or(8.0, f64::from);
        let width = WIDTH - left - RIGHT;
        let height = bounded(width * tall / wide, HEIGHTS.0, HEIGHTS.1);
        let px_per_m = lesser(width / (wide * room), height / (tall * room));
        let centre = frame.centre();
        let step = nice_step(width / px_per_m, 8);
        let half = vec2(height / px_per_m / 2.0, width / px_per_m / 2.0);
        let north = Fitted::new(centre.x - half.x, centre.x + half.x, step);
        let east = Fitted::new(centre.y - half.y, centre.y + half.y, step);
        Map { centre, px_per_m, width, height, left, north, east }
    }

    /// Right and down from the drawn area's upper left corner (px).
    fn px(&self, point_m: Vec2) -> (f64, f64) {
        let from_centre = point_m - self.centre;
        (
            self.width / 2.0 + from_centre.y * self.px_per_m,
            self.height / 2.0 - from_centre.x * self.px_per_m,
        )
    }

    fn path(&self, points_m: &[Vec2]) -> String {
        let mut path = String::with_capacity(points_m.len() * 12);
        let mut last = None;
        for (index, point) in points_m.iter().enumerate() {
            let (x, y) = self.px(*point);
            let is_end = index + 1 == points_m.len();
            let is_near = |(x0, y0): (f64, f64)| (x - x0).abs() < FINEST && (y - y0).abs() < FINEST;
            if last.is_some_and(is_near) && !is_end {
                continue;
            }
            let _ = write!(path, "{}{x:.2},{y:.2}", if last.is_none() { 'M' } else { 'L' });
            last = Some((x, y));
        }
        path
    }
}

impl Plan {
    /// The view as a `figure` with its title and note.
    pub fn render(&self) -> Markup {
        let map = Map::of(self.frame);
        let (full_width, full_height) = (WIDTH, TOP + map.height + BOTTOM);
        html! {
            figure class="plan" {
                figcaption { (self.title) }
                svg viewBox=(format!("0 0 {full_width} {full_height:.1}")) role="img"
                    aria-label=(self.title) {
                    (grid(&map))
                    // A nested picture cuts what lies outside.
                    svg x=(format!("{:.1}", map.left)) y=(TOP) width=(format!("{:.1}", map.width))
                        height=(format!("{:.1}", map.height)) overflow="hidden" {
                        @for outline in &self.outlines { (outlined(outline, &map)) }
                        @for fender in &self.fenders { (fenders::fender(fender, &map)) }
                        @for track in &self.tracks {
                            path d=(map.path(&track.points_m)) fill="none" stroke=(colour(track.style))
                                stroke-width="1" stroke-dasharray=(dash(2)) {}
                        }
                        @for ends_m in &self.harbour.banks { (harbour::bank(*ends_m, &map)) }
                        @for line in &self.harbour.lines { (harbour::line(line, &map)) }
                        @for tug in &self.harbour.tugs { (harbour::tug(tug, &map)) }
                        @for (label, at) in self.labels.iter().zip(label_places(self, &map)) {
                            @if let Some((x, y)) = at { (named(label, x, y)) }
                        }
                        @for arrow in &self.arrows { (arrowed(arrow, &map)) }
                        (harbour::corner(&self.harbour.weather))
                        (north_arrow(&map))
                        (scale_bar(&map))
                    }
                    rect class="frame" x=(format!("{:.1}", map.left)) y=(TOP)
                        width=(format!("{:.1}", map.width)) height=(format!("{:.1}", map.height)) {}
                }
                @if !self.note.is_empty() { p class="note" { (self.note) } }
            }
        }
    }
}

/// Fill, its opacity, stroke width and dash of a stage.
fn look(stage: Stage) -> (&'static str, &'static str, &'static str) {
    match stage {
        Stage::Fixed => ("0.55", "1.2", ""),
        Stage::Start => ("0", "0.8", ""),
        Stage::Peak => ("0.18", "1.6", ""),
        Stage::End => ("0", "1.1", "5 3"),
    }
}

fn outlined(outline: &Outlined, map: &Map) -> Markup {
    let (opacity, stroke_width, dashes) = look(outline.stage);
    let is_fixed = outline.stage == Stage::Fixed;
    let (fill, stroke) = if is_fixed {
        ("#b9c0c8", "#4a5460")
    } else {
        (colour(outline.style), colour(outline.style))
    };
    html! {
        path d={ (map.path(&outline.vertices_m)) "Z" } fill=(fill) fill-opacity=(opacity)
            stroke=(stroke) stroke-width=(stroke_width) stroke-dasharray=(dashes)
            stroke-linejoin="round" {}
    }
}

/// The key to how outlines are drawn, for the stages that `plans` show.
pub fn outlined_legend() -> Markup {
    let entries = [
        (Stage::Start, "at the start"),
        (Stage::Peak, "at the largest force"),
        (Stage::End, "at the end"),
        (Stage::Fixed, "fixed"),
    ];
    html! {
        ul class="legend" {
            @for (stage, text) in entries {
                @let (opacity, stroke_width, dashes) = look(stage);
                @let (fill, stroke) = if stage == Stage::Fixed { ("#b9c0c8", "#4a5460") }
                    else { (colour(0), colour(0)) };
                li {
                    svg width="30" height="12" viewBox="0 0 30 12" aria-hidden="true" {
                        path d="M2,2H22L28,6L22,10H2Z" fill=(fill) fill-opacity=(opacity)
                            stroke=(stroke) stroke-width=(stroke_width) stroke-dasharray=(dashes) {}
                    }
                    (text)
                }
            }
            li {
                svg width="30" height="12" viewBox="0 0 30 12" aria-hidden="true" {
                    path d="M1,6H29" fill="none" stroke=(colour(0)) stroke-dasharray=(dash(2)) {}
                }
                "track of the centre of gravity"
            }
            li {
                svg width="30" height="16" viewBox="0 0 30 16" aria-hidden="true" { (point(15.0, 8.0)) }
                "point of the largest force"
            }
        }
    }
}

/// Where the text of an arrow starts, or ends where it stands left of it (px).
fn arrow_text(arrow: &Arrow, map: &Map) -> (f64, f64, bool) {
    let (x, y) = map.px(arrow.from_m);
    if arrow.direction == Vec2::ZERO {
        return (x + 8.0, y - 8.0, false);
    }
    let (dx, dy) = (arrow.direction.y, -arrow.direction.x);
    let is_left = dx < -0.3;
    let shift = if is_left { -8.0 } else { 8.0 };
    (x + dx * ARROW + shift, y + dy * ARROW, is_left)
}

fn named(label: &Label, x: f64, y: f64) -> Markup {
    html! {
        text class="halo name" x=(format!("{x:.1}")) y=(format!("{:.1}", y + 4.0))
            text-anchor="middle" { (label.text) }
    }
}

fn arrowed(arrow: &Arrow, map: &Map) -> Markup {
    let (x, y) = map.px(arrow.from_m);
    let (dx, dy) = (arrow.direction.y, -arrow.direction.x);
    let has_length = arrow.direction != Vec2::ZERO;
    let (tip_x, tip_y) = (x + dx * ARROW, y + dy * ARROW);
    let (neck_x, neck_y) = (tip_x - dx * 9.0, tip_y - dy * 9.0);
    let shaft = format!("M{x:.1},{y:.1}L{neck_x:.1},{neck_y:.1}");
    let head = format!(
        "M{tip_x:.1},{tip_y:.1}L{:.1},{:.1}L{:.1},{:.1}Z",
        neck_x - dy * 4.0,
        neck_y + dx * 4.0,
        neck_x + dy * 4.0,
        neck_y - dx * 4.0
    );
    let (text_x, text_y, is_left) = arrow_text(arrow, map);
    let anchor = if is_left { "end" } else { "start" };
    html! {
        @if has_length {
            path d=(shaft) stroke="#000" stroke-width="1.6" fill="none" {}
            path d=(head) fill="#000" {}
        }
        (point(x, y))
        text class="halo name" x=(format!("{text_x:.1}")) y=(format!("{:.1}", text_y + 4.0))
            text-anchor=(anchor) { (arrow.label) }
    }
}

/// A point where a force acts: a ring, so that the colour of a fender below it is seen.
fn point(x: f64, y: f64) -> Markup {
    let (x, y) = (format!("{x:.1}"), format!("{y:.1}"));
    html! {
        circle cx=(x) cy=(y) r="7" fill="none" stroke="#000" stroke-width="1.1" {}
        circle cx=(x) cy=(y) r="1" fill="#000" {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plan(frame: Frame) -> String {
        Plan {
            title: "<plan>".to_owned(),
            frame,
            outlines: vec![Outlined {
                vertices_m: vec![frame.low, frame.high, vec2(frame.low.x, frame.high.y)],
                stage: Stage::Peak,
                style: 9,
            }],
            fenders: vec![FenderBox {
                mount_m: frame.low,
                out_m: vec2(1.0, 0.0),
                half_width_m: vec2(0.0, 1.0),
                used: Use::Failed,
            }],
            harbour: Harbour {
                lines: vec![LineDrawn {
                    ends_m: [frame.low, frame.high],
                    share: 0.6,
                    has_parted: false,
                }],
                tugs: vec![TugDrawn {
                    at_m: frame.low,
                    direction: vec2(0.0, 1.0),
                    on_line: true,
                    label: "<script>".to_owned(),
                }],
                banks: vec![[frame.low, frame.high]],
                weather: vec![Weather {
                    towards: vec2(1.0, 0.0),
                    text: "<script>".to_owned(),
                    colour: "#000",
                }],
            },
            tracks: vec![Track { points_m: vec![frame.low, frame.high], style: 1 }],
            arrows: vec![Arrow {
                from_m: frame.low,
                direction: vec2(1.0, 0.0),
                label: "<script>".to_owned(),
            }],
            labels: vec![Label {
                at_m: frame.low,
                reach_m: 1.0,
                side: Vec2::ZERO,
                text: "<script>".to_owned(),
            }],
            note: String::new(),
        }
        .render()
        .into_string()
    }

    #[test]
    fn any_frame_is_drawn() {
        let frames = [
            Frame { low: Vec2::ZERO, high: vec2(400.0, 50.0) },
            Frame { low: vec2(1e7, 1e7), high: vec2(1e7 + 1.0, 1e7 + 400.0) },
            Frame { low: Vec2::ZERO, high: Vec2::ZERO },
            Frame { low: vec2(-1e9, -1e9), high: vec2(1e9, 1e9) },
            Frame::about(vec2(1e8, 1e8), 1e-9),
        ];
        for frame in frames {
            let svg = plan(frame);
            assert!(
                !svg.contains("NaN") && !svg.contains("inf") && !svg.contains("<script"),
                "{svg}"
            );
        }
    }

    #[test]
    fn north_is_up_and_east_is_right_at_one_scale() {
        let map = Map::of(Frame { low: Vec2::ZERO, high: vec2(100.0, 300.0) });
        let origin = map.px(vec2(50.0, 50.0));
        let north = map.px(vec2(60.0, 50.0));
        let east = map.px(vec2(50.0, 60.0));
        assert!(north.1 < origin.1 && (north.0 - origin.0).abs() < 1e-9);
        assert!(east.0 > origin.0 && (east.1 - origin.1).abs() < 1e-9);
        assert!(((origin.1 - north.1) - (east.0 - origin.0)).abs() < 1e-9);
    }
}
