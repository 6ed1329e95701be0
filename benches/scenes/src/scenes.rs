//! Scenes that every engine plays: the same outlines, masses, places, loads and restitution.

use std::f64::consts::TAU;

use fenderline_contact::{BodyState, Material, Rotation, Vec2, Wrench, vec2};

/// The material of a fender of 500 kN/m² with friction, as in the paper's Table 1.
pub const RUBBER: Material = Material {
    stiffness_npm2: 500e3,
    damping_nspm2: 0.0,
    shear_stiffness_npm: 3e6,
    friction_static: 0.5,
    friction_dynamic: 0.5,
    restitution: 0.1,
};

/// Speed at which the bodies of a [`Scene`] come on (m/s), and how deep the bodies are in their fenders at the start
/// (m): so little that rapier2d, which pushes bodies out of each other, keeps all contacts.
const APPROACH_MPS: f64 = 0.05;
const DEPTH_M: f64 = 0.02;

/// What is stepped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scene {
    /// A tug against one fender.
    Tug,
    /// A ship alongside eight fenders.
    Ship,
    /// A ship alongside eight fenders, which are faces of one quay in an engine that has faces.
    Faces,
    /// A ship alongside the given number of narrow fenders, which are faces of one quay in an engine that has faces.
    Fenders(usize),
    /// A ship alongside the given number of narrow fenders, each a body of its own.
    Blocks(usize),
    /// The given number of tugs in a square, each against a fender of its own; any body may touch any other.
    Pairs(usize),
    /// The given number of tugs in a line, each pressed on the tug before it, the first on a quay.
    Chain(usize),
    /// A square of barges, with the given number along each side, pressed into the corner of two quays.
    Raft(usize),
    /// Two stars with the given number of corners each, one of them fixed, that touch with a few of their rays.
    Stars(usize),
    /// A floating star with the given number of corners against a coast with as many, which has the outline of a comb.
    StarOnComb(usize),
    /// Two combs with the given number of corners each, one of them fixed, that touch with all of their teeth.
    Combs(usize),
}

impl Scene {
    /// The scene with the given name on the command line.
    pub fn named(name: &str) -> Option<Scene> {
        match name {
            "tug" => Some(Scene::Tug),
            "ship" => Some(Scene::Ship),
            "faces" => Some(Scene::Faces),
            "fenders-100" => Some(Scene::Fenders(100)),
            "fenders-300" => Some(Scene::Fenders(300)),
            "fenders-1000" => Some(Scene::Fenders(1_000)),
            "blocks-100" => Some(Scene::Blocks(100)),
            "blocks-1000" => Some(Scene::Blocks(1_000)),
            "pairs-1000" => Some(Scene::Pairs(1_000)),
            "pairs-10000" => Some(Scene::Pairs(10_000)),
            _ => match name.split_once('-')? {
                ("chain", count) => count.parse().ok().map(Scene::Chain),
                ("raft", side) => side.parse().ok().map(Scene::Raft),
                ("stars", corners) => corners.parse().ok().map(Scene::Stars),
                ("coast", corners) => corners.parse().ok().map(Scene::StarOnComb),
                ("combs", corners) => corners.parse().ok().map(Scene::Combs),
                _ => None,
            },
        }
    }

    /// The scene at its start, where the bodies of every contact come on slowly and a load presses them together.
    pub fn plan(self) -> Plan {
        let mut plan = Plan::new(RUBBER);
        match self {
            Scene::Tug => plan.tug_at_fender(vec2(0.0, 0.0)),
            Scene::Ship => plan.ship_at_fenders(),
            Scene::Faces => {
                plan.ship_at_fenders();
                plan.faces = true;
            }
            Scene::Fenders(count) => {
                plan.ship_at_many_fenders(count);
                plan.faces = true;
            }
            Scene::Blocks(count) => plan.ship_at_many_fenders(count),
            Scene::Pairs(count) => plan.square_of_tugs(count),
            Scene::Chain(count) => plan.chain_of_tugs(count),
            Scene::Raft(side) => plan.raft_of_barges(side),
            Scene::Stars(corners) => plan.star_at(star(corners), corners, STAR_M),
            Scene::StarOnComb(corners) => plan.star_at(comb(corners), corners, 0.0),
            Scene::Combs(corners) => plan.combs(corners),
        }
        plan
    }
}

