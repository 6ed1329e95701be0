//! Axes of charts: title, range and ticks.

use fenderline_contact::number::{bounded, greater, lesser};

use super::number::{fixed, order_of};

/// An axis of a chart: its name, its unit, and values that it must cover besides the data.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    label: String,
    unit: String,
    included: Option<(f64, f64)>,
    is_tight: bool,
    is_logarithmic: bool,
}

impl Axis {
    /// An axis whose title reads `label [unit]`; an empty `unit` leaves the bracket out. The range of the axis covers
    /// the data, widened to round numbers.
    pub fn new(label: &str, unit: &str) -> Axis {
        Axis {
            label: label.to_owned(),
            unit: unit.to_owned(),
            included: None,
            is_tight: false,
            is_logarithmic: false,
        }
    }

    /// Extends the range of the axis so that it covers `value`.
    pub fn including(mut self, value: f64) -> Axis {
        let (lo, hi) = self.included.unwrap_or((value, value));
        self.included = Some((lesser(lo, value), greater(hi, value)));
        self
    }

    /// Makes the axis begin and end exactly at the smallest and the largest value, not at round numbers.
    pub fn tight(mut self) -> Axis {
        self.is_tight = true;
        self
    }

    /// Makes the axis logarithmic, from one power of ten to another; values that are not positive are not drawn.
    pub fn logarithmic(mut self) -> Axis {
        self.is_logarithmic = true;
        self
    }

    pub(super) fn title(&self) -> String {
        if self.unit.is_empty() {
            self.label.clone()
        } else {
            format!("{} [{}]", self.label, self.unit)
        }
    }

    pub(super) fn unit(&self) -> &str {
        &self.unit
    }

    /// Fits the range and ticks of the axis to `values`; values that are not finite are ignored.
    pub(super) fn fit(&self, values: impl Iterator<Item = f64>, ticks_wanted: u32) -> Fitted {
        if self.is_logarithmic {
            return self.fit_decades(values);
        }
        let extremes = values.filter(|v| v.is_finite()).fold(self.included, |range, v| {
            let (lo, hi) = range.unwrap_or((v, v));
            Some((lesser(lo, v), greater(hi, v)))
        });
        let (lo, hi) = widened(extremes.unwrap_or((0.0, 1.0)));
        // Adding 0 gives zero one sign; otherwise a −0 in the data would become an end of the axis.
        let (lo, hi) = (lo + 0.0, hi + 0.0);
        let step = nice_step(hi - lo, ticks_wanted);
        if self.is_tight {
            return Fitted::new(lo, hi, step);
        }
        Fitted::new(libm::floor(lo / step) * step + 0.0, libm::ceil(hi / step) * step + 0.0, step)
    }
}

impl Axis {
    /// Fits a logarithmic axis to `values`: the range runs from one power of ten to another.
    fn fit_decades(&self, values: impl Iterator<Item = f64>) -> Fitted {
        let included = self.included.into_iter().flat_map(|(lo, hi)| [lo, hi]);
        let positive = included.chain(values).filter(|v| v.is_finite() && *v > 0.0);
        let extremes = positive.fold(None, |range, v| {
            let (lo, hi) = range.unwrap_or((v, v));
            Some((lesser(lo, v), greater(hi, v)))
        });
        let (lo, hi) = extremes.unwrap_or((0.1, 1.0));
        let slack = 1e-9;
        let first = libm::floor(libm::log10(lo) + slack) + 0.0;
        let last = libm::ceil(libm::log10(hi) - slack) + 0.0;
        Fitted {
            lo: first,
            hi: if last > first { last } else { first + 1.0 },
            // Every decade, or every second decade and so on if there are many.
            step: greater(libm::ceil((last - first) / 12.0), 1.0),
            is_logarithmic: true,
        }
    }
}

/// Widens a range so that it has a length even if all data have the same value.
fn widened((lo, hi): (f64, f64)) -> (f64, f64) {
    let scale = greater(lo.abs(), hi.abs());
    if hi - lo > 1e-12 * scale && (hi - lo).is_finite() {
        return (lo, hi);
    }
    if scale == 0.0 {
        return (0.0, 1.0);
    }
    if hi - lo > scale {
        // The difference overflowed. This does not happen in charts of runs, but the function must end
        // for any input.
        return (-f64::MAX / 4.0, f64::MAX / 4.0);
    }
    (lo - 0.05 * scale, hi + 0.05 * scale)
}

/// The step, 1, 2 or 5 times a power of ten, that divides `span` into about `wanted` parts.
pub(super) fn nice_step(span: f64, wanted: u32) -> f64 {
    let rough = greater(span / f64::from(wanted.max(1)), f64::MIN_POSITIVE);
    let power = libm::exp10(f64::from(order_of(rough)));
    let ratio = rough / power;
    let leading = match ratio {
        r if r <= 1.000_001 => 1.0,
        r if r <= 2.000_001 => 2.0,
        r if r <= 5.000_001 => 5.0,
        _ => 10.0,
    };
    leading * power
}

/// An axis fitted to data.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Fitted {
    pub(super) lo: f64,
    pub(super) hi: f64,
    step: f64,
    /// Whether the axis is logarithmic, with powers of ten as ends and step.
    is_logarithmic: bool,
}

