//! Fenders: faces on a body with a law of their own.

use alloc::string::String;
use alloc::vec::Vec;

use crate::error::ModelError;
use crate::geometry::convex::ConvexPolygon;
use crate::model::{BodyId, Material, MaterialId};
use crate::number::{bounded, greater};
use crate::unloading::Unloading;
use crate::vec2::{Rotation, Vec2, vec2};

/// Index of a fender, in the order in which fenders were added.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FenderId(pub u32);

/// A fender on a quay, on a tug's bow or along a ship's belting.
///
/// It touches the outlines of the bodies that its own body makes a pair with; that pair's material is
/// the solid structure behind it. Friction, restitution and damping are its own material's.
///
/// Its force is the gradient of the energy that it stores (see [`FenderLaw`]), so that a frictionless
/// closed loop does no work, whatever its path: it points along the face's axis where a corner presses
/// on the face, and square to the hull where a flat side covers the whole face. With an [`Unloading`] law it is the
/// gradient of the energy that the fender can give back, and a closed loop costs what the law says.
#[derive(Clone, Debug, PartialEq)]
pub struct Fender {
    /// Name, used in errors.
    pub name: String,
    /// Fixes the order of all sums among the fenders of one body; unique on that body.
    pub key: u64,
    /// The body that carries it.
    pub body: BodyId,
    /// Middle of the line where it is mounted, in the body's frame (m).
    pub position_m: Vec2,
    /// Direction in which it faces, in the body's frame: 0 forward, positive to starboard (rad).
    pub facing_rad: f64,
    /// Width of the face (m).
    pub width_m: f64,
    /// From the mounting to the face, uncompressed (m).
    pub projection_m: f64,
    /// Reaction from deflection.
    pub law: FenderLaw,
    /// How its reaction falls when the hull retreats, by the coupled method. Its material's restitution does nothing
    /// then. `None`: by restitution alone.
    pub unloading: Option<Unloading>,
    /// Friction, restitution, damping and, for [`FenderLaw::Area`], stiffness.
    pub material: MaterialId,
    /// The deflection that it is made for (m): beyond it an event is told; compression times are
    /// counted from it.
    pub rated_deflection_m: f64,
    /// Where it stiffens to a stop; `None` for a law that stiffens by itself.
    pub stop: Option<Stop>,
    /// Corrections of its reaction.
    pub factors: ReactionFactors,
}

/// Reaction R from deflection δ.
#[derive(Clone, Debug, PartialEq)]
pub enum FenderLaw {
    /// The paper's: N = k S with the material's k, an elastic foundation. Stored: ½ k ∫ d² ds, with d(s)
    /// the depth of the hull behind the face; δ is the largest d.
    Area,
    /// Points (δ (m), R (N)), from (0, 0) on, with straight lines between them. Beyond the last point the
    /// last line goes on where it rises; where it falls the reaction stays.
    /// δ is the mean of d(s) over the width of the face, which is the deflection of the fender's axis
    /// where a flat side covers the face. Stored: ∫ R dδ.
    Curve(Vec<[f64; 2]>),
}

/// The end of a fender's travel: from `from_m` on a further spring acts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// Deflection at which it begins (m).
    pub from_m: f64,
    /// Stiffness (N/m).
    pub stiffness_npm: f64,
}

/// Corrections of a fender's reaction, all multiplied. Those by speed and angle are taken when a contact
/// begins and kept until it ends, as a berthing has *one* speed and *one* angle; a factor that changed
/// under load would make or destroy stored energy.
#[derive(Clone, Debug, PartialEq)]
pub struct ReactionFactors {
    /// Temperature, manufacturing tolerance and whatever else does not change in a run.
    pub constant: f64,
    /// Points (compression time (s), factor) with the time rising; straight lines between them, the
    /// ends held. The time is δ_rated/(0.74 V) for the speed of approach V. Empty: 1.
    pub by_compression_time: Vec<[f64; 2]>,
    /// Points (angle between face and hull (rad), factor), the same way. Empty: 1.
    pub by_angle: Vec<[f64; 2]>,
}

