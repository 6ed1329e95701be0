//! The outputs of an engine FMU and of a simulation FMU, which are read after a step.

use fenderline_contact::Contact;
use fenderline_contact::number::greater;
use fenderline_results::FENDERS;
use fenderline_sim::{PairSetup, Setup};

use crate::table::{Causality, Class, Output, StandsFor, Table, Variable};
use crate::unit::Unit;
use crate::view::View;

type Read = fn(&View<'_>, [usize; 2]) -> f64;
/// An output: its name, description and unit, and the function that reads its value.
type Column<'a> = (&'a str, &'a str, Unit, Read);

fn add(table: &mut Table, stem: &str, of: [usize; 2], columns: &[Column<'_>]) -> Vec<usize> {
    let add = |&(name, description, unit, read): &Column<'_>| {
        table.add(Variable {
            name: if stem.is_empty() { name.to_owned() } else { format!("{stem}.{name}") },
            description: description.to_owned(),
            unit,
            class: Class::Real,
            causality: Causality::Output,
            start: 0.0,
            range: None,
            stands_for: StandsFor::Output(Output { of, read }),
        })
    };
    columns.iter().map(add).collect()
}

/// Adds the outputs for contact: the wrench on each body, and forces at each fender and at each pair of outlines that
/// may touch.
pub(crate) fn add_contact(table: &mut Table, setup: &Setup) {
    use Unit::{Joule, Metre, Newton, NewtonMetre, One, Radian, SquareMetre};
    let columns: [Column<'_>; 3] = [
        (
            "force_x_n",
            "mean contact force on the body to the north; forward if host.body_fixed is true",
            Newton,
            |v, [b, _]| v.wrench(b).force_n.x,
        ),
        (
            "force_y_n",
            "mean contact force on the body to the east; to starboard if host.body_fixed is true",
            Newton,
            |v, [b, _]| v.wrench(b).force_n.y,
        ),
        (
            "moment_z_nm",
            "moment of the contact forces about the body's centre of gravity, positive to starboard",
            NewtonMetre,
            |v, [b, _]| v.wrench(b).moment_nm,
        ),
    ];
    for (index, body) in setup.bodies.iter().enumerate() {
        let places = add(table, &format!("body.{}", body.name), [index, 0], &columns);
        table.group("Force", format!("{}.contact", body.name), &places[..2]);
        table.group("Torque", format!("{}.contact_moment", body.name), &places[2..]);
    }
    let columns: [Column<'_>; 6] = [
        (
            "deflection_m",
            "deflection of the fender at the start of the step",
            Metre,
            |v, [f, _]| v.on_fender(f).fold(0.0, |most, c| greater(most, c.depth_m)),
        ),
        (
            "reaction_n",
            "mean reaction of the fender along its axis over the step",
            Newton,
            |v, [f, _]| {
                v.on_fender(f).fold(0.0, |sum, c| sum + c.normal_force_n * libm::cos(c.tilt_rad))
            },
        ),
        (
            "peak_reaction_n",
            "largest reaction of the fender along its axis within the step",
            Newton,
            |v, [f, _]| {
                let along = |c: &Contact| c.peak_normal_force_n * libm::cos(c.tilt_rad);
                v.on_fender(f).fold(0.0, |sum, c| sum + along(c))
            },
        ),
        ("tangential_force_n", "friction force along the fender's face", Newton, |v, [f, _]| {
            v.on_fender(f).fold(0.0, |sum, c| sum + c.tangential_force_n)
        }),
        (
            "stored_j",
            "energy stored in the fender's spring and stop at the start of the step",
            Joule,
            |v, [f, _]| v.on_fender(f).fold(0.0, |sum, c| sum + c.energy.stored_j),
        ),
        (
            "tilt_rad",
            "largest angle between the fender's face and the hull",
            Radian,
            |v, [f, _]| v.on_fender(f).fold(0.0, |most, c| greater(most, c.tilt_rad.abs())),
        ),
    ];
    for (index, fender) in setup.fenders.iter().enumerate() {
        add(table, &format!("fender.{}", fender.name), [index, 0], &columns);
    }
    let columns: [Column<'_>; 6] = [
        ("patches", "number of contact patches of the two bodies", One, |v, pair| {
            v.of_pair(pair).count() as f64
        }),
        (
            "normal_force_n",
            "sum of the pressing normal forces between the two bodies, a mean over the step",
            Newton,
            |v, pair| v.of_pair(pair).fold(0.0, |sum, c| sum + c.normal_force_n),
        ),
        (
            "peak_normal_force_n",
            "sum of the largest normal forces between the two bodies within the step",
            Newton,
            |v, pair| v.of_pair(pair).fold(0.0, |sum, c| sum + c.peak_normal_force_n),
        ),
        (
            "tangential_force_n",
            "sum of the friction forces between the two bodies",
            Newton,
            |v, pair| v.of_pair(pair).fold(0.0, |sum, c| sum + c.tangential_force_n),
        ),
        ("depth_m", "largest penetration", Metre, |v, pair| {
            v.of_pair(pair).fold(0.0, |most, c| greater(most, c.depth_m))
        }),
        ("area_m2", "overlap area", SquareMetre, |v, pair| {
            v.of_pair(pair).fold(0.0, |sum, c| sum + c.area_m2)
        }),
    ];
    for bodies in outline_pairs(setup) {
        let [one, two] = bodies.map(|body| &setup.bodies[body].name);
        add(table, &format!("pair.{one}-{two}"), bodies, &columns);
    }
}

/// Adds outputs for the largest wrench on each body within the last step.
pub(crate) fn add_peaks(table: &mut Table, setup: &Setup) {
    use Unit::{Newton, NewtonMetre};
    let columns: [Column<'_>; 3] = [
        (
            "peak_force_x_n",
            "contact force on the body to the north, when the force was largest within the step; forward if \
             host.body_fixed is true. \
             Size fenders by this largest force, but move the body by the mean force force_x_n",
            Newton,
            |v, [b, _]| v.peak(b).force_n.x,
        ),
        (
            "peak_force_y_n",
            "contact force on the body to the east, when the force was largest within the step; to starboard if \
             host.body_fixed is true",
            Newton,
            |v, [b, _]| v.peak(b).force_n.y,
        ),
        (
            "peak_moment_z_nm",
            "moment of the contact forces on the body when their force was largest, positive to starboard",
            NewtonMetre,
            |v, [b, _]| v.peak(b).moment_nm,
        ),
    ];
    for (index, body) in setup.bodies.iter().enumerate() {
        let places = add(table, &format!("body.{}", body.name), [index, 0], &columns);
        table.group("Force", format!("{}.contact_peak", body.name), &places[..2]);
        table.group("Torque", format!("{}.contact_peak_moment", body.name), &places[2..]);
    }
}

/// Pairs of bodies whose outlines may touch and of which at least one floats, in the order of the set-up.
fn outline_pairs(setup: &Setup) -> Vec<[usize; 2]> {
    let named = |one: usize, two: usize| {
        let is = |pair: &PairSetup| pair.bodies == [one, two] || pair.bodies == [two, one];
        setup.pairs.iter().any(is)
    };
    let floats = |body: usize| setup.bodies[body].mass.is_some();
    let count = setup.bodies.len();
    let all = (0..count).flat_map(|one| (one + 1..count).map(move |two| [one, two]));
    all.filter(|&[one, two]| {
        (floats(one) || floats(two)) && (setup.all_other_pairs.is_some() || named(one, two))
    })
    .collect()
}

/// Adds the further outputs of a simulation: states, vessels, tugs, lines and energy.
pub(crate) fn add_simulation(table: &mut Table, setup: &Setup) {
    add_motion(table, setup);
    add_world(table, setup);
    use Unit::Joule;
    let columns: [Column<'_>; 9] = [
        ("energy.kinetic_j", "kinetic energy of all bodies, added mass included", Joule, |v, _| {
            v.of_simulation(|s| s.energy().kinetic_j)
        }),
        (
            "energy.load_work_j",
            "work that all forces except contact have done on the bodies",
            Joule,
            |v, _| v.of_simulation(|s| s.energy().load_work_j),
        ),
        ("energy.stored_j", "energy stored in the springs and stops of contacts", Joule, |v, _| {
            v.of_simulation(|s| s.energy().stored_j)
        }),
        ("energy.shear_stored_j", "stored in shear springs", Joule, |v, _| {
            v.of_simulation(|s| s.energy().shear_stored_j)
        }),
        ("energy.hysteresis_j", "hysteresis loss of fenders", Joule, |v, _| {
            v.of_simulation(|s| s.energy().hysteresis_j)
        }),
        ("energy.damping_j", "lost to damping", Joule, |v, _| {
            v.of_simulation(|s| s.energy().damping_j)
        }),
        ("energy.restitution_j", "lost to restitution", Joule, |v, _| {
            v.of_simulation(|s| s.energy().restitution_j)
        }),
        ("energy.friction_j", "lost to friction", Joule, |v, _| {
            v.of_simulation(|s| s.energy().friction_j)
        }),
        ("energy.residual_j", "energy error that the time step has caused", Joule, |v, _| {
            v.of_simulation(|s| s.energy().residual_j)
        }),
    ];
    add(table, "", [0, 0], &columns);
}

/// Description of the body's velocities, which belong to another time than its positions.
const NORTH_MPS: &str = "velocity to the north; by the coupled method with the integrator semi_implicit, the \
                         velocities in this list belong to the middle of the scenario's last (sub-)step";

fn add_motion(table: &mut Table, setup: &Setup) {
    use Unit::{Metre, MetrePerSecond, Radian, RadianPerSecond};
    let columns: [Column<'_>; 8] = [
        ("x_m", "north coordinate of the body's centre of gravity", Metre, |v, [b, _]| {
            v.states[b].position_m.x
        }),
        ("y_m", "east coordinate of the body's centre of gravity", Metre, |v, [b, _]| {
            v.states[b].position_m.y
        }),
        ("heading_rad", "heading, clockwise from north", Radian, |v, [b, _]| {
            v.states[b].heading_rad
        }),
        ("velocity_x_mps", NORTH_MPS, MetrePerSecond, |v, [b, _]| v.states[b].velocity_mps.x),
        ("velocity_y_mps", "velocity, east", MetrePerSecond, |v, [b, _]| {
            v.states[b].velocity_mps.y
        }),
        (
            "r_radps",
            "rate of turn of the body, positive to starboard",
            RadianPerSecond,
            |v, [b, _]| v.states[b].yaw_rate_radps,
        ),
        ("u_mps", "surge, forward", MetrePerSecond, |v, [b, _]| v.own_velocity(b).x),
        ("v_mps", "sway, to starboard", MetrePerSecond, |v, [b, _]| v.own_velocity(b).y),
    ];
    for (index, body) in setup.bodies.iter().enumerate() {
        if body.mass.is_none() {
            continue;
        }
        let name = &body.name;
        let places = add(table, &format!("body.{name}"), [index, 0], &columns);
        table.group("LinearDisplacement", format!("{name}.position"), &places[..2]);
        table.group("AngularDisplacement", format!("{name}.heading"), &places[2..3]);
        table.group("LinearVelocity", format!("{name}.velocity"), &places[3..5]);
        table.group("AngularVelocity", format!("{name}.rate_of_turn"), &places[5..6]);
    }
    // The second index is that of the quantity in the catalogue.
    let read: Read = |v, [f, quantity]| {
        v.of_simulation(|s| {
            let summary = s.fender_summaries().find(|summary| summary.fender == f);
            let quantity = &FENDERS.quantities[quantity];
            quantity.amount(&s.setup().fenders[f], summary).number().unwrap_or(0.0)
        })
    };
    for (index, fender) in setup.fenders.iter().enumerate() {
        for (place, quantity) in FENDERS.quantities.iter().enumerate().filter(|(_, q)| q.is_in_fmu)
        {
            let unit = Unit::of_symbol(quantity.unit);
            let description = format!("{}, up to now; 0 where there is none", quantity.meaning);
            let columns = [(quantity.name, description.as_str(), unit, read)];
            add(table, &format!("fender.{}", fender.name), [index, place], &columns);
        }
    }
}

fn add_world(table: &mut Table, setup: &Setup) {
    use Unit::{Metre, Newton, One, PerSecond, Radian};
    let columns: [Column<'_>; 6] = [
        (
            "rudder_rad",
            "rudder angle; a positive angle turns the ship to starboard",
            Radian,
            |v, [i, _]| v.of_simulation(|s| s.vessels()[i].rudder.value),
        ),
        ("shaft_rps", "revolutions, positive ahead", PerSecond, |v, [i, _]| {
            v.of_simulation(|s| s.vessels()[i].shaft.value)
        }),
        ("heave_m", "heave of the vessel, positive down, without waves", Metre, |v, [i, _]| {
            v.of_simulation(|s| s.vessels()[i].attitude.heave.value)
        }),
        (
            "roll_rad",
            "heel of the vessel, positive to starboard, without waves",
            Radian,
            |v, [i, _]| v.of_simulation(|s| s.vessels()[i].attitude.roll.value),
        ),
        (
            "pitch_rad",
            "pitch of the vessel, positive with the bow up, without waves",
            Radian,
            |v, [i, _]| v.of_simulation(|s| s.vessels()[i].attitude.pitch.value),
        ),
        ("squat_m", "squat: sinkage under way", Metre, |v, [i, _]| {
            v.of_simulation(|s| s.vessels()[i].squat_m)
        }),
    ];
    let thruster: [Column<'_>; 1] = [("thrust", "thrust over the largest", One, |v, [i, unit]| {
        v.of_simulation(|s| s.vessels()[i].thrusters[unit].value)
    })];
    let azimuth: [Column<'_>; 2] = [
        ("power", "thrust of the azimuth unit over its thrust at rest", One, |v, [i, unit]| {
            v.of_simulation(|s| s.vessels()[i].azimuths[unit].power.value)
        }),
        (
            "direction_rad",
            "direction of the azimuth unit's thrust, from the bow",
            Radian,
            |v, [i, unit]| v.of_simulation(|s| s.vessels()[i].azimuths[unit].direction.angle_rad),
        ),
    ];
    for (index, vessel) in setup.world.vessels.iter().enumerate() {
        let stem = format!("vessel.{}", setup.bodies[vessel.body].name);
        add(table, &stem, [index, 0], &columns);
        for (unit, of) in vessel.thrusters.iter().enumerate() {
            add(table, &format!("{stem}.thruster.{}", of.name), [index, unit], &thruster);
        }
        for (unit, of) in vessel.azimuths.iter().enumerate() {
            add(table, &format!("{stem}.azimuth.{}", of.name), [index, unit], &azimuth);
        }
    }
    let columns: [Column<'_>; 2] = [
        ("force_n", "force on the ship", Newton, |v, [i, _]| {
            v.of_simulation(|s| {
                let force = s.tugs()[i].force;
                libm::hypot(force.surge_n, force.sway_n)
            })
        }),
        (
            "direction_rad",
            "direction of the tug's force, from the ship's bow",
            Radian,
            |v, [i, _]| v.of_simulation(|s| s.tugs()[i].state.direction_rad),
        ),
    ];
    for (index, tug) in setup.world.tugs.iter().enumerate() {
        add(table, &format!("tug.{}", tug.tug.name), [index, 0], &columns);
    }
    let columns: [Column<'_>; 3] = [
        ("tension_n", "tension of the line at the ship's end", Newton, |v, [i, _]| {
            v.of_simulation(|s| s.lines()[i].load.tension_n)
        }),
        ("length_m", "unstretched length outboard", Metre, |v, [i, _]| {
            v.of_simulation(|s| s.lines()[i].line.as_ref().map_or(0.0, |(_, state)| state.length_m))
        }),
        ("parted", "1 if the line has parted, else 0", One, |v, [i, _]| {
            v.of_simulation(|s| {
                let line = s.lines()[i].line.as_ref();
                line.map_or(0.0, |(_, state)| f64::from(u8::from(state.parted)))
            })
        }),
    ];
    for (index, line) in setup.world.lines.iter().enumerate() {
        add(table, &format!("line.{}", line.line.name), [index, 0], &columns);
    }
}

/// Reads all outputs.
pub(crate) fn read(table: &Table, view: &View<'_>, values: &mut [f64]) {
    for (variable, value) in table.variables.iter().zip(values) {
        if let StandsFor::Output(Output { of, read }) = variable.stands_for {
            *value = read(view, of);
        }
    }
}
