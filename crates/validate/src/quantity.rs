//! The quantities that are taken from a run to be compared.

use super::play::Played;

/// A quantity of a run, which has the unit [`Quantity::unit`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    /// Largest depth of overlap.
    PeakDepth,
    /// Largest normal force.
    PeakForce,
    /// Normal force over time.
    Impulse,
    /// Kinetic energy that is lost in the run, as a share of the kinetic energy at its start.
    EnergyLost,
    /// Speed at which the bodies part at the end of the contact.
    FinalSpeed,
    /// Duration of the contact, from the first to the last step in which the bodies overlap.
    ContactDuration,
    /// Duration of the first push, which is the first unbroken run of steps with a normal force.
    PushDuration,
    /// Largest change of the linear momentum of all bodies, as a share of Σ|mv|.
    LinearMomentumDrift,
    /// Largest change of the angular momentum of all bodies, as a share of Σ|x × mv| + |Iω|.
    AngularMomentumDrift,
}

impl Quantity {
    const ALL: [(&'static str, Quantity); 9] = [
        ("peak_depth", Quantity::PeakDepth),
        ("peak_force", Quantity::PeakForce),
        ("impulse", Quantity::Impulse),
        ("energy_lost", Quantity::EnergyLost),
        ("final_speed", Quantity::FinalSpeed),
        ("contact_duration", Quantity::ContactDuration),
        ("push_duration", Quantity::PushDuration),
        ("linear_momentum_drift", Quantity::LinearMomentumDrift),
        ("angular_momentum_drift", Quantity::AngularMomentumDrift),
    ];

    /// The quantity that a file of published numbers calls `name`.
    pub(super) fn named(name: &str) -> Option<Quantity> {
        Quantity::ALL.iter().find(|(known, _)| *known == name).map(|(_, quantity)| *quantity)
    }

    /// The unit in which the quantity is compared and shown; empty for a plain number.
    pub(super) fn unit(self) -> &'static str {
        match self {
            Quantity::PeakDepth => "m",
            Quantity::PeakForce => "MN",
            Quantity::Impulse => "MN·s",
            Quantity::FinalSpeed => "m/s",
            Quantity::ContactDuration | Quantity::PushDuration => "s",
            Quantity::EnergyLost
            | Quantity::LinearMomentumDrift
            | Quantity::AngularMomentumDrift => "",
        }
    }

    /// The value of the quantity in a run.
    pub(super) fn of(self, run: &Played) -> f64 {
        match self {
            Quantity::PeakDepth => run.pair.peak_depth_m,
            Quantity::PeakForce => run.pair.peak_normal_force_n * 1e-6,
            Quantity::Impulse => run.pair.impulse_ns * 1e-6,
            Quantity::EnergyLost => run.energy_lost,
            Quantity::FinalSpeed => run.pair.final_speed_mps,
            Quantity::ContactDuration => run.contact_duration_s(),
            Quantity::PushDuration => run.push_duration_s(),
            Quantity::LinearMomentumDrift => run.momentum.linear_drift(),
            Quantity::AngularMomentumDrift => run.momentum.angular_drift(),
        }
    }
}
