//! The one module that judges sweeps: continuity, mirror image, laws, growth, references.

use fenderline_contact::number::{greater, lesser};
use fenderline_report::plot::plain;

use super::reference::{Is, Reference, References};
use super::sweep::{Curve, Function, Law, Sweep};

/// How finely sweeps are sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Resolution {
    /// The sweep is sampled at few places along its axis, as in tests.
    Reduced,
    /// For the page.
    Full,
}

impl Resolution {
    /// Number of steps along an axis; the check of continuity also looks at twice as many.
    pub(super) fn steps(self) -> u32 {
        match self {
            Resolution::Reduced => 60,
            Resolution::Full => 360,
        }
    }

    /// Number of steps between two places that are halved again and again in search of a jump: the steps where the
    /// curve bends the most.
    fn searched(self) -> usize {
        match self {
            Resolution::Reduced => 6,
            Resolution::Full => 16,
        }
    }
}

/// How many times a step between two places is halved, always towards the half over which the value changes more. The
/// last half is 10⁻¹² of the step.
const HALVINGS: u32 = 40;
/// Largest change of a continuous curve over the last half of a step, as a share of the curve's largest value.
const LEFT: f64 = 1e-6;
/// Largest difference that rounding may make between a value and its mirror image, as a share of the largest value.
const MIRROR: f64 = 1e-11;
/// Share of the largest value below which the growth of a value is not judged.
const SMALL: f64 = 1e-6;
/// Where a reference is smaller than this share of its largest value, a difference is judged by this share of the
/// largest value, not by the reference itself.
const NEAR_ZERO: f64 = 0.25;

/// The values of a sweep's curves, and what the checks found about the curves.
pub(super) struct Judged {
    /// Places on the axis.
    pub(super) places: Vec<f64>,
    /// For each curve of the sweep, its values at `places`.
    pub(super) values: Vec<Vec<f64>>,
    pub(super) findings: Vec<Finding>,
    pub(super) compared: Vec<Compared>,
}

/// What a check found about a curve.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Finding {
    pub(super) curve: String,
    /// Name of the check, as `known_fault` in `validation/sweeps.toml` gives it.
    pub(super) check: String,
    pub(super) holds: bool,
    /// In words and figures.
    pub(super) found: String,
    /// The place on the axis of the sweep at which the curve is farthest from what the check asks.
    pub(super) at: f64,
    /// Why the check is known to fail; `None` if it is not.
    pub(super) known: Option<String>,
}

/// How a curve compares with a reference.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Compared {
    pub(super) curve: String,
    pub(super) short: String,
    /// Places on the axis, values of the reference, and how much the curve may differ from them.
    pub(super) points: Vec<[f64; 3]>,
    pub(super) is_line: bool,
    /// The least and the greatest ratio of our value to the reference, where the reference is not near zero.
    pub(super) ratio: [f64; 2],
    /// The band.
    pub(super) band: f64,
    /// The greatest difference divided by the allowed difference, and the place where it is.
    pub(super) worst: f64,
    pub(super) worst_at: f64,
    pub(super) holds: bool,
    /// Why the curve is known to be outside the reference's band; `None` if it is not.
    pub(super) known: Option<String>,
}

/// Samples the curves of a sweep and judges them.
pub(super) fn judge(sweep: &Sweep, references: &References, resolution: Resolution) -> Judged {
    let fine = sweep.axis.places(2 * resolution.steps());
    let (mut values, mut findings) = (Vec::new(), Vec::new());
    for curve in &sweep.curves {
        let ys: Vec<f64> = fine.iter().map(|&x| (curve.at)(x)).collect();
        judge_curve(curve, [&fine, &ys], resolution, &mut findings);
        values.push(ys);
    }
    for finding in &mut findings {
        let known = references.known_faults.iter().find(|known| {
            known.sweep == sweep.key && known.curve == finding.curve && known.check == finding.check
        });
        finding.known = known.map(|known| known.note.clone());
    }
    let of_it = references.references.iter().filter(|reference| reference.sweep == sweep.key);
    let compared = of_it.map(|reference| compare(sweep, reference, resolution)).collect();
    Judged { places: fine, values, findings, compared }
}

