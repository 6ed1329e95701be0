//! Mooring lines, tugs, wind and current in a plan view.

use fenderline_contact::Vec2;
use fenderline_contact::number::greater;
use fenderline_sim::chart::ChartFeature;
use maud::{Markup, html};

use super::approached::Approached;
use super::box2::{Box2, HALF_LINE};
use super::depths::DepthLimits;
use super::map::Map;
use super::passing::{self, PassingDrawn};
use super::planned::PlannedDrawn;

/// What a plan view shows besides hulls and fenders; nothing by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Harbour {
    /// Features of the nautical chart, drawn below everything else.
    pub chart: Vec<ChartFeature>,
    /// Depths at which the shades of the chart change; `None` if there is no ship.
    pub limits: Option<DepthLimits>,
    /// Mooring lines.
    pub lines: Vec<LineDrawn>,
    /// Chains of anchors on the bottom, each from hawse pipe to anchor (m).
    pub anchors: Vec<[Vec2; 2]>,
    /// Tugs that are forces.
    pub tugs: Vec<TugDrawn>,
    /// The two ends of each bank (m).
    pub banks: Vec<[Vec2; 2]>,
    /// Passing ships.
    pub passing: Vec<PassingDrawn>,
    /// Measured ways of ships to the berth.
    pub approached: Vec<Approached>,
    /// Passage plans.
    pub plans: Vec<PlannedDrawn>,
    /// Wind, current and waves, shown in a corner.
    pub weather: Vec<Weather>,
}

/// A mooring line from fairlead to bollard, earth-fixed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineDrawn {
    /// Ends of the mooring line (m).
    pub ends_m: [Vec2; 2],
    /// Peak tension of the line divided by its break load.
    pub share: f64,
    /// Whether the mooring line parted.
    pub has_parted: bool,
}

/// A tug at a ship's side.
#[derive(Clone, Debug, PartialEq)]
pub struct TugDrawn {
    /// Point where the tug's force acts (m).
    pub at_m: Vec2,
    /// Direction of the tug's force on the ship, of length 1; zero if the tug is standing by.
    pub direction: Vec2,
    /// Whether the tug pulls on a line; otherwise she pushes with her bow.
    pub on_line: bool,
    /// Text at the tug: her name and force.
    pub label: String,
}

/// Wind, current or waves, shown by an arrow and a text in the corner of a plan view.
#[derive(Clone, Debug, PartialEq)]
pub struct Weather {
    /// Direction towards which wind, current or waves go, of length 1.
    pub towards: Vec2,
    /// Text that says what the arrow is (wind, current or waves), how strong, and from where.
    pub text: String,
    /// Colour of the arrow.
    pub colour: &'static str,
}

/// Length and beam of a drawn tug (m): those of a usual harbour tug, because the run has only the force of the
/// tug.
const TUG: (f64, f64) = (28.0, 11.0);
/// Smallest drawn length of a tug (px).
const LEAST_TUG: f64 = 16.0;
/// Height of one row of the corner with the weather (px).
const ROW: f64 = 24.0;

/// Colour, width and dash of a mooring line.
fn look(share: f64, has_parted: bool) -> (&'static str, &'static str, &'static str) {
    match share {
        _ if has_parted => ("#c00020", "2.4", "3 4"),
        share if share > 0.5 => ("#a02c00", "2.8", ""),
        share if share > 0.25 => ("#e07b1f", "2.2", ""),
        _ => ("#2a6f3c", "1.6", ""),
    }
}

pub(super) fn line(line: &LineDrawn, map: &Map) -> Markup {
    let [(x0, y0), (x1, y1)] = line.ends_m.map(|end| map.px(end));
    let (stroke, width, dashes) = look(line.share, line.has_parted);
    html! {
        path d=(format!("M{x0:.1},{y0:.1}L{x1:.1},{y1:.1}")) fill="none" stroke=(stroke)
            stroke-width=(width) stroke-dasharray=(dashes) {}
        circle cx=(format!("{x1:.1}")) cy=(format!("{y1:.1}")) r="2.4" fill="#222" {}
    }
}

