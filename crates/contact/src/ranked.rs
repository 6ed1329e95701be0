//! Bodies in the order of their keys, as the stages read them.
//!
//! Of many bodies most are of a few classes: harbour tugs, fenders of one type. What is the same of them to the bit
//! is kept once, so that a step over thousands reads a number each and little else.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use core::ops::Index;

use crate::coupled::turning::Turning;
use crate::fender::RankedFender;
use crate::geometry::convex::ConvexPolygon;
use crate::mass::InverseMatrix;
use crate::model::{Body, Mobility};
use crate::number::{greater, lesser};
use crate::outline::Outline;

/// No place of a piece.
const SEVERAL: u32 = u32::MAX;

/// The bodies by rank.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ranked {
    /// Number of each body's class.
    class_of: Vec<u32>,
    classes: Vec<RankedBody>,
    /// What else there is of each class.
    rests: Vec<Rest>,
    /// Of each body whose outline is convex its place in `pieces`; [`SEVERAL`] of the others.
    // By itself: the one thing that is asked of a body where two are clipped.
    only_piece: Vec<u32>,
    /// Whether each has the same mass in all axes.
    // By itself too: the one thing that is asked of a body as it moves.
    alike: Vec<bool>,
    /// Area of the smallest of them (m²).
    smallest_m2: f64,
    /// The convex pieces of all outlines, shape by shape.
    pieces: Vec<ConvexPolygon>,
    /// The pieces of each shape, from and to.
    shapes: Vec<(u32, u32)>,
    /// Each body's fenders, from and to, in `Model::faces`.
    faces: Vec<(u32, u32)>,
}

/// What steps read of a body: all of a class have it in common. One line of the processor's cache.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(crate) struct RankedBody {
    /// Number of its outline's shape.
    shape: u32,
    /// Whether it has the same mass in all axes.
    pub(crate) is_alike: bool,
    /// Largest distance of a vertex from the centre of gravity (m).
    pub(crate) radius_m: f64,
    /// The same with the body's fenders (m).
    pub(crate) reach_m: f64,
    pub(crate) area_m2: f64,
    /// 1/m (1/kg).
    pub(crate) inverse_mass: f64,
    /// 1/I (1/(kg·m²)).
    pub(crate) inverse_inertia: f64,
    /// The largest inverse mass in any direction, without rotation (1/kg).
    pub(crate) lightest_inverse_mass: f64,
    /// That in yaw, of the full matrix (1/(kg·m²)).
    pub(crate) inverse_of_turning: f64,
}

/// What steps seldom read of a body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rest {
    /// M⁻¹ in the body's axes.
    pub(crate) inverse: InverseMatrix,
    /// About half of its width: a convex body's area is about its length times its width (m).
    pub(crate) half_width_m: f64,
    /// Masses in surge, sway and yaw of a body whose momentum the engine turns with it.
    pub(crate) turns: Option<Turning>,
}