/// One body.
#[derive(Clone, Debug)]
pub struct Part {
    /// Outline of the body in the body's frame, in the positive sense (m).
    pub outline_m: Vec<Vec2>,
    /// Mass and yaw inertia of the body; `None` for a fixed body.
    pub mass: Option<Mass>,
    /// The state of the body at the start.
    pub state: BodyState,
    /// Steady load on the body at its centre of gravity.
    pub load: Wrench,
}

/// Mass and yaw inertia of a body; the mass is the same in surge and sway, because rapier2d knows no other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mass {
    /// Mass in surge and sway (kg).
    pub mass_kg: f64,
    /// Inertia in yaw about the centre of gravity (kg·m²).
    pub yaw_inertia_kgm2: f64,
}

/// All bodies of a scene, with the material of their contacts.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The bodies.
    pub parts: Vec<Part>,
    /// The material of all contacts.
    pub material: Material,
    /// Whether any body may touch any other; otherwise each floating body may touch each fixed one, and the pairs are
    /// named one by one.
    pub anyone: bool,
    /// Whether the fixed bodies are a row of blocks along an east quay, which our engine plays as faces of one body.
    pub faces: bool,
    /// Size of each fender block along the quay and across it (m).
    pub fender_m: (f64, f64),
}

impl Plan {
    /// A scene without bodies.
    pub fn new(material: Material) -> Plan {
        Plan { parts: Vec::new(), material, anyone: false, faces: false, fender_m: FENDER_M }
    }

    /// Adds a fixed body (m, rad).
    pub fn fixed(&mut self, outline_m: Vec<Vec2>, position_m: Vec2, heading_rad: f64) {
        let state = BodyState { position_m, heading_rad, ..BodyState::default() };
        self.parts.push(Part { outline_m, mass: None, state, load: Wrench::default() });
    }

    /// Adds a floating body with a steady force on the body (m, N).
    pub fn floating(&mut self, outline_m: Vec<Vec2>, mass: Mass, state: BodyState, force_n: Vec2) {
        let load = Wrench { force_n, moment_nm: 0.0 };
        self.parts.push(Part { outline_m, mass: Some(mass), state, load });
    }

    /// A tug of the paper's size with her bow to the east, at the block of a fender.
    fn tug_at_fender(&mut self, at_m: Vec2) {
        let mass = Mass { mass_kg: 1.01e6, yaw_inertia_kgm2: 6.0e7 };
        self.floating(corners(&TUG), mass, coming(at_m, 0.25 * TAU + 0.01), vec2(0.0, 300e3));
        let beyond = at_m + vec2(0.0, 16.0 + 0.5 - DEPTH_M);
        self.fixed(corners(&FENDER), beyond, 0.0);
    }

    /// The paper's container ship with eight fenders along her starboard side.
    fn ship_at_fenders(&mut self) {
        let mass = Mass { mass_kg: 9.06e7, yaw_inertia_kgm2: 4.9e11 };
        self.floating(corners(&SHIP), mass, coming(vec2(0.0, 0.0), 1e-5), vec2(0.0, 2.4e6));
        for k in 0..8 {
            let place = vec2(-110.0 + 28.0 * f64::from(k), 23.0 + 0.5 - DEPTH_M);
            self.fixed(corners(&FENDER), place, 0.0);
        }
    }

    /// The paper's container ship with `count` fenders side by side along her parallel middle body, and gaps of a fifth
    /// of their spacing between them.
    fn ship_at_many_fenders(&mut self, count: usize) {
        const ALONG_M: f64 = 240.0;
        let mass = Mass { mass_kg: 9.06e7, yaw_inertia_kgm2: 4.9e11 };
        self.floating(corners(&SHIP), mass, coming(vec2(0.0, 0.0), 1e-6), vec2(0.0, 16e6));
        let apart_m = ALONG_M / count as f64;
        self.fender_m = (0.8 * apart_m, 1.0);
        for k in 0..count {
            let place = vec2(-145.0 + apart_m * (k as f64 + 0.5), 23.0 + 0.5 - DEPTH_M);
            self.fixed(block(self.fender_m.0, self.fender_m.1), place, 0.0);
        }
    }

