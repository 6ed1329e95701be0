//! One random impact: a tug at any heading, velocity and rate of turn meets fenders on a quay or a pontoon.

use std::f64::consts::PI;

use fenderline_contact::{FenderLaw, Material, Panel, Unloading, vec2};
use fenderline_sim::{
    ChainKind, ChainSetup, FenderSetup, Integrator, MassProperties, Method, PairSetup, Setup,
    Simulation,
};

use crate::draw::Draw;
use crate::support::scenes::{FENDER_HEIGHT_M, berth_materials, cone_fender, quay, tug};
use crate::support::{floating, rectangle, spring};

/// The random parameters of an impact.
#[derive(Clone, Debug)]
pub(crate) struct Episode {
    /// Mass of the pontoon that carries the fenders (kg); `None` if a quay carries them.
    host_kg: Option<f64>,
    /// Added mass in sway of the tug and of the pontoon, divided by their displacements.
    added: [f64; 2],
    boxy: bool,
    heading_rad: f64,
    along_m: f64,
    approach_mps: f64,
    slide_mps: f64,
    spin_radps: f64,
    pub(crate) restitution: f64,
    friction: f64,
    sliding_share: f64,
    shear_stiffness_npm: f64,
    law: Law,
    pub(crate) step_s: f64,
    /// Unloading law of the fenders.
    unloading: Option<UnloadsBy>,
    /// Panel in front of each fender: the places of its two cones, and the break load of its tension chain.
    pub(crate) panel: Option<([f64; 2], f64)>,
}

#[derive(Clone, Copy, Debug)]
enum Law {
    Cone,
    Linear,
    Area,
}

#[derive(Clone, Copy, Debug)]
enum UnloadsBy {
    /// The fenders return this share of the absorbed energy.
    Returned(f64),
    /// At each deflection, the reaction of the unloading curve is this share of the loading curve's. For fenders with
    /// an area law, the number is the returned share of the absorbed energy.
    Curve(f64),
}

/// The energy balance of a random impact, as shares of the kinetic energy before the impact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outcome {
    /// Energy lost in contact.
    lost: f64,
    /// Residual of the energy balance: the error of the Coriolis terms within a step.
    pub(crate) turning: f64,
    pub(crate) touched: bool,
    /// True if the hull also touched the structure behind the fenders.
    pub(crate) touched_structure: bool,
}

impl Outcome {
    /// Energy gained by contact.
    pub(crate) fn gain(&self) -> f64 {
        -self.lost
    }

    /// Energy gained by contact, with the residual of the energy balance added.
    pub(crate) fn gain_with_turning(&self) -> f64 {
        self.turning - self.lost
    }
}

/// Draws the parameters of an impact from a seed. With `unloads` the fenders have unloading laws, but the impact is the
/// same as without `unloads`.
pub(crate) fn random(seed: u64, anisotropic: bool, unloads: bool) -> Episode {
    let mut draw = Draw::new(seed);
    let added = [draw.between(0.0, 0.9), draw.between(0.0, 0.9)];
    Episode {
        host_kg: draw.one_of(&[false, true]).then(|| libm::exp10(draw.between(5.0, 8.0))),
        added: if anisotropic { added } else { [0.0; 2] },
        boxy: draw.one_of(&[false, true]),
        heading_rad: draw.between(-PI, PI),
        along_m: draw.between(-12.0, 12.0),
        approach_mps: draw.between(0.05, 1.5),
        slide_mps: draw.between(-0.5, 0.5),
        spin_radps: draw.between(-0.05, 0.05),
        restitution: draw.between(0.0, 0.9),
        friction: draw.between(0.0, 0.8),
        sliding_share: draw.between(0.3, 1.0),
        shear_stiffness_npm: libm::exp10(draw.between(5.5, 8.0)),
        law: draw.one_of(&[Law::Cone, Law::Linear, Law::Area]),
        step_s: draw.one_of(&[0.05, 0.1, 0.5, 1.0]),
        unloading: unloads.then(|| {
            let share = draw.between(Unloading::MIN_RETURNED_SHARE, 0.95);
            draw.one_of(&[UnloadsBy::Returned(share), UnloadsBy::Curve(share)])
        }),
        panel: draw.one_of(&[false, true]).then(|| {
            let cones_m = [draw.between(-1.9, -0.2), draw.between(0.2, 1.9)];
            (cones_m, libm::exp10(draw.between(3.0, 7.0)))
        }),
    }
}

/// Simulates an impact for 20 s and returns its energy balance.
pub(crate) fn play(episode: &Episode) -> Outcome {
    let mut simulation = Simulation::new(setup(episode)).expect("a good set-up");
    let before_j = simulation.energy().kinetic_j;
    let (mut touched, mut touched_structure) = (false, false);
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        touched |= record.contacts.iter().any(|c| c.fender.is_some());
        touched_structure |= record.contacts.iter().any(|c| c.fender.is_none());
    }
    let energy = simulation.energy();
    Outcome {
        lost: 1.0 - (energy.kinetic_j - energy.residual_j) / before_j,
        turning: energy.residual_j / before_j,
        touched,
        touched_structure,
    }
}

