//! The broad phase, compared with a test of every pair. The contacts are the same, bit for bit.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

use crate::support;

use fenderline_contact::{Body, BodyState, vec2};
use support::harbour::{PAPER, Run, body, model, model_of_explicit_pairs};
use support::shapes::{ellipse, hull, points, rectangle};

/// Pseudo-random numbers in [0, 1) (xorshift64).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

fn some_bodies(numbers: &mut Numbers, count: u64) -> Vec<Body> {
    let anchor = points(&[
        (0.0, -8.0),
        (3.0, -8.0),
        (3.0, 8.0),
        (0.0, 8.0),
        (0.0, 6.0),
        (2.0, 0.0),
        (0.0, -6.0),
    ]);
    let shapes = [rectangle(4.0, 2.0), hull(30.0, 9.0, 12), ellipse(12.0, 5.0, 20, &[]), anchor];
    (0..count)
        .map(|i| {
            let shape = &shapes[(numbers.next() * shapes.len() as f64) as usize];
            body((i * 7919) % 1009, shape, numbers.next() < 0.8)
        })
        .collect()
}

#[test]
fn all_other_pairs_find_the_contacts_of_explicit_pairs() {
    let mut numbers = Numbers(0x2545_f491_4f6c_dd1d);
    let bodies = some_bodies(&mut numbers, 300);
    let mut states: Vec<BodyState> = bodies
        .iter()
        .map(|b| {
            let pace = if b.mobility == fenderline_contact::Mobility::Fixed { 0.0 } else { 3.0 };
            BodyState {
                position_m: vec2(numbers.between(-120.0, 120.0), numbers.between(-120.0, 120.0)),
                heading_rad: numbers.between(0.0, 6.3),
                velocity_mps: vec2(numbers.between(-pace, pace), numbers.between(-pace, pace)),
                yaw_rate_radps: numbers.between(-0.1, 0.1) * pace,
            }
        })
        .collect();
    let mut swept = Run::new(model(bodies.clone(), PAPER));
    let mut paired = Run::new(model_of_explicit_pairs(bodies, PAPER));
    let mut touching = 0;
    for step in 0..200 {
        let (one, two) = (swept.step(&states, 0.1), paired.step(&states, 0.1));
        assert_eq!(one, two, "step {step}");
        assert_eq!(swept.work.wrenches(), paired.work.wrenches(), "step {step}");
        assert_eq!(swept.work.events(), paired.work.events(), "step {step}");
        touching += one.len();
        for state in &mut states {
            state.position_m += state.velocity_mps * 0.1;
            state.heading_rad += state.yaw_rate_radps * 0.1;
            // At times the body is teleported back from the far end.
            if state.position_m.x.abs() > 140.0 {
                state.position_m.x = -state.position_m.x.clamp(-120.0, 120.0);
            }
            if state.position_m.y.abs() > 140.0 {
                state.position_m.y = -state.position_m.y.clamp(-120.0, 120.0);
            }
        }
    }
    assert!(touching > 10_000, "{touching}");
}
