//! The neighbour list: pairs of bodies that are near each other, kept from step to step.
//!
//! The list holds every pair whose circles meet when each circle is drawn a little too large. As long as no body has
//! used up its own margin, by moving or by a longer reach, every pair whose true circles meet is in the list. Users of
//! the list test the true circles, so its age affects the cost of a step and never the result.

use alloc::vec::Vec;

use crate::bodies::Bodies;
use crate::material::MaterialId;
use crate::model::Model;
use crate::pair::{Bounds, RankedPair};
use crate::vec2::Vec2;

/// How much larger a body's circle in the list is than its own, as a fraction. A larger margin makes the list longer, a
/// smaller one makes it short-lived.
const MARGIN: f64 = 0.1;

/// The fraction of its margin that a body may use: less than 1, to cover rounding.
const USABLE: f64 = 0.999;

/// The list, and where the bodies were when it was made. Computed by [`NeighbourList::renew`].
#[derive(Clone, Debug, Default)]
pub(crate) struct NeighbourList {
    /// Layout of the model that the list was made for.
    layout: u64,
    /// By rank.
    circles: Vec<Circle>,
    /// In the order of their ranks.
    pairs: Vec<RankedPair>,
    bounds: Vec<Bounds>,
    /// The bodies by the southern ends of their circles.
    by_x: Vec<(f64, u32)>,
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

    /// Does this circle contain the same body's present circle?
    #[inline]
    fn holds(&self, center_m: Vec2, radius_m: f64) -> bool {
        let margin_m = USABLE * (self.radius_m - radius_m);
        margin_m >= 0.0 && (center_m - self.center_m).length_squared() <= margin_m * margin_m
    }
}

impl NeighbourList {
    /// The pairs of the list. They include all pairs that no `Pair` of the model names, that are not both fixed and whose
    /// circles of `reach_m` meet.
    pub(crate) fn pairs(&self) -> &[RankedPair] {
        &self.pairs
    }

    /// Bounds of these pairs, in the same order.
    pub(crate) fn bounds(&self) -> &[Bounds] {
        &self.bounds
    }

    /// Is the list still valid? Only active bodies can have moved.
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

    /// Sweep and prune, from south to north.
    fn sweep(&mut self, model: &Model, material: MaterialId) {
        let ends = (0..).zip(&self.circles);
        self.by_x.clear();
        self.by_x.extend(ends.map(|(rank, circle)| (circle.center_m.x - circle.radius_m, rank)));
        self.by_x.sort_unstable_by(|p, q| p.0.total_cmp(&q.0).then(p.1.cmp(&q.1)));
        self.pairs.clear();
        for (i, &(_, one)) in self.by_x.iter().enumerate() {
            let circle = self.circles[one as usize];
            let north_m = circle.center_m.x + circle.radius_m;
            for &(south_m, two) in &self.by_x[i + 1..] {
                if south_m > north_m {
                    break;
                }
                if circle.meets(&self.circles[two as usize]) {
                    let (a, b) = (one.min(two), one.max(two));
                    let [body_a, body_b] = [a, b].map(|rank| &model.ranked[rank as usize]);
                    let both_stand = body_a.stands && body_b.stands;
                    if !both_stand && !is_named(model, a, b) {
                        self.pairs.push(RankedPair::new((a, body_a), (b, body_b), material));
                    }
                }
            }
        }
        self.pairs.sort_unstable_by_key(|pair| (pair.a, pair.b));
        self.bounds.clear();
        self.bounds.extend(
            self.pairs.iter().map(|pair| Bounds::of(&model.ranked, model.materials(), pair)),
        );
    }
}

fn is_named(model: &Model, a: u32, b: u32) -> bool {
    model.pairs.binary_search_by_key(&(a, b), |p| (p.a, p.b)).is_ok()
}
