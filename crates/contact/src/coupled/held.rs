//! Energy and force of a fender's contacts, needed when the outline of the hull changes.

/// Energy and force of the contacts of a fender with a hull.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Held {
    /// Energy stored in the fender by its loading curve (J).
    pub(crate) loading_j: f64,
    /// Energy that has compressed the fender so far, heat included (J).
    pub(crate) energy_j: f64,
    /// Force of the fender by its loading curve, and force by its unloading law (N).
    pub(crate) loading_n: f64,
    pub(crate) force_n: f64,
}

impl Held {
    /// The fender's force by the unloading law, divided by the force by the loading curve.
    pub(crate) fn share(&self) -> f64 {
        if self.loading_n > 0.0 { self.force_n / self.loading_n } else { 1.0 }
    }
}
