//! The vertical walls that stand for the banks beside a vessel, from cross-sections of the bottom by place.

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{BodyState, Vec2, vec2};
use fenderline_ship::hydro::Particulars;

use super::environment::Bottom;

/// Strips of equal length along the ship, each with a cross-section to port and to starboard at its middle.
const STRIPS: u32 = 6;
/// Distance from the ship's axis, divided by her beam, at which the effect of a bank begins to fade, and from which on a
/// bank has none; our choice.
const REACH: [f64; 2] = [8.0, 10.0];
/// A step of a section over its distance from the axis: as long as a cell of the field, so that a breakwater of a cell's width
/// is not passed over, but within these limits.
const STEP: [f64; 2] = [0.02, 0.064];
/// A step is cut in half, at most so many times, while more than [`FINE`] of the layers meet the bottom in the step. So a
/// steep bank is placed to 0.1 % of its distance: in a channel the forces of two banks are nearly equal, and the
/// difference counts.
const HALVINGS: u32 = 5;
const FINE: f64 = 0.02;

/// The walls beside a vessel, to port and to starboard.
///
/// The water beside the ship is cut into thin level layers, from the surface down to the mean depth under her. In each
/// layer the nearest place at which the bottom stands above the layer is a vertical wall; behind the first such place a
/// layer has no water. A wall's effect goes as 1/y or as 1/y² with its distance y from her axis, by the method that computes
/// the force. The wall that stands for a section has the mean effect of the section's layers, and the wall that stands for
/// a side has the mean effect of the side's sections. So a vertical bank stands for itself, a submerged bank is a wall
/// farther off, water that is deeper than under her has no effect, and a level bottom gives no wall. This is our own
/// assumption, without a source: no whole set of published formulas for banks of any shape was found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Walls {
    /// One over the distance of each wall from the ship's axis, from the mean of 1/y (1/m), for Norrbin's formulas, whose
    /// force goes as 1/y; 0: no wall.
    pub per_m: [f64; 2],
    /// One over the square of each distance, from the mean of 1/y² (1/m²), for the flow of an image, whose force goes
    /// about so in shallow water; 0: no wall.
    pub per_m2: [f64; 2],
}

impl Walls {
    /// The walls beside a vessel at a level of the water above datum (m), with the mean depth under her (m).
    ///
    /// A place without data is as deep as the last place with data nearer to her.
    #[must_use]
    pub fn beside(
        hull: &Particulars,
        state: &BodyState,
        bottom: &Bottom,
        level_m: f64,
        depth_m: f64,
    ) -> Walls {
        let mut walls = Walls::default();
        let [least_m, _] = bottom.range_m();
        if depth_m <= 0.0 || least_m + level_m >= depth_m {
            return walls; // nowhere shallower than under her
        }
        let pose = state.pose();
        let section = Section { bottom, level_m, depth_m, half_beam_m: 0.5 * hull.beam_m };
        for strip in 0..STRIPS {
            let share = (f64::from(strip) + 0.5) / f64::from(STRIPS) - 0.5;
            let axis_m = vec2(share * hull.length_m - hull.centre_of_gravity_m, 0.0);
            for (index, side) in [-1.0, 1.0].into_iter().enumerate() {
                let out = pose.rotation.apply(vec2(0.0, side));
                let [per_m, per_m2] = section.effects(pose.apply(axis_m), out);
                walls.per_m[index] += per_m / f64::from(STRIPS);
                walls.per_m2[index] += per_m2 / f64::from(STRIPS);
            }
        }
        walls
    }
}

/// What holds for all cross-sections of a step.
struct Section<'b> {
    bottom: &'b Bottom,
    /// Level of the water above datum (m).
    level_m: f64,
    /// Mean depth under the ship (m).
    depth_m: f64,
    /// Distance from the axis at which a section begins (m).
    half_beam_m: f64,
}

impl Section<'_> {
    /// Means of 1/y and 1/y² over the layers of one side of a section, which goes `out` (a unit vector) from a place on
    /// the axis.
    fn effects(&self, axis_m: Vec2, out: Vec2) -> [f64; 2] {
        let mut ray = Ray { section: self, axis_m, out, blocked: 0.0, effects: [0.0; 2] };
        let cell_m = self.bottom.field.cell_m();
        let (mut last_m, mut next_m) = (self.half_beam_m, self.half_beam_m);
        while ray.blocked < 1.0 && last_m < 2.0 * REACH[1] * self.half_beam_m {
            let shoal = ray.shoal(next_m);
            ray.go([last_m, next_m], shoal, 0);
            let step_m = bounded(cell_m, STEP[0] * next_m, STEP[1] * next_m);
            (last_m, next_m) = (next_m, next_m + step_m);
        }
        ray.effects
    }
}

/// One side of a section, as far as it was looked at.
struct Ray<'s> {
    section: &'s Section<'s>,
    axis_m: Vec2,
    out: Vec2,
    /// Share of the layers that have met the bottom.
    blocked: f64,
    /// Sums of 1/y and 1/y² over these layers.
    effects: [f64; 2],
}

impl Ray<'_> {
    /// Share of the layers that the bottom stands above, at a distance from the axis; 0 without data.
    fn shoal(&self, off_m: f64) -> f64 {
        let Section { bottom, level_m, depth_m, .. } = self.section;
        bottom.depth_m(self.axis_m + self.out * off_m).map_or(0.0, |below_datum_m| {
            bounded(1.0 - (below_datum_m + level_m) / depth_m, 0.0, 1.0)
        })
    }

    /// Goes on between two distances; at the second the bottom stands above a share of the layers.
    fn go(&mut self, [from_m, to_m]: [f64; 2], shoal: f64, halvings: u32) {
        if shoal <= self.blocked {
            return;
        }
        let wall_m = 0.5 * (from_m + to_m);
        if shoal - self.blocked > FINE && halvings < HALVINGS && from_m < to_m {
            let half_way = self.shoal(wall_m);
            self.go([from_m, wall_m], half_way, halvings + 1);
            return self.go([wall_m, to_m], shoal, halvings + 1);
        }
        let beam_m = 2.0 * self.section.half_beam_m;
        let off = lesser(greater(wall_m / beam_m, REACH[0]), REACH[1]);
        let fades = (REACH[1] - off) / (REACH[1] - REACH[0]);
        let effect = (shoal - self.blocked) * fades * fades * (3.0 - 2.0 * fades) / wall_m;
        self.effects[0] += effect;
        self.effects[1] += effect / wall_m;
        self.blocked = shoal;
    }
}
