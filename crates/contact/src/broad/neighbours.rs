//! The neighbour list: pairs of bodies that are near each other, kept from step to step.
//!
//! The list holds every pair of bodies whose circles meet when each circle is drawn a little too large. A body may
//! move, or may reach farther, until it has used up the margin of its circle. Until a body has used up its margin,
//! every pair of bodies whose true circles meet is in the list. Users of the list test the true circles, so the age of
//! the list affects the cost of a step, but never the result.

use alloc::vec::Vec;

use crate::broad::bodies::Bodies;
use crate::geometry::extent::Extent;
use crate::maths::number::greater;
use crate::maths::room::room_for;
use crate::maths::spread::SpreadSort;
use crate::maths::vec2::Vec2;
use crate::model::Model;
use crate::model::material::MaterialId;
use crate::model::pair::{Bounds, RankedPair};

/// Margin of the list: how much larger a body's circle in the list is than its true circle, as a fraction. A larger
/// margin makes the list longer; a smaller margin makes the list valid for a shorter time.
const MARGIN: f64 = 0.1;

/// The fraction of the margin that a body may use before the list is made anew. The fraction is less than 1, to cover
/// rounding.
const USABLE: f64 = 0.999;

/// Strips are wider than the largest circle by this fraction, so that rounding puts no circle into the strip after the
/// next.
const ROUNDING: f64 = 1e-6;

/// The neighbour list, with the circles that the bodies had when the list was made. Computed by
/// [`NeighbourList::renew`].
#[derive(Clone, Debug, Default)]
pub(crate) struct NeighbourList {
    /// Layout of the model for which the list was made.
    layout: u64,
    /// Enlarged circles of the bodies, by rank.
    circles: Vec<Circle>,
    /// Pairs of bodies, in the order of their ranks.
    pairs: Vec<RankedPair>,
    bounds: Vec<Bounds>,
    /// The bodies in the order of the sweep.
    order: Vec<Swept>,
    sort_of_order: SpreadSort<Swept>,
    /// Ranks of each pair of bodies as a single number, with the lower rank in the upper half of the bits. When sorted
    /// as numbers, the pairs are in the order of their ranks.
    ranks: Vec<u64>,
    sort_of_ranks: SpreadSort<u64>,
}

/// A body in the sweep that finds circles that meet. The plane is cut into strips, as wide as the largest circle, that
/// run from west to east. The southern ends of two circles that meet lie in the same strip or in neighbouring strips.
/// Within a strip the bodies are in the order of their western ends, measured in steps so small that hardly two bodies
/// share the same step.
#[derive(Clone, Copy, Debug, Default)]
struct Swept {
    strip: u32,
    /// Western and eastern end of the body's circle, measured in steps.
    west: u32,
    east: u32,
    rank: u32,
}

/// A body's enlarged circle.
#[derive(Clone, Copy, Debug)]
struct Circle {
    center_m: Vec2,
    radius_m: f64,
}

impl Circle {
    #[inline]
    fn meets(&self, other: &Circle) -> bool {
        let reach_m = self.radius_m + other.radius_m;
        (self.center_m - other.center_m).length_squared() <= reach_m * reach_m
    }

    /// Returns true if this enlarged circle of a body contains the present circle of the same body.
    #[inline]
    fn holds(&self, center_m: Vec2, radius_m: f64) -> bool {
        let margin_m = USABLE * (self.radius_m - radius_m);
        margin_m >= 0.0 && (center_m - self.center_m).length_squared() <= margin_m * margin_m
    }
}

impl NeighbourList {
    /// Makes an empty list with room for this number of bodies and pairs.
    pub(crate) fn with_room(bodies: usize, pairs: usize) -> NeighbourList {
        NeighbourList {
            layout: 0,
            circles: room_for(bodies),
            pairs: room_for(pairs),
            bounds: room_for(pairs),
            order: room_for(bodies),
            sort_of_order: SpreadSort::with_room(bodies),
            ranks: room_for(pairs),
            sort_of_ranks: SpreadSort::with_room(pairs),
        }
    }

