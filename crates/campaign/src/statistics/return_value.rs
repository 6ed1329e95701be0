//! Design values: converts return periods and lifetimes into the probability of one berthing, by the number of
//! berthings a year.
//!
//! Berthings are taken as independent and with the same distribution F. The largest of N berthings is then at most x
//! with probability F(x)^N.

use core::fmt;

/// The traffic of a berth: its number of berthings a year.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Traffic {
    per_year: f64,
}

/// A number that is not a valid traffic, return period or lifetime.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TrafficError {
    /// The number of berthings a year must be positive.
    PerYear,
    /// A return period must be longer than one year: every year has a largest berthing.
    ReturnPeriod,
    /// A lifetime must be a positive number of years.
    Life,
    /// A probability must lie between 0 and 1.
    Probability,
}

impl fmt::Display for TrafficError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            TrafficError::PerYear => "the number of berthings a year must be positive",
            TrafficError::ReturnPeriod => "a return period must be a number of years above 1",
            TrafficError::Life => "a lifetime must be a positive number of years",
            TrafficError::Probability => "a probability must lie between 0 and 1",
        })
    }
}

impl std::error::Error for TrafficError {}

impl Traffic {
    /// A number of berthings a year, whole or not.
    ///
    /// # Errors
    /// Fails if the number of berthings a year is not positive.
    pub fn new(per_year: f64) -> Result<Traffic, TrafficError> {
        match per_year > 0.0 && per_year.is_finite() {
            true => Ok(Traffic { per_year }),
            false => Err(TrafficError::PerYear),
        }
    }

    /// Berthings a year.
    #[must_use]
    pub fn per_year(self) -> f64 {
        self.per_year
    }

    /// The probability p that one berthing exceeds the value of a return period of T years: 1 − (1 − p)^n = 1/T for n
    /// berthings a year. For long return periods p is nearly 1/(nT).
    ///
    /// # Errors
    /// Fails if the return period is not longer than one year.
    pub fn exceedance_of_period(self, years: f64) -> Result<f64, TrafficError> {
        match years > 1.0 && years.is_finite() {
            true => Ok(-libm::expm1(libm::log1p(-1.0 / years) / self.per_year)),
            false => Err(TrafficError::ReturnPeriod),
        }
    }

    /// The return period (years) of the value that one berthing exceeds with probability `p`; infinite for 0.
    #[must_use]
    pub fn period_of(self, p: f64) -> f64 {
        1.0 / self.chance_in(p, 1.0)
    }

    /// The chance that at least one berthing within `years` exceeds the value that each berthing exceeds with
    /// probability `p`.
    #[must_use]
    pub fn chance_in(self, p: f64, years: f64) -> f64 {
        -libm::expm1(self.per_year * years * libm::log1p(-p))
    }

    /// The probability p that one berthing exceeds the value that the largest berthing of a lifetime exceeds with
    /// probability `chance`: 1 − (1 − chance)^(1/N) for N = n × years.
    ///
    /// # Errors
    /// Fails if the lifetime is not positive, or if the chance is not between 0 and 1.
    pub fn exceedance_of_life(self, years: f64, chance: f64) -> Result<f64, TrafficError> {
        if !(years > 0.0 && years.is_finite()) {
            return Err(TrafficError::Life);
        }
        if !(chance > 0.0 && chance < 1.0) {
            return Err(TrafficError::Probability);
        }
        Ok(-libm::expm1(libm::log1p(-chance) / (self.per_year * years)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_yearly_chance_of_a_return_value_is_one_over_the_period() {
        let traffic = Traffic::new(60.0).unwrap();
        for years in [2.0, 50.0, 475.0, 1e6] {
            let p = traffic.exceedance_of_period(years).unwrap();
            let yearly = 1.0 - libm::pow(1.0 - p, 60.0);
            assert!((yearly * years - 1.0).abs() < 1e-7, "{years}");
            assert!((traffic.period_of(p) / years - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn the_lifetime_maximum_of_a_uniform_variable_is_a_power() {
        // F = x on 0..1: the largest of N is at most 1 − p with probability (1 − p)^N.
        let traffic = Traffic::new(100.0).unwrap();
        let p = traffic.exceedance_of_life(50.0, 0.05).unwrap();
        assert!((libm::pow(1.0 - p, 5000.0) - 0.95).abs() < 1e-12);
        assert!((traffic.chance_in(p, 50.0) - 0.05).abs() < 1e-12);
    }

    #[test]
    fn impossible_traffic_is_refused() {
        assert_eq!(Traffic::new(-3.0), Err(TrafficError::PerYear));
        assert_eq!(Traffic::new(f64::NAN), Err(TrafficError::PerYear));
        let traffic = Traffic::new(60.0).unwrap();
        assert_eq!(traffic.exceedance_of_period(1.0), Err(TrafficError::ReturnPeriod));
        assert_eq!(traffic.exceedance_of_life(0.0, 0.5), Err(TrafficError::Life));
        assert_eq!(traffic.exceedance_of_life(50.0, 1.0), Err(TrafficError::Probability));
    }
}
