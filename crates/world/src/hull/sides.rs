//! The outlines that the fenders of a run meet, and the places of fenders that lean, renewed before each step.

use fenderline_contact::number::{bounded, greater};
use fenderline_contact::{
    BodyId, BodyState, Contact, FenderId, Memory, Model, RenewalBuffers, Slice, Vec2,
};

use super::cut::Posture;
use super::heights::{HeightWork, Heights};
use super::lean::Leaning;
use crate::fender::FenderSetup;
use crate::setup::Setup;
use crate::world::HullMotion;

/// Distance of a hull's bounding box from a fender beyond which the hull is not cut at the fender (m). Heel moves a
/// side of a hull by less than this distance.
const NEAR_M: f64 = 5.0;

/// How a fender meets a hull with outlines at several heights, in one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HullTouch {
    /// Height of the contact (m): above the keel of a floating body, above datum for a fixed body.
    pub height_m: f64,
    /// Tangent of the angle by which the hull's side leans out over the fender; positive for flare.
    pub slope: f64,
    /// Place of the contact on the upright hull, forward and to starboard of the centre of gravity (m).
    pub place_m: Vec2,
}

/// A fender that would have pressed on a hull if the hull had a side at the fender's height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SideMissed {
    /// Index of the fender in [`crate::setup::Setup::fenders`].
    pub fender: usize,
    /// Index of the hull's body in [`crate::setup::Setup::bodies`].
    pub body: usize,
    /// Start of the first step in which the fender missed the hull (s).
    pub first_s: f64,
    /// How far the middle of the fender's face was above the highest outline (m); a negative number says how far it was
    /// below the lowest outline.
    pub off_m: f64,
}

/// The part of a hull that a fender meets.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Met {
    /// No outline was cut for the fender yet.
    Unset,
    /// The hull has no side at the fender's height.
    NoSide,
    /// The fender meets the outline of the hull that was cut at the fender.
    Side(Posture),
}

/// A fender, and a hull that it may meet.
#[derive(Clone, Debug)]
struct Pair {
    fender: usize,
    body: usize,
    /// The vessel of the hull and the vessel of the fender, as indices in the set-up's vessels.
    vessel: Option<usize>,
    host_vessel: Option<usize>,
    met: Met,
    /// Height of the hull's centre of gravity above the keel (m).
    gravity_m: f64,
    /// Half of the hull's length and breadth (m).
    half_size_m: Vec2,
    missed: Option<SideMissed>,
}

/// The outline that a fender met before the step, kept so that it can be restored if the step fails.
#[derive(Clone, Debug)]
struct Undo {
    pair: usize,
    met: Met,
    before: Option<Slice>,
}

/// All pairs of a fender and a hull with outlines at several heights in a run.
#[derive(Clone, Debug, Default)]
pub struct Sides {
    pairs: Vec<Pair>,
    /// The lowest and the highest outline of the hull of each pair.
    ends: Vec<[Slice; 2]>,
    /// The energies that new outlines and the lean of fenders put into fenders in the present step.
    pub works: Vec<HeightWork>,
    /// For each contact of the last step, how its fender meets the hull; `None` for other contacts.
    pub touches: Vec<Option<HullTouch>>,
    undo: Vec<Undo>,
    leaning: Vec<Leaning>,
    /// The fenders whose lean changed in this step, as indices into `leaning`, and how far they leaned before (m).
    leaned: Vec<(usize, Vec2)>,
    buffers: RenewalBuffers,
}

