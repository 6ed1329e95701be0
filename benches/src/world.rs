//! What a bench asks of each engine that plays a scene.

#[cfg(feature = "peers")]
use fenderline_bench_peers::{Box2d, Chipmunk};
use fenderline_contact::{BodyState, Vec2};

#[cfg(feature = "peers")]
use crate::c_engines;
use crate::engine::{Method, Ours};
use crate::rapier::Rapier;
use crate::scenes::Plan;

/// A scene within an engine; the engine moves the bodies, or the host does in the same step where the engine only gives
/// forces.
pub(crate) trait World {
    /// Goes back to the moment one step after the scene's start, with warm buffers.
    fn restart(&mut self);

    /// One step of all.
    fn step(&mut self);

    /// Sets a new steady load on a body.
    fn load(&mut self, body: usize, force_n: Vec2);

    fn state(&self, body: usize) -> BodyState;

    /// Number of pairs in contact in the last step's solve.
    fn touching(&self) -> usize;

    /// Largest normal force (N) and depth (m) within the last step; `None` where the engine does not tell them.
    fn peaks(&self) -> Option<(f64, f64)>;
}

/// The engines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Engine {
    /// Ours, the default.
    Coupled,
    /// Our engine by the coupled method without a report of each contact: only wrenches and motions, as rapier2d gives
    /// them.
    CoupledBrief,
    /// Our engine by the paper's method, with forward Euler.
    Paper,
    /// Our engine by the paper's method without a report of each contact.
    PaperBrief,
    /// rapier2d-f64.
    Rapier,
    /// Box2D 3.2, in single precision.
    #[cfg(feature = "peers")]
    Box2d,
    /// Chipmunk 7.
    #[cfg(feature = "peers")]
    Chipmunk,
}

impl Engine {
    /// The engines that the accuracy table compares.
    pub(crate) const ALL: [Engine; 3] = [Engine::Coupled, Engine::Paper, Engine::Rapier];

    /// The variants of our engine, which differ in the time they take.
    pub(crate) const OURS: &[Engine] =
        &[Engine::Coupled, Engine::CoupledBrief, Engine::Paper, Engine::PaperBrief];

    /// Whether the engine is ours by the paper's method.
    pub(crate) fn is_paper(self) -> bool {
        matches!(self, Engine::Paper | Engine::PaperBrief)
    }

    /// The peers in this build, of which rapier2d is the first.
    #[cfg(feature = "peers")]
    pub(crate) const PEERS: &[Engine] = &[Engine::Rapier, Engine::Box2d, Engine::Chipmunk];
    #[cfg(not(feature = "peers"))]
    pub(crate) const PEERS: &[Engine] = &[Engine::Rapier];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Engine::Coupled => "coupled",
            Engine::CoupledBrief => "coupled-brief",
            Engine::Paper => "paper",
            Engine::PaperBrief => "paper-brief",
            Engine::Rapier => "rapier2d",
            #[cfg(feature = "peers")]
            Engine::Box2d => "Box2D",
            #[cfg(feature = "peers")]
            Engine::Chipmunk => "Chipmunk",
        }
    }

    pub(crate) fn world(self, plan: &Plan, step_s: f64) -> Box<dyn World> {
        match self {
            Engine::Coupled => Box::new(Ours::new(plan, Method::Coupled, step_s)),
            Engine::CoupledBrief => Box::new(Ours::new(plan, Method::Coupled, step_s).brief()),
            Engine::Paper => Box::new(Ours::new(plan, Method::Paper, step_s)),
            Engine::PaperBrief => Box::new(Ours::new(plan, Method::Paper, step_s).brief()),
            Engine::Rapier => Box::new(Rapier::new(plan, step_s)),
            #[cfg(feature = "peers")]
            Engine::Box2d => c_engines::world::<Box2d>(plan, step_s),
            #[cfg(feature = "peers")]
            Engine::Chipmunk => c_engines::world::<Chipmunk>(plan, step_s),
        }
    }
}