fn judge_curve(
    curve: &Curve,
    [xs, ys]: [&[f64]; 2],
    resolution: Resolution,
    findings: &mut Vec<Finding>,
) {
    let mut add = |check: &str, holds: bool, found: String, at: f64| {
        let (curve, check) = (curve.name.clone(), check.to_owned());
        findings.push(Finding { curve, check, holds, found, at, known: None });
    };
    if let Some(bad) = ys.iter().position(|y| !y.is_finite()) {
        add("finite", false, format!("{} at {}", ys[bad], xs[bad]), xs[bad]);
        return;
    }
    let largest = ys.iter().map(|y| y.abs()).fold(0.0, greater);
    let (holds, found, at) = continuity(curve, [xs, ys], largest, resolution);
    add("continuity", holds, found, at);
    for (what, image) in &curve.images {
        let (off, at) = asymmetry(image, [xs, ys]);
        let share = if largest > 0.0 { off / largest } else { off };
        let holds = share <= greater(MIRROR, curve.noise);
        add(what, holds, format!("{share:.0e} of the largest value"), at);
    }
    for Law { says, margin } in &curve.laws {
        let margins: Vec<f64> = xs.iter().map(|&x| margin(x)).collect();
        let of_all = margins.iter().map(|m| m.abs()).fold(0.0, greater);
        let (worst, at) = least([xs, &margins]);
        let holds = worst >= -greater(1e-9, curve.noise) * greater(of_all, 1e-3 * largest);
        let found = match holds {
            true => "holds".to_owned(),
            false => {
                let (by, value) = (plain(worst.abs(), 3), plain((curve.at)(at), 3));
                format!("BROKEN by {by} where the value of the curve is {value}")
            }
        };
        add(says, holds, found, at);
    }
    if let Some(power) = curve.growth {
        let (fastest, at) = fastest_growth([xs, ys], largest);
        let holds = fastest <= power + greater(1e-6, 1e3 * curve.noise);
        let found = match fastest.is_finite() {
            true => format!("as the power {fastest:.2} of the axis, at most"),
            false => "does not grow".to_owned(),
        };
        add(&format!("the curve grows at most as the power {power} of the axis"), holds, found, at);
    }
}

/// Checks that a curve is continuous. The steps where the curve bends the most are halved again and again: over the
/// last half, a continuous curve changes by almost nothing.
fn continuity(
    curve: &Curve,
    [xs, ys]: [&[f64]; 2],
    largest: f64,
    resolution: Resolution,
) -> (bool, String, f64) {
    if largest == 0.0 {
        return (true, "zero everywhere".to_owned(), xs[0]);
    }
    let step = |from: usize, by: usize| (ys[from + by] - ys[from]).abs();
    let fine = (0..ys.len() - 1).map(|k| step(k, 1)).fold(0.0, greater);
    let coarse = (0..ys.len() - 2).step_by(2).map(|k| step(k, 2)).fold(0.0, greater);
    let (mut left, mut at) = (0.0, xs[0]);
    for index in most_bent(ys, resolution.searched()) {
        let (rest, place) =
            halved_on(&curve.at, [xs[index], xs[index + 1]], [ys[index], ys[index + 1]]);
        if rest > left {
            (left, at) = (rest, place);
        }
    }
    let share = left / largest;
    let is_continuous = share <= greater(LEFT, curve.noise);
    let steps = format!(
        "largest step {:.2} % of the curve's largest value, and {:.2} % at twice the resolution",
        100.0 * coarse / largest,
        100.0 * fine / largest,
    );
    match (is_continuous, curve.jump) {
        (true, None) => (true, steps, at),
        (true, Some(why)) => {
            (false, format!("the curve has no jump, though its law has one: {why}"), at)
        }
        (false, Some(why)) => (
            true,
            format!(
                "the curve jumps by {:.1} % of its largest value, as its law does: {why}",
                100.0 * share
            ),
            at,
        ),
        (false, None) => (
            false,
            format!(
                "a JUMP of {:.3} % of the curve's largest value that no halving of the step \
                 lessens; {steps}",
                100.0 * share
            ),
            at,
        ),
    }
}

