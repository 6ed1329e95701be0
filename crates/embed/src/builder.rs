//! Builds an engine part by part, by function calls instead of from a scenario file.

use fenderline_contact::{FenderLaw, Material, Outline, ReactionFactors, Stop, Unloading, Vec2};
use fenderline_sim::{
    BodySetup, BodyVelocity, FenderSetup, HullPressure, Integrator, MassProperties, Method,
    NamedMaterial, PairSetup, Rated, Setup, WorldSetup,
};

use crate::engine::Engine;
use crate::error::EngineError;
use crate::settings::Settings;

/// Collects the parts of an [`Engine`]. Indices of bodies, materials and fenders count from 0 in the order of the
/// calls.
///
/// ```
/// use fenderline_contact::{Material, vec2};
/// use fenderline_embed::*;
/// use fenderline_sim::MassProperties;
/// let square = [vec2(-5.0, -5.0), vec2(5.0, -5.0), vec2(5.0, 5.0), vec2(-5.0, 5.0)];
/// let mass = MassProperties { mass_kg: 1e6, yaw_inertia_kgm2: 2e7, ..Default::default() };
/// let mut builder = EngineBuilder::new();
/// let rubber = builder.material("rubber", Material { stiffness_npm2: 500e3, damping_nspm2: 0.0,
///     shear_stiffness_npm: 3e6, friction_static: 0.5, friction_dynamic: 0.5, restitution: 0.1 })?;
/// let tug = builder.body(&BodyDef { name: "tug", outline_m: &square, mass: Some(mass),
///     position_m: vec2(0.0, 0.0), heading_rad: 0.0 })?;
/// let quay = builder.body(&BodyDef { name: "quay", outline_m: &square, mass: None,
///     position_m: vec2(9.9, 0.0), heading_rad: 0.0 })?;
/// builder.pair([tug, quay], rubber)?;
/// let mut engine = builder.build(&Settings::default())?;
/// let states = engine.initial_states().to_vec();
/// let wrenches = engine.advance(&states, None, 0.1)?;
/// assert!(wrenches[tug].force_n.x < -1e5);
/// # Ok::<(), EngineError>(())
/// ```
#[derive(Clone, Debug)]
pub struct EngineBuilder {
    pub(crate) setup: Setup,
    pub(crate) notices: Vec<String>,
}

/// A body to be added to an engine.
#[derive(Clone, Copy, Debug)]
pub struct BodyDef<'a> {
    /// Unique name.
    pub name: &'a str,
    /// Outline of the body, in either sense: x forward and y to starboard of the centre of gravity (m).
    pub outline_m: &'a [Vec2],
    /// Mass and added mass of the body; `None` for a fixed body.
    pub mass: Option<MassProperties>,
    /// Position of the body at the start: north, east (m).
    pub position_m: Vec2,
    /// Heading of the body at the start (rad).
    pub heading_rad: f64,
}

/// A fender to be added: see [`fenderline_contact::Fender`].
#[derive(Clone, Debug)]
pub struct FenderDef<'a> {
    /// Unique name.
    pub name: &'a str,
    /// Index of the body that carries the fender.
    pub body: usize,
    /// Middle of the line where the fender is mounted, in the body's frame (m).
    pub position_m: Vec2,
    /// Direction of the fender's outward normal, in the body's frame: 0 forward, positive to
    /// starboard (rad).
    pub facing_rad: f64,
    /// Width of the fender's face (m).
    pub width_m: f64,
    /// Distance from the fender's mounting to its uncompressed face (m).
    pub projection_m: f64,
    /// Reaction of the fender as a function of its deflection.
    pub law: FenderLaw,
    /// Law by which the fender's reaction falls as the hull moves back; `None` means that the reaction falls by the
    /// restitution of the material.
    pub unloading: Option<Unloading>,
    /// Index of the fender's material: friction, restitution, damping and, for an area law,
    /// stiffness.
    pub material: usize,
    /// Rated deflection of the fender (m); `None` means that it equals the projection. Reaction curves only.
    pub rated_deflection_m: Option<f64>,
    /// The stop at the end of the fender's travel; `None` for a law that stiffens by itself.
    pub stop: Option<Stop>,
}

impl Default for EngineBuilder {
    fn default() -> EngineBuilder {
        EngineBuilder::new()
    }
}

impl EngineBuilder {
    /// An empty builder.
    #[must_use]
    pub fn new() -> EngineBuilder {
        EngineBuilder {
            setup: Setup {
                // The engine does not use these values: the host has other values.
                step_s: 1.0,
                duration_s: 1.0,
                integrator: Integrator::SemiImplicit,
                method: Method::Coupled,
                bodies: Vec::new(),
                materials: Vec::new(),
                pairs: Vec::new(),
                all_other_pairs: None,
                approaches: vec![],
                fenders: Vec::new(),
                berthing: None,
                loads: Vec::new(),
                world: WorldSetup::default(),
            },
            notices: Vec::new(),
        }
    }

    /// Adds a material; [`EngineBuilder::build`] checks the material's numbers.
    ///
    /// # Errors
    /// Fails for a name that is empty or already used.
    pub fn material(&mut self, name: &str, material: Material) -> Result<usize, EngineError> {
        let materials = &mut self.setup.materials;
        check_name("material", name, materials.iter().map(|other| other.name.as_str()))?;
        materials.push(NamedMaterial { name: name.to_owned(), material });
        Ok(materials.len() - 1)
    }

