//! Laws of probability from which the values of a variable are drawn.

mod normal;
mod weibull;

use core::f64::consts::PI;
use core::fmt;

/// Euler's constant, the mean of the standard Gumbel distribution.
const EULER: f64 = 0.577_215_664_901_532_9;
/// Smallest probability that a truncated law may have between its bounds. If the law had a smaller probability between
/// its bounds, too few digits would be left to draw from.
const LEAST_MASS: f64 = 1e-9;

/// A family of laws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LawFamily {
    /// Normal.
    Normal,
    /// The logarithm is normal.
    Lognormal,
    /// Weibull law of two parameters, for values from 0.
    Weibull,
    /// Gumbel of maxima.
    Gumbel,
    /// Uniform.
    Uniform,
    /// Triangular.
    Triangular,
}

impl LawFamily {
    /// Its word in files.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            LawFamily::Normal => "normal",
            LawFamily::Lognormal => "lognormal",
            LawFamily::Weibull => "Weibull",
            LawFamily::Gumbel => "Gumbel",
            LawFamily::Uniform => "uniform",
            LawFamily::Triangular => "triangular",
        }
    }
}

/// Parameters of a family.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    Normal { mean: f64, deviation: f64 },
    Lognormal { log_mean: f64, log_deviation: f64 },
    Weibull { scale: f64, shape: f64 },
    Gumbel { location: f64, scale: f64 },
    Uniform { lower: f64, upper: f64 },
    Triangular { lower: f64, mode: f64, upper: f64 },
}

/// A law of probability of one variable, in the unit of its parameters.
///
/// ```
/// use fenderline_campaign::Law;
/// let speed = Law::lognormal(0.08, 0.04)?;
/// assert!((speed.quantile(0.5) - 0.08 / 1.25_f64.sqrt()).abs() < 1e-12);
/// let bounded = speed.within(None, Some(0.3))?;
/// assert!(bounded.quantile(1.0 - 1e-12) <= 0.3);
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    shape: Shape,
    /// The bounds of a truncated law; infinite if the law is not truncated.
    bounds: [f64; 2],
    /// Probabilities that the law without truncation has below its lower and its upper bound.
    mass: [f64; 2],
}

impl Law {
    fn whole(shape: Shape) -> Law {
        Law { shape, bounds: [f64::NEG_INFINITY, f64::INFINITY], mass: [0.0, 1.0] }
    }

    /// Makes a normal law from mean and standard deviation.
    ///
    /// # Errors
    /// Fails if the standard deviation is not positive.
    pub fn normal(mean: f64, deviation: f64) -> Result<Law, String> {
        positive("standard_deviation", deviation)?;
        Ok(Law::whole(Shape::Normal { mean, deviation }))
    }

    /// Makes a lognormal law from mean and standard deviation of the variable itself.
    ///
    /// # Errors
    /// Fails if a number is not positive.
    pub fn lognormal(mean: f64, deviation: f64) -> Result<Law, String> {
        positive("mean", mean)?;
        positive("standard_deviation", deviation)?;
        let variance = libm::log1p((deviation / mean) * (deviation / mean));
        Law::lognormal_by_logarithm(libm::log(mean) - 0.5 * variance, libm::sqrt(variance))
    }

    /// Makes a lognormal law from mean and standard deviation of the variable's natural logarithm.
    ///
    /// # Errors
    /// Fails if the standard deviation is not positive.
    pub fn lognormal_by_logarithm(log_mean: f64, log_deviation: f64) -> Result<Law, String> {
        positive("log_standard_deviation", log_deviation)?;
        Ok(Law::whole(Shape::Lognormal { log_mean, log_deviation }))
    }

    /// Makes a Weibull law from scale and shape: F = 1 − exp(−(x/scale)^shape).
    ///
    /// # Errors
    /// Fails if a number is not positive.
    pub fn weibull(scale: f64, shape: f64) -> Result<Law, String> {
        positive("scale", scale)?;
        positive("shape", shape)?;
        Ok(Law::whole(Shape::Weibull { scale, shape }))
    }

    /// Makes a Weibull law from mean and standard deviation.
    ///
    /// # Errors
    /// Fails if a number is not positive, or if no shape between 0.1 and 100 has this ratio of standard deviation to
    /// mean.
    pub fn weibull_by_moments(mean: f64, deviation: f64) -> Result<Law, String> {
        positive("mean", mean)?;
        positive("standard_deviation", deviation)?;
        let shape = weibull::shape_of(deviation / mean).ok_or_else(|| {
            format!("no Weibull law with a shape between 0.1 and 100 has a standard deviation of {} of its mean", deviation / mean)
        })?;
        Law::weibull(mean / weibull::mean(shape), shape)
    }

