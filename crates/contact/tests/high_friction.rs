//! At friction 3 and above, many contacts did not converge. At a sliding contact the forces oscillated: each change of
//! the normal force changes friction, and friction presses the bodies together or apart.

#![allow(clippy::disallowed_methods, reason = "they give random input, not results")]

use fenderline_contact::*;

/// Random impacts of a bar on walls and on another bar: eccentric, slender, at any angle, at time steps up to 2 s.
/// Returns the number of steps that did not converge, and the number of steps with contact.
fn not_converged(friction: f64, hits: u64) -> (u32, u32) {
    let (mut not_converged, mut touching) = (0, 0);
    for hit in 0..hits {
        let mut random = Random(hit.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        let bar = |random: &mut Random| {
            let (half_m, beam_m) = (random.between(3.0, 60.0), random.between(1.0, 12.0));
            let ring = [
                vec2(-half_m, -beam_m),
                vec2(0.9 * half_m, -beam_m),
                vec2(half_m, 0.0),
                vec2(0.9 * half_m, beam_m),
                vec2(-half_m, beam_m),
            ];
            let mass_kg = 4.0 * half_m * beam_m * random.between(500.0, 8000.0);
            let gyradius_m = half_m * random.between(0.3, 0.6);
            let free =
                Mobility::Free { mass_kg, yaw_inertia_kgm2: mass_kg * gyradius_m * gyradius_m };
            (Outline::new(&ring).expect("a bar").0, free, half_m)
        };
        let ((one, one_free, one_m), (other, other_free, other_m)) =
            (bar(&mut random), bar(&mut random));
        let wall = [vec2(-200.0, 0.0), vec2(200.0, 0.0), vec2(200.0, 80.0), vec2(-200.0, 80.0)];
        let wall = Outline::new(&wall).expect("a wall").0;
        let masses = [one_free, other_free];
        let mut builder = Model::builder();
        let material = Material {
            stiffness_npm2: 10_f64.powf(random.between(4.5, 7.0)),
            damping_nspm2: 0.0,
            shear_stiffness_npm: 10_f64.powf(random.between(5.0, 8.0)),
            friction_static: friction,
            friction_dynamic: friction * random.between(0.8, 1.0),
            restitution: random.between(0.0, 0.4),
        };
        let material = builder.material(material);
        let body =
            |name: &str, key, outline, mobility| Body { name: name.into(), key, outline, mobility };
        let ids = [
            builder.body(body("one", 1, one, one_free)),
            builder.body(body("other", 2, other, other_free)),
            builder.body(body("wall", 3, wall, Mobility::Fixed)),
        ];
        for pair in [[ids[0], ids[1]], [ids[0], ids[2]], [ids[1], ids[2]]] {
            builder.pair(Pair { bodies: pair, material });
        }
        let model = builder.build().expect("a sound model");
        let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
        let mut states = vec![
            BodyState {
                position_m: vec2(random.between(-30.0, 30.0), -one_m - 1.0),
                heading_rad: random.between(-3.1, 3.1),
                velocity_mps: vec2(random.between(-3.0, 3.0), random.between(0.3, 3.0)),
                yaw_rate_radps: random.between(-0.1, 0.1),
            },
            BodyState {
                position_m: vec2(random.between(-30.0, 30.0), -2.0 * (one_m + other_m)),
                heading_rad: random.between(-3.1, 3.1),
                velocity_mps: vec2(random.between(-1.0, 1.0), random.between(1.0, 5.0)),
                yaw_rate_radps: random.between(-0.1, 0.1),
            },
            BodyState::default(),
        ];
        let step_s = [0.02, 0.1, 0.5, 2.0][hit as usize % 4];
        let loads = [Wrench::default(); 3];
        let kinetic_j = |states: &[BodyState]| {
            let of = |(state, mass): (&BodyState, &Mobility)| match mass {
                Mobility::Free { mass_kg, yaw_inertia_kgm2 } => {
                    0.5 * mass_kg * state.velocity_mps.length_squared()
                        + 0.5 * yaw_inertia_kgm2 * state.yaw_rate_radps * state.yaw_rate_radps
                }
                _ => 0.0,
            };
            states.iter().zip(&masses).map(of).sum::<f64>()
        };
        let start_j = kinetic_j(&states);
        for _ in 0..(40.0 / step_s) as u32 {
            if advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, step_s)
                .is_err()
            {
                panic!("hit {hit}");
            }
            let now_j = kinetic_j(&states);
            assert!(now_j <= start_j * (1.0 + 1e-9), "hit {hit}: {now_j} J of {start_j} J");
            touching += u32::from(!work.contacts().is_empty());
            let is_one = |event: &&Event| matches!(event.kind, EventKind::NotConverged);
            not_converged += work.events().iter().filter(is_one).count() as u32;
        }
    }
    (not_converged, touching)
}

/// Formerly the sweeps did not take into account that friction follows the normal force. Of 66,799 steps with contact,
/// 1,614 did not converge at friction 1, and 30,378 at friction 3.
#[test]
fn high_friction_converges() {
    for friction in [0.7, 1.0, 2.0, 3.0, 10.0] {
        let (not_converged, touching) = not_converged(friction, 120);
        println!(
            "friction {friction}: {not_converged} not converged in {touching} steps with contact"
        );
        // In the remaining cases several contacts of one body wedge it.
        let most = if friction > 1.5 { touching / 500 } else { 0 };
        assert!(not_converged <= most, "friction {friction}: {not_converged} in {touching}");
    }
}

struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}