    /// The pairs of bodies in the list. The list includes all pairs that no `Pair` of the model names, in which at
    /// least one body floats, and whose circles with the radius `reach_m` meet.
    pub(crate) fn pairs(&self) -> &[RankedPair] {
        &self.pairs
    }

    /// Bounds of the pairs in the list, in the order of the pairs.
    pub(crate) fn bounds(&self) -> &[Bounds] {
        &self.bounds
    }

    /// Returns true if the list is still valid. Only active bodies are tested, because only active bodies can have
    /// moved.
    pub(crate) fn holds(&self, model: &Model, bodies: &Bodies) -> bool {
        if self.layout != model.layout {
            return false;
        }
        let count = self.circles.len();
        let (poses, reach_m) = (&bodies.poses[..count], &bodies.reach_m[..count]);
        bodies.active.iter().all(|&rank| {
            let rank = rank as usize;
            self.circles[rank].holds(poses[rank].position_m, reach_m[rank])
        })
    }

    /// Makes the list anew.
    pub(crate) fn renew(&mut self, model: &Model, material: MaterialId, bodies: &Bodies) {
        self.layout = model.layout;
        self.circles.clear();
        let reach = bodies.poses.iter().zip(&bodies.reach_m);
        self.circles.extend(reach.map(|(pose, &reach_m)| Circle {
            center_m: pose.position_m,
            radius_m: reach_m * (1.0 + MARGIN),
        }));
        self.sweep(model, material);
    }

    /// Finds the pairs of circles that meet by "sweep and prune", from west to east in strips.
    fn sweep(&mut self, model: &Model, material: MaterialId) {
        let NeighbourList { circles, order, ranks, .. } = self;
        let widest_steps = arrange(circles, order, &mut self.sort_of_order);
        ranks.clear();
        let mut add = |one: &Swept, two: &Swept| {
            let [circle, other] = [one, two].map(|swept| &circles[swept.rank as usize]);
            if two.west > one.east || two.east < one.west || !circle.meets(other) {
                return;
            }
            let (a, b) = (one.rank.min(two.rank), one.rank.max(two.rank));
            let both_stand = [a, b].iter().all(|&rank| model.ranked[rank as usize].stands);
            if !both_stand && !is_named(model, a, b) {
                ranks.push(joined(a, b));
            }
        };
        let mut of_strips = order.chunk_by(|one, two| one.strip == two.strip).peekable();
        while let Some(strip) = of_strips.next() {
            let mut beside = match of_strips.peek() {
                Some(&next) if next[0].strip - strip[0].strip == 1 => next,
                _ => &[],
            };
            for (index, one) in strip.iter().enumerate() {
                let reached = |two: &&Swept| two.west <= one.east;
                strip[index + 1..].iter().take_while(reached).for_each(|two| add(one, two));
                // Circles of the next strip that end before this one begins also end before all that follow.
                let passed = |two: &&Swept| two.west.saturating_add(widest_steps) < one.west;
                beside = &beside[beside.iter().take_while(passed).count()..];
                beside.iter().take_while(reached).for_each(|two| add(one, two));
            }
        }
        self.sort_of_ranks.sort(ranks, joined(model.ranked.len() as u32, 0), |&ranks| ranks);
        self.pairs.clear();
        self.pairs.extend(ranks.iter().map(|&ranks| {
            let [a, b] = [(ranks >> 32) as u32, ranks as u32];
            let [body_a, body_b] = [a, b].map(|rank| &model.ranked[rank as usize]);
            RankedPair::new((a, body_a), (b, body_b), material)
        }));
        self.bounds.clear();
        self.bounds.extend(
            self.pairs.iter().map(|pair| Bounds::of(&model.ranked, model.materials(), pair)),
        );
    }
}

/// Joins two 32-bit numbers into one number of 64 bits. The joined numbers sort by the first number, and then by the
/// second number.
#[inline]
fn joined(first: u32, second: u32) -> u64 {
    (u64::from(first) << 32) | u64::from(second)
}

