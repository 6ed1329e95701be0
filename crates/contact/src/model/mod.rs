//! The constant part of a contact problem: the bodies, materials and fenders, and the pairs of bodies that may touch.

pub(crate) mod body;
pub(crate) mod fender;
pub(crate) mod kirchhoff;
pub(crate) mod lean;
pub(crate) mod mass;
pub(crate) mod material;
pub mod outline;
pub(crate) mod pair;
pub(crate) mod pile;
pub(crate) mod ranked;
pub(crate) mod ranked_pile;
pub(crate) mod reaction;
pub(crate) mod renew;
pub(crate) mod slice;
pub(crate) mod unloading;

use alloc::vec::Vec;
use alloc::{format, vec};

use crate::error::ModelError;
use crate::maths::hash::Fnv1a;
use crate::maths::number::greater;
use crate::model::body::{Body, Mobility};
use crate::model::fender::{Fender, RankedFender};
use crate::model::mass::InverseMatrix;
use crate::model::material::{BodyId, FenderId, Material, MaterialId};
use crate::model::outline::MAX_COORDINATE_M;
use crate::model::pair::{Bounds, RankedPair};
use crate::model::pile::Pile;
use crate::model::ranked::Ranked;
use crate::model::ranked_pile::RankedPile;
use crate::model::reaction::FenderLaw;
use crate::model::slice::Slices;
use crate::state::body_state::FURTHEST_M;

/// Two bodies that may touch, and the material of their contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// The two bodies of the pair, in any order.
    pub bodies: [BodyId; 2],
    /// The material of the contacts between the two bodies.
    pub material: MaterialId,
}

/// The bodies, materials, fenders and pairs of a contact problem, checked and constant. All mutable state is in
/// [`crate::Memory`], so many runs can share one model.
///
/// ```
/// use fenderline_contact::*;
/// let square = [vec2(-5.0, -5.0), vec2(5.0, -5.0), vec2(5.0, 5.0), vec2(-5.0, 5.0)];
/// let (outline, _) = Outline::new(&square)?;
/// let mut builder = Model::builder();
/// let tug = builder.body(Body {
///     name: "tug".into(),
///     key: 1,
///     outline: outline.clone(),
///     mobility: Mobility::Free { mass_kg: 1e6, yaw_inertia_kgm2: 6e7 },
/// });
/// let quay = builder.body(Body { name: "quay".into(), key: 2, outline, mobility: Mobility::Fixed });
/// let rubber = builder.material(Material {
///     stiffness_npm2: 500e3,
///     damping_nspm2: 0.0,
///     shear_stiffness_npm: 3e6,
///     friction_static: 0.5,
///     friction_dynamic: 0.5,
///     restitution: 0.1,
/// });
/// builder.pair(Pair { bodies: [tug, quay], material: rubber });
/// let model = builder.build()?;
/// assert_eq!(model.bodies().len(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Model {
    bodies: Vec<Body>,
    materials: Vec<Material>,
    pub(crate) fenders: Vec<Fender>,
    /// The fenders, sorted by the rank of the bodies that carry them, then by key. A face's number is its index here
    /// plus 1. The places of leaning fenders change: see [`Model::lean_fender`].
    pub(crate) faces: Vec<RankedFender>,
    /// Number of the face of each fender.
    face_of_fender: Vec<u32>,
    /// The bodies, in the order of their keys.
    pub(crate) ranked: Ranked,
    /// Rank of each body by index, and index of each body by rank.
    pub(crate) rank_of: Vec<u32>,
    pub(crate) id_of: Vec<BodyId>,
    /// Pairs of bodies that the builder was given, sorted by rank.
    pub(crate) pairs: Vec<RankedPair>,
    pub(crate) pair_bounds: Vec<Bounds>,
    /// Material of the pairs of bodies that are not in `pairs`; `None` if those bodies may not touch.
    pub(crate) all_other_pairs: Option<MaterialId>,
    /// Slices of bodies with outlines by height: the outlines that fenders meet. The slices change during a run: see
    /// [`Model::renew_slice`].
    pub(crate) slices: Slices,
    /// Piles of the bodies that stand on piles, by rank.
    pub(crate) piles: Vec<RankedPile>,
    /// Hash that identifies the model, for memory and snapshots.
    pub(crate) fingerprint: u64,
    /// Hash of the model that also depends on the order in which bodies and materials were added. Workspaces need this
    /// hash because they contain indices of bodies and materials.
    pub(crate) layout: u64,
}

