//! Builds the inertias of the bodies and the contact model from a set-up.

use std::sync::Arc;

use fenderline_contact::{Body, BodyId, BodyState, Fender, MaterialId, Model, Pair, Panel};

use crate::chain::tension_chains;
use crate::error::SetupError;
use crate::fender::FenderSetup;
use crate::hull::leaning_bodies;
use crate::order::check_order;
use crate::rigid_body::{Inertia, initial_state};
use crate::setup::{BodySetup, Integrator, Method, Setup};
use crate::world::{mass_matrix, motions};
use fenderline_seakeeping::Motion;

impl Setup {
    /// The contact engine's model of the bodies in the set-up, for use without a simulation. The function is for host
    /// programs that move their bodies themselves and use only the contact engine.
    ///
    /// Method and integrator decide what the inertia of a body contains. In the coupled method with the semi-implicit
    /// integrator, the engine adds the Coriolis terms itself, as in a simulation.
    ///
    /// In this model, fenders meet a body with outlines at several heights at its waterline, because only a simulation
    /// knows the heights of the fenders.
    ///
    /// # Errors
    /// Returns a [`SetupError`], which names the fault in the set-up.
    pub fn contact_model(&self) -> Result<Model, SetupError> {
        if let Some(body) = self.bodies.iter().find(|body| body.dolphin.is_some()) {
            return Err(SetupError::DolphinOfHost { body: body.name.clone() });
        }
        let motions = motions(&self.world, self.step_s);
        build_model(self, &inertias(self, &motions)?, Fenders::MeetOutlines)
    }

    /// The initial states of the bodies, in the order of the set-up.
    #[must_use]
    pub fn initial_states(&self) -> Vec<BodyState> {
        self.bodies.iter().map(initial_state).collect()
    }
}

/// The inertia of each body. The inertia of a vessel comes from her hydrodynamic data, or, if she has no such data,
/// from her manoeuvring model.
pub fn inertias(
    setup: &Setup,
    motions: &[Option<Arc<Motion>>],
) -> Result<Vec<Inertia>, SetupError> {
    let engine_moves =
        setup.method == Method::Coupled && setup.integrator == Integrator::SemiImplicit;
    let of_body = |body: &BodySetup| match &body.dolphin {
        Some(dolphin) => Inertia::of_dolphin(dolphin, body.position_m),
        None => Inertia::of(body.mass.as_ref(), setup.method, engine_moves),
    };
    if let Some(body) = setup.bodies.iter().find(|body| body.dolphin.is_some())
        && !engine_moves
    {
        return Err(SetupError::DolphinNeedsEngine { body: body.name.clone() });
    }
    let mut inertias: Vec<Inertia> = setup.bodies.iter().map(of_body).collect();
    let density_kgpm3 = setup.world.environment.water_density_kgpm3;
    for (vessel, motion) in setup.world.vessels.iter().zip(motions) {
        if setup.bodies.get(vessel.body).is_none_or(|body| body.mass.is_none()) {
            return Err(SetupError::BadBody { owner: "vessel", body: vessel.body });
        }
        if setup.method == Method::Paper {
            return Err(SetupError::VesselByPaperMethod { body: vessel.body });
        }
        if vessel.seakeeping.is_some() && !engine_moves {
            return Err(SetupError::SeakeepingNeedsEngine { body: vessel.body });
        }
        inertias[vessel.body] = Inertia::of_vessel(&match motion {
            Some(motion) => *motion.plane_mass(),
            None => mass_matrix(&vessel.ship, density_kgpm3),
        });
    }
    for tug in &setup.world.tugs {
        if tug.vessel >= setup.world.vessels.len() {
            return Err(SetupError::BadBody { owner: "tug", body: tug.vessel });
        }
        let of_tug = |error| SetupError::Tug { tug: tug.tug.name.clone(), error };
        tug.tug.check().map_err(of_tug)?;
    }
    setup.world.orders.iter().try_for_each(|order| check_order(order, setup))?;
    Ok(inertias)
}