    /// Makes a Gumbel law of maxima from location (mode) and scale: F = exp(−exp(−(x − location)/scale)).
    ///
    /// # Errors
    /// Fails if the scale is not positive.
    pub fn gumbel(location: f64, scale: f64) -> Result<Law, String> {
        positive("scale", scale)?;
        Ok(Law::whole(Shape::Gumbel { location, scale }))
    }

    /// Makes a Gumbel law of maxima from mean and standard deviation.
    ///
    /// # Errors
    /// Fails if the standard deviation is not positive.
    pub fn gumbel_by_moments(mean: f64, deviation: f64) -> Result<Law, String> {
        positive("standard_deviation", deviation)?;
        let scale = deviation * libm::sqrt(6.0) / PI;
        Law::gumbel(mean - EULER * scale, scale)
    }

    /// Uniform between two values.
    ///
    /// # Errors
    /// Fails if the bounds are equal or crossed.
    pub fn uniform(lower: f64, upper: f64) -> Result<Law, String> {
        rising("lower", lower, "upper", upper)?;
        Ok(Law::whole(Shape::Uniform { lower, upper }))
    }

    /// Makes a uniform law from mean and standard deviation.
    ///
    /// # Errors
    /// Fails if the standard deviation is not positive.
    pub fn uniform_by_moments(mean: f64, deviation: f64) -> Result<Law, String> {
        positive("standard_deviation", deviation)?;
        let half = libm::sqrt(3.0) * deviation;
        Law::uniform(mean - half, mean + half)
    }

    /// Makes a triangular law from its two ends and its mode.
    ///
    /// # Errors
    /// Fails if the ends are equal or crossed, or if the mode is not between the ends.
    pub fn triangular(lower: f64, mode: f64, upper: f64) -> Result<Law, String> {
        rising("lower", lower, "upper", upper)?;
        if !(lower <= mode && mode <= upper) {
            return Err(format!(
                "`mode` {mode} is not between `lower` {lower} and `upper` {upper}"
            ));
        }
        Ok(Law::whole(Shape::Triangular { lower, mode, upper }))
    }

    /// Makes a law of a family with two parameters from the values at two probabilities.
    ///
    /// # Errors
    /// Fails if the probabilities are not between 0 and 1, if the probabilities do not rise with the values, if a law of the
    /// family cannot take the values, or if the family is triangular.
    pub fn by_quantiles(family: LawFamily, [one, other]: [(f64, f64); 2]) -> Result<Law, String> {
        for (p, _) in [one, other] {
            if !(0.0 < p && p < 1.0) {
                return Err(format!("probability {p} is not between 0 and 1"));
            }
        }
        if (one.0 < other.0) != (one.1 < other.1) || one.0 == other.0 || one.1 == other.1 {
            return Err("the higher probability does not have the higher value".to_owned());
        }
        // On a suitable scale each family is a straight line: value = a + b × reduced value of the
        // probability.
        let is_logarithmic = matches!(family, LawFamily::Lognormal | LawFamily::Weibull);
        if is_logarithmic && !(one.1 > 0.0 && other.1 > 0.0) {
            return Err(format!("a {} law has positive values only", family.word()));
        }
        let value = |x: f64| if is_logarithmic { libm::log(x) } else { x };
        let reduced = |p: f64| match family {
            LawFamily::Normal | LawFamily::Lognormal => normal::quantile(p),
            LawFamily::Weibull => libm::log(-libm::log1p(-p)),
            LawFamily::Gumbel => -libm::log(-libm::log(p)),
            LawFamily::Uniform | LawFamily::Triangular => p,
        };
        let slope = (value(other.1) - value(one.1)) / (reduced(other.0) - reduced(one.0));
        let start = value(one.1) - slope * reduced(one.0);
        match family {
            LawFamily::Normal => Law::normal(start, slope),
            LawFamily::Lognormal => Law::lognormal_by_logarithm(start, slope),
            LawFamily::Weibull => Law::weibull(libm::exp(start), 1.0 / slope),
            LawFamily::Gumbel => Law::gumbel(start, slope),
            LawFamily::Uniform => Law::uniform(start, start + slope),
            LawFamily::Triangular => {
                Err("a triangular law is given by `lower`, `mode` and `upper`".to_owned())
            }
        }
    }

    /// Truncates the law at a lower and an upper bound.
    ///
    /// # Errors
    /// Fails if the bounds are equal or crossed, or if the law has less than 1e-9 of its probability between the
    /// bounds.
    pub fn within(self, lowest: Option<f64>, highest: Option<f64>) -> Result<Law, String> {
        let bounds = [lowest.unwrap_or(f64::NEG_INFINITY), highest.unwrap_or(f64::INFINITY)];
        rising("at_least", bounds[0], "at_most", bounds[1])?;
        let mass = bounds.map(|bound| self.shape.cdf(bound));
        if mass[1] - mass[0] < LEAST_MASS {
            return Err(format!(
                "the law has a probability of {:e} between its bounds: too little to draw from",
                mass[1] - mass[0]
            ));
        }
        Ok(Law { bounds, mass, ..self })
    }