    fn square_of_tugs(&mut self, count: usize) {
        const APART_M: f64 = 60.0;
        let side = (1..).find(|side| side * side >= count).unwrap_or(1);
        for k in 0..count {
            let (row, column) = ((k / side) as f64, (k % side) as f64);
            // Every row a little further north, so that the rows are not in line.
            self.tug_at_fender(vec2(APART_M * row + 0.4 * column, APART_M * column));
        }
        self.anyone = true;
    }

    /// Each tug of the chain presses on with 30 kN: at rest, the contact k from the end carries k times 30 kN.
    fn chain_of_tugs(&mut self, count: usize) {
        let mass = Mass { mass_kg: 1.01e6, yaw_inertia_kgm2: 6.0e7 };
        for k in 0..count {
            let at_m = vec2(0.0, -(32.0 - DEPTH_M) * k as f64);
            self.floating(corners(&TUG), mass, coming(at_m, 0.25 * TAU), vec2(0.0, 30e3));
        }
        self.fixed(block(200.0, 10.0), vec2(0.0, 16.0 + 5.0 - DEPTH_M), 0.0);
        self.anyone = true;
    }

    /// Each barge of the raft is pressed by 30 kN towards the east quay and by 10 kN towards the north quay.
    fn raft_of_barges(&mut self, side: usize) {
        let (length_m, width_m) = BARGE_M;
        let mass = Mass { mass_kg: 1.0e6, yaw_inertia_kgm2: 1.4e8 };
        for k in 0..side * side {
            let (row, column) = ((k / side) as f64, (k % side) as f64);
            let at_m = vec2(-(length_m - DEPTH_M) * row, -(width_m - DEPTH_M) * column);
            let outline_m = barge(length_m, width_m);
            self.floating(outline_m, mass, coming(at_m, 0.0), vec2(10e3, 30e3));
        }
        let of_raft_m = 2.0 * (length_m + width_m) * (side + 2) as f64;
        let north_m = vec2(0.5 * length_m + 5.0 - DEPTH_M, 0.0);
        let east_m = vec2(0.0, 0.5 * width_m + 5.0 - DEPTH_M);
        self.fixed(block(10.0, of_raft_m), north_m, 0.0);
        self.fixed(block(of_raft_m, 10.0), east_m, 0.0);
        self.anyone = true;
    }
}

impl Plan {
    /// A star slides along a fixed outline and is pressed on it; the outline reaches `reach_m` to the west of its
    /// centre.
    fn star_at(&mut self, fixed_m: Vec<Vec2>, corners: usize, reach_m: f64) {
        let mass = Mass { mass_kg: 8.0e6, yaw_inertia_kgm2: 1.0e10 };
        let mut state = coming(vec2(0.0, 0.0), 0.003);
        state.velocity_mps.x = 0.1;
        self.floating(star(corners), mass, state, vec2(0.0, 2e6));
        self.fixed(fixed_m, vec2(0.0, reach_m + STAR_M - 5.0 * DEPTH_M), 0.0);
        self.anyone = true;
    }

    /// A comb with its teeth to the east is pressed on the teeth of another comb.
    fn combs(&mut self, corners: usize) {
        let mass = Mass { mass_kg: 2.0e7, yaw_inertia_kgm2: 1.5e11 };
        let mut state = coming(vec2(0.3 * TOOTH_M, 0.0), 0.5 * TAU + 1e-6);
        state.velocity_mps.x = 0.01;
        self.floating(comb(corners), mass, state, vec2(0.0, 5e6));
        self.fixed(comb(corners), vec2(0.0, -DEPTH_M), 0.0);
        self.anyone = true;
    }
}

/// Radius of a star out to the tips of its rays, and length of a ray (m).
const STAR_M: f64 = 50.0;
const RAY_M: f64 = 0.3;

