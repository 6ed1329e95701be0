//! What contacts of a fender hold, for a change of the outline that it meets.

/// What the contacts of a fender with a hull hold.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Held {
    /// Energy along the loading curve (J).
    pub(crate) loading_j: f64,
    /// Energy that they took to get there, heat included (J).
    pub(crate) energy_j: f64,
    /// Force of the loading curve, and by the unloading law (N).
    pub(crate) loading_n: f64,
    pub(crate) force_n: f64,
}

impl Held {
    /// The force over that of the loading curve.
    pub(crate) fn share(&self) -> f64 {
        if self.loading_n > 0.0 { self.force_n / self.loading_n } else { 1.0 }
    }
}