/// Collects the parts of a [`Model`].
#[derive(Clone, Debug, Default)]
pub struct ModelBuilder {
    bodies: Vec<Body>,
    materials: Vec<Material>,
    fenders: Vec<Fender>,
    pairs: Vec<Pair>,
    all_other_pairs: Option<MaterialId>,
    by_height: Vec<(BodyId, f64)>,
    leaning: Vec<(BodyId, f64)>,
}

impl Model {
    /// Number of tension chains of a fender's face, given by its number counted from 1; 0 if there is no such face.
    pub(crate) fn chains_of(&self, face: u32) -> usize {
        let law =
            face.checked_sub(1).and_then(|index| self.faces.get(index as usize)?.panel.as_ref());
        law.map_or(0, |law| law.chains.len())
    }

    /// An empty builder.
    #[must_use]
    pub fn builder() -> ModelBuilder {
        ModelBuilder::default()
    }

    /// The bodies of the model, in the order in which they were added.
    #[must_use]
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// The materials of the model, in the order in which they were added.
    #[must_use]
    pub fn materials(&self) -> &[Material] {
        &self.materials
    }

    /// The indices of two bodies, from their ranks.
    #[inline(always)]
    pub(crate) fn ids_of(&self, ranks: [u32; 2]) -> [BodyId; 2] {
        ranks.map(|rank| self.id_of[rank as usize])
    }

    /// Inverse mass matrix M⁻¹ of the body with this index, in the body's own axes.
    pub(crate) fn inverse_of(&self, index: usize) -> &InverseMatrix {
        &self.ranked.rest(self.rank_of[index] as usize).inverse
    }

    /// Number of a fender's face; 0 if there is no fender.
    pub(crate) fn face_of(&self, fender: Option<FenderId>) -> u32 {
        fender.map_or(0, |FenderId(id)| self.face_of_fender[id as usize])
    }

    /// The fenders of the model, in the order in which they were added.
    #[must_use]
    pub fn fenders(&self) -> &[Fender] {
        &self.fenders
    }
}

impl ModelBuilder {
    /// Adds a body.
    pub fn body(&mut self, body: Body) -> BodyId {
        self.bodies.push(body);
        BodyId(self.bodies.len() as u32 - 1)
    }

    /// Adds a material.
    pub fn material(&mut self, material: Material) -> MaterialId {
        self.materials.push(material);
        MaterialId(self.materials.len() as u32 - 1)
    }

    /// Adds a fender. The fender touches the outlines of all bodies that form a pair with the fender's body.
    pub fn fender(&mut self, fender: Fender) -> FenderId {
        self.fenders.push(fender);
        FenderId(self.fenders.len() as u32 - 1)
    }

    /// Lets two bodies touch.
    pub fn pair(&mut self, pair: Pair) -> &mut ModelBuilder {
        self.pairs.push(pair);
        self
    }

    /// Lets all other pairs of bodies touch: the pairs that no call of [`ModelBuilder::pair`] names.
    pub fn all_other_pairs(&mut self, material: MaterialId) -> &mut ModelBuilder {
        self.all_other_pairs = Some(material);
        self
    }

    /// Declares a body with outlines by height, within this radius of the body's centre of gravity (m). A fender then
    /// meets the outline that the body has at the height of the fender. The host sets the outlines by height with
    /// [`Model::renew_slice`]; until then fenders do not meet the body at all. Outlines of other bodies still meet the
    /// outline [`Body::outline`] of this body.
    pub fn outlines_by_height(&mut self, body: BodyId, radius_m: f64) -> &mut ModelBuilder {
        self.by_height.push((body, radius_m));
        self
    }

