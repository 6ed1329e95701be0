//! What a bench asks of each engine that plays a scene.

use fenderline_contact::{BodyState, Vec2};

/// A scene within an engine; the engine moves the bodies, or the host does in the same step where the engine only gives
/// forces.
pub trait World {
    /// Goes back to the moment one step after the scene's start, with warm buffers.
    fn restart(&mut self);

    /// One step of all.
    fn step(&mut self);

    /// Sets a new steady load on a body.
    fn load(&mut self, body: usize, force_n: Vec2);

    /// The present state of a body.
    fn state(&self, body: usize) -> BodyState;

    /// Number of pairs in contact in the last step's solve.
    fn touching(&self) -> usize;

    /// Largest normal force (N) and depth (m) within the last step; `None` where the engine does not tell them.
    fn peaks(&self) -> Option<(f64, f64)>;
}
