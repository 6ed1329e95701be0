//! Finds places for the texts of a plan view, so that no text covers another text, a fender, an arrow or a tug.

use fenderline_contact::Vec2;

use super::box2::{Box2, HALF_LINE};
use super::contents::Plan;
use super::harbour::tug_texts;
use super::map::{Map, Place};

/// Distance of a name from the thing that it belongs to, and distance between two tried places (px).
const GAP: f64 = 5.0;
const SHIFT: f64 = 9.0;
/// Tried places for a name along a body, as shares of half the body's length from its middle.
const ALONG: [f64; 9] = [0.0, 0.2, -0.2, 0.4, -0.4, 0.6, -0.6, 0.8, -0.8];
/// Tried shifts of a name to the side, as shares of half the text's width.
const ASIDE: [f64; 5] = [0.0, -0.5, 0.5, -1.0, 1.0];

/// The middle of each text (px): first the texts of the tugs, then the labels. No text covers another text, a
/// fender, an arrow or a tug. Earlier texts choose their place first; `None` if a text has no free place.
pub(super) fn text_places(plan: &Plan, map: &Map) -> Vec<Option<(f64, f64)>> {
    let mut taken = plan.obstacles(map);
    let mut free = |text: &str, places: Vec<(f64, f64)>, is_good: &dyn Fn(&Box2) -> bool| {
        let free = places.into_iter().map(|(x, y)| Box2::of_text(text, x, y)).find(|text| {
            text.lies_within(map.width, map.height)
                && !taken.iter().any(|other| other.overlaps(text))
                && is_good(text)
        })?;
        taken.push(free);
        Some((free.x, free.y))
    };
    let of_tugs = plan.harbour.tugs.iter().map(|tug| (&tug.label, tug_texts(tug, map)));
    let mut all: Vec<_> = of_tugs.map(|(text, places)| free(text, places, &|_| true)).collect();
    let things: Vec<(f64, f64)> =
        plan.labels.iter().filter_map(|label| thing(&label.place, map)).collect();
    all.extend(plan.labels.iter().map(|label| {
        let own = thing(&label.place, map);
        let is_nearest = |text: &Box2| {
            own.is_none_or(|own| {
                things.iter().all(|other| text.distance(own) <= text.distance(*other))
            })
        };
        free(&label.text, candidates(&label.text, &label.place, map), &is_nearest)
    }));
    all
}

/// Position of the small thing, such as a fender, beside which a name stands (px). No other small thing may be nearer
/// to the name.
fn thing(place: &Place, map: &Map) -> Option<(f64, f64)> {
    match place {
        Place::Beside { point_m, .. } => Some(map.px(*point_m)),
        Place::At(_) | Place::On { .. } => None,
    }
}

/// Possible places for the middle of a text (px), the best first.
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
            // To the side where fenders or tugs stand along a body that is narrower than the text.
            let aside = ASIDE.into_iter().flat_map(|share| {
                spots
                    .map(|(x, y)| (x + share * half_width, y))
                    .into_iter()
                    .flat_map(above_and_below)
            });
            aside.collect()
        }
    }
}

fn above_and_below((x, y): (f64, f64)) -> [(f64, f64); 3] {
    [(x, y), (x, y - 2.0 * SHIFT), (x, y + 2.0 * SHIFT)]
}

/// Places for a text beside a point: on the preferred side, also shifted along it; on the other side only if the
/// preferred side is outside the view.
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

