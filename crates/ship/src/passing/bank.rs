//! The pull of a straight wall on a ship that goes along it, computed as the flow of her mirror image behind the wall.

use fenderline_contact::{Pose, Rotation, Vec2, vec2};

use super::flow::{PassingShip, force_above_bottom};

/// Force and moment [X, Y, N] of a straight wall on a ship that goes ahead or astern beside it, in her axes and about
/// the point from which the places of her sections are measured (N, N, N·m). The force is that of her mirror image: a
/// ship on the other side of the wall that moves as she does.
///
/// For a ship parallel to the wall, Y = (ρu²y/π) ∬ S'S' Σ 1/r³ with r² = (x₂−x₁)² + 4y² + 4n²h²: y is the distance of
/// her axis from the wall, n counts the images in surface and bottom, and h is the depth (m; `None`: deep water, n =
/// 0). The force of a wall was derived by this project from the flow of [`super::force_under_way`]; it is ½u² times the
/// change of her added mass in surge with the distance y. The surge force X of a wall on a ship parallel to it is zero,
/// and so is N for a ship that is alike fore and aft. The flow has no lift and no waves, so that the moment that turns
/// the bow away from a bank is missing.
#[must_use]
pub fn force_of_wall(
    own: &PassingShip<'_>,
    [from_m, to_m]: [Vec2; 2],
    density_kgpm3: f64,
    depth_m: Option<f64>,
    closest_m: f64,
) -> [f64; 3] {
    let along = (to_m - from_m) * (1.0 / (to_m - from_m).length());
    let mirrored = |v: Vec2| along * (2.0 * along.dot(v)) - v;
    let Pose { position_m, rotation } = own.pose;
    let ahead = rotation.apply(vec2(1.0, 0.0));
    // Her speed across her axis is no part of the flow.
    let velocity_mps = ahead * own.velocity_mps.dot(ahead);
    let image_ahead = mirrored(ahead);
    let image = PassingShip {
        sections: own.sections,
        pose: Pose {
            position_m: from_m + mirrored(position_m - from_m),
            rotation: Rotation { cos: image_ahead.x, sin: image_ahead.y },
        },
        velocity_mps: mirrored(velocity_mps),
    };
    let own = PassingShip { velocity_mps, ..*own };
    force_above_bottom([&own, &image], density_kgpm3, closest_m, depth_m)
}
