//! Heights on what is ashore, which the water rises and falls about.

/// The bodies that do not float, and where the water stands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shore<'a> {
    /// Whether each body of the set-up is fixed.
    pub(crate) fixed: &'a [bool],
    /// Level of the water above datum (m).
    pub(crate) level_m: f64,
}

impl Shore<'_> {
    /// Height above the water (m) of what is at a height on a body: above datum on a fixed one, above the water on
    /// one that floats.
    pub(crate) fn above_water_m(&self, body: usize, height_m: f64) -> f64 {
        if self.fixed[body] { height_m - self.level_m } else { height_m }
    }
}
