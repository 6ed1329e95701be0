//! The sectional areas of a slender ship.

use std::fmt;

use crate::range::{OutOfRange, within};

/// Panels along a ship. With 48 panels along the ship, the force by the midpoint rule at a distance of a tenth of her
/// length has an error below 0.5 %.
const PANELS: u32 = 48;

/// The areas of a ship's sections below the water, along the length of the ship.
#[derive(Clone, Debug, PartialEq)]
pub struct Sections {
    /// Panels of equal length along the ship, from aft to forward.
    pub(super) panels: Vec<Panel>,
    /// Sources of the flow: places where the sectional area changes, and the changes, from aft to forward. A blunt
    /// stern or bow counts as one source.
    pub(super) changes: Vec<Change>,
}

/// A panel, which is a part of a ship's length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Panel {
    /// Distance of the panel's middle forward of the origin of the sections (m).
    pub(super) x_m: f64,
    /// Volume of the panel below the water (m³).
    pub(super) volume_m3: f64,
}

/// A change of the sectional area along the ship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Change {
    /// Distance of the place of the change forward of the origin of the sections (m).
    pub(super) x_m: f64,
    /// Sectional area forward of the place, less the area aft of it (m²).
    pub(super) area_m2: f64,
}

/// Errors in the areas of a ship's sections.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SectionsError {
    /// The length of the ship, or the place or area of a section, is outside its range.
    OutOfRange(OutOfRange),
    /// Fewer than two sections.
    TooFew,
    /// A section is not forward of the section before it.
    NotForward {
        /// Index of the section.
        section: usize,
    },
}

impl fmt::Display for SectionsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SectionsError::OutOfRange(error) => error.fmt(f),
            SectionsError::TooFew => f.write_str("a ship needs two sections or more"),
            SectionsError::NotForward { section } => {
                write!(f, "section {section} is not forward of the section before it")
            }
        }
    }
}

impl std::error::Error for SectionsError {}

impl From<OutOfRange> for SectionsError {
    fn from(error: OutOfRange) -> SectionsError {
        SectionsError::OutOfRange(error)
    }
}

impl Sections {
    /// Makes the sections of a ship with areas on a parabola, S = S_m (1 − 4x²/L²), x from midship: the default of
    /// Wang's paper.
    ///
    /// # Errors
    /// Fails for a length that is not between 1 and 1000 m, or an area not between 0.01 and 10⁵ m².
    pub fn parabola(length_m: f64, midship_area_m2: f64) -> Result<Sections, SectionsError> {
        within("length of a ship [m]", length_m, 1.0, 1e3)?;
        within("midship section area [m²]", midship_area_m2, 0.01, 1e5)?;
        let half_m = 0.5 * length_m;
        let share = |x_m: f64| 1.0 - (x_m / half_m) * (x_m / half_m);
        // The integral ∫(1 − x²/h²) dx from the middle to x.
        let volume_m = |x_m: f64| x_m - x_m * x_m * x_m / (3.0 * half_m * half_m);
        Ok(Sections::of(
            (-half_m, half_m),
            |x_m| midship_area_m2 * share(x_m),
            |from_m, to_m| midship_area_m2 * (volume_m(to_m) - volume_m(from_m)),
        ))
    }

