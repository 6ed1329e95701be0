//! The approach of a ship in words.

use super::Approach;
use crate::named::called;
use crate::setup::Setup;

impl Approach {
    /// A sentence that describes the approach.
    #[must_use]
    pub fn sentence(&self, setup: &Setup) -> String {
        let ship = &setup.bodies[self.body].name;
        let fender = &setup.fenders[self.fender].name;
        let to = &setup.bodies[setup.fenders[self.fender].body].name;
        // The fender of a dolphin often has the dolphin's name.
        let fender =
            if fender == to { String::new() } else { format!(", {}", called("fender", fender)) };
        let angle = self.angle_rad.to_degrees();
        let mut text = format!(
            "{ship} meets {to}{fender}, with her {} side {:.1} m {} of midship at {:.3} m/s and \
             {angle:.1}°",
            self.side,
            self.contact_m.abs(),
            if self.contact_m < 0.0 { "aft" } else { "forward" },
            self.speed_mps(),
        );
        if self.is_abnormal() {
            text += &format!(
                "; abnormal berthing: {:.2} times the energy, {:.2} times the normal speed of {:.3} m/s",
                self.energy_factor,
                self.energy_factor.sqrt(),
                self.normal_speed_mps
            );
        }
        text
    }

    /// A sentence with the ship's position, heading and velocity at the start of the approach.
    #[must_use]
    pub fn start_sentence(&self, setup: &Setup) -> String {
        let body = &setup.bodies[self.body];
        format!(
            "{} starts at [{:.3} m, {:.3} m], heading {:.2}°, surge {:.4} m/s, sway {:.4} m/s",
            body.name,
            body.position_m.x,
            body.position_m.y,
            body.heading_rad.to_degrees(),
            body.velocity.surge_mps,
            body.velocity.sway_mps
        )
    }
}
