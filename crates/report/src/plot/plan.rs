//! Plan views: bodies seen from above, north up, at the same scale in both directions.

mod approached;
mod arrows;
mod box2;
mod chart;
mod contents;
mod depths;
mod fenders;
mod furniture;
mod harbour;
mod labels;
mod map;
mod passing;
mod planned;

use fenderline_contact::Vec2;
use maud::{Markup, html};

use super::{colour, dash};
pub use approached::{Approached, approached_legend};
pub use chart::{chart_labels, chart_note, charted_in};
pub use contents::{Outlined, Plan, Stage, Track};
pub use depths::DepthLimits;
pub use fenders::{FenderBox, Use, fenders_legend};
use furniture::{grid, north_arrow, scale_bar};
pub use harbour::{Harbour, LineDrawn, TugDrawn, Weather, harbour_legend};
use labels::text_places;
use map::{ARROW, BOTTOM, Map, TOP, WIDTH, arrow_text};
pub use map::{Arrow, Frame, Label, Place};
pub use passing::PassingDrawn;
pub use planned::{PlannedDrawn, planned_legend, waypoint_name};

impl Plan {
    /// Draws the plan view as an HTML `figure` with its title and note.
    pub fn render(&self) -> Markup {
        let map = Map::of(self.frame);
        let (full_width, full_height) = (WIDTH, TOP + map.height + BOTTOM);
        html! {
            figure class="plan" {
                figcaption { (self.title) }
                svg viewBox=(format!("0 0 {full_width} {full_height:.1}")) role="img"
                    aria-label=(self.title) {
                    (grid(&map))
                    // A nested picture clips everything outside the view.
                    svg x=(format!("{:.1}", map.left)) y=(TOP) width=(format!("{:.1}", map.width))
                        height=(format!("{:.1}", map.height)) overflow="hidden" {
                        (chart::charted(&self.harbour.chart, self.harbour.limits.as_ref(), self.frame, &map))
                        @for plan in &self.harbour.plans { (planned::planned(plan, &map)) }
                        @for ship in &self.harbour.passing { (passing::passing(ship, &map)) }
                        @for outline in &self.outlines { (outlined(outline, &map)) }
                        @for fender in &self.fenders { (fenders::fender(fender, &map)) }
                        @for track in &self.tracks {
                            path d=(map.path(&track.points_m)) fill="none" stroke=(colour(track.style))
                                stroke-width="1" stroke-dasharray=[(!track.is_one_of_many).then(|| dash(2))]
                                stroke-opacity=[track.is_one_of_many.then_some("0.35")] {}
                        }
                        @for way in &self.harbour.approached { (approached::approached(way, &map)) }
                        @for ends_m in &self.harbour.banks { (harbour::bank(*ends_m, &map)) }
                        @for line in &self.harbour.lines { (harbour::line(line, &map)) }
                        @for chain_m in &self.harbour.anchors { (harbour::anchor(*chain_m, &map)) }
                        @for tug in &self.harbour.tugs { (harbour::tug(tug, &map)) }
                        @for (text, at) in self.texts().zip(text_places(self, &map)) {
                            @if let Some((x, y)) = at { (named(text, x, y)) }
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

/// How the outlines of a stage (such as the start of the run) are drawn: fill opacity, stroke width and dash.
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

/// The legend for the outlines of bodies.
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

fn named(text: &str, x: f64, y: f64) -> Markup {
    html! {
        text class="halo name" x=(format!("{x:.1}")) y=(format!("{:.1}", y + 4.0))
            text-anchor="middle" { (text) }
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

/// Draws the point where a force acts as a ring, so that the colour of a fender below it can be seen.
fn point(x: f64, y: f64) -> Markup {
    let (x, y) = (format!("{x:.1}"), format!("{y:.1}"));
    html! {
        circle cx=(x) cy=(y) r="7" fill="none" stroke="#000" stroke-width="1.1" {}
        circle cx=(x) cy=(y) r="1" fill="#000" {}
    }
}

#[cfg(test)]
mod tests {
    use fenderline_contact::vec2;

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
                chart: Vec::new(),
                limits: None,
                anchors: vec![[frame.low, frame.high]],
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
                plans: vec![PlannedDrawn {
                    track_m: vec![frame.low, frame.high],
                    edges_m: vec![vec![frame.low, frame.high]],
                    waypoints: vec![(frame.high, "<b>".to_owned())],
                    wheel_overs: vec![(frame.low, 1.0)],
                }],
                passing: vec![PassingDrawn {
                    outline_m: vec![frame.low, frame.high],
                    track_m: vec![frame.low, frame.high],
                }],
                approached: vec![Approached {
                    path_m: vec![frame.low, frame.high],
                    minutes_m: vec![frame.low],
                    hull_m: vec![frame.low, frame.high],
                    touch_m: frame.high,
                    used: Use::Share(0.6),
                }],
                weather: vec![Weather {
                    towards: vec2(1.0, 0.0),
                    text: "<script>".to_owned(),
                    colour: "#000",
                }],
            },
            tracks: vec![Track {
                points_m: vec![frame.low, frame.high],
                style: 1,
                is_one_of_many: false,
            }],
            arrows: vec![Arrow {
                from_m: frame.low,
                direction: vec2(1.0, 0.0),
                label: "<script>".to_owned(),
            }],
            labels: vec![Label {
                text: "<script>".to_owned(),
                place: Place::On { middle_m: frame.low, half_length_m: vec2(1.0, 0.0) },
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
