//! rapier2d-f64 playing a scene with its usual settings, but for gravity and sleep, which are off.

use fenderline_contact::{BodyState, ConvexPolygon, Outline, Vec2, vec2};
use rapier2d_f64::prelude::{
    ColliderBuilder, MassProperties, PhysicsWorld, Pose, RigidBodyBuilder, RigidBodyHandle,
    SharedShape, Vector,
};

use fenderline_bench_scenes::scenes::{Part, Plan};
use fenderline_bench_scenes::world::World;

/// A scene in rapier2d-f64.
pub(crate) struct Rapier {
    world: PhysicsWorld,
    handles: Vec<RigidBodyHandle>,
    /// The floating bodies, and the state of each at the start.
    floaters: Vec<(RigidBodyHandle, BodyState)>,
}

impl Rapier {
    pub(crate) fn new(plan: &Plan, step_s: f64) -> Rapier {
        let mut world = PhysicsWorld { gravity: Vector::ZERO, ..PhysicsWorld::default() };
        world.integration_parameters.dt = step_s;
        let mut handles = Vec::new();
        let mut floaters = Vec::new();
        for part in &plan.parts {
            let collider = collider(&part.outline_m)
                .density(0.0)
                .friction(plan.material.friction_static)
                .restitution(plan.material.restitution);
            let (handle, _) = world.insert(body(part), collider);
            world.bodies[handle].add_force(vector(part.load.force_n), true);
            handles.push(handle);
            if part.mass.is_some() {
                floaters.push((handle, part.state));
            }
        }
        Rapier { world, handles, floaters }
    }
}

impl World for Rapier {
    fn restart(&mut self) {
        for &(handle, state) in &self.floaters {
            let body = &mut self.world.bodies[handle];
            body.set_position(pose(state), true);
            body.set_linvel(vector(state.velocity_mps), true);
            body.set_angvel(state.yaw_rate_radps, true);
        }
        self.world.step();
    }

    fn step(&mut self) {
        self.world.step();
    }

    fn load(&mut self, body: usize, force_n: Vec2) {
        let body = &mut self.world.bodies[self.handles[body]];
        body.reset_forces(true);
        body.add_force(vector(force_n), true);
    }

    fn state(&self, body: usize) -> BodyState {
        let body = &self.world.bodies[self.handles[body]];
        let (place, velocity) = (body.translation(), body.linvel());
        BodyState {
            position_m: vec2(place.x, place.y),
            heading_rad: body.rotation().angle(),
            velocity_mps: vec2(velocity.x, velocity.y),
            yaw_rate_radps: body.angvel(),
        }
    }

    fn touching(&self) -> usize {
        let pairs = self.world.narrow_phase.contact_pairs();
        pairs.filter(|pair| pair.has_any_active_contact()).count()
    }

    fn peaks(&self) -> Option<(f64, f64)> {
        None
    }
}

/// The shape of a body: one convex shape, or for an outline that is not convex a compound of the pieces that our engine
/// cuts it into.
fn collider(outline_m: &[Vec2]) -> ColliderBuilder {
    let outline = Outline::new(outline_m).expect("the scenes' outlines are sound").0;
    let shape = |piece: &[Vec2]| {
        SharedShape::convex_polyline_unmodified(points(piece)).expect("a convex piece")
    };
    match outline.pieces() {
        [_] => ColliderBuilder::convex_polyline(points(outline_m)).expect("it is convex"),
        pieces => ColliderBuilder::compound(
            pieces
                .iter()
                .map(|piece| (Pose::IDENTITY, shape(ConvexPolygon::new(piece).vertices())))
                .collect(),
        ),
    }
}

fn body(part: &Part) -> RigidBodyBuilder {
    let builder =
        match part.mass {
            None => RigidBodyBuilder::fixed(),
            Some(mass) => RigidBodyBuilder::dynamic().additional_mass_properties(
                MassProperties::new(Vector::ZERO, mass.mass_kg, mass.yaw_inertia_kgm2),
            ),
        };
    builder
        .pose(pose(part.state))
        .linvel(vector(part.state.velocity_mps))
        .angvel(part.state.yaw_rate_radps)
        .can_sleep(false)
}

fn pose(state: BodyState) -> Pose {
    Pose::new(vector(state.position_m), state.heading_rad)
}

fn vector(v: Vec2) -> Vector {
    Vector::new(v.x, v.y)
}

fn points(outline_m: &[Vec2]) -> Vec<Vector> {
    outline_m.iter().map(|&v| vector(v)).collect()
}
