//! Box2D 3.2 as a peer in the benchmarks, in single precision and with its usual four sub-steps a step.

use std::marker::PhantomData;
use std::sync::{Mutex, MutexGuard, PoisonError};

use boxdd_sys::ffi::{
    b2Body_ApplyForceToCenter, b2Body_GetAngularVelocity, b2Body_GetContactCapacity,
    b2Body_GetContactData, b2Body_GetLinearVelocity, b2Body_GetPosition, b2Body_GetRotation,
    b2Body_SetAngularVelocity, b2Body_SetLinearVelocity, b2Body_SetMassData, b2Body_SetTransform,
    b2BodyId, b2BodyType, b2BodyType_b2_dynamicBody, b2BodyType_b2_staticBody, b2ComputeHull,
    b2ContactData, b2CreateBody, b2CreatePolygonShape, b2CreateWorld, b2DefaultBodyDef,
    b2DefaultShapeDef, b2DefaultWorldDef, b2DestroyWorld, b2MakePolygon, b2MassData, b2Rot, b2Vec2,
    b2World_Step, b2WorldId,
};

use crate::{Peer, PeerBody, PeerState};

/// Sub-steps that Box2D takes in a step, as its documents recommend.
const SUB_STEPS: i32 = 4;

/// A world of Box2D.
pub struct Box2d {
    world: b2WorldId,
    bodies: Vec<b2BodyId>,
    /// Each floating body: its number, and the steady force on the body.
    floating: Vec<(usize, b2BodyId, b2Vec2)>,
    step_s: f32,
    /// Makes Box2D's calls stay on one thread.
    _one_thread: PhantomData<*const ()>,
}

impl Peer for Box2d {
    fn new(bodies: &[PeerBody], step_s: f64) -> Box2d {
        let worlds = worlds();
        // SAFETY: the definition is Box2D's own, and lives through the call; no other thread makes or ends a world.
        let world = unsafe {
            let mut of_world = b2DefaultWorldDef();
            of_world.gravity = b2Vec2 { x: 0.0, y: 0.0 };
            of_world.enableSleep = false;
            b2CreateWorld(&raw const of_world)
        };
        drop(worlds);
        let ids: Vec<b2BodyId> = bodies.iter().map(|body| create(world, body)).collect();
        let floats = |index: &usize| bodies[*index].mass.is_some();
        let floating = (0..bodies.len()).filter(floats);
        let floating = floating.map(|index| (index, ids[index], vector(bodies[index].force_n)));
        let floating = floating.collect();
        let _one_thread = PhantomData;
        Box2d { world, bodies: ids, floating, step_s: step_s as f32, _one_thread }
    }

    fn set_state(&mut self, body: usize, state: PeerState) {
        put(self.bodies[body], state);
    }

    fn set_force(&mut self, body: usize, force_n: [f64; 2]) {
        if let Some(floating) = self.floating.iter_mut().find(|floating| floating.0 == body) {
            floating.2 = vector(force_n);
        }
    }

    fn state(&self, body: usize) -> PeerState {
        let id = self.bodies[body];
        // SAFETY: the body is one of this world, which lives.
        let (place, rotation, velocity, yaw_rate) = unsafe {
            (
                b2Body_GetPosition(id),
                b2Body_GetRotation(id),
                b2Body_GetLinearVelocity(id),
                b2Body_GetAngularVelocity(id),
            )
        };
        PeerState {
            position_m: [place.x.into(), place.y.into()],
            heading_rad: libm::atan2(rotation.s.into(), rotation.c.into()),
            velocity_mps: [velocity.x.into(), velocity.y.into()],
            yaw_rate_radps: yaw_rate.into(),
        }
    }

    fn step(&mut self) {
        for &(_, id, force) in &self.floating {
            // SAFETY: the body is one of this world, which lives.
            unsafe { b2Body_ApplyForceToCenter(id, force, false) };
        }
        // SAFETY: the world lives.
        unsafe { b2World_Step(self.world, self.step_s, SUB_STEPS) };
    }

    fn touching(&self) -> usize {
        // A contact between two floating bodies is in the lists of both.
        let twice: usize = self.bodies.iter().map(|&id| touching(id)).sum();
        twice / 2
    }
}

impl Drop for Box2d {
    fn drop(&mut self) {
        let _worlds = worlds();
        // SAFETY: the world lives, and nothing uses it afterwards; no other thread makes or ends a world.
        unsafe { b2DestroyWorld(self.world) };
    }
}

/// Box2D has one list of worlds in a process, so that only one thread at a time may make or end a world.
fn worlds() -> MutexGuard<'static, ()> {
    static WORLDS: Mutex<()> = Mutex::new(());
    WORLDS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Number of contacts of a body that have at least one contact point.
fn touching(id: b2BodyId) -> usize {
    // SAFETY: the body lives. The list has room for as many contacts as Box2D is told, and Box2D says how many of its
    // entries it has written.
    unsafe {
        let room = b2Body_GetContactCapacity(id);
        let mut contacts: Vec<b2ContactData> = Vec::with_capacity(room as usize);
        let count = b2Body_GetContactData(id, contacts.as_mut_ptr(), room);
        contacts.set_len(count as usize);
        contacts.iter().filter(|contact| contact.manifold.pointCount > 0).count()
    }
}

/// Puts a body at a position and heading, with a velocity and a yaw rate.
fn put(id: b2BodyId, state: PeerState) {
    let rotation =
        b2Rot { c: libm::cos(state.heading_rad) as f32, s: libm::sin(state.heading_rad) as f32 };
    // SAFETY: bodies live as long as their world, and are made and used by it alone.
    unsafe {
        b2Body_SetTransform(id, vector(state.position_m), rotation);
        b2Body_SetLinearVelocity(id, vector(state.velocity_mps));
        b2Body_SetAngularVelocity(id, state.yaw_rate_radps as f32);
    }
}

/// Makes a body with the position and motion that it has at the start.
fn create(world: b2WorldId, body: &PeerBody) -> b2BodyId {
    let corners: Vec<b2Vec2> = body.outline_m.iter().map(|&corner| vector(corner)).collect();
    let kind: b2BodyType = match body.mass {
        Some(_) => b2BodyType_b2_dynamicBody,
        None => b2BodyType_b2_staticBody,
    };
    // SAFETY: definitions are Box2D's own; they, corners and hull live through the calls.
    unsafe {
        let mut of_body = b2DefaultBodyDef();
        of_body.type_ = kind;
        of_body.enableSleep = false;
        let id = b2CreateBody(world, &raw const of_body);
        put(id, body.state);
        let hull = b2ComputeHull(corners.as_ptr(), corners.len() as i32);
        assert_eq!(hull.count as usize, corners.len(), "a convex outline");
        let polygon = b2MakePolygon(&raw const hull, 0.0);
        let mut of_shape = b2DefaultShapeDef();
        of_shape.material.friction = body.friction as f32;
        of_shape.material.restitution = body.restitution as f32;
        b2CreatePolygonShape(id, &raw const of_shape, &raw const polygon);
        if let Some([mass_kg, inertia_kgm2]) = body.mass {
            let mass = b2MassData {
                mass: mass_kg as f32,
                center: b2Vec2 { x: 0.0, y: 0.0 },
                rotationalInertia: inertia_kgm2 as f32,
            };
            b2Body_SetMassData(id, mass);
        }
        id
    }
}

fn vector([x, y]: [f64; 2]) -> b2Vec2 {
    b2Vec2 { x: x as f32, y: y as f32 }
}
