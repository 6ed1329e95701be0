//! A warm step of the simulator allocates nothing. The test runs scenarios of the repository with tugs, pilots, azimuth
//! units, lines, waves, gusts and dolphins, with a counting allocator.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::path::Path;
use std::sync::Arc;

use fenderline_contact::vec2;
use fenderline_scenario::Scenario;
use fenderline_sim::environment::{BankMethod, DepthField};
use fenderline_sim::hydro::Squat;
use fenderline_sim::{Bottom, Outside, Setup, Simulation};

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

/// The set-up of a scenario of the repository.
fn load(scenario: &str) -> Setup {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios").join(scenario);
    Scenario::load(&path, &[]).unwrap_or_else(|error| panic!("{error}")).setup
}

/// Number of allocator calls in the steps between two times (s).
fn allocations(setup: Setup, from_s: f64, until_s: f64) -> u64 {
    let mut simulation = Simulation::new(setup).expect("a good set-up");
    let mut before = 0;
    let last = simulation.steps_until(until_s);
    let first = simulation.steps_until(from_s);
    assert!(first < last && last <= simulation.steps_total());
    while simulation.steps_taken() < last {
        if simulation.steps_taken() == first {
            before = ALLOCATIONS.get();
        }
        simulation.step().expect("a good step");
    }
    assert!(before > 0, "the counter counts");
    ALLOCATIONS.get() - before
}

#[test]
fn a_warm_step_allocates_nothing() {
    // Some lists grow when something happens for the first time, such as the first touch or the first events. They are
    // warm after it.
    for (scenario, from_s, until_s) in [
        // A station pilot with thrusters and two tugs brings the ship in. Then she rests on her fenders.
        ("berth/alongside_with_two_tugs.toml", 100.0, 200.0),
        ("berth/alongside_with_two_tugs.toml", 220.0, 300.0),
        // Tugs with azimuth units push.
        ("berth/asd_tugs_push_alongside.toml", 125.0, 200.0),
        ("berth/flexible_dolphins.toml", 60.0, 100.0),
        // Lines and gusts.
        ("berth/moored_three_hours_in_gusts.toml", 60.0, 500.0),
        ("berth/chains_hold_a_panel_that_turns.toml", 40.0, 60.0),
        ("environment/rolling_in_a_beam_sea.toml", 10.0, 60.0),
        ("environment/across_a_tidal_stream.toml", 10.0, 60.0),
        ("environment/dredged_anchor.toml", 100.0, 200.0),
    ] {
        assert_eq!(allocations(load(scenario), from_s, until_s), 0, "allocations in {scenario}");
    }
}

/// A ship that sits on a slope with her side, beside her fenders.
#[test]
fn a_warm_step_on_a_slope_allocates_nothing() {
    let mut setup = load("environment/aground_at_low_water.toml");
    let node = |index: usize| 15.0 + 0.2 * ((index / 101) as f32 - 50.0);
    let depths_m = (0..101 * 101).map(node).collect();
    let field = DepthField::new(vec2(-500.0, -500.0), 10.0, 101, 101, depths_m).expect("a field");
    let environment = &mut setup.world.environment;
    environment.depth_m = None;
    environment.bottom = Some(Bottom {
        field: Arc::new(field),
        outside: Outside::Error,
        banks: Some(BankMethod::Norrbin),
    });
    environment.squat = Some(Squat::BarrassChannel);
    // High water is 3 m above datum; her keel is 14 m under the water.
    setup.bodies[0].position_m.y = -200.0;
    let mut simulation = Simulation::new(setup.clone()).expect("a good set-up");
    simulation.step().expect("a good step");
    assert!(simulation.vessels()[0].aground, "{:?}", simulation.vessels()[0].under_keel_m);
    assert_eq!(allocations(setup, 10.0, 60.0), 0);
}
