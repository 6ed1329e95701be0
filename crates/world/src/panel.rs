//! Motion and loads of panels on several cones in a run.

mod cone_use;

use fenderline_contact::number::greater;
use fenderline_contact::{Panel, PanelMotion};

pub use self::cone_use::ConeUse;

/// Motion and loads of a panel on several cones in a run. The peaks include peaks in sub-steps, between the ends of
/// steps.
#[derive(Clone, Debug, PartialEq)]
pub struct PanelSummary {
    /// The panel's largest turn about the vertical axis in either direction (rad). The turn is positive if the panel's
    /// right end was deflected more, as seen by a viewer who faces the panel.
    pub peak_tilt_rad: f64,
    /// Start of the step with the largest turn (s).
    pub peak_tilt_at_s: f64,
    /// Deflection of the panel's middle at the largest turn (m).
    pub deflection_at_peak_tilt_m: f64,
    /// The largest moment of the cones' reactions about the panel's middle in either direction (N·m). The moment is
    /// positive if the cones on the right had the larger reactions.
    pub peak_moment_nm: f64,
    /// Start of the step with the largest moment (s).
    pub peak_moment_at_s: f64,
    /// The motion of each cone, in the order of the set-up.
    pub cones: Vec<ConeSummary>,
}

/// Motion of one cone behind a panel in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConeSummary {
    /// Position of the cone along the panel, measured from the panel's middle (m).
    pub at_m: f64,
    /// Largest deflection (m).
    pub peak_deflection_m: f64,
    /// Largest stretch of the cone (m): how far the panel pulled the cone out.
    pub peak_stretch_m: f64,
}

impl PanelSummary {
    /// The summary of a panel that a hull first presses at this time (s).
    pub fn new(panel: &Panel, t_s: f64) -> PanelSummary {
        let cone = |&at_m: &f64| ConeSummary { at_m, peak_deflection_m: 0.0, peak_stretch_m: 0.0 };
        PanelSummary {
            peak_tilt_rad: 0.0,
            peak_tilt_at_s: t_s,
            deflection_at_peak_tilt_m: 0.0,
            peak_moment_nm: 0.0,
            peak_moment_at_s: t_s,
            cones: panel.cones_m.iter().map(cone).collect(),
        }
    }

    /// Adds the motion that one hull gives the panel in a step.
    pub fn add(&mut self, motion: &PanelMotion, t_s: f64) {
        if motion.peak_tilt_rad.abs() > self.peak_tilt_rad.abs() {
            (self.peak_tilt_rad, self.peak_tilt_at_s) = (motion.peak_tilt_rad, t_s);
            self.deflection_at_peak_tilt_m = motion.deflection_m;
        }
        if motion.peak_moment_nm.abs() > self.peak_moment_nm.abs() {
            (self.peak_moment_nm, self.peak_moment_at_s) = (motion.peak_moment_nm, t_s);
        }
        let ends = motion.peak_deflections_m.iter().zip(&motion.least_deflections_m);
        for (cone, (&most_m, &least_m)) in self.cones.iter_mut().zip(ends) {
            cone.peak_deflection_m = greater(cone.peak_deflection_m, most_m);
            cone.peak_stretch_m = greater(cone.peak_stretch_m, -least_m);
        }
    }
}
