//! Simulates one step with a ship at a given place and motion, to find the forces that a run would have there.

use fenderline_scenario::Scenario;
use fenderline_sim::hydro::Mmg;
use fenderline_sim::{Setup, Simulation, VesselForces, VesselSetup};

/// A scenario whose first vessel the sweeps look at.
#[derive(Clone)]
pub(super) struct Stage {
    setup: Setup,
}

impl Stage {
    /// Reads a scenario from its text, with time steps so short that the ship hardly moves.
    ///
    /// # Panics
    /// Panics if the text cannot be read, which would be a bug.
    pub(super) fn of(text: &str) -> Stage {
        let text = format!("[time]\nstep = \"1 ms\"\nduration = \"1 s\"\n{text}");
        let scenario = Scenario::parse(&text, "sweep.toml");
        Stage { setup: scenario.unwrap_or_else(|e| panic!("the built-in {e}")).setup }
    }

    /// Her set-up.
    pub(super) fn vessel(&self) -> &VesselSetup {
        &self.setup.world.vessels[0]
    }

    /// The vessel's hull, propeller and rudder at a ratio of depth to draught.
    pub(super) fn at_depth_ratio(&self, ratio: f64) -> Mmg {
        let deep = &self.vessel().deep;
        deep.at_depth(ratio * deep.particulars.draught_m)
    }

    /// The forces on the vessel in the first step, after the set-up was changed.
    ///
    /// # Panics
    /// Panics if the set-up is refused, which would be a bug.
    pub(super) fn forces(&self, change: impl FnOnce(&mut Setup)) -> VesselForces {
        let mut setup = self.setup.clone();
        change(&mut setup);
        let mut simulation = Simulation::new(setup).expect("a good set-up");
        let record = simulation.step().expect("a good step");
        record.vessel_forces[0]
    }
}

/// The loaded tanker of 250,000 dwt of the worked examples of OCIMF's guidelines. The tanker has wind areas of her own;
/// all else about her is estimated.
pub(super) const TANKER: &str = r#"
[vessel.tanker]
length_bp = "329.3 m"
beam = "51.8 m"
draught = "19.2 m"
block_coefficient = 0.85
propeller = { diameter = "9 m", full = "90 rpm" }
rudder = { area = "110 m^2", span = "13 m" }

[body.ship]
vessel = "tanker"
outline = [[-165, -25.9], [140, -25.9], [165, 0], [140, 25.9], [-165, 25.9]]
"#;