/// Finds the steps where the slope of the curve changes the most, and the largest step.
fn most_bent(ys: &[f64], count: usize) -> Vec<usize> {
    let step = |k: usize| ys[k + 1] - ys[k];
    let last = ys.len() - 2;
    let bend = |k: usize| {
        let before = if k > 0 { (step(k) - step(k - 1)).abs() } else { 0.0 };
        let after = if k < last { (step(k + 1) - step(k)).abs() } else { 0.0 };
        // The steps beside a jump bend as much as the one that has it, on one side.
        greater(before, after)
    };
    let mut order: Vec<usize> = (0..=last).collect();
    order.sort_by(|&a, &b| bend(b).total_cmp(&bend(a)));
    order.truncate(count);
    let steepest =
        (0..=last).fold(0, |most, k| if step(k).abs() > step(most).abs() { k } else { most });
    order.push(steepest);
    order
}

/// Halves a step again and again, always towards the half over which the value changes more. Returns the change of the
/// value over the last half, and the place of this half.
fn halved_on(
    at: &Function,
    [mut low, mut high]: [f64; 2],
    [mut y_low, mut y_high]: [f64; 2],
) -> (f64, f64) {
    for _ in 0..HALVINGS {
        let middle = low.midpoint(high);
        if middle <= low || middle >= high {
            break;
        }
        let y = at(middle);
        if (y - y_low).abs() > (y_high - y).abs() {
            (high, y_high) = (middle, y);
        } else {
            (low, y_low) = (middle, y);
        }
    }
    ((y_high - y_low).abs(), low)
}

fn asymmetry(mirrored: &Function, [xs, ys]: [&[f64]; 2]) -> (f64, f64) {
    let mut worst = (0.0, xs[0]);
    for (&x, &y) in xs.iter().zip(ys) {
        let off = (mirrored(x) - y).abs();
        if off > worst.0 || off.is_nan() {
            worst = (off, x);
        }
    }
    worst
}

/// Finds the least value of a curve, and its place on the axis.
fn least([xs, ys]: [&[f64]; 2]) -> (f64, f64) {
    let mut least = (f64::INFINITY, xs[0]);
    for (&x, &y) in xs.iter().zip(ys) {
        if y < least.0 || y.is_nan() {
            least = (y, x);
        }
    }
    least
}

/// Finds the greatest exponent with which the size of the value grows from one place to the next, away from zero.
fn fastest_growth([xs, ys]: [&[f64]; 2], largest: f64) -> (f64, f64) {
    let mut fastest = (f64::NEG_INFINITY, xs[0]);
    for k in 1..xs.len() {
        let (near, far) = if xs[k - 1].abs() < xs[k].abs() { (k - 1, k) } else { (k, k - 1) };
        let (x0, x1) = (xs[near].abs(), xs[far].abs());
        let (y0, y1) = (ys[near].abs(), ys[far].abs());
        let is_one_side = xs[near] * xs[far] > 0.0 && ys[near] * ys[far] > 0.0;
        if !is_one_side || y0 < SMALL * largest {
            continue;
        }
        let power = libm::log(y1 / y0) / libm::log(x1 / x0);
        if power > fastest.0 {
            fastest = (power, xs[near]);
        }
    }
    fastest
}

