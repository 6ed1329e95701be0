//! The physics engines Box2D 3.2 and Chipmunk 7 behind one small, safe interface, for the benchmarks alone.
//!
//! Box2D is built from its sources by the crate `boxdd-sys`. Chipmunk is the library of the system (`libchipmunk-dev`
//! of Debian, which has Chipmunk's run-time checks on): no crate that builds Chipmunk from its sources compiles with
//! today's C library. A Chipmunk that was built without run-time checks is linked by `RUSTFLAGS="-L FOLDER"`.
//!
//! Box2D and Chipmunk run with their usual settings, but for gravity and sleep, which are off. This crate is the only
//! one outside the interfaces of C and of FMI that has `unsafe` code.

mod box2d;
mod chipmunk;

pub use box2d::Box2d;
pub use chipmunk::Chipmunk;

/// A convex body.
#[derive(Clone, Debug)]
pub struct PeerBody {
    /// Outline of the body in the body's frame, in the positive sense, at most eight corners (m).
    pub outline_m: Vec<[f64; 2]>,
    /// Mass (kg) and yaw inertia (kg·m²) of the body about the origin of its frame; `None` if the body is fixed.
    pub mass: Option<[f64; 2]>,
    /// Position and motion of the body at the start.
    pub state: PeerState,
    /// Steady force on the body at the origin of its frame, in earth-fixed axes (N).
    pub force_n: [f64; 2],
    /// Coefficient of friction.
    pub friction: f64,
    /// Coefficient of restitution.
    pub restitution: f64,
}

/// Where a body is and how it moves, in earth-fixed axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PeerState {
    /// Position of the origin of the body's frame (m).
    pub position_m: [f64; 2],
    /// Heading of the body, turning from x to y (rad).
    pub heading_rad: f64,
    /// Velocity of the origin of the body's frame (m/s).
    pub velocity_mps: [f64; 2],
    /// Yaw rate (rad/s).
    pub yaw_rate_radps: f64,
}

/// A world of bodies that a physics engine moves. Bodies are counted in the order in which they were given to the
/// world.
pub trait Peer {
    /// Makes a world of `bodies`, placed as they are at the start, with steps of `step_s` seconds.
    ///
    /// # Panics
    /// Panics if the outline of a body is not convex.
    fn new(bodies: &[PeerBody], step_s: f64) -> Self
    where
        Self: Sized;

    /// Puts a body at a position and heading, with a velocity and a yaw rate.
    fn set_state(&mut self, body: usize, state: PeerState);

    /// Sets the steady force on a body anew (N). A fixed body has no steady force.
    fn set_force(&mut self, body: usize, force_n: [f64; 2]);

    /// The present position and motion of a body.
    fn state(&self, body: usize) -> PeerState;

    /// Moves the world on by one step. Box2D and Chipmunk forget the forces on bodies after each step, so this function
    /// sets the forces again.
    fn step(&mut self);

    /// Pairs in contact.
    fn touching(&self) -> usize;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A barge of 20 × 10 m, 0.1 m off a quay, pushed on it.
    fn barge_and_quay() -> [PeerBody; 2] {
        let block = |x: f64, y: f64| vec![[-x, -y], [x, -y], [x, y], [-x, y]];
        let barge = PeerBody {
            outline_m: block(10.0, 5.0),
            mass: Some([1e6, 4e7]),
            state: PeerState { velocity_mps: [0.0, 0.2], ..PeerState::default() },
            force_n: [0.0, 1e5],
            friction: 0.5,
            restitution: 0.0,
        };
        let quay = PeerBody {
            outline_m: block(50.0, 5.0),
            mass: None,
            state: PeerState { position_m: [0.0, 10.1], ..PeerState::default() },
            force_n: [0.0; 2],
            ..barge.clone()
        };
        [barge, quay]
    }

    #[test]
    fn box2d_lays_a_barge_alongside() {
        let mut world = Box2d::new(&barge_and_quay(), 0.1);
        (0..200).for_each(|_| world.step());
        let PeerState { position_m: [x, y], heading_rad, .. } = world.state(0);
        assert!(x.abs() < 0.01 && (y - 0.1).abs() < 0.05 && heading_rad.abs() < 1e-3, "{x} {y}");
        assert_eq!(world.touching(), 1);
    }

    #[test]
    fn chipmunk_lays_a_barge_alongside() {
        let mut world = Chipmunk::new(&barge_and_quay(), 0.1);
        (0..200).for_each(|_| world.step());
        let PeerState { position_m: [x, y], heading_rad, .. } = world.state(0);
        // It lets bodies overlap by 0.1 m ("collision slop").
        assert!(x.abs() < 0.01 && (y - 0.1).abs() < 0.15 && heading_rad.abs() < 1e-3, "{x} {y}");
        assert_eq!(world.touching(), 1);
    }

    #[test]
    fn a_free_body_moves_by_its_force_alone() {
        let [mut barge, _] = barge_and_quay();
        barge.state = PeerState::default();
        let bodies = [barge];
        let (mut box2d, mut chipmunk) = (Box2d::new(&bodies, 0.1), Chipmunk::new(&bodies, 0.1));
        for _ in 0..100 {
            box2d.step();
            chipmunk.step();
        }
        // 0.1 m/s² for 10 s.
        let [by_box2d, by_chipmunk] =
            [box2d.state(0), chipmunk.state(0)].map(|s| s.velocity_mps[1]);
        assert!((by_box2d - 1.0).abs() < 1e-5, "{by_box2d}");
        assert!((by_chipmunk - 1.0).abs() < 1e-12, "{by_chipmunk}");
    }
}