/// Outline of a star: every other corner is the tip of a ray.
fn star(corners: usize) -> Vec<Vec2> {
    let corner = |k: usize| {
        let radius_m = if k.is_multiple_of(2) { STAR_M } else { STAR_M - RAY_M };
        Rotation::from_angle(TAU * (k as f64 + 0.2) / corners as f64).apply(vec2(radius_m, 0.0))
    };
    (0..corners).map(corner).collect()
}

/// Width of a comb's teeth and of the gaps between them, and length of a tooth (m).
const TOOTH_M: f64 = 0.6;
const TOOTH_LENGTH_M: f64 = 1.0;

/// Outline of a comb: four corners a tooth on a back to the east; the tips of the teeth are on the line y = 0.
fn comb(corners: usize) -> Vec<Vec2> {
    let teeth = corners / 4;
    let half_m = TOOTH_M * (teeth as f64 - 0.5);
    let from_m = |tooth: usize| 2.0 * TOOTH_M * tooth as f64 - half_m;
    let tooth = |k: usize| {
        let [from_m, to_m] = [from_m(k), from_m(k) + TOOTH_M];
        let mut ring =
            vec![(from_m, TOOTH_LENGTH_M), (from_m, 0.0), (to_m, 0.0), (to_m, TOOTH_LENGTH_M)];
        // The back is as wide as its teeth.
        if k == 0 {
            ring[0].1 = 5.0;
        }
        if k + 1 == teeth {
            ring[3].1 = 5.0;
        }
        ring
    };
    (0..teeth).flat_map(tooth).map(|(x, y)| vec2(x, y)).collect()
}

/// Length and width of the barges of a raft (m).
const BARGE_M: (f64, f64) = (40.0, 11.0);

/// Corners of the tug: 32 × 13 m with a flat bow of 10 m.
const TUG: [(f64, f64); 8] = [
    (-16.0, -5.5),
    (-14.0, -6.5),
    (6.0, -6.5),
    (16.0, -5.0),
    (16.0, 5.0),
    (6.0, 6.5),
    (-14.0, 6.5),
    (-16.0, 5.5),
];

/// 298 × 46 m.
const SHIP: [(f64, f64); 6] =
    [(-149.0, -23.0), (104.0, -23.0), (149.0, -3.0), (149.0, 3.0), (104.0, 23.0), (-149.0, 23.0)];

/// Corners of a fender: a block of 4 × 1 m.
const FENDER: [(f64, f64); 4] = [(-2.0, -0.5), (2.0, -0.5), (2.0, 0.5), (-2.0, 0.5)];

/// Size of a fender's block along the quay and across it (m).
const FENDER_M: (f64, f64) = (4.0, 1.0);

/// Outline of a block about the origin, with its length along x.
pub fn block(length_m: f64, width_m: f64) -> Vec<Vec2> {
    let (x, y) = (0.5 * length_m, 0.5 * width_m);
    corners(&[(-x, -y), (x, -y), (x, y), (-x, y)])
}

/// Outline of a barge: a block with its corners cut off, so that barges of a raft do not touch across a corner.
fn barge(length_m: f64, width_m: f64) -> Vec<Vec2> {
    const CUT_M: f64 = 1.0;
    let (x, y) = (0.5 * length_m, 0.5 * width_m);
    let (inner_x, inner_y) = (x - CUT_M, y - CUT_M);
    corners(&[
        (-inner_x, -y),
        (inner_x, -y),
        (x, -inner_y),
        (x, inner_y),
        (inner_x, y),
        (-inner_x, y),
        (-x, inner_y),
        (-x, -inner_y),
    ])
}

fn corners(corners: &[(f64, f64)]) -> Vec<Vec2> {
    corners.iter().map(|&(x, y)| vec2(x, y)).collect()
}

fn coming(position_m: Vec2, heading_rad: f64) -> BodyState {
    let velocity_mps = vec2(0.0, APPROACH_MPS);
    BodyState { position_m, heading_rad, velocity_mps, yaw_rate_radps: 0.0 }
}