impl Default for ReactionFactors {
    fn default() -> ReactionFactors {
        ReactionFactors { constant: 1.0, by_compression_time: Vec::new(), by_angle: Vec::new() }
    }
}

impl FenderLaw {
    /// R = k δ.
    #[must_use]
    pub fn linear(stiffness_npm: f64) -> FenderLaw {
        FenderLaw::Curve(alloc::vec![[0.0, 0.0], [1.0, stiffness_npm]])
    }

    /// R at a deflection, without factors and stop (N); 0 for [`FenderLaw::Area`], whose force is not
    /// one of δ alone.
    #[must_use]
    pub fn reaction_n(&self, deflection_m: f64) -> f64 {
        match self {
            FenderLaw::Area => 0.0,
            FenderLaw::Curve(points) => on_line(points, deflection_m),
        }
    }

    /// ∫ R dδ up to a deflection, without factors and stop (J).
    #[must_use]
    pub fn energy_j(&self, deflection_m: f64) -> f64 {
        let FenderLaw::Curve(points) = self else { return 0.0 };
        integral(points, deflection_m)
    }

    /// The steepest rise of R up to a deflection (N/m).
    pub(crate) fn steepest_npm(&self, up_to_m: f64) -> f64 {
        let FenderLaw::Curve(points) = self else { return 0.0 };
        points
            .windows(2)
            .take_while(|two| two[0][0] <= up_to_m)
            .map(|two| (two[1][1] - two[0][1]) / (two[1][0] - two[0][0]))
            .fold(0.0, greater)
    }
}

impl ReactionFactors {
    /// The factor by angle alone (rad).
    #[must_use]
    pub fn of_angle(&self, angle_rad: f64) -> f64 {
        held(&self.by_angle, angle_rad)
    }

    /// The factor of a contact that begins at a speed (m/s) and an angle (rad).
    pub(crate) fn at(&self, speed_mps: f64, angle_rad: f64, rated_deflection_m: f64) -> f64 {
        // Velocity factors are tabulated by the time at 0.74 of the speed of first touch, as a public calculator for cone
        // fenders has it.
        let time_s = rated_deflection_m / (0.74 * greater(speed_mps, 1e-9));
        self.constant * held(&self.by_compression_time, time_s) * self.of_angle(angle_rad)
    }
}

impl ReactionFactors {
    fn largest(&self) -> f64 {
        let of = |points: &[[f64; 2]]| match points {
            [] => 1.0,
            points => points.iter().map(|p| p[1]).fold(0.0, greater),
        };
        self.constant * of(&self.by_compression_time) * of(&self.by_angle)
    }
}

/// The integral of [`on_line`] from the first point on.
pub(crate) fn integral(points: &[[f64; 2]], x: f64) -> f64 {
    let mut sum = 0.0;
    for two in points.windows(2) {
        let [[from, low], [to, high]] = [two[0], two[1]];
        if x <= to {
            return sum + 0.5 * (low + on_line(points, x)) * (x - from);
        }
        sum += 0.5 * (low + high) * (to - from);
    }
    let [end, last] = points[points.len() - 1];
    sum + 0.5 * (last + on_line(points, x)) * (x - end)
}

/// Straight lines between points; the last one goes on where it rises.
pub(crate) fn on_line(points: &[[f64; 2]], x: f64) -> f64 {
    let index = points[1..points.len() - 1].iter().take_while(|p| p[0] < x).count();
    let [[x0, y0], [x1, y1]] = [points[index], points[index + 1]];
    if x > x1 && y1 < y0 {
        return y1;
    }
    y0 + (y1 - y0) * ((x - x0) / (x1 - x0))
}

/// Straight lines between points; the ends held; 1 where there are none.
fn held(points: &[[f64; 2]], x: f64) -> f64 {
    match points {
        [] => 1.0,
        [only] => only[1],
        [first, .., last] => on_line(points, bounded(x, first[0], last[0])),
    }
}