impl Pair {
    /// Height of a fender above the keel of a hull, at the hull's centre of gravity (m); for a fixed body above datum.
    /// The function also returns heave, roll and pitch of the hull.
    fn height_m(
        &self,
        heights: &Heights<'_>,
        fender: &FenderSetup,
        setup: &Setup,
    ) -> (f64, HullMotion) {
        let hull = heights.motion(self.vessel);
        let mut above_water_m = heights.shore.fender_above_water_m(fender);
        if !fender.floating {
            above_water_m -= heights.motion(self.host_vessel).sinkage_m(fender.position_m);
        }
        if setup.bodies[self.body].is_fixed() {
            return (above_water_m + heights.shore.level_m, hull);
        }
        let draught_m = setup.bodies[self.body].hull.as_ref().map_or(0.0, |hull| hull.draught_m());
        (above_water_m + draught_m + hull.heave_m, hull)
    }
}

impl Sides {
    /// Makes all pairs of fenders and hulls as they are before the first step.
    pub fn new(setup: &Setup) -> Sides {
        let mut sides = Sides { leaning: Leaning::all(setup), ..Sides::default() };
        let vessel_of = |body: usize| setup.world.vessels.iter().position(|v| v.body == body);
        for (fender, of) in setup.fenders.iter().enumerate() {
            for (body, hull) in setup.bodies.iter().enumerate() {
                let Some(hull) = &hull.hull else { continue };
                if body == of.body || !setup.may_touch([body, of.body]) {
                    continue;
                }
                sides.pairs.push(Pair {
                    fender,
                    body,
                    vessel: vessel_of(body),
                    host_vessel: vessel_of(of.body),
                    met: Met::Unset,
                    half_size_m: hull.half_size_m(),
                    gravity_m: gravity_m(hull.draught_m(), vessel_of(body), setup),
                    missed: None,
                });
                sides.ends.push(hull.range_m().map(|end_m| hull.given(end_m)));
            }
        }
        sides
    }

    /// True if no body has outlines at several heights and no fender leans.
    pub fn is_empty(&self) -> bool {
        self.pairs.is_empty() && self.leaning.is_empty()
    }

    /// The fenders that would have pressed on a hull but found no side at their height.
    pub fn missed(&self) -> impl Iterator<Item = &SideMissed> {
        self.pairs.iter().filter_map(|pair| pair.missed.as_ref())
    }

    /// Moves the fenders that lean, and cuts the outlines, for the step that begins at `states`.
    pub fn renew(
        &mut self,
        setup: &Setup,
        (model, memory): (&mut Model, &mut Memory),
        states: &[BodyState],
        heights: &Heights<'_>,
    ) {
        self.works.clear();
        self.undo.clear();
        self.leaned.clear();
        let Sides { pairs, ends, works, undo, leaning, leaned, buffers, .. } = self;
        for (index, leaning) in leaning.iter_mut().enumerate() {
            let engine = (&mut *model, &mut *memory, &mut *buffers);
            if let Some(before_m) = leaning.renew(setup, engine, states, heights, works) {
                leaned.push((index, before_m));
            }
        }
        for (index, (pair, ends)) in pairs.iter_mut().zip(ends).enumerate() {
            let fender = &setup.fenders[pair.fender];
            let Some(hull) = &setup.bodies[pair.body].hull else { continue };
            let [host, own] = [fender.body, pair.body].map(|body| &states[body]);
            let off_m = host.pose().apply(fender.position_m) - own.position_m;
            let speeds_mps = host.velocity_mps.length() + own.velocity_mps.length();
            let place_m = own.pose().rotation.apply_inverse(off_m);
            let off_hull_m =
                greater(place_m.x.abs() - pair.half_size_m.x, place_m.y.abs() - pair.half_size_m.y);
            let reach_m = 3.0 * fender.projection_m + fender.width_m + NEAR_M;
            if off_hull_m > reach_m + 2.0 * heights.step_s * speeds_mps {
                continue;
            }
            let (height_m, motion) = pair.height_m(heights, fender, setup);
            let posture = Posture::new(height_m, motion.roll_rad, motion.pitch_rad);
            let [low_m, high_m] = hull.range_m();
            let at_m = posture.height_at_m(place_m);
            let off_side_m = at_m - bounded(at_m, low_m, high_m);
            let met = match off_side_m.abs() > 0.5 * fender.height_m {
                true => Met::NoSide,
                false => Met::Side(posture),
            };
            let ids = (FenderId(pair.fender as u32), BodyId(pair.body as u32));
            if met == Met::NoSide
                && pair.missed.is_none()
                && model.would_press(ids, states, &ends[usize::from(off_side_m > 0.0)])
            {
                let (fender, body, first_s) = (pair.fender, pair.body, heights.t_s);
                pair.missed = Some(SideMissed { fender, body, first_s, off_m: off_side_m });
            }
            if met == pair.met {
                continue;
            }
            let slice = match met {
                Met::Side(posture) => Some(hull.cut(posture, pair.gravity_m)),
                Met::NoSide | Met::Unset => None,
            };
            let renewal = model.renew_slice(memory, states, ids, slice, buffers);
            undo.push(Undo { pair: index, met: pair.met, before: renewal.before });
            pair.met = met;
            if renewal.work_j != 0.0 {
                let bodies = [fender.body.min(pair.body), fender.body.max(pair.body)];
                works.push(HeightWork { bodies, fender: pair.fender, work_j: renewal.work_j });
            }
        }
    }

