//! Says what a sweep is: one force along one axis, by several curves, with the laws that the force must obey.

use std::rc::Rc;

use fenderline_contact::number::greater;

/// The value of a curve, a force or its coefficient, as a function of the place on the sweep's axis.
pub(super) type Function = Rc<dyn Fn(f64) -> f64>;

/// A sweep: one force along one axis.
pub(super) struct Sweep {
    /// Name of the sweep in `validation/sweeps.toml` and in file names.
    pub(super) key: &'static str,
    /// The heading of the force under which the sweep stands.
    pub(super) subject: &'static str,
    pub(super) title: String,
    pub(super) axis: Axis,
    /// Name and unit of the sweep's values.
    pub(super) value: [&'static str; 2],
    pub(super) curves: Vec<Curve>,
    /// References that are formulas.
    pub(super) lines: Vec<Line>,
    pub(super) note: &'static str,
}

/// The axis of a sweep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axis {
    pub(super) name: &'static str,
    pub(super) unit: &'static str,
    pub(super) from: f64,
    pub(super) to: f64,
    /// True if the ratio from one place to the next is constant, not the step.
    pub(super) is_geometric: bool,
}

impl Axis {
    pub(super) const fn new(name: &'static str, unit: &'static str, from: f64, to: f64) -> Axis {
        Axis { name, unit, from, to, is_geometric: false }
    }

    /// Makes the axis geometric: the ratio from one place to the next is constant.
    pub(super) const fn geometric(mut self) -> Axis {
        self.is_geometric = true;
        self
    }

    /// Makes an axis of angles from one side of the bow to the stern (°).
    pub(super) const fn off_the_bow(name: &'static str) -> Axis {
        Axis::new(name, "°", 0.0, 180.0)
    }

    /// Returns `count` + 1 places from one end of the axis to the other.
    pub(super) fn places(&self, count: u32) -> Vec<f64> {
        let place = |index: u32| {
            let share = f64::from(index) / f64::from(count);
            match index {
                0 => self.from,
                _ if index == count => self.to,
                _ if self.is_geometric => self.from * libm::pow(self.to / self.from, share),
                _ => self.from + (self.to - self.from) * share,
            }
        };
        (0..=count).map(place).collect()
    }
}

/// One curve of a sweep, with the laws that it must obey.
pub(super) struct Curve {
    /// Name of the curve in the legend, which no other curve of the sweep may have.
    pub(super) name: String,
    pub(super) at: Function,
    /// Other situations that must give the same values, such as the mirror image with the signs turned back: the name
    /// of each situation, and its values along the axis.
    pub(super) images: Vec<(&'static str, Function)>,
    pub(super) laws: Vec<Law>,
    /// Largest power of the axis with which the value may grow.
    pub(super) growth: Option<f64>,
    /// Why the curve may jump, if the law of the force itself has a jump.
    pub(super) jump: Option<&'static str>,
    /// Numerical noise of the curve from an iteration, as a share of the largest value.
    pub(super) noise: f64,
}

/// A law of physics that a curve must obey.
pub(super) struct Law {
    /// The law in words, as it is printed.
    pub(super) says: &'static str,
    /// Function of the place that is not negative where the law holds.
    pub(super) margin: Function,
}

/// A reference that is given by a formula.
pub(super) struct Line {
    /// Short name of the reference, as in `validation/sweeps.toml`.
    pub(super) short: &'static str,
    /// Name of the curve with which the reference is compared.
    pub(super) curve: String,
    pub(super) at: Function,
}

/// Noise of a curve by rounding alone, as a share of the largest value.
const ROUNDING: f64 = 1e-12;

impl Curve {
    pub(super) fn of(name: impl Into<String>, at: impl Fn(f64) -> f64 + 'static) -> Curve {
        Curve {
            name: name.into(),
            at: Rc::new(at),
            images: Vec::new(),
            laws: Vec::new(),
            growth: None,
            jump: None,
            noise: ROUNDING,
        }
    }

    /// With its mirror image.
    pub(super) fn mirrored(self, at: impl Fn(f64) -> f64 + 'static) -> Curve {
        self.same_as("mirror", at)
    }

    /// Adds another situation that must give the curve's values to rounding.
    pub(super) fn same_as(
        mut self,
        what: &'static str,
        at: impl Fn(f64) -> f64 + 'static,
    ) -> Curve {
        self.images.push((what, Rc::new(at)));
        self
    }

    /// Adds the law f(x) = f(−x): the mirror image is on the other side of the axis.
    pub(super) fn even(self) -> Curve {
        let at = self.at.clone();
        self.mirrored(move |x| at(-x))
    }

    /// f(x) = −f(−x).
    pub(super) fn odd(self) -> Curve {
        let at = self.at.clone();
        self.mirrored(move |x| -at(-x))
    }

    /// Adds a law to the curve: `margin` is not negative where the law holds.
    pub(super) fn law(
        mut self,
        says: &'static str,
        margin: impl Fn(f64) -> f64 + 'static,
    ) -> Curve {
        self.laws.push(Law { says, margin: Rc::new(margin) });
        self
    }

    /// Adds a law about the curve's value.
    pub(super) fn value_law(
        self,
        says: &'static str,
        margin: impl Fn(f64, f64) -> f64 + 'static,
    ) -> Curve {
        let at = self.at.clone();
        self.law(says, move |x| margin(x, at(x)))
    }

    /// Adds the law that the curve's value is never below zero.
    pub(super) fn never_negative(self, says: &'static str) -> Curve {
        self.value_law(says, |_, value| value)
    }

    /// Adds the law that the curve's value is never above zero.
    pub(super) fn never_positive(self, says: &'static str) -> Curve {
        self.value_law(says, |_, value| -value)
    }

    /// Adds the law that the size of the curve's value is at most a limit.
    pub(super) fn at_most(self, says: &'static str, limit: impl Fn(f64) -> f64 + 'static) -> Curve {
        self.value_law(says, move |x, value| limit(x) - value.abs())
    }

    /// Adds the law that the curve never falls along the axis; `step` is the step with which this is checked.
    pub(super) fn rising(self, says: &'static str, step: f64) -> Curve {
        let at = self.at.clone();
        self.law(says, move |x| at(x + step) - at(x))
    }

    /// Adds the law that the curve never rises along the axis.
    pub(super) fn falling(self, says: &'static str, step: f64) -> Curve {
        let at = self.at.clone();
        self.law(says, move |x| at(x) - at(x + step))
    }

    /// Adds the law that the curve grows at most as this power of the axis, on either side of zero.
    pub(super) fn growing_at_most(mut self, power: f64) -> Curve {
        self.growth = Some(power);
        self
    }

    /// Says that the curve jumps by the law of the force.
    pub(super) fn jumping(mut self, why: &'static str) -> Curve {
        self.jump = Some(why);
        self
    }

    /// Says that the curve's values come from an iteration, whose noise is this share of the largest value.
    pub(super) fn noisy(mut self, share: f64) -> Curve {
        self.noise = greater(share, ROUNDING);
        self
    }
}

impl Line {
    pub(super) fn of(
        short: &'static str,
        curve: impl Into<String>,
        at: impl Fn(f64) -> f64 + 'static,
    ) -> Line {
        Line { short, curve: curve.into(), at: Rc::new(at) }
    }
}
