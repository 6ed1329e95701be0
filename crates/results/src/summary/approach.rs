//! Approaches in `summary.json`.

use fenderline_sim::{Approach, Setup};

use crate::json::{Json, object};

/// The approaches to berths of a set-up, as JSON.
pub(super) fn approaches_json(setup: &Setup) -> Json {
    let one = |approach: &Approach| {
        object!({
            "body": setup.bodies[approach.body].name,
            "fender": setup.fenders[approach.fender].name,
            "side": approach.side.to_string(),
            "contact_forward_of_midship_m": approach.contact_m,
            "speed_mps": approach.speed_mps(),
            "normal_berthing_speed_mps": approach.normal_speed_mps,
            "along_mps": approach.along_mps,
            "angle_rad": approach.angle_rad,
            "distance_m": approach.distance_m,
            "abnormal": approach.is_abnormal(),
            "energy_factor": approach.energy_factor,
        })
    };
    setup.approaches.iter().map(one).collect()
}
