//! Set-up of passing ships and of hulls that act on each other through the water.

use fenderline_contact::Vec2;
use fenderline_contact::number::{bounded, greater, lesser};

use super::restricted::{Berth, factors};
use super::sections::{Sections, SectionsError};
use crate::track::Track;

/// Ratio of length to beam below which messages call a passing ship hardly slender; our choice.
pub const HARDLY_SLENDER: f64 = 4.0;
/// Speed of a passing ship, divided by the speed of long waves in the depth, from which on messages call the forces too
/// small; our choice.
pub const NEARLY_CRITICAL: f64 = 0.6;

/// The data of a hull that are needed for the flow around it.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowHull {
    /// Sections of the hull, about midship.
    pub sections: Sections,
    /// Length (m).
    pub length_m: f64,
    /// Beam (m).
    pub beam_m: f64,
    /// Draught (m).
    pub draught_m: f64,
}

/// A ship that passes on a given track, whatever forces act on her. A passing ship pushes the vessels; the vessels do
/// not push the passing ship.
#[derive(Clone, Debug, PartialEq)]
pub struct PassingSetup {
    /// Name of the ship.
    pub name: String,
    /// Hull of the ship.
    pub hull: FlowHull,
    /// Outline of the ship, forward and to starboard of midship (m).
    pub outline_m: Vec<Vec2>,
    /// Position of the passing ship at each time.
    pub track: Track,
    /// Correction for the depth.
    pub depth: DepthFactors,
    /// The berth at which the vessels lie.
    pub berth: Berth,
}

/// How forces of a passing ship are corrected for the depth of water.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthFactors {
    /// The forces of a passing ship are not corrected: they are those of deep water.
    DeepWater,
    /// By [`super::factors`].
    Kriebel,
}

impl PassingSetup {
    /// Factors on a passing ship's surge and sway force and yaw moment on a vessel in a depth (m; `None`: deep), at a
    /// distance between the axes (m).
    ///
    /// Beyond the range of these factors, the factors at its ends are used: a draught of the whole depth, a gap of 0 or
    /// of 100 beams.
    #[must_use]
    pub fn factors(&self, vessel: &FlowHull, depth_m: Option<f64>, across_m: f64) -> [f64; 3] {
        let mean_beam_m = 0.5 * (vessel.beam_m + self.hull.beam_m);
        let gap = bounded((across_m.abs() - mean_beam_m) / mean_beam_m, 0.0, 100.0);
        match (self.depth, depth_m) {
            (DepthFactors::Kriebel, Some(depth_m)) => {
                let ratio =
                    if depth_m > vessel.draught_m { vessel.draught_m / depth_m } else { 1.0 };
                factors(ratio, gap, self.berth).expect("depth and gap are both within their ranges")
            }
            _ => self.berth.factors(),
        }
    }
}

/// The passing ships of a set-up, and the flow between its ships.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlowSetup {
    /// The hulls of the vessels, in the order in which the vessels are listed. The list of hulls is empty if no ship
    /// passes, vessels do not act on each other, and no bank acts by an image.
    pub hulls: Vec<FlowHull>,
    /// Ships that pass.
    pub passing: Vec<PassingSetup>,
    /// Whether the vessels act on each other through the flow.
    pub between_vessels: bool,
}

impl FlowHull {
    /// Makes a hull with parabolic sections; or, if an outline about midship is given (m), with sections from the beam
    /// of the outline. The midship coefficient is the area of a section divided by its beam and by the draught.
    ///
    /// # Errors
    /// See [`Sections::parabola`] and [`Sections::new`].
    pub fn new(
        [length_m, beam_m, draught_m]: [f64; 3],
        midship_coefficient: f64,
        outline_m: Option<&[Vec2]>,
    ) -> Result<FlowHull, SectionsError> {
        let area_per_beam_m = midship_coefficient * draught_m;
        let sections = match outline_m {
            None => Sections::parabola(length_m, area_per_beam_m * beam_m)?,
            Some(outline_m) => Sections::new(&areas_of(outline_m, area_per_beam_m))?,
        };
        Ok(FlowHull { sections, length_m, beam_m, draught_m })
    }

    /// Whether the flow of slender ships between this ship and other vessels is used. The flow of slender ships is used
    /// for ships of at least 3.5 beams in length (our choice). Tugs are shorter.
    #[must_use]
    pub fn is_slender(&self) -> bool {
        self.length_m >= 3.5 * self.beam_m
    }
}

/// Areas of sections at evenly spaced places along an outline, from the beam of the outline at each place.
fn areas_of(outline_m: &[Vec2], area_per_beam_m: f64) -> Vec<(f64, f64)> {
    const SECTIONS: u32 = 96;
    let ends = outline_m.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), point| {
        (lesser(low, point.x), greater(high, point.x))
    });
    let place = |section: u32| {
        let share = f64::from(section) / f64::from(SECTIONS);
        // A section at a flat end has the beam of that end.
        let share = bounded(share, 1e-9, 1.0 - 1e-9);
        ends.0 + share * (ends.1 - ends.0)
    };
    let sections = (0..=SECTIONS).map(place);
    sections.map(|x_m| (x_m, area_per_beam_m * beam_at_m(outline_m, x_m))).collect()
}

/// Beam of an outline at a place: length of the part of a line across the outline that lies within it (m).
fn beam_at_m(outline_m: &[Vec2], x_m: f64) -> f64 {
    let edges = outline_m.iter().zip(outline_m.iter().cycle().skip(1));
    let mut sides: Vec<f64> = edges
        .filter(|(from, to)| (from.x <= x_m) != (to.x <= x_m))
        .map(|(from, to)| from.y + (x_m - from.x) / (to.x - from.x) * (to.y - from.y))
        .collect();
    sides.sort_by(f64::total_cmp);
    sides.chunks_exact(2).map(|pair| pair[1] - pair[0]).sum()
}

#[cfg(test)]
mod tests {
    use fenderline_contact::vec2;

    use super::*;

    #[test]
    fn sections_of_an_outline_have_its_area_times_the_draught() {
        let outline = [
            vec2(-50.0, -10.0),
            vec2(30.0, -10.0),
            vec2(50.0, 0.0),
            vec2(30.0, 10.0),
            vec2(-50.0, 10.0),
        ];
        let hull = FlowHull::new([100.0, 20.0, 8.0], 0.9, Some(&outline)).unwrap();
        let volume_m3 = 0.9 * 8.0 * (80.0 * 20.0 + 0.5 * 20.0 * 20.0);
        assert!((hull.sections.volume_m3() / volume_m3 - 1.0).abs() < 1e-3);
        assert!(hull.is_slender());
    }
}