/// What the inner stages need of a fender.
#[derive(Clone, Debug)]
pub(crate) struct RankedFender {
    pub(crate) id: FenderId,
    /// Rank of the body that carries it.
    pub(crate) host: u32,
    pub(crate) key: u64,
    pub(crate) material: MaterialId,
    /// Where columns of the hull may be: from the face inwards, to twice the projection.
    pub(crate) zone: ConvexPolygon,
    /// Middle of the face, and the direction from it to the mounting, in the body's frame.
    pub(crate) face_m: Vec2,
    pub(crate) inward: Vec2,
    pub(crate) width_m: f64,
    /// The largest that its factors can be together.
    pub(crate) largest_factor: f64,
    pub(crate) bounds: FenderBounds,
    /// Has it an unloading law?
    pub(crate) unloads: bool,
}

/// Bounds on what a fender does to any hull, which tell in most steps that it needs no sub-steps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FenderBounds {
    /// The steepest rise of its reaction, with the largest of its factors, but for the stop (N/m).
    pub(crate) spring_npm: f64,
    /// Deflection at which the stop begins; infinite where there is none (m).
    pub(crate) stop_from_m: f64,
    /// Of its damper (N·s/m).
    pub(crate) damping_nspm: f64,
    pub(crate) projection_m: f64,
    /// From its host's centre of gravity to the middle of its face, and from there to the corners of its zone (m).
    pub(crate) arm_m: f64,
    pub(crate) spread_m: f64,
}

impl FenderBounds {
    fn of(fender: &Fender, material: &Material, zone: &[Vec2; 4], face_m: Vec2) -> FenderBounds {
        let steepest_npm = match fender.law {
            FenderLaw::Area => material.stiffness_npm2 * fender.width_m,
            FenderLaw::Curve(_) => fender.law.steepest_npm(f64::INFINITY),
        };
        FenderBounds {
            spring_npm: steepest_npm * fender.factors.largest(),
            stop_from_m: fender.stop.map_or(f64::INFINITY, |stop| stop.from_m),
            damping_nspm: material.damping_nspm2 * fender.width_m,
            projection_m: fender.projection_m,
            arm_m: face_m.length(),
            spread_m: zone.iter().fold(0.0, |spread, &v| greater(spread, (v - face_m).length())),
        }
    }
}

impl RankedFender {
    pub(crate) fn new(
        id: FenderId,
        host: u32,
        fender: &Fender,
        material: &Material,
    ) -> RankedFender {
        let Rotation { cos, sin } = Rotation::from_angle(fender.facing_rad);
        let inward = -vec2(cos, sin);
        let along = inward.quarter_turn();
        let face_m = fender.position_m - inward * fender.projection_m;
        let half_m = along * (0.5 * fender.width_m);
        let behind_m = face_m + inward * (2.0 * fender.projection_m);
        let corners = [face_m - half_m, behind_m - half_m, behind_m + half_m, face_m + half_m];
        RankedFender {
            id,
            host,
            key: fender.key,
            material: fender.material,
            zone: ConvexPolygon::new(&corners),
            face_m,
            inward,
            width_m: fender.width_m,
            largest_factor: fender.factors.largest(),
            bounds: FenderBounds::of(fender, material, &corners, face_m),
            unloads: fender.unloading.is_some(),
        }
    }

    /// The farthest that its face reaches from the body's centre of gravity (m).
    pub(crate) fn reach_m(&self) -> f64 {
        self.zone.vertices().iter().fold(0.0, |reach, v| greater(reach, v.length()))
    }
}