    /// Restores the outlines and the places of fenders to those before a failed step.
    pub fn restore(&mut self, model: &mut Model) {
        for (index, before_m) in self.leaned.drain(..) {
            self.leaning[index].restore(model, before_m);
        }
        for Undo { pair, met, before } in self.undo.drain(..) {
            let pair = &mut self.pairs[pair];
            let ids = (FenderId(pair.fender as u32), BodyId(pair.body as u32));
            model.undo_renewal(ids, before);
            pair.met = met;
        }
    }

    /// Finds how each contact of a step meets a hull. `states` are the states of the bodies at the start of the step.
    pub fn find_touches(
        &mut self,
        setup: &Setup,
        model: &Model,
        states: &[BodyState],
        contacts: &[Contact],
    ) {
        if self.pairs.is_empty() {
            return;
        }
        let Sides { pairs, touches, .. } = self;
        touches.clear();
        touches.extend(contacts.iter().map(|contact| {
            let fender = contact.fender?;
            let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
            let of = |pair: &&Pair| pair.fender == fender.0 as usize && bodies.contains(&pair.body);
            let pair = pairs.iter().find(of)?;
            let Met::Side(posture) = pair.met else { return None };
            let range_m = setup.bodies[pair.body].hull.as_ref()?.range_m();
            let side = model.side_met_by(fender, BodyId(pair.body as u32), states);
            let (slope, at_m) = match side {
                Some(side) => (side.slope, side.place_m),
                None => (0.0, place_m(contact, pair.body, &states[pair.body])),
            };
            let (place_m, height_m) = posture.upright(at_m, pair.gravity_m, range_m);
            Some(HullTouch { height_m, slope, place_m })
        }));
    }
}

/// Height of a hull's centre of gravity above the keel (m). If a vessel has no stability data, the height of the
/// waterline is taken instead of the height of the centre of gravity.
fn gravity_m(draught_m: f64, vessel: Option<usize>, setup: &Setup) -> f64 {
    let float = vessel.and_then(|index| setup.world.vessels[index].float);
    float.map_or(draught_m, |float| float.gravity_above_water_m + draught_m)
}

/// The place of a contact in the frame of one of its bodies (m).
pub fn place_m(contact: &Contact, body: usize, state: &BodyState) -> Vec2 {
    let arm_m = if contact.body_1.0 as usize == body { contact.arm_1_m } else { contact.arm_2_m };
    state.pose().rotation.apply_inverse(arm_m)
}

/// The one of two vertical forces that is larger in size, up or down (N).
pub fn larger_force_n(one_n: f64, other_n: f64) -> f64 {
    if greater(other_n, -other_n) > greater(one_n, -one_n) { other_n } else { one_n }
}