    /// Declares that the fenders of a body lean: that the host may move each of them by up to `lean_m` (m) from its
    /// place, with [`Model::lean_fender`].
    pub fn leaning_fenders(&mut self, body: BodyId, lean_m: f64) -> &mut ModelBuilder {
        self.leaning.push((body, lean_m));
        self
    }

    /// Checks all parts and builds the model.
    ///
    /// # Errors
    /// Returns a [`ModelError`], which names the body, the fender or the pair that is wrong.
    pub fn build(self) -> Result<Model, ModelError> {
        let ModelBuilder { bodies, materials, fenders, pairs, all_other_pairs, by_height, leaning } =
            self;
        bodies.iter().try_for_each(check_body)?;
        for (index, material) in materials.iter().enumerate() {
            check_material(index, material)?;
        }
        let (rank_of, id_of) = rank(&bodies)?;
        let faces = rank_fenders(&fenders, &materials, &rank_of)?;
        let mut ranked = Ranked::new(id_of.iter().map(|id| &bodies[id.0 as usize]), &faces);
        let by_height =
            rank_lengths(&bodies, &by_height, "radius of the outlines by height", &rank_of)?;
        by_height.iter().for_each(|&(rank, radius_m)| ranked.widen(rank as usize, radius_m));
        let leaning = rank_lengths(&bodies, &leaning, "lean of the fenders", &rank_of)?;
        for (rank, lean_m) in leaning {
            let own = faces.iter().filter(|face| face.host == rank);
            let reach_m = own.map(RankedFender::reach_m).fold(0.0, greater);
            ranked.widen(rank as usize, reach_m + lean_m);
        }
        let by_height: Vec<u32> = by_height.into_iter().map(|(rank, _)| rank).collect();
        let pairs = rank_pairs(&bodies, &materials, &pairs, (&ranked, &rank_of))?;
        if let Some(MaterialId(index)) = all_other_pairs
            && index as usize >= materials.len()
        {
            return Err(ModelError::UnknownId { what: "material", index });
        }
        let piles = RankedPile::all(&bodies, &id_of);
        let (rank_of_count, face_count) = (rank_of.len(), faces.len());
        let mut model = Model {
            bodies,
            materials,
            fenders,
            face_of_fender: numbers_of(&faces),
            faces,
            ranked,
            rank_of,
            id_of,
            pairs,
            pair_bounds: Vec::new(),
            all_other_pairs,
            slices: Slices::new(rank_of_count, &by_height, face_count),
            piles,
            fingerprint: 0,
            layout: 0,
        };
        model.pair_bounds = model
            .pairs
            .iter()
            .map(|pair| Bounds::of(&model.ranked, &model.materials, pair))
            .collect();
        model.fingerprint = fingerprint(&model);
        model.layout = layout(&model);
        Ok(model)
    }
}

fn check_body(body: &Body) -> Result<(), ModelError> {
    let (mass_kg, yaw_inertia_kgm2) = match body.mobility {
        Mobility::Fixed => return Ok(()),
        Mobility::Free { mass_kg, yaw_inertia_kgm2 } => (mass_kg, yaw_inertia_kgm2),
        Mobility::SurgeSway { surge_kg, sway_kg, yaw_inertia_kgm2 } => {
            check_mass(body, "mass in surge", surge_kg)?;
            (sway_kg, yaw_inertia_kgm2)
        }
        Mobility::OnPile { mass_kg, pile } => return check_pile(body, mass_kg, &pile),
        Mobility::FullMatrix { matrix } => {
            let [[_, b, c], [d, _, e], [f, g, _]] = matrix;
            if (b, c, e) != (d, f, g) || InverseMatrix::of(&matrix).is_none() {
                return Err(ModelError::BadMatrix { body: body.name.clone() });
            }
            (greater(matrix[0][0], matrix[1][1]), matrix[2][2])
        }
    };
    check_mass(body, "mass", mass_kg)?;
    check_mass(body, "yaw inertia", yaw_inertia_kgm2)
}

