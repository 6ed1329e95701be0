//! A warm step allocates nothing. The test runs 100,000 steps with a counting allocator: a ship touches eight fenders,
//! slides along them and leaves.

#[allow(dead_code, reason = "each test uses its own part of the scene")]
mod scene;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use fenderline_contact::{
    Body, BodyState, CoSimHost, EventKind, Friction, HostIntegration, HostSettings, HostWorkspace,
    Material, Memory, Mobility, Model, Outline, Vec2, Workspace, Wrench, advance, step, vec2,
};

const STEP_S: f64 = 0.1;
const STEPS: usize = 100_000;
/// Ten cycles of each of the three motions.
const WARM_UP_STEPS: usize = 20_000;

thread_local! {
    /// Allocator calls of this thread. The test harness has other threads.
    static ALLOCATIONS: Cell<u64> = const { Cell::new(0) };
}

struct Counting;

fn count() {
    // This fails only while the thread ends, after the test.
    let _ = ALLOCATIONS.try_with(|n| n.set(n.get() + 1));
}

// SAFETY: every call goes to the system's allocator unchanged; counting allocates nothing.
#[allow(unsafe_code, reason = "an allocator cannot be written without; tests only")]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: as the caller promised.
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: as the caller promised.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, place: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        // SAFETY: as the caller promised.
        unsafe { System.realloc(place, layout, size) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        // SAFETY: as the caller promised.
        unsafe { System.dealloc(place, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// The ship sways between 0.3 m clear of the fenders and 0.5 m into them. She surges to slide both ways, and yaws so
/// that fenders are touched unequally.
fn ship_at(step: usize) -> BodyState {
    let t = step as f64 * STEP_S;
    let swing = |amplitude: f64, period_s: f64| {
        let rate = core::f64::consts::TAU / period_s;
        (amplitude * libm::sin(rate * t), amplitude * rate * libm::cos(rate * t))
    };
    let (sway_m, sway_mps) = swing(0.4, 97.0);
    let (surge_m, surge_mps) = swing(12.0, 181.0);
    let (heading_rad, yaw_rate_radps) = swing(1e-3, 61.0);
    BodyState {
        position_m: vec2(surge_m, scene::TOUCH_EAST_M + 0.1 + sway_m),
        heading_rad,
        velocity_mps: vec2(surge_mps, sway_mps),
        yaw_rate_radps,
    }
}

#[derive(Debug, Default)]
struct Seen {
    began: usize,
    ended: usize,
    sticking: usize,
    slipping: usize,
    most_touching: usize,
    fewest_touching: usize,
}

impl Seen {
    fn count(&mut self, work: &Workspace) {
        for event in work.events() {
            self.began += usize::from(event.kind == EventKind::ContactBegan);
            self.ended += usize::from(event.kind == EventKind::ContactEnded);
        }
        for contact in work.contacts() {
            match contact.friction {
                Friction::Stick => self.sticking += 1,
                Friction::Slip => self.slipping += 1,
            }
        }
        self.most_touching = self.most_touching.max(work.contacts().len());
        self.fewest_touching = self.fewest_touching.min(work.contacts().len());
    }
}

/// One step of a method.
type Method = fn(&Model, &mut Memory, &mut Workspace, &[BodyState]);

#[test]
fn a_hundred_thousand_warm_steps_allocate_nothing() {
    allocates_nothing(|model, memory, work, states| {
        step(model, memory, work, states, STEP_S).expect("good states");
    });
}

#[test]
fn a_hundred_thousand_warm_steps_of_the_coupled_method_allocate_nothing() {
    const NO_LOADS: [Wrench; scene::FENDERS + 1] =
        [Wrench { force_n: Vec2::ZERO, moment_nm: 0.0 }; scene::FENDERS + 1];
    allocates_nothing(|model, memory, work, states| {
        advance(model, memory, work, states, &NO_LOADS, STEP_S).expect("good states");
    });
}

fn allocates_nothing(method: Method) {
    let model = scene::berth(500e3);
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    let mut states = scene::states(ship_at(0));
    let mut seen = Seen { fewest_touching: usize::MAX, ..Seen::default() };
    let mut allocations_before = 0;
    for index in 0..WARM_UP_STEPS + STEPS {
        if index == WARM_UP_STEPS {
            allocations_before = ALLOCATIONS.get();
        }
        states[scene::SHIP] = ship_at(index);
        method(&model, &mut memory, &mut work, &states);
        if index >= WARM_UP_STEPS {
            seen.count(&work);
        }
    }
    assert_eq!(ALLOCATIONS.get() - allocations_before, 0, "allocations in warm steps");
    assert!(allocations_before > 0, "the counter counts");

    // The run has the intended contacts.
    assert_eq!((seen.most_touching, seen.fewest_touching), (scene::FENDERS, 0), "{seen:?}");
    assert!(seen.began >= 400 && seen.ended >= 400, "{seen:?}");
    assert!(seen.sticking > 1_000 && seen.slipping > 10_000, "{seen:?}");
}

/// A star of 200 corners. Every second corner is the tip of a ray.
fn star() -> Outline {
    let corner = |k: u32| {
        let (sin, cos) = libm::sincos(core::f64::consts::TAU * f64::from(k) / 200.0);
        vec2(cos, sin) * if k.is_multiple_of(2) { 20.0 } else { 19.0 }
    };
    Outline::new(&(0..200).map(corner).collect::<Vec<_>>()).expect("a good outline").0
}

/// Two stars with many pieces. Their rays meet, part, and merge into other patches, as one star rolls to and fro on the
/// other.
#[test]
fn warm_steps_of_outlines_of_many_pieces_allocate_nothing() {
    let mut builder = Model::builder();
    let free = Mobility::Free { mass_kg: 1e6, yaw_inertia_kgm2: 1e8 };
    for (key, mobility) in [(0, free), (1, Mobility::Fixed)] {
        builder.body(Body { name: format!("star {key}"), key, outline: star(), mobility });
    }
    let material = builder.material(Material {
        stiffness_npm2: 500e3,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 3e6,
        friction_static: 0.5,
        friction_dynamic: 0.5,
        restitution: 0.1,
    });
    builder.all_other_pairs(material);
    let model = builder.build().expect("a good model");
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    let mut states = [BodyState::default(); 2];
    let (mut allocations_before, mut most, mut splits) = (0, 0, 0);
    const PERIOD: usize = 1_000;
    for index in 0..6 * PERIOD {
        if index == 3 * PERIOD {
            allocations_before = ALLOCATIONS.get();
        }
        let turn = core::f64::consts::TAU * (index % PERIOD) as f64 / PERIOD as f64;
        let place_m = vec2(2.0 * libm::sin(turn), 39.5 + libm::cos(2.0 * turn));
        states[0] = BodyState { position_m: place_m, heading_rad: 0.1 * turn, ..states[0] };
        step(&model, &mut memory, &mut work, &states, STEP_S).expect("good states");
        most = most.max(work.contacts().len());
        splits += work.events().iter().filter(|e| e.kind == EventKind::PatchSplit).count();
    }
    assert_eq!(ALLOCATIONS.get() - allocations_before, 0, "allocations in warm steps");
    assert!(most >= 4 && splits > 10, "{most} {splits}");
}

/// A load pushes a ship against the fenders and pulls her off again. Forward Euler moves her, and the states are two
/// steps late.
#[test]
fn warm_steps_of_a_cosim_host_allocate_nothing() {
    let model = scene::berth(500e3);
    let settings = HostSettings { delay_steps: 2, integration: HostIntegration::ForwardEuler };
    let (mut host, mut work) = (CoSimHost::new(&model, settings), HostWorkspace::new(&model));
    let mut ship = BodyState { position_m: vec2(0.0, 0.8), ..BodyState::default() };
    let mut past = [ship; 3];
    let mut states = scene::states(ship);
    let (mut began, mut allocations_before) = (0, 0);
    for index in 0..WARM_UP_STEPS + STEPS {
        if index == WARM_UP_STEPS {
            allocations_before = ALLOCATIONS.get();
        }
        past[index % 3] = ship;
        states[scene::SHIP] = past[(index + 1) % 3];
        let wrenches = host.step(&model, &mut work, &states, None, STEP_S).expect("good states");
        let contact = wrenches[scene::SHIP];
        let push_n = 200e3 * libm::sin(index as f64 * STEP_S * core::f64::consts::TAU / 200.0);
        ship.position_m += ship.velocity_mps * STEP_S;
        ship.heading_rad += ship.yaw_rate_radps * STEP_S;
        ship.velocity_mps += (contact.force_n + vec2(0.0, push_n)) * (STEP_S / scene::SHIP_MASS_KG);
        ship.yaw_rate_radps += contact.moment_nm * STEP_S / scene::SHIP_YAW_INERTIA_KGM2;
        began += work.events().iter().filter(|e| e.kind == EventKind::ContactBegan).count();
    }
    assert_eq!(ALLOCATIONS.get() - allocations_before, 0, "allocations in warm steps");
    assert!(allocations_before > 0, "the counter counts");
    assert!(began >= 8, "{began}: she touches and leaves");
}