/// Arranges the bodies for the sweep. Returns the width of the largest circle in steps, or a little more.
fn arrange(circles: &[Circle], order: &mut Vec<Swept>, sort: &mut SpreadSort<Swept>) -> u32 {
    let all = circles.iter().fold(Extent::EMPTY, |all, circle| {
        all.and(Extent::of_circle(circle.center_m, circle.radius_m))
    });
    let widest_m = 2.0 * circles.iter().fold(0.0, |most, circle| greater(circle.radius_m, most));
    let strips_per_m = 1.0 / (widest_m * (1.0 + ROUNDING));
    let steps_per_m = f64::from(u32::MAX) / (all.high_m.y - all.low_m.y);
    // A cast keeps the order; a value beyond the largest number becomes the largest.
    let step = |y_m: f64| ((y_m - all.low_m.y) * steps_per_m) as u32;
    order.clear();
    order.extend((0..).zip(circles).map(|(rank, circle)| {
        let Circle { center_m, radius_m } = *circle;
        Swept {
            strip: ((center_m.x - radius_m - all.low_m.x) * strips_per_m) as u32,
            west: step(center_m.y - radius_m),
            east: step(center_m.y + radius_m),
            rank,
        }
    }));
    let strips = ((all.high_m.x - all.low_m.x) * strips_per_m) as u32;
    sort.sort(order, joined(strips, u32::MAX), |swept| joined(swept.strip, swept.west));
    ((widest_m * steps_per_m) as u32).saturating_add(2)
}

fn is_named(model: &Model, a: u32, b: u32) -> bool {
    model.pairs.binary_search_by_key(&(a, b), |p| (p.a, p.b)).is_ok()
}

#[cfg(test)]
mod tests {
    use alloc::string::String;

    use super::*;
    use crate::maths::vec2::{Pose, vec2};
    use crate::model::body::{Body, Mobility};
    use crate::model::material::Material;
    use crate::model::outline::Outline;

    fn model_of(count: u64) -> (Model, MaterialId) {
        let mut builder = Model::builder();
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let outline = Outline::new(&corners.map(|(x, y)| vec2(x, y))).expect("a square").0;
        for key in 0..count {
            let (name, outline) = (String::new(), outline.clone());
            let mobility = Mobility::Free { mass_kg: 1.0, yaw_inertia_kgm2: 1.0 };
            builder.body(Body { name, key, outline, mobility });
        }
        let material = builder.material(Material {
            stiffness_npm2: 1.0,
            damping_nspm2: 0.0,
            shear_stiffness_npm: 1.0,
            friction_static: 0.0,
            friction_dynamic: 0.0,
            restitution: 0.0,
        });
        builder.all_other_pairs(material);
        (builder.build().expect("a good model"), material)
    }

    /// Circles of very different sizes, near the origin and 1e7 m away, in a square, in a row and at one place.
    #[test]
    fn the_sweep_finds_what_a_comparison_of_all_finds() {
        let (model, material) = model_of(200);
        let mut state = 5_u64;
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for (from_m, north_m, east_m, power) in [
            (0.0, 300.0, 300.0, 1.0),
            (1e7, 3000.0, 3000.0, 3.0),
            (-40.0, 5000.0, 0.0, 2.0),
            (0.0, 0.0, 5000.0, 2.0),
            (0.0, 0.0, 0.0, 1.0),
            (0.0, 1e8, 1e8, 9.0),
        ] {
            let mut bodies = Bodies::with_capacity(200);
            for _ in 0..200 {
                let place_m = vec2(from_m + north_m * number(), from_m + east_m * number());
                bodies.poses.push(Pose::new(place_m, 0.0));
                bodies.reach_m.push(libm::pow(10.0, power * number()));
            }
            let mut list = NeighbourList::default();
            list.renew(&model, material, &bodies);
            let found: Vec<(u32, u32)> = list.pairs().iter().map(|pair| (pair.a, pair.b)).collect();
            let all = (0..200).flat_map(|a| (a + 1..200).map(move |b| (a, b)));
            let meet =
                |&(a, b): &(u32, u32)| list.circles[a as usize].meets(&list.circles[b as usize]);
            assert_eq!(found, all.filter(meet).collect::<Vec<_>>(), "{north_m} {east_m} {power}");
        }
    }
}
