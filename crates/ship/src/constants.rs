//! Physical constants and conversion factors, one definition for the whole workspace.

/// Standard acceleration of gravity (m/s²), by definition (3rd CGPM, 1901).
pub const STANDARD_GRAVITY_MPS2: f64 = 9.806_65;
/// International nautical mile (m), by definition.
pub const NAUTICAL_MILE_M: f64 = 1852.0;
/// One knot in m/s: one nautical mile an hour.
pub const KNOT_MPS: f64 = NAUTICAL_MILE_M / 3600.0;
/// A speed of 1 m/s in knots.
pub const KNOTS_PER_MPS: f64 = 3600.0 / NAUTICAL_MILE_M;
/// Density of sea water (kg/m³), used if a scenario gives none. Sea water at 15 °C with 3.5 % of salt has a density of
/// 1026 kg/m³.
pub const SEA_WATER_KGPM3: f64 = 1025.0;
/// Density of air (kg/m³), used if a scenario gives none: the standard atmosphere at 15 °C.
pub const AIR_KGPM3: f64 = 1.225;
