//! Energy and force of a fender's contacts, for a change of the hull's outline.

/// Energy and force of the contacts of a fender with a hull.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Held {
    /// Energy along the loading curve (J).
    pub(crate) loading_j: f64,
    /// Energy that compressed the fender so far, heat included (J).
    pub(crate) energy_j: f64,
    /// Force by the loading curve, and force by the unloading law (N).
    pub(crate) loading_n: f64,
    pub(crate) force_n: f64,
}

impl Held {
    /// The force by the unloading law, over the force by the loading curve.
    pub(crate) fn share(&self) -> f64 {
        if self.loading_n > 0.0 { self.force_n / self.loading_n } else { 1.0 }
    }
}