/// Checks what does not depend on the rest of the model.
pub(crate) fn check(fender: &Fender) -> Result<(), ModelError> {
    let bad = |field, value, must| {
        Err(ModelError::OutOfRange { owner: fender.name.clone(), field, value, must })
    };
    let size = |value: f64| (1e-6..=1e6).contains(&value);
    let place = |value: f64| value.abs() <= 1e8;
    for (field, value) in [
        ("width", fender.width_m),
        ("projection", fender.projection_m),
        ("rated deflection", fender.rated_deflection_m),
    ] {
        if !size(value) {
            return bad(field, value, "between 1e-6 and 1e6 m");
        }
    }
    for (field, value) in [
        ("position", fender.position_m.x),
        ("position", fender.position_m.y),
        ("facing", fender.facing_rad),
    ] {
        if !place(value) {
            return bad(field, value, "between -1e8 and 1e8");
        }
    }
    if let Some(stop) = fender.stop {
        if !size(stop.from_m) {
            return bad("stop", stop.from_m, "between 1e-6 and 1e6 m");
        }
        if !(0.0..=1e15).contains(&stop.stiffness_npm) {
            return bad("stiffness of the stop", stop.stiffness_npm, "between 0 and 1e15");
        }
    }
    if let FenderLaw::Curve(points) = &fender.law {
        if points.len() < 2 || points[0] != [0.0, 0.0] {
            let first = points.first().map_or(f64::NAN, |p| p[0]);
            return bad("curve", first, "two points or more, the first (0, 0)");
        }
        check_points(fender, "deflection of the curve", points, 0.0..=1e15)?;
    }
    let factors = &fender.factors;
    if !(1e-3..=1e3).contains(&factors.constant) {
        return bad("factor", factors.constant, "between 1e-3 and 1e3");
    }
    fender.unloading.as_ref().map_or(Ok(()), |unloading| unloading.check(fender))?;
    check_points(fender, "compression time", &factors.by_compression_time, 1e-3..=1e3)?;
    check_points(fender, "angle of a factor", &factors.by_angle, 1e-3..=1e3)
}

/// Abscissae that rise and ordinates within bounds.
pub(crate) fn check_points(
    fender: &Fender,
    field: &'static str,
    points: &[[f64; 2]],
    bounds: core::ops::RangeInclusive<f64>,
) -> Result<(), ModelError> {
    let owner = || fender.name.clone();
    for &[x, y] in points {
        if !(0.0..=1e9).contains(&x) {
            let must = "between 0 and 1e9";
            return Err(ModelError::OutOfRange { owner: owner(), field, value: x, must });
        }
        if !bounds.contains(&y) {
            let must = "within its bounds: reactions 0 to 1e15, factors 1e-3 to 1e3";
            return Err(ModelError::OutOfRange { owner: owner(), field, value: y, must });
        }
    }
    match points.windows(2).find(|two| two[1][0] <= two[0][0]) {
        None => Ok(()),
        Some(two) => {
            let (value, must) = (two[1][0], "larger than the one before it");
            Err(ModelError::OutOfRange { owner: owner(), field, value, must })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    #[test]
    fn reaction_and_energy_follow_the_points_and_the_last_line_goes_on() {
        let law = FenderLaw::Curve(vec![[0.0, 0.0], [1.0, 10.0], [2.0, 8.0], [3.0, 12.0]]);
        for (deflection_m, reaction_n, energy_j) in [
            (0.0, 0.0, 0.0),
            (0.5, 5.0, 1.25),
            (1.5, 9.0, 9.75),
            (3.0, 12.0, 24.0),
            (4.0, 16.0, 38.0),
        ] {
            assert_eq!(law.reaction_n(deflection_m), reaction_n);
            assert_eq!(law.energy_j(deflection_m), energy_j);
        }
        assert_eq!(law.steepest_npm(0.5), 10.0);
        assert_eq!(FenderLaw::linear(7.0).reaction_n(3.0), 21.0);
        let buckled = FenderLaw::Curve(vec![[0.0, 0.0], [1.0, 10.0], [2.0, 8.0]]);
        assert_eq!((buckled.reaction_n(3.0), buckled.energy_j(3.0)), (8.0, 22.0));
    }

    #[test]
    fn factors_are_taken_at_the_compression_time_and_held_beyond_their_ends() {
        let factors = ReactionFactors {
            constant: 1.1,
            by_compression_time: vec![[1.0, 1.2], [3.0, 1.0]],
            by_angle: vec![[0.0, 1.0], [0.2, 0.8]],
        };
        // t = 0.74/(0.74·0.5) = 2 s.
        assert!((factors.at(0.5, 0.1, 0.74) - 1.1 * 1.1 * 0.9).abs() < 1e-12);
        assert!((factors.at(0.0, 9.0, 0.74) - 1.1 * 0.8).abs() < 1e-12);
    }
}
