//! The bodies in the order of their keys, in the form in which the stages of a step read them.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use core::ops::Index;

use crate::geometry::box_tree::BoxTree;
use crate::geometry::convex::ConvexPolygon;
use crate::geometry::extent::Extent;
use crate::geometry::shapes::{LEAST_WITH_TREE, Shapes};
use crate::maths::number::{greater, lesser};
use crate::model::body::{Body, Mobility};
use crate::model::fender::RankedFender;
use crate::model::kirchhoff::Kirchhoff;
use crate::model::mass::InverseMatrix;

/// The bodies by rank.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ranked {
    bodies: Vec<RankedBody>,
    /// For each body, the index of the first of its convex pieces and the index after the last. The ranges of pieces
    /// are stored apart from the other data, so that the narrow phase reads few lines of the processor's cache.
    piece_ranges: Vec<[u32; 2]>,
    rests: Vec<Rest>,
    /// The bounding boxes of the outlines, each in the axes of its body.
    boxes: Vec<Extent>,
    /// Area of the body with the smallest outline (m²).
    smallest_m2: f64,
    /// The convex pieces of all outlines. Bodies with equal outlines share the same convex pieces.
    pieces: Vec<ConvexPolygon>,
    /// Trees over the convex pieces of outlines that have many pieces.
    trees: Vec<BoxTree>,
}

/// The data of a body that the steps often read. The often-read data of a body fill one line of the processor's cache.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(crate) struct RankedBody {
    /// True if the body's mass is the same in all directions and in all sub-steps.
    pub(crate) is_alike: bool,
    /// True if the body stands on the ground: it is fixed, or on a pile.
    pub(crate) stands: bool,
    /// True if the outline is one of parts, which may surround the other body.
    pub(crate) is_of_parts: bool,
    /// Largest distance of a vertex of the outline from the body's centre of gravity (m).
    pub(crate) radius_m: f64,
    /// Largest distance of a point of the body or of its fenders from the body's centre of gravity (m).
    pub(crate) reach_m: f64,
    /// Inverse mass 1/m (1/kg); 0 for a fixed body.
    pub(crate) inverse_mass: f64,
    /// 1/I (1/(kg·m²)).
    pub(crate) inverse_inertia: f64,
    /// The largest inverse mass of the body in any direction, without rotation (1/kg).
    pub(crate) lightest_inverse_mass: f64,
    /// Inverse yaw inertia of the body, from the full mass matrix (1/(kg·m²)).
    pub(crate) inverse_of_turning: f64,
}

/// The data of a body that the steps seldom read.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rest {
    /// Inverse mass matrix M⁻¹ in the body's axes.
    pub(crate) inverse: InverseMatrix,
    pub(crate) area_m2: f64,
    /// About half of the body's width (m), computed from the area: the area of a convex body is about its length times
    /// its width.
    pub(crate) half_width_m: f64,
    /// Kirchhoff's equations for a body whose momentum the engine turns with the body; `None` for other bodies.
    pub(crate) kirchhoff: Option<Kirchhoff>,
    /// The index of the first of the body's fenders in `Model::faces`, and the index after the last.
    faces: (u32, u32),
    /// Index in `Ranked::trees`.
    tree: Option<u32>,
}