    /// Makes the sections of a ship from places forward of the origin (m) and areas (m²), from aft to forward, linear
    /// between the places.
    ///
    /// # Errors
    /// Fails for fewer than two sections, a section that is not forward of the section before it, a place beyond ±1000
    /// m, or an area not between 0 and 10⁵ m².
    pub fn new(sections: &[(f64, f64)]) -> Result<Sections, SectionsError> {
        if sections.len() < 2 {
            return Err(SectionsError::TooFew);
        }
        for (index, &(x_m, area_m2)) in sections.iter().enumerate() {
            within("place of a section [m]", x_m, -1e3, 1e3)?;
            within("area of a section [m²]", area_m2, 0.0, 1e5)?;
            if index > 0 && x_m <= sections[index - 1].0 {
                return Err(SectionsError::NotForward { section: index });
            }
        }
        let ends_m = (sections[0].0, sections[sections.len() - 1].0);
        let area_m2 = |x_m: f64| {
            let next = sections.partition_point(|section| section.0 < x_m);
            let next = next.clamp(1, sections.len() - 1);
            let ((aft_m, aft_m2), (forward_m, forward_m2)) = (sections[next - 1], sections[next]);
            let share = (x_m - aft_m) / (forward_m - aft_m);
            aft_m2 + share * (forward_m2 - aft_m2)
        };
        // The volume is the sum of trapezia between the ends and the sections within.
        let volume_m3 = |from_m: f64, to_m: f64| {
            let within = sections.iter().map(|section| section.0);
            let within = within.filter(|x_m| *x_m > from_m && *x_m < to_m);
            let mut volume_m3 = 0.0;
            let mut last_m = from_m;
            for x_m in within.chain([to_m]) {
                volume_m3 += 0.5 * (x_m - last_m) * (area_m2(last_m) + area_m2(x_m));
                last_m = x_m;
            }
            volume_m3
        };
        Ok(Sections::of(ends_m, area_m2, volume_m3))
    }

    fn of(
        (aft_m, forward_m): (f64, f64),
        area_m2: impl Fn(f64) -> f64,
        volume_m3: impl Fn(f64, f64) -> f64,
    ) -> Sections {
        let panel_m = (forward_m - aft_m) / f64::from(PANELS);
        let place_m = |index: u32| {
            if index == PANELS { forward_m } else { aft_m + f64::from(index) * panel_m }
        };
        let mut panels = Vec::with_capacity(PANELS as usize);
        let mut changes = Vec::with_capacity(PANELS as usize + 2);
        changes.push(Change { x_m: aft_m, area_m2: area_m2(aft_m) });
        for index in 0..PANELS {
            let (from_m, to_m) = (place_m(index), place_m(index + 1));
            let x_m = 0.5 * (from_m + to_m);
            panels.push(Panel { x_m, volume_m3: volume_m3(from_m, to_m) });
            changes.push(Change { x_m, area_m2: area_m2(to_m) - area_m2(from_m) });
        }
        changes.push(Change { x_m: forward_m, area_m2: -area_m2(forward_m) });
        changes.retain(|change| change.area_m2 != 0.0);
        Sections { panels, changes }
    }

    /// Volume of the ship below the water (m³).
    #[must_use]
    pub fn volume_m3(&self) -> f64 {
        self.panels.iter().map(|panel| panel.volume_m3).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn volumes_are_exact_and_changes_sum_to_nothing() {
        let ship = Sections::parabola(200.0, 300.0).unwrap();
        assert!((ship.volume_m3() / (2.0 / 3.0 * 200.0 * 300.0) - 1.0).abs() < 1e-12);
        let barge = Sections::new(&[(-50.0, 0.0), (-37.0, 90.0), (40.0, 100.0), (50.0, 60.0)]);
        let barge = barge.unwrap();
        let volume_m3 = 0.5 * (13.0 * 90.0 + 77.0 * 190.0 + 10.0 * 160.0);
        assert!((barge.volume_m3() / volume_m3 - 1.0).abs() < 1e-12);
        for ship in [&ship, &barge] {
            let sum: f64 = ship.changes.iter().map(|change| change.area_m2).sum();
            assert!(sum.abs() < 1e-9, "{sum}");
        }
        // The blunt bow is a separate source.
        let last = barge.changes.last().copied();
        assert_eq!(last, Some(Change { x_m: 50.0, area_m2: -60.0 }));
    }

    #[test]
    fn areas_that_are_no_ship_are_refused() {
        assert!(Sections::parabola(f64::NAN, 10.0).is_err());
        assert!(Sections::parabola(100.0, 0.0).is_err());
        assert_eq!(Sections::new(&[(0.0, 1.0)]), Err(SectionsError::TooFew));
        let back = Sections::new(&[(0.0, 1.0), (5.0, 2.0), (5.0, 3.0)]);
        assert_eq!(back, Err(SectionsError::NotForward { section: 2 }));
        assert!(Sections::new(&[(0.0, 1.0), (5.0, -2.0)]).is_err());
    }
}
