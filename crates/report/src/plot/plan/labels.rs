//! Where names stand in a plan view.

use fenderline_contact::Vec2;

use super::harbour::ROW;
use super::map::{Arrow, Label, Map, arrow_text};

/// A rectangle of the drawn area, by its middle and half its size (px).
#[derive(Clone, Copy)]
pub(super) struct Box2 {
    x: f64,
    y: f64,
    pub(super) half_width: f64,
    half_height: f64,
}

impl Box2 {
    pub(super) fn of_text(text: &str, x: f64, y: f64) -> Box2 {
        let count = u32::try_from(text.chars().count()).map_or(0.0, f64::from);
        Box2 { x, y, half_width: count * 3.6 + 3.0, half_height: 8.0 }
    }

    fn overlaps(&self, other: &Box2) -> bool {
        (self.x - other.x).abs() < self.half_width + other.half_width
            && (self.y - other.y).abs() < self.half_height + other.half_height
    }

    fn lies_within(&self, width: f64, height: f64) -> bool {
        self.x > self.half_width
            && self.x < width - self.half_width
            && self.y > self.half_height
            && self.y < height - self.half_height
    }
}

/// Where each label stands (px), so that none covers another nor an arrow's text; the first come
/// first, and one that finds no place is left out.
pub(super) fn label_places(
    labels: &[Label],
    arrows: &[Arrow],
    weather_rows: usize,
    map: &Map,
) -> Vec<Option<(f64, f64)>> {
    let north = Box2 { x: map.width - 22.0, y: 30.0, half_width: 14.0, half_height: 26.0 };
    let mut taken = vec![north];
    if weather_rows > 0 {
        let rows = u32::try_from(weather_rows).map_or(3.0, f64::from);
        let half_height = 3.0 + 0.5 * ROW * rows;
        taken.push(Box2 { x: 140.0, y: 6.0 + half_height, half_width: 140.0, half_height });
    }
    taken.extend(arrows.iter().map(|arrow| {
        let (x, y, is_left) = arrow_text(arrow, map);
        let mut text = Box2::of_text(&arrow.label, x, y);
        text.x += if is_left { -text.half_width } else { text.half_width };
        text
    }));
    let places = labels.iter().map(|label| {
        let (x, y) = map.px(label.at_m);
        let reach = label.reach_m * map.px_per_m;
        let half_width = Box2::of_text(&label.text, x, y).half_width;
        let candidates = if label.side != Vec2::ZERO {
            // Right and down.
            let (dx, dy) = (label.side.y, -label.side.x);
            let off = reach + 5.0 + half_width * dx.abs() + 8.0 * dy.abs();
            let (dx, dy) = (dx * off, dy * off);
            [(dx, dy), (dx, dy - 9.0), (dx, dy + 9.0), (1.6 * dx, 1.6 * dy), (-dx, -dy)]
        } else if reach < half_width {
            let (aside, off) = (reach + half_width + 2.0, reach + 12.0);
            // Outwards, away from what the view is about.
            let aside = if x < map.width / 2.0 { -aside } else { aside };
            [(aside, 0.0), (-aside, 0.0), (0.0, -off), (0.0, off), (aside, -18.0)]
        } else {
            [0.0, -18.0, 18.0, -36.0, 36.0].map(|shift| (0.0, shift))
        };
        let free = candidates.into_iter().find_map(|(dx, dy)| {
            let text = Box2::of_text(&label.text, x + dx, y + dy);
            let is_free = text.lies_within(map.width, map.height)
                && !taken.iter().any(|other| other.overlaps(&text));
            is_free.then_some(text)
        })?;
        taken.push(free);
        Some((free.x, free.y))
    });
    places.collect()
}