/// Draws an anchor on the bottom, with its chain.
pub(super) fn anchor(chain_m: [Vec2; 2], map: &Map) -> Markup {
    let [(x0, y0), (x1, y1)] = chain_m.map(|end| map.px(end));
    html! {
        path d=(format!("M{x0:.1},{y0:.1}L{x1:.1},{y1:.1}")) fill="none" stroke="#333"
            stroke-width="1.6" stroke-dasharray="5 3" {}
        g transform=(format!("translate({x1:.1} {y1:.1})")) fill="none" stroke="#222" stroke-width="1.6" {
            circle cx="0" cy="-6" r="1.8" {}
            path d="M0,-4V7M-4,-2H4M-6,3Q-5,7 0,7Q5,7 6,3" {}
        }
    }
}

/// Draws a bank as a broad dashed line.
pub(super) fn bank(ends_m: [Vec2; 2], map: &Map) -> Markup {
    let [(x0, y0), (x1, y1)] = ends_m.map(|end| map.px(end));
    html! {
        path d=(format!("M{x0:.1},{y0:.1}L{x1:.1},{y1:.1}")) fill="none" stroke="#8a6d3b"
            stroke-width="5" stroke-dasharray="2 4" {}
    }
}

/// The place where a tug is drawn (px).
struct TugPlace {
    /// Corners of the tug's hull, beginning at her bow.
    hull: [(f64, f64); 5],
    /// Ends of the tug's line from the ship; `None` if she pushes.
    line: Option<[(f64, f64); 2]>,
    /// Point beside the middle of the tug's hull on the preferred side, where her text begins, or ends if it stands to
    /// the left.
    text: (f64, f64),
    is_left: bool,
    /// Distance from the middle of the tug's hull to her text (px).
    aside: f64,
}

fn tug_place(tug: &TugDrawn, map: &Map) -> TugPlace {
    let length = greater(TUG.0 * map.px_per_m, LEAST_TUG);
    let half = 0.5 * length * TUG.1 / TUG.0;
    // Right and down.
    let (dx, dy) = match tug.direction {
        Vec2::ZERO => (0.0, -1.0),
        direction => (direction.y, -direction.x),
    };
    let (x, y) = map.px(tug.at_m);
    // A tug that pushes lies behind her force with her bow at the hull; a tug that pulls lies ahead of her
    // force, on a line.
    let gap = if tug.on_line { 1.4 * length } else { 0.0 };
    let (bow_x, bow_y, back) = if tug.on_line {
        (x + dx * (gap + length), y + dy * (gap + length), -1.0)
    } else {
        (x, y, -1.0)
    };
    let at = |along: f64, across: f64| {
        (bow_x + dx * back * along - dy * across, bow_y + dy * back * along + dx * across)
    };
    let corners =
        [(0.0, 0.0), (0.3 * length, half), (length, half), (length, -half), (0.3 * length, -half)];
    let hull = corners.map(|(along, across)| at(along, across));
    let (text_x, text_y) = at(0.5 * length, 0.0);
    let (is_left, aside) = if dx > 0.3 || (dx.abs() <= 0.3 && x < 0.5 * map.width) {
        (true, -greater(half, 0.5 * length) - 6.0)
    } else {
        (false, greater(half, 0.5 * length) + 6.0)
    };
    let line = tug.on_line.then_some([(x, y), (x + dx * gap, y + dy * gap)]);
    TugPlace { hull, line, text: (text_x + aside, text_y), is_left, aside }
}

/// Places for the middle of a tug's text (px), the best first: beside her hull, shifted along it, then on her other
/// side.
pub(super) fn tug_texts(tug: &TugDrawn, map: &Map) -> Vec<(f64, f64)> {
    let place = tug_place(tug, map);
    let near = Box2::of_text_from(&tug.label, place.text, place.is_left).x;
    let hull_x = place.text.0 - place.aside;
    let other = 2.0 * hull_x - near;
    let down = [0.0, -1.0, 1.0, -2.0, 2.0, -3.0, 3.0].map(|lines| lines * 2.0 * HALF_LINE);
    let beside = |x: f64| down.map(|down| (x, place.text.1 + down));
    [near, other].into_iter().flat_map(beside).collect()
}

/// Draws a tug without her text.
pub(super) fn tug(tug: &TugDrawn, map: &Map) -> Markup {
    let TugPlace { hull, line, .. } = tug_place(tug, map);
    let hull: Vec<String> = hull.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
    html! {
        @if let Some([(x0, y0), (x1, y1)]) = line {
            path d=(format!("M{x0:.1},{y0:.1}L{x1:.1},{y1:.1}")) fill="none"
                stroke="#222" stroke-width="1.2" {}
        }
        path d=(format!("M{}Z", hull.join("L"))) fill=(if tug.direction == Vec2::ZERO { "#fff" } else { "#f6d34a" })
            stroke="#222" stroke-width="1.2" {}
    }
}