fn check_pile(body: &Body, mass_kg: f64, pile: &Pile) -> Result<(), ModelError> {
    check_mass(body, "mass", mass_kg)?;
    let check = |field, value: f64, is_good: bool, must| {
        if is_good {
            return Ok(());
        }
        Err(ModelError::OutOfRange { owner: body.name.clone(), field, value, must })
    };
    let (stiffness, damping, limit) = (pile.stiffness_npm, pile.damping_nspm, pile.yield_n);
    let is_stiff = stiffness > 0.0 && stiffness <= LARGEST_STIFFNESS;
    check("pile stiffness", stiffness, is_stiff, "positive and at most 1e18")?;
    let is_damping = (0.0..=LARGEST_STIFFNESS).contains(&damping);
    check("pile damping", damping, is_damping, "between 0 and 1e18")?;
    check("pile yield load", limit, limit > 0.0, "positive")?;
    let place_m = greater(pile.place_m.x.abs(), pile.place_m.y.abs());
    let is_near = pile.place_m.is_finite() && place_m <= FURTHEST_M;
    check("place of the pile", place_m, is_near, "at most 1e9 m from the origin")
}

fn check_mass(body: &Body, field: &'static str, value: f64) -> Result<(), ModelError> {
    if value > 0.0 && value <= LARGEST_MASS {
        return Ok(());
    }
    let must = "positive and at most 1e30";
    Err(ModelError::OutOfRange { owner: body.name.clone(), field, value, must })
}

/// Largest mass and stiffness of a model; larger values could overflow in products of masses, stiffnesses and areas.
const LARGEST_MASS: f64 = 1e30;
const LARGEST_STIFFNESS: f64 = 1e18;

fn check_material(index: usize, m: &Material) -> Result<(), ModelError> {
    let check = |field, value: f64, low: f64, high: f64, must| {
        if value >= low && value <= high {
            return Ok(());
        }
        Err(ModelError::OutOfRange { owner: format!("material {index}"), field, value, must })
    };
    let stiff = "between 0 and 1e18";
    check("stiffness", m.stiffness_npm2, 0.0, LARGEST_STIFFNESS, stiff)?;
    check("damping", m.damping_nspm2, 0.0, LARGEST_STIFFNESS, stiff)?;
    check("shear stiffness", m.shear_stiffness_npm, 0.0, LARGEST_STIFFNESS, stiff)?;
    check("static friction", m.friction_static, 0.0, 1e6, "between 0 and 1e6")?;
    check(
        "dynamic friction",
        m.friction_dynamic,
        0.0,
        m.friction_static,
        "between 0 and the static friction",
    )?;
    check("restitution", m.restitution, 0.0, 1.0, "between 0 and 1")
}

/// The rank of each body by index, which follows from the keys, and the index of each body by rank.
fn rank(bodies: &[Body]) -> Result<(Vec<u32>, Vec<BodyId>), ModelError> {
    let mut order: Vec<u32> = (0..bodies.len() as u32).collect();
    order.sort_by_key(|&i| bodies[i as usize].key);
    for two in order.windows(2) {
        let (first, second) = (&bodies[two[0] as usize], &bodies[two[1] as usize]);
        if first.key == second.key {
            return Err(ModelError::DuplicateKey { body: second.name.clone(), key: second.key });
        }
    }
    let mut rank_of = vec![0; bodies.len()];
    for (rank, &id) in order.iter().enumerate() {
        rank_of[id as usize] = rank as u32;
    }
    Ok((rank_of, order.into_iter().map(BodyId).collect()))
}