/// Places for a text around a body that is too small to hold it; first those away from the middle of the view.
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

    use super::super::map::Arrow;
    use super::super::{
        FenderBox, Frame, Harbour, Label, LineDrawn, Outlined, Stage, TugDrawn, Use, Weather,
    };
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
        let boxes = boxes(&plan, &map);
        assert_eq!(
            boxes.len(),
            plan.labels.len() + plan.obstacles(&map).len(),
            "a name is missing"
        );
        for (k, one) in boxes.iter().enumerate().take(plan.labels.len()) {
            let clear = boxes[k + 1..].iter().all(|other| !one.overlaps(other));
            assert!(clear, "{one:?} among {boxes:?}");
        }
    }
    /// The texts that have a place, then all that they must not cover.
    fn boxes(plan: &Plan, map: &Map) -> Vec<Box2> {
        let placed = text_places(plan, map).into_iter().zip(plan.texts());
        let placed = placed.filter_map(|(at, text)| Some(Box2::of_text(text, at?.0, at?.1)));
        placed.chain(plan.obstacles(map)).collect()
    }

    /// A ship of 300 m at a quay with 40 fenders and 24 bollards, three pairs of tugs that work side by side, wind and
    /// current: the texts that are drawn, read from the picture itself, cover neither each other nor a fender or a tug.
    #[test]
    fn no_text_covers_another_where_fenders_bollards_and_tugs_are_many() {
        let along = |k: u32, of: u32| 300.0 * (f64::from(k) + 0.5) / f64::from(of) - 150.0;
        let fenders: Vec<FenderBox> = (0..40)
            .map(|k| FenderBox {
                mount_m: vec2(along(k, 40), 0.0),
                out_m: vec2(0.0, -2.0),
                half_width_m: vec2(1.5, 0.0),
                used: Use::Untouched,
            })
            .collect();
        let beside = |text: String, point_m| Label {
            text,
            place: Place::Beside { point_m, side: vec2(0.0, 1.0) },
        };
        let on = |text: &str, east_m: f64| Label {
            text: text.to_owned(),
            place: Place::On { middle_m: vec2(0.0, east_m), half_length_m: vec2(150.0, 0.0) },
        };
        let bollard_m = |k: u32| vec2(along(k, 24), 12.0);
        let fender_names = fenders.clone().into_iter().enumerate();
        let labels = [on("bulk carrier", -24.0), on("berth 7 north", 8.0)].into_iter();
        let labels =
            labels.chain(fender_names.map(|(k, of)| beside(format!("cone_{k}"), of.mount_m)));
        let labels =
            labels.chain((0..24).map(|k| beside(format!("breast_line_{k} 37 %"), bollard_m(k))));
        let tug = |k: u32| TugDrawn {
            at_m: vec2(along(k / 2, 3) + 25.0 * f64::from(k % 2), -46.0),
            direction: vec2(0.0, 1.0),
            on_line: false,
            label: format!("Tug number {k} pushes 550 kN"),
        };
        let line = |k: u32| LineDrawn {
            ends_m: [vec2(along(k, 24), -4.0), bollard_m(k)],
            share: 0.37,
            has_parted: false,
        };
        let weather =
            |text: &str| Weather { towards: vec2(0.0, 1.0), text: text.to_owned(), colour: "#000" };
        let outline = vec![vec2(-150.0, -4.0), vec2(150.0, -4.0), vec2(150.0, -46.0)];
        let plan = Plan {
            title: String::new(),
            frame: Frame { low: vec2(-160.0, -90.0), high: vec2(160.0, 40.0) },
            outlines: vec![Outlined { vertices_m: outline, stage: Stage::Peak, style: 0 }],
            fenders,
            harbour: Harbour {
                chart: Vec::new(),
                limits: None,
                lines: (0..24).map(line).collect(),
                anchors: Vec::new(),
                tugs: (0..6).map(tug).collect(),
                banks: Vec::new(),
                passing: Vec::new(),
                approached: Vec::new(),
                plans: Vec::new(),
                weather: vec![weather("wind 12 m/s (23.3 kn) from west"), weather("current")],
            },
            tracks: Vec::new(),
            arrows: vec![Arrow {
                from_m: vec2(0.0, -2.0),
                direction: vec2(0.0, -1.0),
                label: "N = 1234 kN".to_owned(),
            }],
            labels: labels.collect(),
            note: String::new(),
        };
        let map = Map::of(plan.frame);
        let drawn = drawn_texts(&plan.render().into_string());
        assert!(drawn.iter().any(|(text, _)| text == "bulk carrier"), "{drawn:?}");
        let of_tugs = drawn.iter().filter(|(text, _)| text.starts_with("Tug")).count();
        assert_eq!(of_tugs, 6, "each tug has her text: {drawn:?}");
        let arrow = super::super::arrows::boxes(&plan.arrows[0], &map);
        // The arrow's text and the N of the north arrow are among the obstacles.
        let obstacles = plan.obstacles(&map).into_iter().map(|of| ("an obstacle".to_owned(), of));
        let texts: Vec<_> = drawn.into_iter().filter(|(text, _)| !text.starts_with('N')).collect();
        assert!(arrow.len() == 3 && texts.len() > 10);
        let all: Vec<_> = texts.iter().cloned().chain(obstacles).collect();
        for (k, (text, one)) in texts.iter().enumerate() {
            for (other_text, other) in &all[k + 1..] {
                assert!(!one.overlaps(other), "{text} {one:?} covers {other_text} {other:?}");
            }
        }
    }

    /// The texts of class `name` in a picture, with the rectangles that they cover.
    fn drawn_texts(svg: &str) -> Vec<(String, Box2)> {
        let value = |text: &str, key: &str| {
            let (_, rest) = text.split_once(&format!(" {key}=\"")).expect("the attribute");
            rest.split_once('"').expect("its end").0.to_owned()
        };
        let texts = svg.split("<text class=\"halo name\"").skip(1).map(|rest| {
            let (tag, rest) = rest.split_once('>').expect("a tag");
            let text = rest.split_once('<').expect("a text").0.to_owned();
            let number = |key| value(tag, key).parse::<f64>().expect("a number");
            let (x, y) = (number("x"), number("y") - 4.0);
            let covered = match value(tag, "text-anchor").as_str() {
                "middle" => Box2::of_text(&text, x, y),
                anchor => Box2::of_text_from(&text, (x, y), anchor == "end"),
            };
            (text, covered)
        });
        texts.collect()
    }
}
