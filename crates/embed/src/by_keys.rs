//! Fenders by the keys of scenario files: catalogue fenders, panels on several cones, chains, face heights.

use std::fmt::Write as _;

use fenderline_contact::{Material, Vec2};
use fenderline_scenario::{Override, Scenario, ScenarioError};
use fenderline_sim::FenderSetup;

use crate::builder::{EngineBuilder, check_name};
use crate::error::EngineError;

impl EngineBuilder {
    /// Adds a fender by the keys of a scenario's `[fender.NAME]`, one `KEY=VALUE` a line. All keys of a fender in a
    /// scenario are allowed: type and size of a catalogue, temperature, cones of a panel, chains. The key `on` names
    /// the body that carries the fender, and `material` its material; body and material must have been added before.
    /// The values of the keys carry units, as in scenarios.
    ///
    /// ```
    /// # use fenderline_contact::{Material, vec2};
    /// # use fenderline_embed::*;
    /// # let mut builder = EngineBuilder::new();
    /// # builder.material("rubber", Material { stiffness_npm2: 500e3, damping_nspm2: 0.0,
    /// #     shear_stiffness_npm: 3e6, friction_static: 0.2, friction_dynamic: 0.2, restitution: 0.1 })?;
    /// let quay = [vec2(-5.0, -50.0), vec2(0.0, -50.0), vec2(0.0, 50.0), vec2(-5.0, 50.0)];
    /// builder.body(&BodyDef { name: "quay", outline_m: &quay, mass: None,
    ///     position_m: vec2(0.0, 0.0), heading_rad: 0.0 })?;
    /// builder.fender_by_keys("f1", "on=quay\nmaterial=rubber\ntype=cone\nsize=1050 F1.1\n\
    ///     position=[0, 12]\nwidth=2 m\ntemperature=40 degC")?;
    /// # Ok::<(), EngineError>(())
    /// ```
    ///
    /// # Errors
    /// Fails for a name that is empty or already used; for a body or material that does not exist; and for any mistake
    /// that the reader of scenarios finds, with its line. After an error no fender is added.
    pub fn fender_by_keys(&mut self, name: &str, keys: &str) -> Result<usize, EngineError> {
        let names = self.setup.fenders.iter().map(|other| other.name.as_str());
        check_name("fender", name, names)?;
        let shown = shown(name, "fender");
        let (mut on, mut material, mut changes) = (None, None, Vec::new());
        for line in keys.lines().map(str::trim).filter(|line| !line.is_empty()) {
            let (key, value) =
                line.split_once('=').map_or((line, ""), |(key, value)| (key.trim(), value.trim()));
            match key {
                "on" => on = Some(self.body_named(unquoted(value))?),
                "material" => material = Some(self.material_named(unquoted(value))?),
                _ => {
                    let path = format!("fender.{shown}.{key}");
                    changes.push(Override::new(line, &path, value).map_err(keys_error)?);
                }
            }
        }
        let missing = |key| EngineError::MissingKey { fender: name.to_owned(), key };
        let body = on.ok_or_else(|| missing("on"))?;
        let material = material.ok_or_else(|| missing("material"))?;
        let text = self.scenario_of(&shown, body, material);
        let scenario = Scenario::parse_with(&text, name, &changes).map_err(keys_error)?;
        let mut made = scenario.setup;
        let own = made.fenders.swap_remove(0);
        // The reader makes a separate material for a roller, from the material that the roller names.
        let material = match made.materials.get(own.material) {
            Some(of_roller) if own.material != 0 => {
                self.setup.materials.push(of_roller.clone());
                self.setup.materials.len() - 1
            }
            _ => material,
        };
        let about_fender = scenario.notices.iter().map(ToString::to_string);
        self.notices.extend(about_fender.filter(|notice| notice.contains("fender")));
        self.setup.fenders.push(FenderSetup { name: name.to_owned(), body, material, ..own });
        Ok(self.setup.fenders.len() - 1)
    }

    /// Text of a scenario with the body, the material and a fender to which the given keys are added.
    fn scenario_of(&self, fender: &str, body: usize, material: usize) -> String {
        let (body, material) = (&self.setup.bodies[body], &self.setup.materials[material]);
        let (carrier, rubber) = (shown(&body.name, "body"), shown(&material.name, "material"));
        let mut text =
            String::from("[time]\nstep = 1.0\nduration = 1.0\n[contact]\nmethod = \"coupled\"\n");
        let _ = writeln!(text, "[material.{rubber}]\n{}", material_keys(&material.material));
        let corner = |corner: &Vec2| format!("[{:?}, {:?}]", corner.x, corner.y);
        let corners: Vec<String> = body.outline.vertices().iter().map(corner).collect();
        let corners = corners.join(", ");
        let _ = writeln!(text, "[body.{carrier}]\nfixed = true\noutline = [{corners}]");
        let _ = writeln!(text, "[fender.{fender}]\non = \"{carrier}\"\nmaterial = \"{rubber}\"");
        text
    }
}

/// The numbers of a material, without those that [`EngineBuilder::build`] will refuse.
fn material_keys(m: &Material) -> String {
    let numbers = [
        ("stiffness", m.stiffness_npm2),
        ("damping", m.damping_nspm2),
        ("shear_stiffness", m.shear_stiffness_npm),
        ("friction_static", m.friction_static),
        ("friction_dynamic", m.friction_dynamic),
        ("restitution", m.restitution),
    ];
    let line = |(key, number): (&str, f64)| {
        let number = if number.is_finite() { number } else { 0.0 };
        format!("{key} = {number:?}")
    };
    numbers.map(line).join("\n")
}

/// The name of a fender, body or material, if TOML accepts it as a bare key; else a neutral name.
fn shown(name: &str, otherwise: &str) -> String {
    let is_bare = name.len() <= 60
        && name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-');
    if is_bare { name.to_owned() } else { otherwise.to_owned() }
}

/// Reads a value that may stand in quotes or not.
fn unquoted(value: &str) -> &str {
    let inner = |quote| value.strip_prefix(quote)?.strip_suffix(quote);
    inner('"').or_else(|| inner('\'')).unwrap_or(value)
}

fn keys_error(error: ScenarioError) -> EngineError {
    EngineError::Keys(Box::new(error))
}
