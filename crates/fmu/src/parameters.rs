//! Parameters of an FMU: numbers of the set-up that a master can change until the end of initialization.

use fenderline_contact::Unloading;
use fenderline_sim::{FenderSetup, MassProperties, Setup};

use crate::table::{Causality, Class, Parameter, StandsFor, Table, Variable};
use crate::unit::Unit;

/// Largest mass or stiffness that a parameter may have, in SI units. Some values have narrower limits in the engine.
const LARGEST: f64 = 1e15;

/// A number in a type of the set-up: name, description and unit of the parameter, and the functions that read and write
/// the number.
struct Field<T> {
    name: &'static str,
    description: &'static str,
    unit: Unit,
    range: Option<[f64; 2]>,
    read: fn(&T) -> f64,
    write: fn(&mut Setup, usize, f64),
}

fn add<T>(table: &mut Table, stem: &str, of: usize, thing: &T, fields: &[Field<T>]) {
    for field in fields {
        table.add(Variable {
            name: format!("{stem}.{}", field.name),
            description: field.description.to_owned(),
            unit: field.unit,
            class: Class::Real,
            causality: Causality::Parameter,
            start: (field.read)(thing),
            range: field.range,
            stands_for: StandsFor::Parameter(Parameter { of, write: field.write }),
        });
    }
}

macro_rules! material {
    ($name:literal, $unit:ident, $field:ident, $description:literal) => {
        Field {
            name: $name,
            description: $description,
            unit: Unit::$unit,
            range: Some([0.0, if $name == "restitution" { 1.0 } else { LARGEST }]),
            read: |m: &fenderline_contact::Material| m.$field,
            write: |setup, of, value| setup.materials[of].material.$field = value,
        }
    };
}

macro_rules! mass {
    ($name:literal, $unit:ident, $field:ident, $description:literal) => {
        Field {
            name: $name,
            description: $description,
            unit: Unit::$unit,
            range: Some([0.0, LARGEST]),
            read: |m: &MassProperties| m.$field,
            write: |setup, of, value| {
                if let Some(mass) = &mut setup.bodies[of].mass {
                    mass.$field = value;
                }
            },
        }
    };
}

macro_rules! start {
    ($name:literal, $unit:ident, $($field:ident).+, $description:literal) => {
        Field {
            name: $name,
            description: $description,
            unit: Unit::$unit,
            range: None,
            read: |b: &fenderline_sim::BodySetup| b.$($field).+,
            write: |setup, of, value| setup.bodies[of].$($field).+ = value,
        }
    };
}

/// Adds the parameters for materials, and for the masses of bodies. The masses of vessels are not parameters, because
/// the vessels' models give them.
pub(crate) fn add_materials_and_masses(table: &mut Table, setup: &Setup) {
    let fields = [
        material!("stiffness_npm2", NewtonPerSquareMetre, stiffness_npm2, "area stiffness k"),
        material!("damping_nspm2", NewtonSecondPerSquareMetre, damping_nspm2, "area damping c"),
        material!(
            "shear_stiffness_npm",
            NewtonPerMetre,
            shear_stiffness_npm,
            "stiffness k_s of the material's shear spring"
        ),
        material!("friction_static", One, friction_static, "coefficient of static friction"),
        material!("friction_dynamic", One, friction_dynamic, "coefficient of dynamic friction"),
        material!("restitution", One, restitution, "coefficient of restitution γ"),
    ];
    for (of, named) in setup.materials.iter().enumerate() {
        add(table, &format!("material.{}", named.name), of, &named.material, &fields);
    }
    let fields = [
        mass!("mass_kg", Kilogram, mass_kg, "displacement"),
        mass!("yaw_inertia_kgm2", KilogramSquareMetre, yaw_inertia_kgm2, "moment of inertia"),
        mass!("added_surge_kg", Kilogram, added_surge_kg, "added mass in surge"),
        mass!("added_sway_kg", Kilogram, added_sway_kg, "added mass in sway"),
        mass!("added_yaw_kgm2", KilogramSquareMetre, added_yaw_kgm2, "added moment of inertia"),
    ];
    for (of, body) in setup.bodies.iter().enumerate() {
        let is_vessel = setup.world.vessels.iter().any(|vessel| vessel.body == of);
        if let (Some(mass), false) = (&body.mass, is_vessel) {
            add(table, &format!("body.{}", body.name), of, mass, &fields);
        }
    }
}

/// Adds the parameter for the returned energy of each fender whose unloading law is a share of the absorbed energy. If
/// a fender has this parameter, the restitution of its material has no effect.
pub(crate) fn add_fenders(table: &mut Table, setup: &Setup) {
    let fields = [Field {
        name: "returned_energy",
        description: "share of the absorbed energy that the fender returns",
        unit: Unit::One,
        range: Some([Unloading::MIN_RETURNED_SHARE, 1.0]),
        read: |fender: &FenderSetup| match fender.unloading {
            Some(Unloading::ReturnedEnergy(share)) => share,
            _ => 1.0,
        },
        write: |setup, of, value| {
            setup.fenders[of].unloading = Some(Unloading::ReturnedEnergy(value));
        },
    }];
    for (of, fender) in setup.fenders.iter().enumerate() {
        if matches!(fender.unloading, Some(Unloading::ReturnedEnergy(_))) {
            add(table, &format!("fender.{}", fender.name), of, fender, &fields);
        }
    }
}

/// Adds the parameters of a simulation for the places and motions with which the floating bodies start.
pub(crate) fn add_starts(table: &mut Table, setup: &Setup) {
    let fields = [
        start!("start_x_m", Metre, position_m.x, "north coordinate of the body at the start"),
        start!("start_y_m", Metre, position_m.y, "east coordinate of the body at the start"),
        start!("start_heading_rad", Radian, heading_rad, "heading at the start"),
        start!(
            "start_u_mps",
            MetrePerSecond,
            velocity.surge_mps,
            "surge velocity of the body at the start, \
            positive forward"
        ),
        start!(
            "start_v_mps",
            MetrePerSecond,
            velocity.sway_mps,
            "sway velocity of the body at the start, \
            positive to starboard"
        ),
        start!(
            "start_r_radps",
            RadianPerSecond,
            velocity.yaw_radps,
            "rate of turn of the body at the start"
        ),
    ];
    for (of, body) in setup.bodies.iter().enumerate() {
        if body.mass.is_some() {
            add(table, &format!("body.{}", body.name), of, body, &fields);
        }
    }
}

/// The set-up with the values of the parameters that the master has set.
pub(crate) fn applied(table: &Table, values: &[f64], setup: &Setup) -> Setup {
    let mut setup = setup.clone();
    for (variable, &value) in table.variables.iter().zip(values) {
        // Unchanged parameters keep the value of the scenario file, bit for bit.
        if let StandsFor::Parameter(parameter) = variable.stands_for
            && value.to_bits() != variable.start.to_bits()
        {
            (parameter.write)(&mut setup, parameter.of, value);
        }
    }
    setup
}
