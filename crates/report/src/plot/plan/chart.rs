//! Draws the nautical chart behind a plan view.

use core::fmt::Write as _;

use fenderline_contact::Vec2;
use fenderline_sim::chart::{
    Chart, ChartFeature, ChartKind, ChartLight, ChartShape, MarkColour, MarkSide,
};
use maud::{Markup, html};

use crate::plot::plain;

use super::depths::{DepthLimits, areas, depth_fill, safety_contour};
use super::map::{Frame, Label, Map, Place};

/// Half the size of a drawn buoy (px).
const MARK: f64 = 5.0;

/// Features of the nautical chart that a plan view of `frame` may show, with some room around the frame, because the
/// view can be wider.
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

/// The names and depths of the nautical chart within `frame`, for the list of texts that need a place in the view.
pub fn chart_labels(features: &[ChartFeature], frame: Frame) -> Vec<Label> {
    let is_in = |at: &Vec2| {
        (frame.low.x..=frame.high.x).contains(&at.x) && (frame.low.y..=frame.high.y).contains(&at.y)
    };
    let label = |feature: &ChartFeature| {
        let text = match (feature.kind, feature.depth_m) {
            (ChartKind::DepthContour, Some(depth_m)) => format!("{depth_m} m"),
            (
                ChartKind::Sounding | ChartKind::Rock | ChartKind::Obstruction | ChartKind::Wreck,
                Some(depth_m),
            ) => format!("{depth_m}"),
            (ChartKind::Bridge | ChartKind::Cable, _) => {
                format!("{} m clear", feature.clearance_m?)
            }
            (ChartKind::Light, _) => feature.light.as_ref()?.character.clone(),
            (ChartKind::Name | ChartKind::Buoy | ChartKind::Beacon | ChartKind::Landmark, _) => {
                feature.name.clone()
            }
            _ => return None,
        };
        let points: Vec<Vec2> = feature.shape.points_m().filter(is_in).collect();
        let at = *points.get(points.len() / 2)?;
        let place = match feature.kind {
            ChartKind::Buoy
            | ChartKind::Beacon
            | ChartKind::Landmark
            | ChartKind::Light
            | ChartKind::Rock
            | ChartKind::Obstruction
            | ChartKind::Wreck => {
                Place::Beside { point_m: at, side: fenderline_contact::vec2(0.0, 1.0) }
            }
            _ => Place::At(points),
        };
        (!text.is_empty()).then_some(Label { text, place })
    };
    features.iter().filter_map(label).collect()
}

/// What a reader must know of the nautical chart: where the depth of the run comes from, and what of the chart is not
/// drawn.
pub fn chart_note(chart: &Chart, has_bottom: bool, limits: Option<&DepthLimits>) -> Markup {
    html! {
        p class="note" {
            @if has_bottom {
                "The depth of the water in the run depends on the place. Depths of the chart are in metres below chart datum."
            } @else {
                "The chart is only drawn: the run uses the depth that the scenario gives. Depths are in metres."
            }
            @if let Some(limits) = limits {
                " Shades of the water, from dark to light: shallower than the draught of " (limits.ship) ", "
                (plain(limits.draught_m, 4)) " m; not safe, to the bold safety contour at " (plain(limits.safety_m(), 4))
                " m, with " (plain(limits.clearance_m, 4)) " m under the keel at chart datum; safe; deeper than "
                (plain(limits.deep_m(), 4)) " m."
            }
            @if let Some(left_out) = chart.left_out_in_words() { " Left out of the chart: " (left_out) "." }
        }
    }
}

