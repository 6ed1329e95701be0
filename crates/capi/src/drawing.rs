//! Functions that give a program what it draws: outlines and the faces of fenders, all in one call each.

use fenderline_embed::FenderView;

use crate::border::write_all;
use crate::engine::{among, give_all};
use crate::failure::{FlStatus, failure};
use crate::table::{ENGINES, FlEngine};
use crate::types::{FL_NONE, FlFenderView};

/// Copies the outline of a body: `vertices` gets pairs of x (forward) and y (to starboard) from the centre of gravity
/// (m), in the sense of rotation from x to y. `capacity` is the room in `vertices`; `*vertices` gets the number of
/// vertices of the outline. NULL `vertices` with a capacity of 0 only ask for the number of vertices. If the capacity
/// is too small for the outline, nothing is copied, and the status is FL_STATUS_BUFFER_TOO_SMALL. Outlines of bodies do
/// not change, so that a program need read them only once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_outline(
    engine: *const FlEngine,
    body: u32,
    outline_m: *mut f64,
    capacity: usize,
    vertices: *mut usize,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        let body = among("body", held.engine.model().bodies(), body)?;
        let own: Vec<[f64; 2]> = body.outline.vertices().iter().map(|v| [v.x, v.y]).collect();
        // SAFETY: as the caller promises.
        unsafe { give_pairs(&own, outline_m, capacity, vertices) }
    })
}

/// Copies the drawing data of all fenders after the last step. A fender counts as uncompressed before the first step,
/// and while nothing presses it. `count` is the number of fenders of the engine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_fender_views(
    engine: *const FlEngine,
    views: *mut FlFenderView,
    count: usize,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        let own: Vec<FenderView> = held.engine.fender_views().collect();
        if own.len() != count {
            let text = format_args!("there are {} fenders, but the array has {count}", own.len());
            return failure(FlStatus::BadArgument, text);
        }
        // SAFETY: as the caller promises; `count` is the number of fenders.
        unsafe { write_all(views, &own, "views", FlFenderView::outward) }
    })
}

/// Copies all pairs of numbers to the caller, or none if they do not fit, and stores the number of pairs.
///
/// # Safety
/// The caller promises room for `capacity` pairs.
pub(crate) unsafe fn give_pairs(
    own: &[[f64; 2]],
    into: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> crate::failure::Outcome {
    // SAFETY: as the caller promises.
    unsafe { give_all(own, into.cast::<[f64; 2]>(), capacity, count, |pair| pair) }
}

impl FlFenderView {
    pub(crate) fn outward(view: FenderView) -> FlFenderView {
        let ([mount_1, mount_2], [face_1, face_2]) = (view.mount_m, view.face_m);
        FlFenderView {
            body: view.body.0,
            hull: view.hull.map_or(FL_NONE, |hull| hull.0),
            mount_1_forward_m: mount_1.x,
            mount_1_starboard_m: mount_1.y,
            mount_2_forward_m: mount_2.x,
            mount_2_starboard_m: mount_2.y,
            face_1_forward_m: face_1.x,
            face_1_starboard_m: face_1.y,
            face_2_forward_m: face_2.x,
            face_2_starboard_m: face_2.y,
            deflection_m: view.deflection_m,
            rated_deflection_m: view.rated_deflection_m,
            normal_force_n: view.normal_force_n,
            peak_normal_force_n: view.peak_normal_force_n,
            peak_deflection_m: view.peak_deflection_m,
            panel_turn_rad: view.panel_turn_rad,
        }
    }
}