impl Ranked {
    /// Of these bodies, whose fenders are in the order of their ranks.
    pub(crate) fn new<'b>(
        bodies: impl Iterator<Item = &'b Body>,
        fenders: &[RankedFender],
    ) -> Ranked {
        let (mut shapes, mut classes) = (BTreeMap::new(), BTreeMap::new());
        let mut ranked = Ranked { smallest_m2: f64::INFINITY, ..Ranked::default() };
        for (rank, body) in bodies.enumerate() {
            let from = fenders.partition_point(|face| (face.host as usize) < rank);
            let to = fenders.partition_point(|face| face.host as usize <= rank);
            ranked.faces.push((from as u32, to as u32));
            let reach_m = fenders[from..to].iter().map(RankedFender::reach_m).fold(0.0, greater);
            let (next_shape, next_class) =
                (ranked.shapes.len() as u32, ranked.classes.len() as u32);
            let shape = *shapes.entry(bits_of_pieces(&body.outline)).or_insert(next_shape);
            if shape == next_shape {
                ranked.push_shape(&body.outline);
            }
            let (class, rest) = describe(body, shape, reach_m);
            let number = *classes.entry(bits(&class, &rest)).or_insert(next_class);
            if number == next_class {
                ranked.classes.push(class);
                ranked.rests.push(rest);
            }
            ranked.class_of.push(number);
            ranked.smallest_m2 = lesser(ranked.smallest_m2, class.area_m2);
            ranked.alike.push(class.is_alike);
            let (first, end) = ranked.shapes[shape as usize];
            ranked.only_piece.push(if end - first == 1 { first } else { SEVERAL });
        }
        ranked
    }

    /// Adds the pieces of an outline.
    fn push_shape(&mut self, outline: &Outline) {
        let first = self.pieces.len() as u32;
        self.pieces.extend(outline.pieces().iter().map(|piece| ConvexPolygon::new(piece)));
        self.shapes.push((first, self.pieces.len() as u32));
    }

    /// Number of bodies.
    #[inline]
    pub(crate) fn len(&self) -> usize {
        self.class_of.len()
    }

    /// For stages that read many: as many as there are bodies, so that ranks are checked once.
    #[inline(always)]
    pub(crate) fn bodies(&self) -> Bodies<'_> {
        Bodies { class_of: &self.class_of, classes: &self.classes }
    }

    /// What steps seldom read of a body.
    #[inline]
    pub(crate) fn rest(&self, rank: usize) -> &Rest {
        &self.rests[self.class_of[rank] as usize]
    }

    /// Area of the smallest body (m²); infinite where there is none.
    #[inline]
    pub(crate) fn smallest_m2(&self) -> f64 {
        self.smallest_m2
    }

    /// Whether each body has the same mass in all axes, by rank.
    #[inline]
    pub(crate) fn alike(&self) -> &[bool] {
        &self.alike
    }

    /// For a stage that clips many.
    #[inline(always)]
    pub(crate) fn convex(&self) -> Convex<'_> {
        Convex { only_piece: &self.only_piece, pieces: &self.pieces }
    }

    /// The convex pieces of a body's outline.
    pub(crate) fn pieces(&self, rank: usize) -> &[ConvexPolygon] {
        let (from, to) = self.shapes[self[rank].shape as usize];
        &self.pieces[from as usize..to as usize]
    }

    /// Its fenders, from and to, in `Model::faces`.
    #[inline]
    pub(crate) fn faces(&self, rank: usize) -> (u32, u32) {
        self.faces[rank]
    }
}

impl Index<usize> for Ranked {
    type Output = RankedBody;

    #[inline(always)]
    fn index(&self, rank: usize) -> &RankedBody {
        &self.classes[self.class_of[rank] as usize]
    }
}

/// See [`Ranked::bodies`].
#[derive(Clone, Copy)]
pub(crate) struct Bodies<'m> {
    class_of: &'m [u32],
    classes: &'m [RankedBody],
}

impl<'m> Bodies<'m> {
    /// Number of bodies.
    #[inline(always)]
    pub(crate) fn len(&self) -> usize {
        self.class_of.len()
    }

    /// The body of a rank.
    #[inline(always)]
    pub(crate) fn of(&self, rank: usize) -> &'m RankedBody {
        &self.classes[self.class_of[rank] as usize]
    }
}

/// See [`Ranked::convex`].
#[derive(Clone, Copy)]
pub(crate) struct Convex<'m> {
    only_piece: &'m [u32],
    pieces: &'m [ConvexPolygon],
}

impl<'m> Convex<'m> {
    /// Number of bodies.
    #[inline(always)]
    pub(crate) fn len(&self) -> usize {
        self.only_piece.len()
    }

    /// The outline of a body that is convex.
    #[inline(always)]
    pub(crate) fn of(&self, rank: usize) -> Option<&'m ConvexPolygon> {
        self.pieces.get(self.only_piece[rank] as usize)
    }
}

impl RankedBody {
    #[inline]
    pub(crate) fn is_fixed(&self) -> bool {
        self.inverse_mass == 0.0
    }
}

/// What tells one shape from another: the corners of its pieces.
fn bits_of_pieces(outline: &Outline) -> Vec<u64> {
    let mut bits = Vec::new();
    for piece in outline.pieces() {
        bits.push(piece.len() as u64);
        bits.extend(piece.iter().flat_map(|v| [v.x.to_bits(), v.y.to_bits()]));
    }
    bits
}

