//! A damped oscillator, solved exactly in each step.

/// Value and rate of one of the motions heave, roll and pitch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Heave (m), or angle of roll or pitch (rad).
    pub value: f64,
    /// Rate of change of the motion (m/s, rad/s).
    pub rate: f64,
}

/// The oscillator with the equation M ẍ + 2ζ√(MC) ẋ + C x = F.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillator {
    /// Mass or inertia M of the oscillator, added mass included (kg, kg·m²).
    pub inertia: f64,
    /// Restoring coefficient C of the oscillator (N/m, N·m/rad).
    pub restoring: f64,
    /// ζ: damping ratio.
    pub damping: f64,
}

impl Oscillator {
    /// ω₀ = √(C/M) (rad/s).
    #[must_use]
    pub fn rate_radps(&self) -> f64 {
        libm::sqrt(self.restoring / self.inertia)
    }

    /// Undamped natural period (s).
    #[must_use]
    pub fn period_s(&self) -> f64 {
        2.0 * core::f64::consts::PI / self.rate_radps()
    }

    /// The oscillator's motion after `step_s` seconds under a constant force, in closed form for any step and damping
    /// ratio.
    #[must_use]
    pub fn after(&self, from: Motion, force: f64, step_s: f64) -> Motion {
        let equilibrium = force / self.restoring;
        let (omega, zeta) = (self.rate_radps(), self.damping);
        let (x, v) = (from.value - equilibrium, from.rate);
        let decay = zeta * omega;
        let fade = libm::exp(-decay * step_s);
        // With s = ω√|1 − ζ²|: x(t) = e^{−ζωt}(x(c + ζω q/s) + v q/s), where c and q are cos st and sin st below
        // critical damping, and cosh st and sinh st above it.
        let square = 1.0 - zeta * zeta;
        let s = omega * libm::sqrt(square.abs());
        let t = s * step_s;
        let (c, q_over_s, s_q) = if t < 1e-6 {
            (1.0, step_s, square.signum() * s * s * step_s)
        } else if square > 0.0 {
            (libm::cos(t), libm::sin(t) / s, s * libm::sin(t))
        } else {
            (libm::cosh(t), libm::sinh(t) / s, -s * libm::sinh(t))
        };
        let value = fade * (x * (c + decay * q_over_s) + v * q_over_s);
        let rate = fade * (v * (c - decay * q_over_s) - x * (s_q + decay * decay * q_over_s));
        Motion { value: value + equilibrium, rate }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The motion by ten thousand small steps of the explicit midpoint rule. The error per step is (ωh)³.
    fn by_small_steps(o: &Oscillator, mut m: Motion, force: f64, seconds: f64) -> Motion {
        let h = seconds / 1e4;
        let acceleration = |m: Motion| {
            let c = 2.0 * o.damping * (o.inertia * o.restoring).sqrt();
            (force - o.restoring * m.value - c * m.rate) / o.inertia
        };
        for _ in 0..10_000 {
            let half = Motion {
                value: m.value + 0.5 * h * m.rate,
                rate: m.rate + 0.5 * h * acceleration(m),
            };
            m = Motion { value: m.value + h * half.rate, rate: m.rate + h * acceleration(half) };
        }
        m
    }

    #[test]
    fn the_closed_form_agrees_with_integration_for_weak_critical_and_strong_damping() {
        for damping in [0.0, 0.15, 0.999_999_999, 1.0, 1.000_000_001, 2.5] {
            let o = Oscillator { inertia: 3.0, restoring: 0.7, damping };
            let from = Motion { value: 0.4, rate: -0.2 };
            for seconds in [0.0, 0.1, 3.0, 12.0] {
                let (exact, numerical) =
                    (o.after(from, 0.5, seconds), by_small_steps(&o, from, 0.5, seconds));
                assert!((exact.value - numerical.value).abs() < 1e-6, "ζ {damping}, {seconds} s");
                assert!((exact.rate - numerical.rate).abs() < 1e-6, "ζ {damping}, {seconds} s");
            }
        }
    }

    #[test]
    fn two_steps_equal_one_of_twice_the_length_and_equilibrium_is_kept() {
        let o = Oscillator { inertia: 1e9, restoring: 3e8, damping: 0.15 };
        let from = Motion { value: 0.1, rate: 0.02 };
        let (two, one) = (o.after(o.after(from, 1e6, 2.0), 1e6, 2.0), o.after(from, 1e6, 4.0));
        assert!((two.value - one.value).abs() < 1e-15 && (two.rate - one.rate).abs() < 1e-15);
        let rest = Motion { value: 1e6 / 3e8, rate: 0.0 };
        assert!((o.after(rest, 1e6, 100.0).value - rest.value).abs() < 1e-17);
    }
}