/// Draws the features of the nautical chart, kind by kind in a fixed order.
pub(super) fn charted(
    features: &[ChartFeature],
    limits: Option<&DepthLimits>,
    frame: Frame,
    map: &Map,
) -> Markup {
    let is_of_depth = |kind: &ChartKind| kind.is_area_of_depth();
    let of = |kind| features.iter().filter(move |feature| feature.kind == kind);
    let others = ChartKind::ALL.into_iter().filter(|kind| !is_of_depth(kind)).flat_map(of);
    let contour =
        limits.map_or_else(Vec::new, |limits| safety_contour(features, frame, limits.safety_m()));
    html! {
        @for feature in areas(features) {
            @if let ChartShape::Area(rings) = &feature.shape {
                (drawn(feature, limits, &rings_path(rings, map), true))
            }
        }
        @if !contour.is_empty() {
            path d=(contour.iter().map(|ends| map.path(ends)).collect::<String>()) fill="none"
                stroke="#3b4a57" stroke-width="1.8" stroke-linecap="round" {}
        }
        @for feature in others {
            @match &feature.shape {
                ChartShape::Point(at_m) => (point(feature, map.px(*at_m))),
                ChartShape::Line(line) => (drawn(feature, limits, &map.path(line), false)),
                ChartShape::Area(rings) => (drawn(feature, limits, &rings_path(rings, map), true)),
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

fn drawn(
    feature: &ChartFeature,
    limits: Option<&DepthLimits>,
    path: &str,
    is_area: bool,
) -> Markup {
    let depth_m = feature.depth_m.unwrap_or(0.0);
    let (fill, stroke, width, dashes) = match feature.kind {
        ChartKind::Coverage => ("none", "none", "0", ""),
        ChartKind::DepthArea => (depth_fill(depth_m, limits), "none", "0", ""),
        ChartKind::DredgedArea => (depth_fill(depth_m, limits), "#6d9cbf", "0.8", "6 3"),
        ChartKind::UnsurveyedArea => ("#dcdcdc", "none", "0", ""),
        ChartKind::DepthContour => ("none", "#6d9cbf", "0.8", ""),
        ChartKind::Rock | ChartKind::Obstruction | ChartKind::Wreck => {
            (depth_fill(depth_m, limits), "#222", "0.8", "2 2")
        }
        ChartKind::Quay
        | ChartKind::Pontoon
        | ChartKind::Building
        | ChartKind::Mooring
        | ChartKind::Landmark => ("#d8d2be", "#4a5460", "1.2", ""),
        ChartKind::Berth => ("none", "#4a5460", "0.8", "4 3"),
        ChartKind::Fairway | ChartKind::Anchorage => ("none", "#a0529b", "0.8", "6 4"),
        ChartKind::Bridge => ("none", "#4a5460", "2.4", ""),
        ChartKind::Cable => ("none", "#4a5460", "0.8", "10 3"),
        ChartKind::LeadingLine => ("none", "#4a5460", "0.8", "8 4"),
        _ => ("#ebe5d1", "#8a7d54", "0.9", ""),
    };
    html! {
        path d=(path) fill=(if is_area { fill } else { "none" }) fill-rule="evenodd" stroke=(stroke)
            stroke-width=(width) stroke-dasharray=(dashes) {}
    }
}

/// Draws a buoy, beacon, light, danger or post. A sounding or a name is drawn as text alone.
fn point(feature: &ChartFeature, (x, y): (f64, f64)) -> Markup {
    let s = MARK;
    let plus = format!("M{:.1},{y:.1}h{:.1}M{x:.1},{:.1}v{:.1}", x - s, 2.0 * s, y - s, 2.0 * s);
    match (feature.kind, &feature.light) {
        (ChartKind::Light, Some(light)) => lamp(light, (x, y)),
        (ChartKind::Rock | ChartKind::Obstruction | ChartKind::Wreck, _) => html! {
            path d=(plus) fill="none" stroke="#222" stroke-width="1" {}
            @if feature.kind == ChartKind::Wreck {
                path d=(format!(
                    "M{:.1},{:.1}v{s:.1}m{s:.1},0v{:.1}", x - 0.5 * s, y - 0.5 * s, -s
                )) fill="none" stroke="#222" stroke-width="1" {}
            }
            @if feature.kind == ChartKind::Obstruction {
                circle cx=(format!("{x:.1}")) cy=(format!("{y:.1}")) r=(format!("{:.1}", 1.3 * s))
                    fill="none" stroke="#222" stroke-width="0.8" stroke-dasharray="2 2" {}
            }
        },
        (
            ChartKind::Mooring
            | ChartKind::Landmark
            | ChartKind::Coast
            | ChartKind::Quay
            | ChartKind::Pontoon
            | ChartKind::Building,
            _,
        ) => html! {
            rect x=(format!("{:.1}", x - 0.5 * s)) y=(format!("{:.1}", y - 0.5 * s))
                width=(s) height=(s) fill="#d8d2be" stroke="#4a5460" stroke-width="0.8" {}
        },
        _ => mark(feature, (x, y)),
    }
}

/// Draws a light: a dot in the colour of the light, and an arc over its sector. North is up.
fn lamp(light: &ChartLight, (x, y): (f64, f64)) -> Markup {
    let fill = match light.colour {
        MarkColour::Red => "#c8102e",
        MarkColour::Green => "#0a7a33",
        MarkColour::Black => "#222",
        MarkColour::Yellow | MarkColour::White => "#f0b400",
    };
    let reach = 4.0 * MARK;
    html! {
        @if let Some([from_rad, to_rad]) = light.sector_rad {
            @let turn_rad = 2.0 * core::f64::consts::PI;
            @let over_rad = to_rad - from_rad + if to_rad <= from_rad { turn_rad } else { 0.0 };
            @let end = |rad: f64| (x + reach * libm::sin(rad), y - reach * libm::cos(rad));
            @let ((x1, y1), (x2, y2)) = (end(from_rad), end(to_rad));
            @let is_large = u8::from(over_rad > core::f64::consts::PI);
            path d=(format!("M{x1:.1},{y1:.1}A{reach:.1},{reach:.1} 0 {is_large} 1 {x2:.1},{y2:.1}"))
                fill="none" stroke=(fill) stroke-width="2" {}
        }
        circle cx=(format!("{x:.1}")) cy=(format!("{y:.1}")) r="2.5" fill=(fill) stroke="#222"
            stroke-width="0.6" {}
    }
}

/// Draws the mark of a buoy or beacon: a can for port, a cone for starboard, otherwise a ball. Other features have no
/// mark.
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
