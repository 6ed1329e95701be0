//! The vertical walls that stand for the banks beside a vessel, from cross-sections of the bottom by place.

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{BodyState, Vec2, vec2};
use fenderline_ship::hydro::Particulars;

use super::environment::Bottom;

/// Strips of equal length along the ship, each with a cross-section to port and to starboard at its middle.
const STRIPS: u32 = 8;
/// Distance from the ship's axis, divided by her beam, at which the effect of a bank begins to fade, and from which on a
/// bank has none; our choice.
const REACH: [f64; 2] = [8.0, 10.0];
/// The fewest and the most soundings of a section, between which a section has one for each cell of the field.
const SOUNDINGS: [f64; 2] = [16.0, 128.0];

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
        (bottom, level_m, depth_m): (&Bottom, f64, f64),
    ) -> Walls {
        let mut walls = Walls::default();
        let [least_m, _] = bottom.range_m();
        if depth_m <= 0.0 || least_m + level_m >= depth_m {
            return walls; // nowhere shallower than under her
        }
        let pose = state.pose();
        let half_beam_m = 0.5 * hull.beam_m;
        let span_m = REACH[1] * hull.beam_m - half_beam_m;
        let soundings = bounded(span_m / bottom.field.cell_m(), SOUNDINGS[0], SOUNDINGS[1]) as u32; // in range
        let section = Section {
            bottom,
            level_m,
            depth_m,
            half_beam_m,
            step_m: span_m / f64::from(soundings),
            soundings,
        };
        for strip in 0..STRIPS {
            let share = (f64::from(strip) + 0.5) / f64::from(STRIPS) - 0.5;
            let axis_m = vec2(share * hull.length_m - hull.centre_of_gravity_m, 0.0);
            for (index, side) in [-1.0, 1.0].into_iter().enumerate() {
                let out = pose.rotation.apply(vec2(0.0, side));
                let [per_m, per_m2] = section.effects(pose.apply(axis_m), out, hull.beam_m);
                walls.per_m[index] += per_m / f64::from(STRIPS);
                walls.per_m2[index] += per_m2 / f64::from(STRIPS);
            }
        }
        walls
    }
}

/// How a side of a cross-section is sounded.
struct Section<'b> {
    bottom: &'b Bottom,
    /// Level of the water above datum (m).
    level_m: f64,
    /// Mean depth under the ship (m).
    depth_m: f64,
    /// Distance from the axis at which a section begins (m).
    half_beam_m: f64,
    /// Distance from sounding to sounding (m).
    step_m: f64,
    /// Steps from the ship's side to the end of the section.
    soundings: u32,
}

impl Section<'_> {
    /// Means of 1/y and 1/y² over the layers of one side of a section, which goes `out` (a unit vector) from a place on
    /// the axis. Between two soundings the share of the layers that have met the bottom is taken as linear.
    fn effects(&self, axis_m: Vec2, out: Vec2, beam_m: f64) -> [f64; 2] {
        let (mut blocked, mut effects) = (0.0, [0.0; 2]);
        for index in 0..=self.soundings {
            let off_m = self.half_beam_m + self.step_m * f64::from(index);
            let Some(below_datum_m) = self.bottom.depth_m(axis_m + out * off_m) else { continue };
            let shoal = bounded(1.0 - (below_datum_m + self.level_m) / self.depth_m, 0.0, 1.0);
            if shoal <= blocked {
                continue;
            }
            let wall_m = greater(off_m - 0.5 * self.step_m, self.half_beam_m);
            let off = lesser(greater(wall_m / beam_m, REACH[0]), REACH[1]);
            let fades = (REACH[1] - off) / (REACH[1] - REACH[0]);
            let effect = (shoal - blocked) * fades * fades * (3.0 - 2.0 * fades) / wall_m;
            effects[0] += effect;
            effects[1] += effect / wall_m;
            blocked = shoal;
            if blocked >= 1.0 {
                break;
            }
        }
        effects
    }
}