impl Fitted {
    pub(super) fn new(lo: f64, hi: f64, step: f64) -> Fitted {
        Fitted { lo, hi, step, is_logarithmic: false }
    }

    /// Place of `value` on the axis: 0 at the low end, 1 at the high end.
    pub(super) fn share(&self, value: f64) -> f64 {
        let value = if self.is_logarithmic { libm::log10(value) } else { value };
        (value - self.lo) / (self.hi - self.lo)
    }

    /// The ticks of the axis and their labels.
    pub(super) fn ticks(&self) -> Vec<(f64, String)> {
        // Multiples by whole numbers, so that no rounding adds up; bounded for any input.
        let slack = 1e-9;
        let first = libm::ceil(self.lo / self.step - slack);
        let last = libm::floor(self.hi / self.step + slack);
        let count = bounded(last - first, 0.0, 50.0) as u32;
        let decimals = usize::try_from(-order_of(self.step * 1.000_001)).unwrap_or(0);
        (0..=count)
            .map(|i| {
                let value = (first + f64::from(i)) * self.step;
                if self.is_logarithmic {
                    return (libm::exp10(value), power_of_ten(value as i32));
                }
                (value, fixed(value, decimals))
            })
            .collect()
    }
}

/// The label of a power of ten: a whole or decimal number near 1, else 10 with a raised exponent.
fn power_of_ten(exponent: i32) -> String {
    match exponent {
        0..=3 => fixed(libm::exp10(f64::from(exponent)), 0),
        -2..0 => fixed(libm::exp10(f64::from(exponent)), usize::try_from(-exponent).unwrap_or(0)),
        _ => {
            let raised = |c: char| match c {
                '-' => '⁻',
                '1' => '¹',
                '2' => '²',
                '3' => '³',
                // The others stand in a row.
                digit => {
                    char::from_u32(0x2070 + u32::from(digit) - u32::from('0')).unwrap_or(digit)
                }
            };
            format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_cover_the_data() {
        let fitted = Axis::new("force", "kN").fit([0.0, 5012.0].into_iter(), 5);
        let labels: Vec<_> = fitted.ticks().into_iter().map(|(_, label)| label).collect();
        assert_eq!(labels, ["0", "2000", "4000", "6000"]);
        let fitted = Axis::new("depth", "m").fit([0.0, 0.96].into_iter(), 5);
        let labels: Vec<_> = fitted.ticks().into_iter().map(|(_, label)| label).collect();
        assert_eq!(labels, ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
    }

    #[test]
    fn a_logarithmic_axis_has_a_tick_a_decade() {
        let fitted = Axis::new("p", "").logarithmic().fit([0.5, 2e-4, 0.0, -1.0].into_iter(), 5);
        let labels: Vec<_> = fitted.ticks().into_iter().map(|(_, label)| label).collect();
        assert_eq!(labels, ["10⁻⁴", "10⁻³", "0.01", "0.1", "1"]);
        assert!((fitted.share(0.01) - 0.5).abs() < 1e-12);
        assert!(!fitted.share(0.0).is_finite() && !fitted.share(-1.0).is_finite());
        let fitted = Axis::new("p", "").logarithmic().fit([1e-40, 1e40].into_iter(), 5);
        assert!(fitted.ticks().len() < 14);
        assert!(Axis::new("p", "").logarithmic().fit([].into_iter(), 5).ticks().len() == 2);
    }

    /// On aarch64 the minimum of +0 and −0 was −0, and the report's axis began at "-0"; on x86 it was +0.
    #[test]
    fn an_axis_does_not_begin_at_minus_zero() {
        for data in [[0.0, -0.0, 1.0], [-0.0, 0.0, 1.0], [-0.0, -0.0, 1.0], [-0.0, -1.0, -0.3]] {
            for axis in [Axis::new("force", "kN"), Axis::new("force", "kN").tight()] {
                for axis in [axis.clone(), axis.clone().including(0.0), axis.including(-0.0)] {
                    let fitted = axis.fit(data.into_iter(), 5);
                    let ends = format!("{} {}", fitted.lo, fitted.hi);
                    assert!(!ends.split(' ').any(|end| end == "-0"), "{data:?} gave {ends}");
                }
            }
        }
    }

    #[test]
    fn an_axis_of_constant_or_missing_data_has_a_range() {
        let cases: [&[f64]; 8] = [
            &[],
            &[0.0],
            &[7.0, 7.0],
            &[f64::NAN, f64::INFINITY],
            &[1e7, 1e7 + 1e-9],
            &[-f64::MAX, f64::MAX],
            &[0.0, 5e-324],
            &[-1e300, 1e300],
        ];
        for values in cases {
            for axis in [Axis::new("a", ""), Axis::new("a", "").tight()] {
                let fitted = axis.fit(values.iter().copied(), 5);
                assert!(fitted.hi > fitted.lo, "{values:?} gave {fitted:?}");
                assert!(fitted.ticks().len() <= 51);
                assert!(fitted.share(fitted.hi).is_finite());
            }
        }
    }
}
