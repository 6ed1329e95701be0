//! Where the names stand in a plan view: none covers another text, a fender, an arrow or a tug.

use fenderline_contact::Vec2;

use super::box2::{Box2, HALF_LINE};
use super::map::{ARROW, Arrow, Label, Map, Place, arrow_text};

/// Distances from the thing that a name belongs to, and between two tries (px).
const GAP: f64 = 5.0;
const SHIFT: f64 = 9.0;
/// Places along a body, as shares of half its length from the middle.
const ALONG: [f64; 9] = [0.0, 0.2, -0.2, 0.4, -0.4, 0.6, -0.6, 0.8, -0.8];

/// The middle of each label (px), on nothing that is `taken`. The first labels choose first; `None`: there is no free
/// place.
pub(super) fn label_places(
    labels: &[Label],
    mut taken: Vec<Box2>,
    map: &Map,
) -> Vec<Option<(f64, f64)>> {
    let things: Vec<(f64, f64)> =
        labels.iter().filter_map(|label| thing(&label.place, map)).collect();
    let places = labels.iter().map(|label| {
        let own = thing(&label.place, map);
        let free = candidates(&label.text, &label.place, map).into_iter().find_map(|(x, y)| {
            let text = Box2::of_text(&label.text, x, y);
            let is_free = text.lies_within(map.width, map.height)
                && !taken.iter().any(|other| other.overlaps(&text));
            let is_nearest = own.is_none_or(|own| {
                things.iter().all(|other| text.distance(own) <= text.distance(*other))
            });
            (is_free && is_nearest).then_some(text)
        })?;
        taken.push(free);
        Some((free.x, free.y))
    });
    places.collect()
}

/// The small thing that a name stands beside (px). No other such thing may be nearer to the name.
fn thing(place: &Place, map: &Map) -> Option<(f64, f64)> {
    match place {
        Place::Beside { point_m, .. } => Some(map.px(*point_m)),
        Place::At(_) | Place::On { .. } => None,
    }
}

/// The ring at an arrow's beginning, its shaft and its text.
pub(super) fn arrow_boxes(arrow: &Arrow, map: &Map) -> Vec<Box2> {
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

/// Places for the middle of a text (px), the best first.
fn candidates(text: &str, place: &Place, map: &Map) -> Vec<(f64, f64)> {
    let half_width = Box2::of_text(text, 0.0, 0.0).half_width;
    match place {
        Place::At(points_m) => {
            points_m.iter().flat_map(|point_m| above_and_below(map.px(*point_m))).collect()
        }
        Place::Beside { point_m, side } => beside(map.px(*point_m), *side, half_width, map),
        Place::On { middle_m, half_length_m } => {
            let reach = half_length_m.length() * map.px_per_m;
            if reach < half_width {
                return around(map.px(*middle_m), reach, half_width, map);
            }
            let spots = ALONG.map(|share| map.px(*middle_m + *half_length_m * share));
            spots.into_iter().flat_map(above_and_below).collect()
        }
    }
}

fn above_and_below((x, y): (f64, f64)) -> [(f64, f64); 3] {
    [(x, y), (x, y - 2.0 * SHIFT), (x, y + 2.0 * SHIFT)]
}

/// Beside a point: on one side, shifted along it; on the other side only if this one is outside the view.
fn beside((x, y): (f64, f64), side: Vec2, half_width: f64, map: &Map) -> Vec<(f64, f64)> {
    // Right and down.
    let (dx, dy) = (side.y, -side.x);
    let off = GAP + half_width * dx.abs() + HALF_LINE * dy.abs();
    let at = |off: f64, along: f64| (x + dx * off - dy * along, y + dy * off + dx * along);
    let (near_x, near_y) = at(off, 0.0);
    let is_in_view = Box2 { x: near_x, y: near_y, half_width, half_height: HALF_LINE }
        .lies_within(map.width, map.height);
    if is_in_view {
        // Farther off where a ring or an arrow stands beside the point.
        let off = [off, off + SHIFT, off + 2.0 * SHIFT];
        let along = [0.0, -SHIFT, SHIFT, -2.0 * SHIFT, 2.0 * SHIFT];
        off.into_iter().flat_map(|off| along.map(|along| at(off, along))).collect()
    } else {
        vec![at(-off, 0.0)]
    }
}

/// Around a body that is too small for the text: outwards first, away from the middle of the view.
fn around((x, y): (f64, f64), reach: f64, half_width: f64, map: &Map) -> Vec<(f64, f64)> {
    let outwards = if x < map.width / 2.0 { -1.0 } else { 1.0 };
    let (near, off) = (outwards * (reach + half_width + 2.0), reach + 12.0);
    let far = near + outwards * 2.0 * GAP;
    let places = [
        (near, 0.0),
        (far, 0.0),
        (near, -2.0 * SHIFT),
        (near, 2.0 * SHIFT),
        (-near, 0.0),
        (-far, 0.0),
        (0.0, -off),
        (0.0, off),
    ];
    places.map(|(dx, dy)| (x + dx, y + dy)).to_vec()
}

#[cfg(test)]
mod tests {
    use fenderline_contact::vec2;

    use super::super::{FenderBox, Frame, Harbour, Plan, Use};
    use super::*;

    /// A quay 20 m wide along the view with eight fenders, whose names stand on it.
    #[test]
    fn the_name_of_a_quay_stands_clear_of_its_fenders_and_their_names() {
        let fender = |k: u32| FenderBox {
            mount_m: vec2(20.0 * f64::from(k) - 100.0, 0.0),
            out_m: vec2(0.0, -2.0),
            half_width_m: vec2(1.5, 0.0),
            used: Use::Untouched,
        };
        let names = (0..8).map(|k| Label {
            text: format!("cone_{k}"),
            place: Place::Beside { point_m: fender(k).mount_m, side: vec2(0.0, 1.0) },
        });
        let quay = Label {
            text: "quay".to_owned(),
            place: Place::On { middle_m: vec2(0.0, 10.0), half_length_m: vec2(200.0, 0.0) },
        };
        let plan = Plan {
            title: String::new(),
            frame: Frame { low: vec2(-200.0, -300.0), high: vec2(200.0, 300.0) },
            outlines: Vec::new(),
            fenders: (0..8).map(fender).collect(),
            harbour: Harbour::default(),
            tracks: Vec::new(),
            arrows: Vec::new(),
            labels: names.chain([quay]).collect(),
            note: String::new(),
        };
        let map = Map::of(plan.frame);
        let placed = label_places(&plan.labels, plan.obstacles(&map), &map);
        let boxes: Vec<Box2> = placed
            .iter()
            .zip(&plan.labels)
            .map(|(at, label)| {
                let (x, y) = at.unwrap_or_else(|| panic!("no place for {}", label.text));
                Box2::of_text(&label.text, x, y)
            })
            .chain(plan.obstacles(&map))
            .collect();
        for (k, one) in boxes.iter().enumerate().take(plan.labels.len()) {
            let clear = boxes[k + 1..].iter().all(|other| !one.overlaps(other));
            assert!(clear, "{one:?} among {boxes:?}");
        }
    }
}
