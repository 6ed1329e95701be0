//! Draws the nautical chart behind a plan view.

use core::fmt::Write as _;

use fenderline_contact::Vec2;
use fenderline_sim::chart::{ChartFeature, ChartKind, ChartShape, MarkColour, MarkSide};
use maud::{Markup, html};

use super::map::{Frame, Label, Map, Place};

/// Half the size of a drawn buoy (px).
const MARK: f64 = 5.0;

/// Chart features that a plan view of `frame` may show, with some room around the frame, because the view can be wider.
pub fn charted_in(features: &[ChartFeature], frame: Frame) -> Vec<ChartFeature> {
    let [tall, wide] = [frame.size().x, frame.size().y];
    let room = fenderline_contact::vec2(tall + wide, tall + wide);
    let (low, high) = (frame.low - room, frame.high + room);
    let is_near = |feature: &&ChartFeature| {
        Frame::around(feature.shape.points_m()).is_some_and(|around| {
            around.low.x <= high.x
                && around.high.x >= low.x
                && around.low.y <= high.y
                && around.high.y >= low.y
        })
    };
    features.iter().filter(is_near).cloned().collect()
}

/// The chart's names and depths in the frame, for the list of texts that need a place in the view.
pub fn chart_labels(features: &[ChartFeature], frame: Frame) -> Vec<Label> {
    let is_in = |at: &Vec2| {
        (frame.low.x..=frame.high.x).contains(&at.x) && (frame.low.y..=frame.high.y).contains(&at.y)
    };
    let label = |feature: &ChartFeature| {
        let text = match (feature.kind, feature.depth_m) {
            (ChartKind::DepthContour, Some(depth_m)) => format!("{depth_m} m"),
            (ChartKind::Name | ChartKind::Buoy | ChartKind::Beacon, _) => feature.name.clone(),
            _ => return None,
        };
        let points: Vec<Vec2> = feature.shape.points_m().filter(is_in).collect();
        let at = *points.get(points.len() / 2)?;
        let place = match feature.kind {
            ChartKind::Buoy | ChartKind::Beacon => {
                Place::Beside { point_m: at, side: fenderline_contact::vec2(0.0, 1.0) }
            }
            _ => Place::At(points),
        };
        (!text.is_empty()).then_some(Label { text, place })
    };
    features.iter().filter_map(label).collect()
}

/// The note that tells the reader what the chart means for the run.
pub fn chart_note() -> Markup {
    html! {
        p class="note" {
            "The chart is only drawn: the run has the depth of the scenario. Depths in metres."
        }
    }
}

/// Draws the chart's features, kind by kind in a fixed order.
pub(super) fn charted(features: &[ChartFeature], map: &Map) -> Markup {
    let of = |kind| features.iter().filter(move |feature| feature.kind == kind);
    html! {
        @for feature in ChartKind::ALL.into_iter().flat_map(of) {
            @match &feature.shape {
                ChartShape::Point(at_m) => (mark(feature, map.px(*at_m))),
                ChartShape::Line(line) => (drawn(feature, &map.path(line), false)),
                ChartShape::Area(rings) => (drawn(feature, &rings_path(rings, map), true)),
            }
        }
    }
}

fn rings_path(rings: &[Vec<Vec2>], map: &Map) -> String {
    let mut path = String::new();
    for ring in rings {
        let _ = write!(path, "{}Z", map.path(ring));
    }
    path
}

fn drawn(feature: &ChartFeature, path: &str, is_area: bool) -> Markup {
    let (fill, stroke, width, dashes) = match feature.kind {
        ChartKind::DepthArea => (depth_fill(feature.depth_m.unwrap_or(0.0)), "none", "0", ""),
        ChartKind::DepthContour => ("none", "#6d9cbf", "0.8", ""),
        ChartKind::Quay => ("#d8d2be", "#4a5460", "1.2", ""),
        ChartKind::LeadingLine => ("none", "#4a5460", "0.8", "8 4"),
        _ => ("#ebe5d1", "#8a7d54", "0.9", ""),
    };
    html! {
        path d=(path) fill=(if is_area { fill } else { "none" }) fill-rule="evenodd" stroke=(stroke)
            stroke-width=(width) stroke-dasharray=(dashes) {}
    }
}

/// Fill colour of a charted depth: shallow water is darker, as on a paper chart.
fn depth_fill(depth_m: f64) -> &'static str {
    match depth_m {
        depth if depth < 0.0 => "#cfd8a8",
        depth if depth < 5.0 => "#a8d0ea",
        depth if depth < 10.0 => "#c6e0f1",
        depth if depth < 20.0 => "#e0eff8",
        _ => "#f4fafd",
    }
}

/// Draws the mark of a chart feature: a can for a port buoy, a cone for a starboard buoy, otherwise a ball. A feature
/// that is only a name has no mark.
fn mark(feature: &ChartFeature, (x, y): (f64, f64)) -> Markup {
    let Some(mark) = feature.mark else { return html! {} };
    let fill = match mark.colour {
        MarkColour::Red => "#c8102e",
        MarkColour::Green => "#0a7a33",
        MarkColour::Yellow => "#f0b400",
        MarkColour::Black => "#222",
        MarkColour::White => "#fff",
    };
    let s = MARK;
    let ball = format!(
        "M{:.1},{y:.1}a{s},{s} 0 1 0 {:.1},0a{s},{s} 0 1 0 {:.1},0Z",
        x - s,
        2.0 * s,
        -2.0 * s
    );
    let path = match mark.side {
        Some(MarkSide::Port) => format!(
            "M{:.1},{:.1}h{:.1}v{:.1}h{:.1}Z",
            x - 0.8 * s,
            y - s,
            1.6 * s,
            2.0 * s,
            -1.6 * s
        ),
        Some(MarkSide::Starboard) => {
            format!("M{x:.1},{:.1}L{:.1},{:.1}H{:.1}Z", y - 1.1 * s, x + s, y + s, x - s)
        }
        None => ball,
    };
    let base = format!("M{x:.1},{:.1}v3m{:.1},0h{:.1}", y + s, -s, 2.0 * s);
    html! {
        path d=(path) fill=(fill) stroke="#222" stroke-width="0.8" {}
        @if feature.kind == ChartKind::Beacon {
            path d=(base) fill="none" stroke="#222" stroke-width="0.8" {}
        }
    }
}
