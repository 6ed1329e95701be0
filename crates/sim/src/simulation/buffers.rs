//! Arrays of one simulation that are reused from step to step.

use fenderline_contact::{BodyState, Contact, Memory, Model, Vec2, Workspace, Wrench};

use crate::integrate::Rate;
use fenderline_world::mean_velocity::MeanVelocity;
use fenderline_world::world::WorldBackup;

/// Most lists in these buffers have one entry per body.
#[derive(Clone, Debug)]
pub(super) struct Buffers {
    /// All loads except contact.
    pub(super) loads: Vec<Wrench>,
    /// The part of `loads` that the set-up and the host program give, without the forces of vessels, tugs, lines and
    /// anchors.
    pub(super) plain_loads: Vec<Wrench>,
    /// The wrench that turns a body's momentum with the body over the step, if the engine does not do so.
    pub(super) turning: Vec<Wrench>,
    /// Wrenches given by [`super::Simulation::set_external`].
    pub(super) external: Vec<Wrench>,
    /// Sum of the wrenches that move each body.
    pub(super) sums: Vec<Wrench>,
    /// Rates of change of the bodies' states in the Runge–Kutta stages.
    pub(super) rates: [Vec<Rate>; 4],
    /// States of the bodies in a Runge–Kutta stage.
    pub(super) trial: Vec<BodyState>,
    /// States before the step.
    pub(super) before: Vec<BodyState>,
    /// How far the velocities of the contact engine lag behind the positions (s).
    pub(super) lags_s: Vec<f64>,
    /// Mean velocities of the bodies over the step.
    pub(super) mean: Vec<MeanVelocity>,
    /// Velocity of the current at each body (m/s).
    pub(super) currents_mps: Vec<Vec2>,
    /// Contacts of Runge–Kutta stages 2 to 4.
    pub(super) stage_contacts: [Vec<Contact>; 3],
    /// Contact memory of a Runge–Kutta stage.
    pub(super) stage_memory: Memory,
    /// Contact workspace of a Runge–Kutta stage.
    pub(super) stage_work: Workspace,
    /// The contact memory before the step, restored if a later Runge–Kutta stage fails.
    pub(super) backup: Memory,
    /// The state of vessels, tugs, lines and anchors before the step, restored if the step fails.
    pub(super) world: WorldBackup,
}

impl Buffers {
    pub(super) fn new(model: &Model, states: &[BodyState], memory: &Memory) -> Buffers {
        let count = states.len();
        let zero = || vec![Wrench::default(); count];
        Buffers {
            loads: zero(),
            plain_loads: zero(),
            turning: zero(),
            external: zero(),
            sums: zero(),
            rates: std::array::from_fn(|_| vec![Rate::default(); count]),
            trial: states.to_vec(),
            before: states.to_vec(),
            lags_s: vec![0.0; count],
            mean: vec![MeanVelocity::default(); count],
            currents_mps: vec![Vec2::ZERO; count],
            stage_contacts: Default::default(),
            stage_memory: memory.clone(),
            stage_work: Workspace::new(model),
            backup: memory.clone(),
            world: WorldBackup::default(),
        }
    }
}