fn setup(episode: &Episode) -> Setup {
    let mut host = quay();
    host.mass = episode.host_kg.map(|mass_kg| MassProperties {
        mass_kg,
        yaw_inertia_kgm2: mass_kg * 100.0,
        added_sway_kg: mass_kg * episode.added[0],
        ..Default::default()
    });
    let own = tug();
    let outline = if episode.boxy { rectangle(32.0, 11.0) } else { own.outline };
    // The point of the hull nearest to the quay is 0.05 m off the fender faces.
    let reach_m = farthest_east_m(outline.vertices(), episode.heading_rad);
    let mut tug = floating("tug", outline, 930e3, 8.0);
    tug.mass.as_mut().expect("she floats").added_sway_kg = 930e3 * episode.added[1];
    tug.heading_rad = episode.heading_rad;
    tug.position_m = vec2(episode.along_m, -FENDER_HEIGHT_M - reach_m - 0.05);
    let (sin, cos) = (libm::sin(episode.heading_rad), libm::cos(episode.heading_rad));
    tug.velocity.surge_mps = episode.slide_mps * cos + episode.approach_mps * sin;
    tug.velocity.sway_mps = -episode.slide_mps * sin + episode.approach_mps * cos;
    tug.velocity.yaw_radps = episode.spin_radps;

    let mut materials = berth_materials();
    materials[0].material.restitution = episode.restitution;
    materials[1].material = Material {
        shear_stiffness_npm: episode.shear_stiffness_npm,
        friction_static: episode.friction,
        friction_dynamic: episode.friction * episode.sliding_share,
        ..spring(400e3, episode.restitution)
    };
    Setup {
        step_s: episode.step_s,
        duration_s: 20.0,
        integrator: Integrator::SemiImplicit,
        method: Method::Coupled,
        bodies: vec![host, tug],
        materials,
        pairs: vec![PairSetup { bodies: [0, 1], material: 0 }],
        all_other_pairs: None,
        approaches: vec![],
        fenders: (0..4).map(|k| fender(k, episode)).collect(),
        berthing: None,
        loads: vec![],
        world: fenderline_sim::WorldSetup::default(),
    }
}

fn farthest_east_m(vertices: &[fenderline_contact::Vec2], heading_rad: f64) -> f64 {
    let (sin, cos) = (libm::sin(heading_rad), libm::cos(heading_rad));
    vertices.iter().map(|v| v.x * sin + v.y * cos).fold(0.0, f64::max)
}

fn unloading(unloads_by: UnloadsBy, law: &FenderLaw) -> Unloading {
    match (unloads_by, law) {
        (UnloadsBy::Returned(share), _) | (UnloadsBy::Curve(share), FenderLaw::Area) => {
            Unloading::ReturnedEnergy(share)
        }
        // The unloading curve is zero at first, and meets the loading curve at its end.
        (UnloadsBy::Curve(share), FenderLaw::Curve(points)) => {
            let [end_m, _] = points[points.len() - 1];
            let lower = |&[at_m, reaction_n]: &[f64; 2]| {
                [at_m, reaction_n * (share * (2.0 * at_m / end_m).min(1.0)).max(at_m / end_m - 0.5)]
            };
            Unloading::Curve(points.iter().map(lower).collect())
        }
    }
}

/// Fender `k` of four, each 4 m wide, with gaps of 0.5 m.
fn fender(k: u32, episode: &Episode) -> FenderSetup {
    let along_m = 4.5 * (f64::from(k) - 1.5);
    let mut fender = cone_fender(&format!("fender {k}"), along_m, FENDER_HEIGHT_M, 1.2e6);
    fender.width_m = 4.0;
    match episode.law {
        Law::Cone => {}
        Law::Linear => fender.law = FenderLaw::linear(1.5e6),
        Law::Area => (fender.law, fender.rated) = (FenderLaw::Area, None),
    }
    fender.unloading = episode.unloading.map(|unloads_by| unloading(unloads_by, &fender.law));
    // A panel has a reaction curve, and a returned share of the energy.
    if let (Some((cones_m, break_load_n)), FenderLaw::Curve(_)) = (episode.panel, &fender.law) {
        fender.panel = Some(Panel { cones_m: cones_m.to_vec(), tension_chains: vec![] });
        fender.chains = vec![ChainSetup {
            kind: ChainKind::Tension,
            at_m: 1.9,
            slack_m: 0.01,
            stiffness_npm: 1e7,
            break_load_n,
        }];
        fender.unloading = episode.unloading.map(|unloads_by| match unloads_by {
            UnloadsBy::Returned(share) | UnloadsBy::Curve(share) => {
                Unloading::ReturnedEnergy(share)
            }
        });
    }
    fender
}
