//! Draws what every plan view has: grid, north arrow, scale bar.

use core::fmt::Write as _;

use maud::{Markup, html};

use super::box2::Box2;
use super::map::{BOTTOM, Map, TOP, WIDTH};
use crate::plot::axis::nice_step;
use crate::plot::number::{fixed, order_of};

/// Draws grid lines and ticks in metres, and the titles of both axes.
pub(super) fn grid(map: &Map) -> Markup {
    let (right, base) = (map.left + map.width, TOP + map.height);
    let px = |east: f64| map.left + map.east.share(east) * map.width;
    let py = |north: f64| base - map.north.share(north) * map.height;
    let mut lines = String::new();
    for (value, _) in map.east.ticks() {
        let _ = write!(lines, "M{:.1},{TOP}V{base:.1}", px(value));
    }
    for (value, _) in map.north.ticks() {
        let _ = write!(lines, "M{:.1},{:.1}H{right:.1}", map.left, py(value));
    }
    html! {
        path class="grid" d=(lines) {}
        g class="ticks" {
            @for (value, label) in map.east.ticks() {
                @let half = Box2::of_text(&label, 0.0, 0.0).half_width;
                @if px(value) + half < WIDTH {
                    text x=(format!("{:.1}", px(value))) y=(format!("{:.1}", base + 15.0))
                    text-anchor="middle" { (label) }
                }
            }
            @for (value, label) in map.north.ticks() {
                text x=(format!("{:.1}", map.left - 6.0)) y=(format!("{:.1}", py(value) + 3.8))
                    text-anchor="end" { (label) }
            }
        }
        text class="axis" x=(format!("{:.1}", map.left + map.width / 2.0))
            y=(format!("{:.1}", base + BOTTOM - 7.0)) text-anchor="middle" { "east [m]" }
        text class="axis" text-anchor="middle"
            transform=(format!("translate(12 {:.1}) rotate(-90)", TOP + map.height / 2.0)) {
            "north [m]"
        }
    }
}

/// The rectangles of the north arrow and the scale bar, which names must not cover.
pub(super) fn boxes(map: &Map) -> Vec<Box2> {
    let x = map.width - 22.0;
    let (length_m, length) = scale(map);
    let label = scale_label(length_m);
    let text = Box2::of_text_from(&label, (SCALE_LEFT + length + 6.0, map.height - 18.0), false);
    let bar = (SCALE_LEFT, map.height - 24.0);
    vec![
        Box2::between((x - 14.0, 4.0), (x + 14.0, 56.0)),
        Box2::between(bar, (SCALE_LEFT + length, map.height - 8.0)),
        text,
    ]
}

/// Draws the north arrow; north is up in a plan view.
pub(super) fn north_arrow(map: &Map) -> Markup {
    let x = map.width - 22.0;
    html! {
        g aria-label="north is up" {
            path d=(format!("M{x:.1},10l7,26l-7,-6l-7,6Z")) fill="#fff" stroke="#222" {}
            path d=(format!("M{x:.1},10l0,20l-7,6Z")) fill="#222" {}
            text class="halo name" x=(format!("{x:.1}")) y="49" text-anchor="middle" { "N" }
        }
    }
}

/// Left end of the scale bar (px).
const SCALE_LEFT: f64 = 14.0;

/// Length of the scale bar, in metres and in pixels.
fn scale(map: &Map) -> (f64, f64) {
    let length_m = nice_step(map.width / map.px_per_m, 6);
    (length_m, length_m * map.px_per_m)
}

fn scale_label(length_m: f64) -> String {
    format!("{} m", fixed(length_m, decimals_of(length_m)))
}

/// Draws the scale bar, which has a round length.
pub(super) fn scale_bar(map: &Map) -> Markup {
    let (length_m, length) = scale(map);
    let (x, y) = (SCALE_LEFT, map.height - 14.0);
    let label = scale_label(length_m);
    html! {
        rect x=(x) y=(format!("{:.1}", y - 5.0)) width=(format!("{length:.1}")) height="5"
            fill="#fff" stroke="#222" {}
        rect x=(x) y=(format!("{:.1}", y - 5.0)) width=(format!("{:.1}", length / 2.0)) height="5"
            fill="#222" stroke="#222" {}
        text class="halo" x=(format!("{:.1}", x + length + 6.0)) y=(format!("{y:.1}")) { (label) }
    }
}

/// Number of decimals that shows a length with one significant digit.
fn decimals_of(length_m: f64) -> usize {
    usize::try_from(-order_of(length_m * 1.000_001)).unwrap_or(0)
}
