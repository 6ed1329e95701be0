//! Checking a scenario takes time in proportion to its size. The tests compare ratios of times, each the least of
//! several runs, so that other programs on the machine do not matter.

use std::fmt::Write as _;
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use fenderline_scenario::Scenario;

const HEAD: &str = "[time]\nstep = \"0.1 s\"\nduration = \"1 s\"\n";

/// Processor time of this thread; where the system does not report it, elapsed time.
fn work_time() -> Duration {
    static START: OnceLock<Instant> = OnceLock::new();
    let statistics = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    match statistics.split(' ').next().and_then(|nanoseconds| nanoseconds.parse().ok()) {
        Some(nanoseconds) => Duration::from_nanos(nanoseconds),
        None => START.get_or_init(Instant::now).elapsed(),
    }
}

/// The least time of some checks, and how many notices there are.
fn time_of(text: &str) -> (Duration, usize) {
    let once = || {
        let start = work_time();
        let scenario = Scenario::parse(text, "large.toml").expect("it is good");
        (work_time() - start, scenario.notices.len())
    };
    (0..4).map(|_| once()).min().expect("some tries")
}

/// Eight times as much input takes about eight times as long; quadratic growth would take 64 times. The bound is their
/// geometric mean.
fn assert_linear(what: &str, text: impl Fn(usize) -> String, fewest_notices: usize) {
    const SMALL: usize = 1000;
    let (small, large) = (time_of(&text(SMALL)), time_of(&text(8 * SMALL)));
    assert!(large.1 >= 8 * fewest_notices, "{what}: {} notices", large.1);
    let ratio = large.0.as_secs_f64() / small.0.as_secs_f64();
    println!("{what}: {:?}, eight times as many {:?}: {ratio:.1} times as long", small.0, large.0);
    assert!(ratio < 22.0, "{what}: eight times as many take {ratio:.1} times as long");
}

fn tables(count: usize, table: impl Fn(usize, &mut String)) -> String {
    let mut text = HEAD.to_owned();
    (0..count).for_each(|index| table(index, &mut text));
    text
}

fn body(index: usize, text: &mut String) {
    let _ = write!(
        text,
        "[body.b{index}]\noutline = [[-1, 1], [1, 1], [1, -1], [-1, -1]]\nmass = \"1 t\"\ngyradius = \"1 m\"\n\
         position = [{}, 0]\n",
        10 * index
    );
}

fn material(index: usize, text: &mut String) {
    let _ = write!(text, "[material.m{index}]\nstiffness = \"1 MN/m^2\"\nrestitution = 0.1\n");
}

#[test]
fn bodies_with_a_notice_each_are_not_checked_in_quadratic_time() {
    assert_linear("bodies", |n| tables(n, body), 1000);
}

#[test]
fn unused_materials_and_bodies_are_not_reported_in_quadratic_time() {
    let pair = "[[pair]]\nbodies = [\"b0\", \"b1\"]\nmaterial = \"m0\"\n";
    let all = |n| {
        tables(n, |index, text| {
            body(index, text);
            material(index, text);
        }) + pair
    };
    assert_linear("materials", all, 2 * 1000 - 3);
}

#[test]
fn bodies_in_one_long_line_are_not_checked_in_quadratic_time() {
    let one_line = |n: usize| {
        let bodies = (0..n).map(|index| {
            format!(
                "b{index} = {{ outline = [[-1, 1], [1, 1], [1, -1], [-1, -1]], mass = \"1 t\", gyradius = \"1 m\", \
                 position = [{}, 0] }}",
                10 * index
            )
        });
        format!("body = {{ {} }}\n{HEAD}", bodies.collect::<Vec<_>>().join(", "))
    };
    assert_linear("bodies in one line", one_line, 1000);
}

#[test]
fn kinds_of_vessels_and_their_bodies_are_not_looked_up_in_quadratic_time() {
    let all = |n| {
        tables(n, |index, text| {
            let _ = write!(
                text,
                "[vessel.v{index}]\nfrom = \"kcs\"\n[body.b{index}]\nvessel = \"v{index}\"\nposition = [{}, 0]\n\
                 outline = [[-1, 1], [1, 1], [1, -1], [-1, -1]]\n",
                1000 * index
            );
        })
    };
    assert_linear("vessels", all, 0);
}

#[test]
fn pairs_fenders_lines_and_orders_are_not_checked_in_quadratic_time() {
    let all = |n| {
        let mut text = HEAD.to_owned();
        material(0, &mut text);
        (0..=n).for_each(|index| body(index, &mut text));
        for index in 0..n {
            let _ = write!(
                text,
                "[[pair]]\nbodies = [\"b{index}\", \"b{}\"]\nmaterial = \"m0\"\n\
                 [fender.f{index}]\non = \"b{index}\"\nposition = [1, 0]\nfacing = \"0 deg\"\nwidth = \"1 m\"\n\
                 projection = \"1 m\"\nmaterial = \"m0\"\nstiffness = \"2 MN/m\"\n",
                index + 1
            );
        }
        text
    };
    assert_linear("pairs and fenders", all, 1000);
}
