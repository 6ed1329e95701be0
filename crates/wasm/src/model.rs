//! Reads the contact engine's model from JSON: materials, bodies, fenders and pairs by their names.

use fenderline_contact::{FenderLaw, HostIntegration, HostSettings, Material, Stop, Vec2};
use fenderline_embed::{BodyDef, CoriolisTerms, Engine, EngineBuilder, FenderDef, Host, Settings};
use fenderline_sim::{MassProperties, Method};
use serde::Deserialize;

use crate::problem::Problem;

/// The JSON of a model, field by field as the package's TypeScript documents it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct ModelJson {
    materials: Vec<MaterialJson>,
    bodies: Vec<BodyJson>,
    #[serde(default)]
    fenders: Vec<FenderJson>,
    #[serde(default)]
    pairs: Vec<PairJson>,
    all_other_pairs: Option<String>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct MaterialJson {
    name: String,
    stiffness_npm2: f64,
    #[serde(default)]
    damping_nspm2: f64,
    #[serde(default)]
    shear_stiffness_npm: f64,
    #[serde(default)]
    friction_static: f64,
    #[serde(default)]
    friction_dynamic: f64,
    #[serde(default)]
    restitution: f64,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct BodyJson {
    name: String,
    outline_m: Vec<[f64; 2]>,
    mass: Option<MassJson>,
    #[serde(default)]
    position_m: [f64; 2],
    #[serde(default)]
    heading_rad: f64,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct MassJson {
    mass_kg: f64,
    yaw_inertia_kgm2: f64,
    #[serde(default)]
    added_surge_kg: f64,
    #[serde(default)]
    added_sway_kg: f64,
    #[serde(default)]
    added_yaw_kgm2: f64,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct FenderJson {
    name: String,
    body: String,
    position_m: [f64; 2],
    facing_rad: f64,
    width_m: f64,
    projection_m: f64,
    /// Points of deflection and reaction of the fender; without them the fender has the area law.
    curve: Option<Vec<[f64; 2]>>,
    material: String,
    rated_deflection_m: Option<f64>,
    stop: Option<StopJson>,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct StopJson {
    from_m: f64,
    stiffness_npm: f64,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PairJson {
    bodies: [String; 2],
    material: String,
}

/// Settings of an engine.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct SettingsJson {
    method: Option<MethodJson>,
    #[serde(default)]
    host: HostJson,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
enum MethodJson {
    Coupled,
    Paper,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
enum HostJson {
    Direct {
        coriolis: Option<CoriolisJson>,
    },
    CoSimulation {
        #[serde(default)]
        delay_steps: u32,
        #[serde(default)]
        integration: IntegrationJson,
    },
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
enum CoriolisJson {
    ByEngine,
    InLoads,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
enum IntegrationJson {
    #[default]
    ForwardEuler,
    SemiImplicit,
}

impl Default for HostJson {
    fn default() -> HostJson {
        HostJson::Direct { coriolis: None }
    }
}

/// Makes a contact engine of a model in JSON.
///
/// # Errors
/// Fails for text that is not the JSON of a model, for a name that no part has, and for a number out of range.
pub fn engine(model: &str, settings: &str) -> Result<Engine, Problem> {
    let model: ModelJson = read("model", model)?;
    let settings = self::settings(settings)?;
    let mut builder = EngineBuilder::new();
    for material in &model.materials {
        builder.material(&material.name, material.material())?;
    }
    for body in &model.bodies {
        add_body(&mut builder, body)?;
    }
    for fender in &model.fenders {
        builder.fender(&fender.def(&model)?)?;
    }
    for PairJson { bodies: [one, two], material } in &model.pairs {
        let place = "a pair";
        let bodies = [model.body(one, place)?, model.body(two, place)?];
        builder.pair(bodies, model.material(material, place)?)?;
    }
    if let Some(material) = &model.all_other_pairs {
        builder.all_other_pairs(model.material(material, "`all_other_pairs`")?)?;
    }
    Ok(builder.build(&settings)?)
}

/// Reads the settings of a contact engine.
///
/// # Errors
/// Fails for text that is not the JSON of an engine's settings.
pub fn settings(text: &str) -> Result<Settings, Problem> {
    let SettingsJson { method, host } = read("settings", text)?;
    let method = method.map(|method| match method {
        MethodJson::Coupled => Method::Coupled,
        MethodJson::Paper => Method::Paper,
    });
    let host = match host {
        HostJson::Direct { coriolis } => Host::Direct {
            coriolis: coriolis.map(|terms| match terms {
                CoriolisJson::ByEngine => CoriolisTerms::ByEngine,
                CoriolisJson::InLoads => CoriolisTerms::InLoads,
            }),
        },
        HostJson::CoSimulation { delay_steps, integration } => {
            let integration = match integration {
                IntegrationJson::ForwardEuler => HostIntegration::ForwardEuler,
                IntegrationJson::SemiImplicit => HostIntegration::SemiImplicit,
            };
            Host::CoSimulation(HostSettings { delay_steps, integration })
        }
    };
    Ok(Settings { method, host })
}

fn read<'a, T: Deserialize<'a>>(what: &str, text: &'a str) -> Result<T, Problem> {
    serde_json::from_str(text).map_err(|e| {
        let message = format!("the JSON of the {what} is not understood: {e}");
        Problem::new("model", message).at(e.line(), e.column())
    })
}

fn add_body(builder: &mut EngineBuilder, body: &BodyJson) -> Result<usize, Problem> {
    let outline: Vec<Vec2> = body.outline_m.iter().copied().map(point).collect();
    let mass = body.mass.map(|mass| MassProperties {
        mass_kg: mass.mass_kg,
        yaw_inertia_kgm2: mass.yaw_inertia_kgm2,
        added_surge_kg: mass.added_surge_kg,
        added_sway_kg: mass.added_sway_kg,
        added_yaw_kgm2: mass.added_yaw_kgm2,
    });
    Ok(builder.body(&BodyDef {
        name: &body.name,
        outline_m: &outline,
        mass,
        position_m: point(body.position_m),
        heading_rad: body.heading_rad,
    })?)
}

impl MaterialJson {
    fn material(&self) -> Material {
        Material {
            stiffness_npm2: self.stiffness_npm2,
            damping_nspm2: self.damping_nspm2,
            shear_stiffness_npm: self.shear_stiffness_npm,
            friction_static: self.friction_static,
            friction_dynamic: self.friction_dynamic,
            restitution: self.restitution,
        }
    }
}

impl FenderJson {
    fn def(&self, model: &ModelJson) -> Result<FenderDef<'_>, Problem> {
        let place = format!("fender `{}`", self.name);
        Ok(FenderDef {
            name: &self.name,
            body: model.body(&self.body, &place)?,
            position_m: point(self.position_m),
            facing_rad: self.facing_rad,
            width_m: self.width_m,
            projection_m: self.projection_m,
            law: self.curve.clone().map_or(FenderLaw::Area, FenderLaw::Curve),
            unloading: None,
            material: model.material(&self.material, &place)?,
            rated_deflection_m: self.rated_deflection_m,
            stop: self
                .stop
                .map(|stop| Stop { from_m: stop.from_m, stiffness_npm: stop.stiffness_npm }),
        })
    }
}

impl ModelJson {
    fn body(&self, name: &str, place: &str) -> Result<usize, Problem> {
        index("body", name, self.bodies.iter().map(|body| &*body.name), place)
    }

    fn material(&self, name: &str, place: &str) -> Result<usize, Problem> {
        index("material", name, self.materials.iter().map(|material| &*material.name), place)
    }
}

fn index<'n>(
    what: &str,
    name: &str,
    mut names: impl Iterator<Item = &'n str>,
    place: &str,
) -> Result<usize, Problem> {
    let found = names.position(|other| other == name);
    found.ok_or_else(|| {
        Problem::new("model", format_args!("{place}: in the model no {what} is named `{name}`"))
    })
}

fn point([x, y]: [f64; 2]) -> Vec2 {
    Vec2 { x, y }
}