/// Checks the fenders and sorts them by the rank of their bodies and by key.
fn rank_fenders(
    fenders: &[Fender],
    materials: &[Material],
    rank_of: &[u32],
) -> Result<Vec<RankedFender>, ModelError> {
    let mut faces = Vec::with_capacity(fenders.len());
    for (index, one) in fenders.iter().enumerate() {
        fender::check(one)?;
        let Some(material) = materials.get(one.material.0 as usize) else {
            return Err(ModelError::UnknownId { what: "material", index: one.material.0 });
        };
        let Some(&host) = rank_of.get(one.body.0 as usize) else {
            return Err(ModelError::UnknownId { what: "body", index: one.body.0 });
        };
        faces.push(RankedFender::new(FenderId(index as u32), host, one, material));
    }
    faces.sort_by_key(|face| (face.host, face.key));
    for two in faces.windows(2) {
        if (two[0].host, two[0].key) == (two[1].host, two[1].key) {
            let second = &fenders[two[1].id.0 as usize];
            return Err(ModelError::DuplicateKey { body: second.name.clone(), key: second.key });
        }
    }
    Ok(faces)
}

/// The bodies for which the host has declared a length, such as a radius of the outlines by height: rank and declared
/// length (m) of each body, in the order of the ranks.
fn rank_lengths(
    bodies: &[Body],
    lengths: &[(BodyId, f64)],
    field: &'static str,
    rank_of: &[u32],
) -> Result<Vec<(u32, f64)>, ModelError> {
    let mut ranks = Vec::with_capacity(lengths.len());
    for &(BodyId(index), length_m) in lengths {
        let Some(body) = bodies.get(index as usize) else {
            return Err(ModelError::UnknownId { what: "body", index });
        };
        if !(length_m > 0.0 && length_m <= MAX_COORDINATE_M) {
            let (owner, must) = (body.name.clone(), "positive and at most 1e8 m");
            return Err(ModelError::OutOfRange { owner, field, value: length_m, must });
        }
        ranks.push((rank_of[index as usize], length_m));
    }
    ranks.sort_by_key(|&(rank, _)| rank);
    ranks.dedup_by_key(|&mut (rank, _)| rank);
    Ok(ranks)
}

/// The number of the face of each fender.
fn numbers_of(faces: &[RankedFender]) -> Vec<u32> {
    let mut numbers = vec![0; faces.len()];
    for (number, face) in (1..).zip(faces) {
        numbers[face.id.0 as usize] = number;
    }
    numbers
}

fn rank_pairs(
    bodies: &[Body],
    materials: &[Material],
    pairs: &[Pair],
    (by_rank, rank_of): (&Ranked, &[u32]),
) -> Result<Vec<RankedPair>, ModelError> {
    let mut ranked = Vec::with_capacity(pairs.len());
    for pair in pairs {
        for BodyId(index) in pair.bodies {
            if index as usize >= bodies.len() {
                return Err(ModelError::UnknownId { what: "body", index });
            }
        }
        if pair.material.0 as usize >= materials.len() {
            return Err(ModelError::UnknownId { what: "material", index: pair.material.0 });
        }
        let [one, two] = pair.bodies.map(|id| rank_of[id.0 as usize]);
        let [first, second] = pair.bodies.map(|id| &bodies[id.0 as usize]);
        if one == two {
            return Err(bad_pair(first, second, "a body cannot touch itself"));
        }
        let [a, b] = [one.min(two), one.max(two)].map(|rank| (rank, &by_rank[rank as usize]));
        if a.1.stands && b.1.stands {
            let why = "both bodies stand on the ground: no force would bring them together";
            return Err(bad_pair(first, second, why));
        }
        ranked.push(RankedPair::new(a, b, pair.material));
    }
    ranked.sort_by_key(|p| (p.a, p.b));
    let of_rank = |rank: u32| bodies.iter().zip(rank_of).find(|(_, r)| **r == rank).map(|(b, _)| b);
    for two in ranked.windows(2) {
        if (two[0].a, two[0].b) == (two[1].a, two[1].b)
            && let (Some(a), Some(b)) = (of_rank(two[0].a), of_rank(two[0].b))
        {
            return Err(bad_pair(a, b, "named twice"));
        }
    }
    Ok(ranked)
}

fn bad_pair(first: &Body, second: &Body, why: &'static str) -> ModelError {
    ModelError::BadPair { bodies: [first.name.clone(), second.name.clone()], why }
}