/// What is known of a body of this shape, whose fenders reach so far.
fn describe(body: &Body, shape: u32, fenders_reach_m: f64) -> (RankedBody, Rest) {
    let (mass_kg, yaw_inertia_kgm2, inverse) = match body.mobility {
        Mobility::Fixed => (f64::INFINITY, f64::INFINITY, Some(InverseMatrix::default())),
        Mobility::Free { mass_kg, yaw_inertia_kgm2 } => {
            let inverse = InverseMatrix::isotropic(mass_kg, yaw_inertia_kgm2);
            (mass_kg, yaw_inertia_kgm2, Some(inverse))
        }
        Mobility::SurgeSway { surge_kg, sway_kg, yaw_inertia_kgm2 } => {
            let matrix = body.mobility.matrix().expect("it floats");
            (lesser(surge_kg, sway_kg), yaw_inertia_kgm2, InverseMatrix::of(&matrix))
        }
        Mobility::FullMatrix { matrix } => {
            let lightest = lesser(matrix[0][0], matrix[1][1]);
            (lightest, matrix[2][2], InverseMatrix::of(&matrix))
        }
    };
    let inverse = inverse.expect("checked with the body");
    let (area_m2, radius_m) = (body.outline.area_m2(), body.outline.radius_m());
    let class = RankedBody {
        shape,
        is_alike: inverse.is_isotropic(),
        radius_m,
        reach_m: greater(radius_m, fenders_reach_m),
        area_m2,
        inverse_mass: 1.0 / mass_kg,
        inverse_inertia: 1.0 / yaw_inertia_kgm2,
        lightest_inverse_mass: inverse.lightest(),
        inverse_of_turning: inverse.of_turning(),
    };
    let half_width_m = 0.25 * area_m2 / radius_m;
    (class, Rest { inverse, half_width_m, turns: Turning::of(&body.mobility) })
}

/// What tells one class from another: all else follows from it.
type ClassBits = (u32, [u64; 5], [u64; 6], Option<[u64; 3]>);

fn bits(class: &RankedBody, rest: &Rest) -> ClassBits {
    let RankedBody { radius_m, reach_m, area_m2, inverse_mass, inverse_inertia, .. } = *class;
    let numbers = [radius_m, reach_m, area_m2, inverse_mass, inverse_inertia].map(f64::to_bits);
    (class.shape, numbers, rest.inverse.to_bits(), rest.turns.map(|turns| turns.to_bits()))
}

#[cfg(test)]
mod tests {
    use alloc::format;

    use super::*;
    use crate::vec2::vec2;

    fn body(key: u64, length_m: f64, mobility: Mobility) -> Body {
        let corners = [(0.0, 0.0), (length_m, 0.0), (length_m, 4.0), (0.0, 4.0)];
        let (outline, _) = Outline::new(&corners.map(|(x, y)| vec2(x, y))).expect("a box");
        Body { name: format!("{key}"), key, outline, mobility }
    }

    #[test]
    fn bodies_of_one_shape_share_its_pieces_and_those_of_one_class_all_else() {
        let tug = Mobility::Free { mass_kg: 1e6, yaw_inertia_kgm2: 6e7 };
        let laden = Mobility::Free { mass_kg: 2e6, yaw_inertia_kgm2: 6e7 };
        let bodies = [
            body(1, 30.0, tug),
            body(2, 2.0, Mobility::Fixed),
            body(3, 30.0, tug),
            body(4, 30.0, laden),
            body(5, 2.0, Mobility::Fixed),
        ];
        let ranked = Ranked::new(bodies.iter(), &[]);
        assert_eq!((ranked.pieces.len(), ranked.shapes.len()), (2, 2));
        assert_eq!(ranked.class_of, [0, 1, 0, 2, 1]);
        assert_eq!(ranked.only_piece, [0, 1, 0, 0, 1]);
        assert_eq!((ranked[3].inverse_mass, ranked[3].area_m2), (0.5e-6, 120.0));
        assert!(core::ptr::eq(ranked.pieces(0), ranked.pieces(3)));
        assert_eq!(size_of::<RankedBody>(), 64);
    }
}
