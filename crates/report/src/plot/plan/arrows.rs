//! The room that an arrow takes in a plan view.

use fenderline_contact::Vec2;

use super::box2::Box2;
use super::map::{ARROW, Arrow, Map, arrow_text};

/// The rectangles that an arrow covers: the ring at its beginning, its shaft and its text.
pub(super) fn boxes(arrow: &Arrow, map: &Map) -> Vec<Box2> {
    let (x, y) = map.px(arrow.from_m);
    let mut all = vec![Box2::around(&[(x, y)], 8.0)];
    if arrow.direction != Vec2::ZERO {
        let tip = (x + arrow.direction.y * ARROW, y - arrow.direction.x * ARROW);
        all.push(Box2::around(&[(x, y), tip], 5.0));
    }
    if !arrow.label.is_empty() {
        let (text_x, text_y, is_left) = arrow_text(arrow, map);
        all.push(Box2::of_text_from(&arrow.label, (text_x, text_y), is_left));
    }
    all
}
