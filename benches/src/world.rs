//! The engines that play the scenes.

#[cfg(feature = "peers")]
use fenderline_bench_peers::{Box2d, Chipmunk};
use fenderline_bench_scenes::engine::Variant;
use fenderline_bench_scenes::scenes::Plan;
use fenderline_bench_scenes::world::World;

#[cfg(feature = "peers")]
use crate::c_engines;
use crate::rapier::Rapier;

/// The engines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Engine {
    /// Ours.
    Own(Variant),
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
    pub(crate) const ALL: [Engine; 3] =
        [Engine::Own(Variant::Coupled), Engine::Own(Variant::Paper), Engine::Rapier];

    /// The variants of our engine, which differ in the time they take.
    pub(crate) const OURS: [Engine; 4] = [
        Engine::Own(Variant::Coupled),
        Engine::Own(Variant::CoupledBrief),
        Engine::Own(Variant::Paper),
        Engine::Own(Variant::PaperBrief),
    ];

    /// Whether the engine is ours by the paper's method.
    pub(crate) fn is_paper(self) -> bool {
        matches!(self, Engine::Own(Variant::Paper | Variant::PaperBrief))
    }

    /// The peers in this build, of which rapier2d is the first.
    #[cfg(feature = "peers")]
    pub(crate) const PEERS: &[Engine] = &[Engine::Rapier, Engine::Box2d, Engine::Chipmunk];
    #[cfg(not(feature = "peers"))]
    pub(crate) const PEERS: &[Engine] = &[Engine::Rapier];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Engine::Own(variant) => variant.name(),
            Engine::Rapier => "rapier2d",
            #[cfg(feature = "peers")]
            Engine::Box2d => "Box2D",
            #[cfg(feature = "peers")]
            Engine::Chipmunk => "Chipmunk",
        }
    }

    pub(crate) fn world(self, plan: &Plan, step_s: f64) -> Box<dyn World> {
        match self {
            Engine::Own(variant) => Box::new(variant.world(plan, step_s)),
            Engine::Rapier => Box::new(Rapier::new(plan, step_s)),
            #[cfg(feature = "peers")]
            Engine::Box2d => c_engines::world::<Box2d>(plan, step_s),
            #[cfg(feature = "peers")]
            Engine::Chipmunk => c_engines::world::<Chipmunk>(plan, step_s),
        }
    }
}
