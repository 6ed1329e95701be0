//! Chipmunk 7 as a peer in the benchmarks, in double precision and with its usual ten iterations a step.

use std::ffi::{c_int, c_void};

use crate::{Peer, PeerBody, PeerState};

/// `cpVect`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
struct Vector {
    x: f64,
    y: f64,
}

type Space = *mut c_void;
type Body = *mut c_void;
type Shape = *mut c_void;
type Arbiter = *mut c_void;

// As in `chipmunk.h` of 7.0.3, whose `cpFloat` is `double`.
#[link(name = "chipmunk")]
unsafe extern "C" {
    fn cpSpaceNew() -> Space;
    fn cpSpaceFree(space: Space);
    fn cpSpaceStep(space: Space, dt: f64);
    fn cpSpaceAddBody(space: Space, body: Body) -> Body;
    fn cpSpaceAddShape(space: Space, shape: Shape) -> Shape;
    fn cpBodyNew(mass: f64, moment: f64) -> Body;
    fn cpBodyNewStatic() -> Body;
    fn cpBodyFree(body: Body);
    fn cpBodySetPosition(body: Body, position: Vector);
    fn cpBodySetAngle(body: Body, angle: f64);
    fn cpBodySetVelocity(body: Body, velocity: Vector);
    fn cpBodySetAngularVelocity(body: Body, angular_velocity: f64);
    fn cpBodySetForce(body: Body, force: Vector);
    fn cpBodyGetPosition(body: Body) -> Vector;
    fn cpBodyGetAngle(body: Body) -> f64;
    fn cpBodyGetVelocity(body: Body) -> Vector;
    fn cpBodyGetAngularVelocity(body: Body) -> f64;
    fn cpBodyEachArbiter(
        body: Body,
        each: extern "C" fn(Body, Arbiter, *mut c_void),
        data: *mut c_void,
    );
    fn cpArbiterGetCount(arbiter: Arbiter) -> c_int;
    fn cpPolyShapeNewRaw(body: Body, count: c_int, corners: *const Vector, radius: f64) -> Shape;
    fn cpShapeFree(shape: Shape);
    fn cpShapeSetFriction(shape: Shape, friction: f64);
    fn cpShapeSetElasticity(shape: Shape, elasticity: f64);
}

/// A space of Chipmunk.
pub struct Chipmunk {
    space: Space,
    bodies: Vec<Body>,
    shapes: Vec<Shape>,
    /// Each floating body: its number, and the steady force on the body.
    floating: Vec<(usize, Body, Vector)>,
    step_s: f64,
}

impl Peer for Chipmunk {
    fn new(bodies: &[PeerBody], step_s: f64) -> Chipmunk {
        // SAFETY: it takes nothing. Gravity is 0 and sleep off, as it comes.
        let space = unsafe { cpSpaceNew() };
        let floats = |index: &usize| bodies[*index].mass.is_some();
        let made: Vec<(Body, Shape)> = bodies.iter().map(|body| create(space, body)).collect();
        let floating = (0..bodies.len()).filter(floats);
        let floating = floating.map(|index| (index, made[index].0, vector(bodies[index].force_n)));
        let floating = floating.collect();
        let (bodies, shapes) = made.into_iter().unzip();
        Chipmunk { space, bodies, shapes, floating, step_s }
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
        let body = self.bodies[body];
        // SAFETY: the body is one of this space, which lives.
        let (place, angle, velocity, angular) = unsafe {
            (
                cpBodyGetPosition(body),
                cpBodyGetAngle(body),
                cpBodyGetVelocity(body),
                cpBodyGetAngularVelocity(body),
            )
        };
        PeerState {
            position_m: [place.x, place.y],
            heading_rad: angle,
            velocity_mps: [velocity.x, velocity.y],
            yaw_rate_radps: angular,
        }
    }

    fn step(&mut self) {
        for &(_, body, force) in &self.floating {
            // SAFETY: the body is one of this space, which lives.
            unsafe { cpBodySetForce(body, force) };
        }
        // SAFETY: the space lives.
        unsafe { cpSpaceStep(self.space, self.step_s) };
    }

    fn touching(&self) -> usize {
        // A contact is in the lists of both its bodies.
        let mut twice = 0_usize;
        for &body in &self.bodies {
            // SAFETY: the body lives, and `count` is called with this counter alone, before the call returns.
            unsafe { cpBodyEachArbiter(body, count, (&raw mut twice).cast()) };
        }
        twice / 2
    }
}

extern "C" fn count(_: Body, arbiter: Arbiter, counter: *mut c_void) {
    // SAFETY: Chipmunk calls it from `cpBodyEachArbiter` alone, with a contact that lives and the counter of
    // `Chipmunk::touching`.
    unsafe { *counter.cast::<usize>() += usize::from(cpArbiterGetCount(arbiter) > 0) };
}

impl Drop for Chipmunk {
    fn drop(&mut self) {
        // SAFETY: shapes, bodies and space live, and nothing uses them afterwards. `cpSpaceFree` does not touch them.
        unsafe {
            cpSpaceFree(self.space);
            self.shapes.iter().for_each(|&shape| cpShapeFree(shape));
            self.bodies.iter().for_each(|&body| cpBodyFree(body));
        }
    }
}

/// Puts a body at a position and heading, with a velocity and a yaw rate.
fn put(body: Body, state: PeerState) {
    // SAFETY: bodies live as long as their space, and are made and used by it alone.
    unsafe {
        cpBodySetPosition(body, vector(state.position_m));
        cpBodySetAngle(body, state.heading_rad);
        cpBodySetVelocity(body, vector(state.velocity_mps));
        cpBodySetAngularVelocity(body, state.yaw_rate_radps);
    }
}

/// Makes a body with the position and motion that it has at the start. The body is put at its place before its shape is
/// added: thousands of shapes at one place would all be candidate pairs for contact.
fn create(space: Space, body: &PeerBody) -> (Body, Shape) {
    let corners: Vec<Vector> = body.outline_m.iter().map(|&corner| vector(corner)).collect();
    // SAFETY: space, body and shape live; the corners live through the call, which copies them.
    unsafe {
        let made = match body.mass {
            Some([mass_kg, inertia_kgm2]) => cpBodyNew(mass_kg, inertia_kgm2),
            None => cpBodyNewStatic(),
        };
        put(made, body.state);
        cpSpaceAddBody(space, made);
        let shape = cpPolyShapeNewRaw(made, corners.len() as c_int, corners.as_ptr(), 0.0);
        cpShapeSetFriction(shape, body.friction);
        cpShapeSetElasticity(shape, body.restitution);
        cpSpaceAddShape(space, shape);
        (made, shape)
    }
}

fn vector([x, y]: [f64; 2]) -> Vector {
    Vector { x, y }
}