    /// Adds a body; [`EngineBuilder::build`] checks the body's masses.
    ///
    /// # Errors
    /// Fails for a name that is empty or already used, or an invalid outline.
    pub fn body(&mut self, parts: &BodyDef<'_>) -> Result<usize, EngineError> {
        let bodies = &mut self.setup.bodies;
        check_name("body", parts.name, bodies.iter().map(|other| other.name.as_str()))?;
        let name = parts.name.to_owned();
        let outline = match Outline::new(parts.outline_m) {
            Ok((outline, _)) => outline,
            Err(error) => return Err(EngineError::Outline { body: name, error }),
        };
        bodies.push(BodySetup {
            name,
            outline,
            hull: None,
            mass: parts.mass,
            position_m: parts.position_m,
            heading_rad: parts.heading_rad,
            velocity: BodyVelocity::default(),
            dolphin: None,
        });
        Ok(bodies.len() - 1)
    }

    /// Adds a fender; [`EngineBuilder::build`] checks the fender's numbers.
    ///
    /// # Errors
    /// Fails for a name that is empty or already used, a body or material that does not exist, or a rated deflection
    /// for an area law.
    pub fn fender(&mut self, parts: &FenderDef<'_>) -> Result<usize, EngineError> {
        let names = self.setup.fenders.iter().map(|other| other.name.as_str());
        check_name("fender", parts.name, names)?;
        self.check_body(parts.body)?;
        self.check_material(parts.material)?;
        let rated = match parts.rated_deflection_m {
            None => None,
            Some(deflection_m) => {
                Some(Rated::of(&parts.law, deflection_m).ok_or(EngineError::Settings(
                    "a fender whose reaction follows an area law has no rated deflection",
                ))?)
            }
        };
        self.setup.fenders.push(FenderSetup {
            name: parts.name.to_owned(),
            body: parts.body,
            position_m: parts.position_m,
            facing_rad: parts.facing_rad,
            width_m: parts.width_m,
            // Of no matter to forces in the plane: pressure and heel are reports'.
            height_m: 0.0,
            above_water_m: 0.0,
            floating: false,
            projection_m: parts.projection_m,
            law: parts.law.clone(),
            unloading: parts.unloading.clone(),
            material: parts.material,
            rated,
            stop: parts.stop,
            factors: ReactionFactors::default(),
            panel: None,
            chains: vec![],
            panel_mass_kg: 0.0,
            energy_by_angle: Vec::new(),
            hull_pressure: HullPressure::Unknown,
            hull_pressure_limit_npm2: None,
            source: None,
        });
        Ok(self.setup.fenders.len() - 1)
    }

    /// Enables contact between two bodies.
    ///
    /// # Errors
    /// Fails if the body or the material does not exist.
    pub fn pair(&mut self, bodies: [usize; 2], material: usize) -> Result<(), EngineError> {
        bodies.into_iter().try_for_each(|body| self.check_body(body))?;
        self.check_material(material)?;
        self.setup.pairs.push(PairSetup { bodies, material });
        Ok(())
    }

    /// Enables contact between all other pairs of bodies, which no call of [`EngineBuilder::pair`] names.
    ///
    /// # Errors
    /// No such material.
    pub fn all_other_pairs(&mut self, material: usize) -> Result<(), EngineError> {
        self.check_material(material)?;
        self.setup.all_other_pairs = Some(material);
        Ok(())
    }

    /// Finds the index of the body with the given name.
    ///
    /// # Errors
    /// [`EngineError::NoSuchName`].
    pub fn body_named(&self, name: &str) -> Result<usize, EngineError> {
        index_of("body", name, self.setup.bodies.iter().map(|body| body.name.as_str()))
    }

    /// Finds the index of the material with the given name.
    ///
    /// # Errors
    /// [`EngineError::NoSuchName`].
    pub fn material_named(&self, name: &str) -> Result<usize, EngineError> {
        index_of("material", name, self.setup.materials.iter().map(|one| one.name.as_str()))
    }

    /// Finds the index of the fender with the given name.
    ///
    /// # Errors
    /// [`EngineError::NoSuchName`].
    pub fn fender_named(&self, name: &str) -> Result<usize, EngineError> {
        index_of("fender", name, self.setup.fenders.iter().map(|one| one.name.as_str()))
    }

    /// Makes the engine. After a build the builder can be used further.
    ///
    /// # Errors
    /// Fails for a number out of range, with the body, material or fender and the field; and for settings that
    /// conflict.
    pub fn build(&self, settings: &Settings) -> Result<Engine, EngineError> {
        Engine::from_setup(String::new(), self.setup.clone(), self.notices.clone(), settings)
    }

    fn check_body(&self, index: usize) -> Result<(), EngineError> {
        check_index("body", index, self.setup.bodies.len())
    }

    fn check_material(&self, index: usize) -> Result<(), EngineError> {
        check_index("material", index, self.setup.materials.len())
    }
}

fn check_index(what: &'static str, index: usize, count: usize) -> Result<(), EngineError> {
    if index < count { Ok(()) } else { Err(EngineError::NoSuch { what, index, count }) }
}

fn index_of<'n>(
    what: &'static str,
    name: &str,
    mut names: impl Iterator<Item = &'n str>,
) -> Result<usize, EngineError> {
    let found = names.position(|other| other == name);
    found.ok_or_else(|| EngineError::NoSuchName { what, name: name.to_owned() })
}

pub(crate) fn check_name<'n>(
    what: &'static str,
    name: &str,
    mut others: impl Iterator<Item = &'n str>,
) -> Result<(), EngineError> {
    let why = if name.is_empty() {
        "is empty"
    } else if others.any(|other| other == name) {
        "is already used"
    } else {
        return Ok(());
    };
    Err(EngineError::Name { what, name: name.to_owned(), why })
}