/// FNV-1a hash of all parts of the model on which a memory depends, in the order of the keys.
fn fingerprint(model: &Model) -> u64 {
    let mut hash = Fnv1a::default();
    hash.word(model.ranked.len() as u64);
    for (rank, id) in model.id_of.iter().enumerate() {
        let ranked = &model.ranked[rank];
        let body = &model.bodies[id.0 as usize];
        hash.word(body.key);
        hash.numbers(&[ranked.inverse_mass, ranked.inverse_inertia]);
        match body.mobility {
            Mobility::Fixed | Mobility::Free { .. } => {}
            Mobility::OnPile { pile, .. } => {
                hash.word(u64::MAX - 1);
                hash.numbers(&[pile.place_m.x, pile.place_m.y, pile.stiffness_npm]);
                hash.numbers(&[pile.damping_nspm, pile.yield_n]);
            }
            Mobility::FullMatrix { matrix } => hash.numbers(matrix.as_flattened()),
            Mobility::SurgeSway { surge_kg, sway_kg, .. } => {
                hash.word(u64::MAX);
                hash.numbers(&[surge_kg, sway_kg]);
            }
        }
        for v in body.outline.vertices() {
            hash.numbers(&[v.x, v.y]);
        }
        if body.outline.is_of_parts() {
            for piece in body.outline.pieces() {
                hash.word(piece.len() as u64);
                piece.iter().for_each(|v| hash.numbers(&[v.x, v.y]));
            }
        }
    }
    let material = |hash: &mut Fnv1a, MaterialId(index): MaterialId| {
        let m = &model.materials[index as usize];
        hash.numbers(&[m.stiffness_npm2, m.damping_nspm2, m.shear_stiffness_npm]);
        hash.numbers(&[m.friction_static, m.friction_dynamic, m.restitution]);
    };
    for pair in &model.pairs {
        hash.word(u64::from(pair.a));
        hash.word(u64::from(pair.b));
        material(&mut hash, pair.material);
    }
    if let Some(id) = model.all_other_pairs {
        material(&mut hash, id);
    }
    for rank in model.slices.ranks() {
        hash.word(u64::from(rank));
        hash.word(model.ranked[rank as usize].radius_m.to_bits());
    }
    hash.word(model.faces.len() as u64);
    for face in &model.faces {
        hash.word(u64::from(face.host));
        hash.word(face.key);
        material(&mut hash, face.material);
        hash_fender(&mut hash, &model.fenders[face.id.0 as usize]);
    }
    hash.finish()
}

/// Hash of the fingerprint and of the indices of bodies and materials.
fn layout(model: &Model) -> u64 {
    let mut hash = Fnv1a::default();
    hash.word(model.fingerprint);
    model.id_of.iter().for_each(|id| hash.word(u64::from(id.0)));
    let of_pairs = model.pairs.iter().map(|pair| pair.material);
    for MaterialId(index) in of_pairs.chain(model.all_other_pairs) {
        hash.word(u64::from(index));
    }
    hash.finish()
}

fn hash_fender(hash: &mut Fnv1a, fender: &Fender) {
    let factors = &fender.factors;
    let [from_m, stiffness_npm] =
        fender.stop.map_or([-1.0; 2], |stop| [stop.from_m, stop.stiffness_npm]);
    hash.numbers(&[fender.position_m.x, fender.position_m.y, fender.facing_rad]);
    hash.numbers(&[fender.width_m, fender.projection_m, fender.rated_deflection_m]);
    hash.numbers(&[from_m, stiffness_npm, factors.constant]);
    let curve: &[[f64; 2]] = match &fender.law {
        FenderLaw::Area => &[],
        FenderLaw::Curve(points) => points,
    };
    if let Some(unloading) = &fender.unloading {
        unloading.words().for_each(|value| hash.word(value.to_bits()));
    }
    if let Some(panel) = &fender.panel {
        hash.word(u64::MAX);
        panel.words().for_each(|value| hash.word(value.to_bits()));
    }
    for points in [curve, &factors.by_compression_time, &factors.by_angle] {
        hash.word(points.len() as u64);
        hash.numbers(points.as_flattened());
    }
}
