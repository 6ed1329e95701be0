//! Measured approaches of ships to a berth in a plan view.

use core::fmt::Write as _;

use fenderline_contact::Vec2;
use maud::{Markup, html};

use super::fenders::Use;
use super::map::Map;

/// The way of a ship to her first touch of a fender, earth-fixed.
#[derive(Clone, Debug, PartialEq)]
pub struct Approached {
    /// Way of the point of the hull that touches (m).
    pub path_m: Vec<Vec2>,
    /// Places of that point at whole minutes before the touch (m).
    pub minutes_m: Vec<Vec2>,
    /// Outline of the hull at the touch (m); empty for none.
    pub hull_m: Vec<Vec2>,
    /// Place of the first touch (m).
    pub touch_m: Vec2,
    /// How far the most used fender was used, which sets colour and width.
    pub used: Use,
}

/// Colour, width and dash of a way. Fills of fenders are too pale for lines.
fn look(of: Use) -> (&'static str, &'static str, &'static str) {
    match of {
        Use::Failed => ("#3a0010", "3.6", ""),
        Use::Share(share) if share > 1.0 => ("#b2001e", "3.2", ""),
        Use::Share(share) if share > 0.75 => ("#d9590b", "2.6", ""),
        Use::Share(share) if share > 0.5 => ("#c79500", "2.0", ""),
        Use::Share(_) => ("#0072b2", "1.4", ""),
        Use::NotRated | Use::Untouched => ("#4a5460", "1.4", "4 3"),
    }
}

pub(super) fn approached(of: &Approached, map: &Map) -> Markup {
    let (stroke, width, dashes) = look(of.used);
    let (x, y) = map.px(of.touch_m);
    let mut minutes = String::new();
    for at_m in &of.minutes_m {
        let (x, y) = map.px(*at_m);
        let _ = write!(minutes, "M{:.1},{y:.1}a2.2,2.2 0 1 0 4.4,0a2.2,2.2 0 1 0 -4.4,0", x - 2.2);
    }
    html! {
        @if !of.hull_m.is_empty() {
            path d={ (map.path(&of.hull_m)) "Z" } fill=(stroke) fill-opacity="0.05" stroke=(stroke)
                stroke-width="0.9" stroke-linejoin="round" {}
        }
        path d=(map.path(&of.path_m)) fill="none" stroke=(stroke) stroke-width=(width)
            stroke-dasharray=(dashes) stroke-linejoin="round" {}
        @if !minutes.is_empty() { path d=(minutes) fill="#fff" stroke=(stroke) {} }
        path d=(mark(x, y)) fill=(stroke) stroke="#fff" stroke-width="0.8" {}
    }
}

/// A square on its corner.
fn mark(x: f64, y: f64) -> String {
    format!("M{:.1},{y:.1}l4.5,-4.5l4.5,4.5l-4.5,4.5Z", x - 4.5)
}

/// The legend for ways of ships to a berth.
pub fn approached_legend() -> Markup {
    let entries = [
        (Use::NotRated, "no rating or no run"),
        (Use::Share(0.3), "to 50 % of rated"),
        (Use::Share(0.6), "to 75 %"),
        (Use::Share(0.9), "to 100 %"),
        (Use::Share(1.5), "over rated"),
        (Use::Failed, "FAILED"),
    ];
    html! {
        ul class="legend" {
            li { "Approaches:" }
            @for (of, text) in entries {
                @let (stroke, width, dashes) = look(of);
                li {
                    svg width="30" height="12" viewBox="0 0 30 12" aria-hidden="true" {
                        path d="M1,6H29" fill="none" stroke=(stroke) stroke-width=(width)
                            stroke-dasharray=(dashes) {}
                    }
                    (text)
                }
            }
            li {
                svg width="16" height="14" viewBox="0 0 16 14" aria-hidden="true" {
                    path d=(mark(8.0, 7.0)) fill="#4a5460" {}
                }
                "first touch"
            }
            li {
                svg width="12" height="12" viewBox="0 0 12 12" aria-hidden="true" {
                    circle cx="6" cy="6" r="2.2" fill="#fff" stroke="#4a5460" {}
                }
                "whole minutes before"
            }
        }
    }
}