    /// The value that the variable does not exceed with probability `p`, which is between 0 and 1, both excluded.
    #[must_use]
    pub fn quantile(&self, p: f64) -> f64 {
        let [low, high] = self.mass;
        let value = self.shape.quantile(low + p * (high - low));
        // Rounding may leave the bounds by a digit.
        fenderline_contact::number::bounded(value, self.bounds[0], self.bounds[1])
    }

    /// The probability that the variable is at most `x`.
    #[must_use]
    pub fn cdf(&self, x: f64) -> f64 {
        let [low, high] = self.mass;
        if x <= self.bounds[0] {
            0.0
        } else if x >= self.bounds[1] {
            1.0
        } else {
            (self.shape.cdf(x) - low) / (high - low)
        }
    }
}

impl Shape {
    fn cdf(self, x: f64) -> f64 {
        match self {
            Shape::Normal { mean, deviation } => normal::cdf((x - mean) / deviation),
            Shape::Lognormal { .. } | Shape::Weibull { .. } if x <= 0.0 => 0.0,
            Shape::Lognormal { log_mean, log_deviation } => {
                normal::cdf((libm::log(x) - log_mean) / log_deviation)
            }
            Shape::Weibull { scale, shape } => -libm::expm1(-libm::pow(x / scale, shape)),
            Shape::Gumbel { location, scale } => libm::exp(-libm::exp(-(x - location) / scale)),
            Shape::Uniform { lower, upper } => {
                fenderline_contact::number::bounded((x - lower) / (upper - lower), 0.0, 1.0)
            }
            Shape::Triangular { lower, mode, upper } => {
                if x <= lower {
                    0.0
                } else if x >= upper {
                    1.0
                } else if x < mode {
                    (x - lower) * (x - lower) / ((upper - lower) * (mode - lower))
                } else {
                    1.0 - (upper - x) * (upper - x) / ((upper - lower) * (upper - mode))
                }
            }
        }
    }

    fn quantile(self, p: f64) -> f64 {
        match self {
            Shape::Normal { mean, deviation } => mean + deviation * normal::quantile(p),
            Shape::Lognormal { log_mean, log_deviation } => {
                libm::exp(log_mean + log_deviation * normal::quantile(p))
            }
            Shape::Weibull { scale, shape } => scale * libm::pow(-libm::log1p(-p), 1.0 / shape),
            Shape::Gumbel { location, scale } => location - scale * libm::log(-libm::log(p)),
            Shape::Uniform { lower, upper } => lower + p * (upper - lower),
            Shape::Triangular { lower, mode, upper } => {
                let (rise, fall, width) = (mode - lower, upper - mode, upper - lower);
                if p * width < rise {
                    lower + libm::sqrt(p * width * rise)
                } else {
                    upper - libm::sqrt((1.0 - p) * width * fall)
                }
            }
        }
    }
}

impl fmt::Display for Law {
    /// Writes the law in words: its family, its parameters rounded to four digits, and its bounds.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.shape {
            Shape::Normal { mean, deviation } => {
                write!(f, "normal, mean {}, standard deviation {}", short(mean), short(deviation))
            }
            Shape::Lognormal { log_mean, log_deviation } => write!(
                f,
                "lognormal, median {}, standard deviation of the logarithm {}",
                short(libm::exp(log_mean)),
                short(log_deviation)
            ),
            Shape::Weibull { scale, shape } => {
                write!(f, "Weibull, scale {}, shape {}", short(scale), short(shape))
            }
            Shape::Gumbel { location, scale } => {
                write!(f, "Gumbel, location {}, scale {}", short(location), short(scale))
            }
            Shape::Uniform { lower, upper } => {
                write!(f, "uniform from {} to {}", short(lower), short(upper))
            }
            Shape::Triangular { lower, mode, upper } => {
                write!(f, "triangular from {} by {} to {}", short(lower), short(mode), short(upper))
            }
        }?;
        if self.bounds[0] > f64::NEG_INFINITY {
            write!(f, ", at least {}", short(self.bounds[0]))?;
        }
        if self.bounds[1] < f64::INFINITY {
            write!(f, ", at most {}", short(self.bounds[1]))?;
        }
        Ok(())
    }
}

/// A number with four digits.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    format!("{rounded}")
}

fn positive(name: &str, value: f64) -> Result<(), String> {
    if value > 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(format!("`{name}` must be above 0, but is {value}"))
    }
}

fn rising(low: &str, lower: f64, high: &str, upper: f64) -> Result<(), String> {
    if lower < upper {
        Ok(())
    } else {
        Err(format!("`{low}` {lower} is not below `{high}` {upper}"))
    }
}

#[cfg(test)]
mod tests;