/// Compares a reference with the curve that it names.
///
/// # Panics
/// Panics if the sweep has no such curve or no such formula, which is a mistake in `validation/sweeps.toml`.
fn compare(sweep: &Sweep, reference: &Reference, resolution: Resolution) -> Compared {
    let curve = sweep.curves.iter().find(|curve| curve.name == reference.curve);
    let curve = curve
        .unwrap_or_else(|| panic!("sweeps.toml: {} has no curve {}", sweep.key, reference.curve));
    let pairs: Vec<[f64; 2]> = match &reference.is {
        Is::Points(points) => points.clone(),
        Is::Line { from, to } => {
            let line = sweep
                .lines
                .iter()
                .find(|line| line.short == reference.short && line.curve == reference.curve);
            let line = line.unwrap_or_else(|| {
                panic!("sweeps.toml: {} has no formula {}", sweep.key, reference.short)
            });
            let places = sweep.axis.places(resolution.steps());
            let within = places.into_iter().filter(|x| (*from..=*to).contains(x));
            within.map(|x| [x, (line.at)(x)]).collect()
        }
    };
    let largest = pairs.iter().map(|[_, y]| y.abs()).fold(0.0, greater);
    let (mut ratio, mut worst) = ([f64::INFINITY, f64::NEG_INFINITY], (0.0, pairs[0][0]));
    let mut points = Vec::with_capacity(pairs.len());
    for [x, theirs] in pairs {
        let ours = (curve.at)(x);
        let allowed = reference.band * greater(theirs.abs(), NEAR_ZERO * largest);
        points.push([x, theirs, allowed]);
        let off = (ours - theirs).abs() / allowed;
        if off > worst.0 || off.is_nan() {
            worst = (off, x);
        }
        if theirs.abs() >= NEAR_ZERO * largest {
            ratio = [lesser(ratio[0], ours / theirs), greater(ratio[1], ours / theirs)];
        }
    }
    let known = &reference.known_mismatch;
    Compared {
        curve: reference.curve.clone(),
        short: reference.short.clone(),
        points,
        is_line: matches!(reference.is, Is::Line { .. }),
        ratio,
        band: reference.band,
        worst: worst.0,
        worst_at: worst.1,
        holds: worst.0 <= 1.0 + 1e-9,
        known: (!known.is_empty()).then(|| known.clone()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::sweep::Axis;
    use super::*;

    /// The checks that fail for a curve over −1 to 1.
    fn failing(curve: Curve) -> Vec<String> {
        let sweep = Sweep {
            key: "test",
            subject: "Test",
            title: String::new(),
            axis: Axis::new("x", "", -1.0, 1.0),
            value: ["y", ""],
            curves: vec![curve],
            lines: Vec::new(),
            note: "",
        };
        let none = References { references: vec![], none: vec![], known_faults: vec![] };
        let judged = judge(&sweep, &none, Resolution::Reduced);
        let failing = judged.findings.into_iter().filter(|finding| !finding.holds);
        failing.map(|finding| finding.check).collect()
    }

    #[test]
    fn a_jump_fails_and_a_steep_or_bent_curve_does_not() {
        let steps =
            |size: f64| Curve::of("jump", move |x: f64| x * x + if x > 0.123 { size } else { 0.0 });
        assert_eq!(failing(steps(0.5)), ["continuity"]);
        assert_eq!(failing(steps(1e-3)), ["continuity"]);
        assert!(failing(steps(0.5).jumping("by its law")).is_empty());
        assert_eq!(failing(steps(0.0).jumping("by its law")), ["continuity"], "there is none");
        assert!(failing(Curve::of("root", |x: f64| x.abs().sqrt())).is_empty());
        assert!(failing(Curve::of("corner", |x: f64| (x - 0.3).abs())).is_empty());
        let steep = Curve::of("steep", |x: f64| libm::tanh(2e3 * (x - 0.1)));
        assert!(failing(steep).is_empty());
        assert_eq!(failing(Curve::of("pole", |x: f64| 1.0 / x)), ["finite"]);
    }

    #[test]
    fn an_asymmetry_a_wrong_sign_and_a_fast_growth_fail() {
        assert!(failing(Curve::of("cubic", |x| x * x * x).odd()).is_empty());
        assert_eq!(failing(Curve::of("cubic", |x| x * x * x + 1e-9).odd()), ["mirror"]);
        let drag = |power: f64| Curve::of("drag", move |x: f64| -x * libm::pow(x.abs(), power));
        let says = "it is against the motion";
        assert!(failing(drag(1.0).value_law(says, |x, y| -x * y).growing_at_most(2.0)).is_empty());
        assert_eq!(failing(drag(1.0).value_law(says, |x, y| x * y)), [says]);
        assert_eq!(
            failing(drag(1.2).growing_at_most(2.0)),
            ["the curve grows at most as the power 2 of the axis"]
        );
    }
}
