//! What a program needs to draw fenders: their faces as they are compressed now.

use fenderline_contact::number::greater;
use fenderline_contact::{BodyId, Fender, FenderId, Rotation, Vec2, vec2};

use crate::engine::Engine;

/// Drawing data of a fender, in the frame of the body that carries the fender: x forward, y to starboard of the centre
/// of gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FenderView {
    /// Index of the body that carries the fender.
    pub body: BodyId,
    /// Index of the body that presses the fender; if several bodies do, of the body that presses deepest. `None` means
    /// that no body presses the fender.
    pub hull: Option<BodyId>,
    /// The two ends of the line where the fender is mounted (m): left and right as seen when looking out from the body.
    pub mount_m: [Vec2; 2],
    /// The two ends of the fender's face in its present compression and turn (m): left and right as seen when looking
    /// out from the body.
    pub face_m: [Vec2; 2],
    /// Deflection of the fender in the last step (m); 0 if no body presses the fender.
    pub deflection_m: f64,
    /// Rated deflection (m).
    pub rated_deflection_m: f64,
    /// Normal force on the fender in the last step, summed over all bodies that press it (N).
    pub normal_force_n: f64,
    /// Largest normal force of a single body on the fender within the last step (N).
    pub peak_normal_force_n: f64,
    /// Largest deflection of the fender within the last step (m).
    pub peak_deflection_m: f64,
    /// Turn of a panel on several cones about the vertical (rad); positive if the right end, as you look at the face,
    /// is deflected more. 0 for other fenders.
    pub panel_turn_rad: f64,
}

impl Engine {
    /// Drawing data of all fenders, in the order of the model, after the last step; before the first step the fenders
    /// are uncompressed.
    pub fn fender_views(&self) -> impl Iterator<Item = FenderView> + '_ {
        let count = self.model().fenders().len() as u32;
        (0..count).map(|index| self.fender_view(FenderId(index)))
    }

    fn fender_view(&self, id: FenderId) -> FenderView {
        let fender = &self.model().fenders()[id.0 as usize];
        let mut view = at_rest(fender);
        let Ok(results) = self.results() else { return view };
        for contact in results.contacts.iter().filter(|contact| contact.fender == Some(id)) {
            view.normal_force_n += contact.normal_force_n;
            view.peak_normal_force_n =
                greater(view.peak_normal_force_n, contact.peak_normal_force_n);
            view.peak_deflection_m = greater(view.peak_deflection_m, contact.peak_depth_m);
            if view.hull.is_none() || contact.depth_m > view.deflection_m {
                let [one, two] = [contact.body_1, contact.body_2];
                view.hull = Some(if one == fender.body { two } else { one });
                view.deflection_m = contact.depth_m;
            }
        }
        if view.hull.is_some() {
            let panel = results.panels.iter().find(|p| p.fender == id && Some(p.hull) == view.hull);
            view.panel_turn_rad = panel.map_or(0.0, |panel| panel.tilt_rad);
            view.face_m = face(fender, view.deflection_m, view.panel_turn_rad);
        }
        view
    }
}

fn at_rest(fender: &Fender) -> FenderView {
    let along = Rotation::from_angle(fender.facing_rad).apply(vec2(0.0, 0.5 * fender.width_m));
    FenderView {
        body: fender.body,
        hull: None,
        mount_m: [fender.position_m - along, fender.position_m + along],
        face_m: face(fender, 0.0, 0.0),
        deflection_m: 0.0,
        rated_deflection_m: fender.rated_deflection_m,
        normal_force_n: 0.0,
        peak_normal_force_n: 0.0,
        peak_deflection_m: 0.0,
        panel_turn_rad: 0.0,
    }
}

/// The ends of a fender's face, first the left end as seen when looking out from the body. The right end of the face,
/// for somebody who looks at the face, is the left end for somebody who looks out from the body.
fn face(fender: &Fender, deflection_m: f64, turn_rad: f64) -> [Vec2; 2] {
    let out = Rotation::from_angle(fender.facing_rad);
    let middle_m = fender.position_m + out.apply(vec2(fender.projection_m - deflection_m, 0.0));
    let turned = Rotation::from_angle(-turn_rad).apply(vec2(0.0, 0.5 * fender.width_m));
    let half_m = out.apply(turned);
    [middle_m - half_m, middle_m + half_m]
}