/// The rectangles that texts must not cover: tugs with their lines, and the corner with the weather.
pub(super) fn boxes(harbour: &Harbour, map: &Map) -> Vec<Box2> {
    let tugs = harbour.tugs.iter().flat_map(|tug| {
        let place = tug_place(tug, map);
        let line = place.line.map(|ends| Box2::around(&ends, 1.0));
        std::iter::once(Box2::around(&place.hull, 1.0)).chain(line)
    });
    let (width, height) = corner_size(&harbour.weather);
    let corner = Box2::between((6.0, 6.0), (6.0 + width, 6.0 + height));
    tugs.chain((!harbour.weather.is_empty()).then_some(corner)).collect()
}

/// Width and height of the corner with the weather (px).
fn corner_size(weather: &[Weather]) -> (f64, f64) {
    let longest = weather.iter().map(|of| of.text.chars().count()).max().unwrap_or(0);
    let width = 44.0 + 5.8 * u32::try_from(longest).map_or(60.0, f64::from);
    let rows = u32::try_from(weather.len()).map_or(3.0, f64::from);
    (width, 6.0 + ROW * rows)
}

/// Draws the upper left corner of a plan view, with the arrows of wind, current and waves.
pub(super) fn corner(weather: &[Weather]) -> Markup {
    let (width, height) = corner_size(weather);
    html! {
        @if !weather.is_empty() {
            rect x="6" y="6" width=(format!("{width:.0}")) height=(format!("{height:.0}"))
                fill="#fff" fill-opacity="0.9" stroke="#cfd6de" {}
            @for (index, of) in (0_u32..).zip(weather) {
                @let (x, y) = (24.0, 9.0 + ROW * (f64::from(index) + 0.5));
                @let (dx, dy) = (of.towards.y, -of.towards.x);
                path d=(format!("M{:.1},{:.1}L{:.1},{:.1}", x - 10.0 * dx, y - 10.0 * dy, x + 3.0 * dx, y + 3.0 * dy))
                    stroke=(of.colour) stroke-width="2.2" fill="none" {}
                path d=(format!("M{:.1},{:.1}L{:.1},{:.1}L{:.1},{:.1}Z", x + 11.0 * dx, y + 11.0 * dy,
                    x + 2.0 * dx - 5.0 * dy, y + 2.0 * dy + 5.0 * dx,
                    x + 2.0 * dx + 5.0 * dy, y + 2.0 * dy - 5.0 * dx)) fill=(of.colour) {}
                text x="42" y=(format!("{:.1}", y + 4.0)) { (of.text) }
            }
        }
    }
}

/// The legend for mooring lines, tugs, banks and passing ships.
pub fn harbour_legend([has_lines, has_tugs, has_banks, has_passing]: [bool; 4]) -> Markup {
    let entries = [
        (0.1, false, "peak to 25 % of break load"),
        (0.3, false, "to 50 %"),
        (0.9, false, "over 50 %"),
        (0.0, true, "PARTED"),
    ];
    html! {
        ul class="legend" {
            @if has_lines {
                li { "Lines:" }
                @for (share, has_parted, text) in entries {
                    @let (stroke, width, dashes) = look(share, has_parted);
                    li {
                        svg width="30" height="12" viewBox="0 0 30 12" aria-hidden="true" {
                            path d="M1,6H29" fill="none" stroke=(stroke) stroke-width=(width)
                                stroke-dasharray=(dashes) {}
                        }
                        (text)
                    }
                }
            }
            @if has_tugs {
                li {
                    svg width="30" height="12" viewBox="0 0 30 12" aria-hidden="true" {
                        path d="M28,6L21,11H4V1H21Z" fill="#f6d34a" stroke="#222" {}
                    }
                    "tug, with the bow at the place of pushing (not to scale; white: standing by)"
                }
            }
            @if has_banks {
                li {
                    svg width="30" height="12" viewBox="0 0 30 12" aria-hidden="true" {
                        path d="M1,6H29" fill="none" stroke="#8a6d3b" stroke-width="5"
                            stroke-dasharray="2 4" {}
                    }
                    "bank (the pull of a bank is unvalidated)"
                }
            }
            @if has_passing { (passing::legend()) }
        }
    }
}
