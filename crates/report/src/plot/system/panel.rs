//! A drawing of a fender panel on several cones, seen from above, at the same scale in both directions.

use core::fmt::Write as _;

use fenderline_contact::number::{greater, lesser};
use maud::{Markup, html};

use super::face::{QUAY, QUAY_EDGE, px};
use super::scale::Scale;
use super::section::{LINE, PANEL, TEXTS, WIDTH, beside};
use crate::plot::Use;

/// A panel on several cones to be drawn as seen from above: the structure is at the top of the drawing, the water at
/// the bottom.
#[derive(Clone, Debug, PartialEq)]
pub struct PanelPlan {
    /// Printed above the drawing.
    pub title: String,
    /// Width of the panel (m).
    pub width_m: f64,
    /// Distance from the mounting to the face of the uncompressed panel (m).
    pub projection_m: f64,
    /// Deflection of the panel's middle, as drawn (m).
    pub deflection_m: f64,
    /// Turn of the panel, as drawn (rad); positive if the right end is deflected more.
    pub tilt_rad: f64,
    /// The cones behind the panel, from left to right.
    pub cones: Vec<ConeDrawn>,
    /// Places of the tension chains along the panel (m).
    pub chains_m: Vec<f64>,
    /// Lines of text beside the drawing.
    pub texts: Vec<String>,
}

/// A cone behind the panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConeDrawn {
    /// Place of the cone to the right of the panel's middle (m).
    pub at_m: f64,
    /// How the cone was used in the run.
    pub used: Use,
}

/// Largest height of the drawing (px).
const HEIGHT: f64 = 170.0;
/// How much structure behind the panel and how much water before it is drawn, as shares of the panel's projection.
const BEHIND: f64 = 0.35;
const BEFORE: f64 = 0.25;
/// Room beside the panel as a share of its width.
const BESIDE: f64 = 0.08;

impl PanelPlan {
    /// Draws the panel as an HTML `figure`.
    pub fn render(&self) -> Markup {
        let half_m = (0.5 + BESIDE) * self.width_m;
        let out_m = [-BEHIND * self.projection_m, (1.0 + BEFORE) * self.projection_m];
        let px_per_m = lesser(HEIGHT / (out_m[1] - out_m[0]), (TEXTS - 40.0) / (2.0 * half_m));
        let (width, height) = (2.0 * half_m * px_per_m, (out_m[1] - out_m[0]) * px_per_m);
        let left = 0.5 * (TEXTS - 20.0 - width);
        let x = Scale::new([-half_m, half_m], left, left + width);
        let y = Scale::new(out_m, 8.0, 8.0 + height);
        let whole = greater(height + 16.0, LINE * self.texts.len() as f64 + 20.0);
        html! {
            figure class="system" {
                figcaption { (self.title) }
                svg viewBox=(format!("0 0 {WIDTH} {whole:.1}")) role="img" aria-label=(self.title) {
                    svg x=(px(left)) y="8" width=(px(width)) height=(px(height)) overflow="hidden"
                        viewBox=(format!("{left:.1} 8 {width:.1} {height:.1}")) { (self.drawn(&x, &y)) }
                    rect class="frame" x=(px(left)) y="8" width=(px(width)) height=(px(height)) {}
                    (beside(&self.texts))
                }
            }
        }
    }

    fn drawn(&self, x: &Scale, y: &Scale) -> Markup {
        let whole = x.length((1.0 + 2.0 * BESIDE) * self.width_m);
        let left = x.px(-(0.5 + BESIDE) * self.width_m);
        let top = y.px(-BEHIND * self.projection_m);
        html! {
            rect x=(px(left - 2.0)) y=(px(top - 2.0)) width=(px(whole + 4.0))
                height=(px(y.px(0.0) - top + 2.0)) fill=(QUAY) fill-opacity="0.55" stroke=(QUAY_EDGE) stroke-width="1.1" {}
            path d=(self.panel(x, y, 0.0, 0.0)) fill="none" stroke="#5b6675" stroke-width="0.9" stroke-dasharray="4 3" {}
            @for cone in &self.cones {
                path d=(self.cone(x, y, cone.at_m)) fill=(cone.used.fill()) stroke="#222" stroke-width="0.9" {}
            }
            path d=(self.panel(x, y, self.deflection_m, self.tilt_rad)) fill="#555" stroke="#222" stroke-width="1" {}
            @for &at_m in &self.chains_m {
                path d=(format!(
                    "M{:.1},{:.1}V{:.1}",
                    x.px(at_m), y.px(0.0), y.px(self.back_m(at_m, self.deflection_m, self.tilt_rad))
                )) stroke="#222" stroke-width="1.6" stroke-dasharray="2.5 1.5" fill="none" {}
            }
        }
    }

    /// Distance of the panel's back from the mounting, at a place along the panel (m).
    fn back_m(&self, at_m: f64, deflection_m: f64, tilt_rad: f64) -> f64 {
        (1.0 - PANEL) * self.projection_m - deflection_m - at_m * tilt_rad
    }

    fn panel(&self, x: &Scale, y: &Scale, deflection_m: f64, tilt_rad: f64) -> String {
        let half_m = 0.5 * self.width_m;
        let mut path = String::new();
        for (letter, at_m, before_m) in [
            ('M', -half_m, 0.0),
            ('L', half_m, 0.0),
            ('L', half_m, PANEL * self.projection_m),
            ('L', -half_m, PANEL * self.projection_m),
        ] {
            let out_m = self.back_m(at_m, deflection_m, tilt_rad) + before_m;
            let _ = write!(path, "{letter}{:.1},{:.1}", x.px(at_m), y.px(out_m));
        }
        path.push('Z');
        path
    }

    /// Draws a cone from the structure to the panel, wider at its foot. The scenario does not have the widths of cones.
    fn cone(&self, x: &Scale, y: &Scale, at_m: f64) -> String {
        let spacings = self.cones.windows(2).map(|pair| pair[1].at_m - pair[0].at_m);
        let room_m = spacings.fold(0.8 * self.projection_m, lesser);
        let (foot_m, head_m) = (0.45 * room_m, 0.3 * room_m);
        let end_m = |at_m: f64| self.back_m(at_m, self.deflection_m, self.tilt_rad);
        format!(
            "M{:.1},{:.1}L{:.1},{:.1}L{:.1},{:.1}L{:.1},{:.1}Z",
            x.px(at_m - foot_m),
            y.px(0.0),
            x.px(at_m + foot_m),
            y.px(0.0),
            x.px(at_m + head_m),
            y.px(end_m(at_m + head_m)),
            x.px(at_m - head_m),
            y.px(end_m(at_m - head_m))
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 0.3 m at the middle, and 0.1 rad: the ends of a panel of 4 m are pressed by 0.1 m and 0.5 m.
    #[test]
    fn the_right_end_of_a_panel_that_turns_is_pressed_more() {
        let plan = PanelPlan {
            title: String::new(),
            width_m: 4.0,
            projection_m: 1.0,
            deflection_m: 0.3,
            tilt_rad: 0.1,
            cones: Vec::new(),
            chains_m: Vec::new(),
            texts: Vec::new(),
        };
        let pressed_m =
            [-2.0, 0.0, 2.0].map(|at_m| 1.0 - PANEL - plan.back_m(at_m, plan.deflection_m, 0.1));
        for (ours, theirs) in pressed_m.into_iter().zip([0.1, 0.3, 0.5]) {
            assert!((ours - theirs).abs() < 1e-12, "{ours}");
        }
    }
}