impl Ranked {
    /// Computes the data of these bodies, which are given in the order of their ranks. `fenders` must be sorted by the
    /// ranks of the bodies that carry them.
    pub(crate) fn new<'b>(
        bodies: impl Iterator<Item = &'b Body>,
        fenders: &[RankedFender],
    ) -> Ranked {
        let mut ranked = Ranked { smallest_m2: f64::INFINITY, ..Ranked::default() };
        let mut shared = BTreeMap::new();
        for (rank, body) in bodies.enumerate() {
            let from = fenders.partition_point(|face| (face.host as usize) < rank);
            let to = fenders.partition_point(|face| face.host as usize <= rank);
            let of_parts = body.outline.is_of_parts().then(|| body.outline.pieces().concat());
            let corners = of_parts.as_deref().unwrap_or(body.outline.vertices());
            let corners = corners.iter().map(|v| (v.x.to_bits(), v.y.to_bits()));
            let (pieces, tree) = *shared.entry(corners.collect::<Vec<_>>()).or_insert_with(|| {
                let first = ranked.pieces.len() as u32;
                ranked.pieces.extend(body.outline.pieces().iter().map(|p| ConvexPolygon::new(p)));
                let own = &ranked.pieces[first as usize..];
                let tree = (own.len() >= LEAST_WITH_TREE || of_parts.is_some()).then(|| {
                    ranked.trees.push(BoxTree::new(own));
                    ranked.trees.len() as u32 - 1
                });
                ([first, ranked.pieces.len() as u32], tree)
            });
            let reach_m = fenders[from..to].iter().map(RankedFender::reach_m).fold(0.0, greater);
            let (often, mut seldom) = describe(body, reach_m);
            (seldom.faces, seldom.tree) = ((from as u32, to as u32), tree);
            ranked.smallest_m2 = lesser(ranked.smallest_m2, seldom.area_m2);
            ranked.bodies.push(often);
            ranked.piece_ranges.push(pieces);
            ranked.rests.push(seldom);
            let (low_m, high_m) = body.outline.bounds();
            ranked.boxes.push(Extent { low_m, high_m });
        }
        ranked
    }

    /// Lets a body reach at least this far from its centre of gravity (m).
    pub(crate) fn widen(&mut self, rank: usize, radius_m: f64) {
        let body = &mut self.bodies[rank];
        body.radius_m = greater(body.radius_m, radius_m);
        body.reach_m = greater(body.reach_m, radius_m);
    }

    /// Number of bodies.
    #[inline]
    pub(crate) fn len(&self) -> usize {
        self.bodies.len()
    }

    /// The data of a body that the steps seldom read.
    #[inline]
    pub(crate) fn rest(&self, rank: usize) -> &Rest {
        &self.rests[rank]
    }

    /// The bounding box of a body's outline, in the axes of the body.
    #[inline]
    pub(crate) fn extent(&self, rank: usize) -> Extent {
        self.boxes[rank]
    }

    /// Area of the body with the smallest outline (m²); infinite if the model has no bodies.
    #[inline]
    pub(crate) fn smallest_m2(&self) -> f64 {
        self.smallest_m2
    }

    /// The convex pieces of a body's outline.
    #[inline]
    pub(crate) fn pieces(&self, rank: usize) -> &[ConvexPolygon] {
        let [from, to] = self.piece_ranges[rank];
        &self.pieces[from as usize..to as usize]
    }

    /// The convex pieces of a body's outline, with the tree over the pieces if the outline has a tree.
    #[inline]
    pub(crate) fn shapes(&self, rank: usize) -> Shapes<'_> {
        let tree = self.rests[rank].tree.map(|index| &self.trees[index as usize]);
        Shapes { pieces: self.pieces(rank), tree }
    }

    /// The outline of a body if it is a single convex piece, else `None`.
    #[inline(always)]
    pub(crate) fn convex(&self, rank: usize) -> Option<&ConvexPolygon> {
        match self.pieces(rank) {
            [only] => Some(only),
            _ => None,
        }
    }

    /// The fenders of a body, as a range (from, to) of `Model::faces`.
    #[inline]
    pub(crate) fn faces(&self, rank: usize) -> (u32, u32) {
        self.rests[rank].faces
    }
}

impl Index<usize> for Ranked {
    type Output = RankedBody;

    #[inline(always)]
    fn index(&self, rank: usize) -> &RankedBody {
        &self.bodies[rank]
    }
}

impl RankedBody {
    #[inline]
    pub(crate) fn is_fixed(&self) -> bool {
        self.inverse_mass == 0.0
    }
}

/// Computes the often-read and the seldom-read data of a body. `fenders_reach_m` is the largest distance of the body's
/// fenders from its centre of gravity (m).
fn describe(body: &Body, fenders_reach_m: f64) -> (RankedBody, Rest) {
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
        Mobility::OnPile { mass_kg, .. } => {
            (mass_kg, f64::INFINITY, Some(InverseMatrix::unturnable(1.0 / mass_kg)))
        }
        Mobility::FullMatrix { matrix } => {
            let lightest = lesser(matrix[0][0], matrix[1][1]);
            (lightest, matrix[2][2], InverseMatrix::of(&matrix))
        }
    };
    let inverse = inverse.expect("checked with the body");
    let (area_m2, radius_m) = (body.outline.area_m2(), body.outline.radius_m());
    let on_pile = matches!(body.mobility, Mobility::OnPile { .. });
    let often = RankedBody {
        is_alike: inverse.is_isotropic() && !on_pile,
        is_of_parts: body.outline.is_of_parts(),
        stands: on_pile || matches!(body.mobility, Mobility::Fixed),
        radius_m,
        reach_m: greater(radius_m, fenders_reach_m),
        inverse_mass: 1.0 / mass_kg,
        inverse_inertia: 1.0 / yaw_inertia_kgm2,
        lightest_inverse_mass: inverse.largest_inverse_mass(),
        inverse_of_turning: inverse.inverse_inertia(),
    };
    let half_width_m = body.outline.half_width_m();
    let kirchhoff = match body.mobility {
        Mobility::SurgeSway { surge_kg, sway_kg, yaw_inertia_kgm2 } => {
            Kirchhoff::new(surge_kg, sway_kg, yaw_inertia_kgm2)
        }
        _ => None,
    };
    (often, Rest { inverse, area_m2, half_width_m, kirchhoff, faces: (0, 0), tree: None })
}
