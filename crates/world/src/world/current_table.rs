//! The user's own current coefficients for a vessel's hull at low speed.

use std::sync::Arc;

use fenderline_contact::number::bounded;

use fenderline_ship::environment::{EnvironmentError, LoadTable};
use fenderline_ship::hydro::{Controls, Force, Mmg, Velocity, Water};
use fenderline_ship::range::within;

/// A table of current forces on a hull, and the two speeds through the water between which the manoeuvring model takes
/// over from the table.
///
/// The table is for a ship that does not turn. Up to `alone_until_mps`, the hull's force is H = C + (M(u, v, r) − M(u,
/// v, 0)): the force C of the table, plus the force that the rate of turn adds in the manoeuvring model M. From
/// `gone_from_mps` on, the hull's force is M alone. Between the two speeds, a smooth step leads from H to M, so that
/// the force and its slope are continuous.
#[derive(Clone, Debug, PartialEq)]
pub struct CurrentTable {
    loads: Arc<LoadTable>,
    alone_until_mps: f64,
    gone_from_mps: f64,
    source: Arc<str>,
}

impl CurrentTable {
    /// A table with its source; the source is in the user's words.
    ///
    /// # Errors
    /// Fails if a speed is out of range, or if the second speed is less than 0.1 m/s above the first.
    pub fn new(
        loads: LoadTable,
        [alone_until_mps, gone_from_mps]: [f64; 2],
        source: &str,
    ) -> Result<CurrentTable, EnvironmentError> {
        within("speed up to which the current table alone acts [m/s]", alone_until_mps, 0.0, 20.0)?;
        let least_mps = alone_until_mps + 0.1;
        within(
            "speed from which on the current table does not act [m/s]",
            gone_from_mps,
            least_mps,
            40.0,
        )?;
        Ok(CurrentTable {
            loads: Arc::new(loads),
            alone_until_mps,
            gone_from_mps,
            source: source.into(),
        })
    }

    /// The table.
    #[must_use]
    pub fn loads(&self) -> &LoadTable {
        &self.loads
    }

    /// Speed through the water up to which the table alone acts, and speed from which on the table does not act (m/s).
    #[must_use]
    pub fn speeds_mps(&self) -> [f64; 2] {
        [self.alone_until_mps, self.gone_from_mps]
    }

    /// The source of the table, as the user wrote it.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.source
    }

    /// Share with which the table acts at this speed through the water (m/s), 1 to 0.
    #[must_use]
    pub fn share(&self, speed_mps: f64) -> f64 {
        let wide_mps = self.gone_from_mps - self.alone_until_mps;
        let t = bounded((speed_mps - self.alone_until_mps) / wide_mps, 0.0, 1.0);
        1.0 - t * t * (3.0 - 2.0 * t)
    }

    /// The table's force on a hull that goes through the water and does not turn, at this ratio of depth to draught
    /// (`None` for deep water).
    #[must_use]
    pub fn force(&self, velocity: &Velocity, water: Water, depth_ratio: Option<f64>) -> Force {
        let speed_mps = velocity.speed_mps();
        let pressure_npm2 = 0.5 * water.density_kgpm3 * speed_mps * speed_mps;
        // The water comes from the direction of the ship's motion: γ is the drift angle, positive if the ship slides to
        // port.
        let [surge, sway, yaw] =
            self.loads.at(velocity.drift_rad(), depth_ratio).map(|value| value * pressure_npm2);
        Force { surge_n: surge, sway_n: sway, yaw_nm: yaw }
    }

    /// The force on the hull with the share of the table at this speed; `hull` is the force by the manoeuvring model
    /// alone.
    pub fn hull(
        &self,
        model: &Mmg,
        hull: Force,
        velocity: &Velocity,
        water: Water,
        depth_ratio: Option<f64>,
    ) -> Force {
        let share = self.share(velocity.speed_mps());
        if share == 0.0 {
            return hull;
        }
        let straight = Velocity { yaw_radps: 0.0, ..*velocity };
        let of_model = model.parts(&straight, &Controls::default(), water).hull;
        hull + (self.force(velocity, water, depth_ratio) + of_model * -1.0) * share
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use super::*;
    use fenderline_ship::environment::Sides;

    fn table() -> CurrentTable {
        let values = vec![[-50.0, 0.0, 0.0], [0.0, 4000.0, 1000.0], [70.0, 0.0, 0.0]];
        let angles = vec![0.0, 0.5 * PI, PI];
        let loads = LoadTable::new(vec![1.0], angles, values, Sides::Mirrored).unwrap();
        CurrentTable::new(loads, [2.0, 4.0], "test").unwrap()
    }

    #[test]
    fn the_water_pushes_along_with_it() {
        let push = |surge_mps: f64, sway_mps: f64| {
            let velocity = Velocity { surge_mps, sway_mps, yaw_radps: 0.0 };
            table().force(&velocity, Water { density_kgpm3: 1000.0 }, None)
        };
        assert!((push(2.0, 0.0).surge_n + 100e3).abs() < 1e-6, "she goes ahead");
        assert!((push(-2.0, 0.0).surge_n - 140e3).abs() < 1e-6, "she goes astern");
        // The ship slides to port, so the water comes from port.
        assert!((push(0.0, -1.0).sway_n - 2e6).abs() < 1e-6);
        assert!((push(0.0, 1.0).sway_n + 2e6).abs() < 1e-6);
        assert_eq!(push(0.0, 0.0), Force::default());
    }

    #[test]
    fn the_share_falls_from_one_to_none_without_a_jump_or_a_kink() {
        let table = table();
        let share = |speed_mps: f64| table.share(speed_mps);
        assert_eq!(
            [share(0.0), share(2.0), share(3.0), share(4.0), share(9.0)],
            [1.0, 1.0, 0.5, 0.0, 0.0]
        );
        for step in 0..500 {
            let at = 0.01 * f64::from(step);
            assert!((share(at + 1e-6) - share(at)).abs() < 1e-6, "{at}");
            let slope = |from: f64| (share(from + 1e-5) - share(from)) / 1e-5;
            assert!((slope(at + 1e-4) - slope(at)).abs() < 1e-3, "{at}");
        }
        let loads = table.loads().clone();
        assert!(CurrentTable::new(loads, [3.0, 3.0], "").is_err());
    }
}