/// Which outline fenders meet on bodies with outlines at several heights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fenders {
    /// Fenders meet the outline at the waterline.
    MeetOutlines,
    /// Each fender meets the outline at its own height, which the simulation cuts.
    MeetSlices,
}

/// The contact model of a set-up.
pub fn build_model(
    setup: &Setup,
    inertias: &[Inertia],
    fenders_do: Fenders,
) -> Result<Model, SetupError> {
    let mut builder = Model::builder();
    let keys = keys_of(setup.bodies.iter().map(|body| body.name.as_str()))
        .map_err(|name| SetupError::DuplicateName { what: "bodies", name })?;
    for ((body, inertia), key) in setup.bodies.iter().zip(inertias).zip(keys) {
        builder.body(Body {
            name: body.name.clone(),
            key,
            outline: body.outline.clone(),
            mobility: inertia.mobility(),
        });
    }
    for (body, hull) in
        setup.bodies.iter().enumerate().filter_map(|(i, b)| Some((i, b.hull.as_ref()?)))
    {
        if setup.method == Method::Paper {
            return Err(SetupError::HullByPaperMethod { body });
        }
        if fenders_do == Fenders::MeetSlices {
            builder.outlines_by_height(BodyId(body as u32), hull.radius_m());
        }
    }
    if fenders_do == Fenders::MeetSlices {
        for (body, lean_m) in leaning_bodies(setup) {
            builder.leaning_fenders(BodyId(body as u32), lean_m);
        }
    }
    for material in &setup.materials {
        builder.material(material.material);
    }
    let keys = keys_of(setup.fenders.iter().map(|fender| fender.name.as_str()))
        .map_err(|name| SetupError::DuplicateName { what: "fenders", name })?;
    for (fender, key) in setup.fenders.iter().zip(keys) {
        builder.fender(engine_fender(fender, key));
    }
    for pair in &setup.pairs {
        let bodies = pair.bodies.map(|body| BodyId(body as u32));
        builder.pair(Pair { bodies, material: MaterialId(pair.material as u32) });
    }
    if let Some(material) = setup.all_other_pairs {
        builder.all_other_pairs(MaterialId(material as u32));
    }
    Ok(builder.build()?)
}

/// A fender in the form of the contact engine. Without a rating, the fender's rated deflection is its projection.
fn engine_fender(fender: &FenderSetup, key: u64) -> Fender {
    Fender {
        name: fender.name.clone(),
        key,
        body: BodyId(fender.body as u32),
        position_m: fender.position_m,
        facing_rad: fender.facing_rad,
        width_m: fender.width_m,
        projection_m: fender.projection_m,
        law: fender.law.clone(),
        unloading: fender.unloading.clone(),
        material: MaterialId(fender.material as u32),
        rated_deflection_m: fender.rated.map_or(fender.projection_m, |rated| rated.deflection_m),
        stop: fender.stop,
        factors: fender.factors.clone(),
        panel: fender
            .panel
            .as_ref()
            .map(|panel| Panel { tension_chains: tension_chains(&fender.chains), ..panel.clone() }),
    }
}

/// The key of each name for the contact engine. The key is the index of the name among the sorted names, so that the
/// order of bodies and fenders in a scenario does not change the results. If a name occurs twice, the function fails
/// with this name.
fn keys_of<'n>(names: impl Iterator<Item = &'n str>) -> Result<Vec<u64>, String> {
    let names: Vec<&str> = names.collect();
    let mut order: Vec<usize> = (0..names.len()).collect();
    order.sort_by(|&i, &j| names[i].cmp(names[j]));
    if let Some(two) = order.windows(2).find(|two| names[two[0]] == names[two[1]]) {
        return Err(names[two[0]].to_owned());
    }
    let mut keys = vec![0; names.len()];
    for (key, &index) in order.iter().enumerate() {
        keys[index] = key as u64;
    }
    Ok(keys)
}
