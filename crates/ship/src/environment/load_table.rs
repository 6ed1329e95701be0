//! Forces of a steady flow on a ship, from a table by angle. A table of forces may hold values for several depths of
//! water.

use core::f64::consts::{PI, TAU};

use super::error::EnvironmentError;
use super::table::{Place, check_axis, place};
use crate::range::within;

/// Surge and sway force (m²) and yaw moment about midship (m³) of a flow on a ship, each divided by the dynamic
/// pressure ½ρV² of the flow. Each value of the table is therefore a coefficient times the reference area; for the
/// moment, also times the reference length.
///
/// The angle γ of the table is that of [`super::wind::RelativeWind`]: the direction from which the flow comes, measured
/// from the bow, positive over the port side. Forces in the table are positive forward and to starboard; the moment is
/// positive if it turns the bow to starboard. The values are interpolated linearly between two angles and between two
/// depths of the table. After the last angle of the table, the interpolation goes on to its first angle. In water
/// shallower than the table's least depth the values of that depth are used, and in deeper water than its greatest
/// depth the values of the greatest.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadTable {
    depth_ratios: Vec<f64>,
    angles_rad: Vec<f64>,
    /// Values of the table: all angles of the first depth, then all angles of the next depth.
    values: Vec<[f64; 3]>,
    sides: Sides,
}

/// The range of the angles of a [`LoadTable`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// The table's angles go from 0 to π: a flow over starboard is the mirror image of a flow over port.
    Mirrored,
    /// The table's angles go round a whole turn, each angle once.
    Both,
}

impl LoadTable {
    /// Makes a table from the ratios of water depth to draught, the angles (rad) and the values: all angles of the
    /// first depth, then all angles of the next. A table with a single depth holds for every depth of water.
    ///
    /// # Errors
    /// Fails for axes that do not rise; fewer than three angles; a wrong number of values; a value that is not finite;
    /// mirrored angles that do not reach from 0 to π; other angles that span a whole turn or more.
    pub fn new(
        depth_ratios: Vec<f64>,
        angles_rad: Vec<f64>,
        values: Vec<[f64; 3]>,
        sides: Sides,
    ) -> Result<LoadTable, EnvironmentError> {
        check_axis("depths of a table of forces", depth_ratios.iter().copied(), 1)?;
        check_axis("angles of a table of forces", angles_rad.iter().copied(), 3)?;
        let (first_rad, last_rad) = (angles_rad[0], angles_rad[angles_rad.len() - 1]);
        match sides {
            Sides::Mirrored => {
                within("first angle of a mirrored table [rad]", first_rad, 0.0, 0.0)?;
                within("last angle of a mirrored table [rad]", last_rad, PI, PI)?;
            }
            Sides::Both => {
                let most_rad = TAU - 1e-9;
                within("span of the angles of a table [rad]", last_rad - first_rad, 0.0, most_rad)?;
            }
        }
        let expected = depth_ratios.len() * angles_rad.len();
        if values.len() != expected {
            let found = values.len();
            return Err(EnvironmentError::Length { table: "table of forces", expected, found });
        }
        for value in values.iter().flatten() {
            within("force over dynamic pressure [m² or m³]", *value, -1e9, 1e9)?;
        }
        Ok(LoadTable { depth_ratios, angles_rad, values, sides })
    }

    /// The table's depths of water, divided by the draught.
    #[must_use]
    pub fn depth_ratios(&self) -> &[f64] {
        &self.depth_ratios
    }

    /// The angles (rad).
    #[must_use]
    pub fn angles_rad(&self) -> &[f64] {
        &self.angles_rad
    }

    /// True if the table was given for a flow over one side only.
    #[must_use]
    pub fn is_mirrored(&self) -> bool {
        self.sides == Sides::Mirrored
    }

    /// The table's values [X, Y, N] (m², m², m³) at an angle γ (rad) and at a ratio of water depth to draught; a ratio
    /// of `None` means deep water. A mirrored table has no side force and no moment if the flow comes from straight
    /// ahead or astern.
    #[must_use]
    pub fn at(&self, angle_rad: f64, depth_ratio: Option<f64>) -> [f64; 3] {
        let wrapped_rad = libm::remainder(angle_rad, TAU);
        let at_depth = |row: usize| match self.sides {
            Sides::Both => self.in_row(row, self.around(wrapped_rad)),
            Sides::Mirrored => {
                let [surge, sway, yaw] = self.in_row(row, self.along(wrapped_rad.abs()));
                let side = if wrapped_rad == 0.0 || wrapped_rad.abs() >= PI {
                    0.0
                } else {
                    wrapped_rad.signum()
                };
                [surge, side * sway, side * yaw]
            }
        };
        let ratios = &self.depth_ratios;
        let ratio = depth_ratio.unwrap_or(f64::INFINITY);
        let Place { low, high, share } = place(ratios.len(), |k| ratios[k], ratio);
        if low == high {
            return at_depth(low);
        }
        mixed(at_depth(low), at_depth(high), share)
    }

    /// Finds an angle's place on the axis of a mirrored table.
    fn along(&self, angle_rad: f64) -> Place {
        place(self.angles_rad.len(), |k| self.angles_rad[k], angle_rad)
    }

    /// Finds an angle's place on the axis of a table that goes round a whole turn. A table of a whole turn is closed
    /// between its last and its first angle.
    fn around(&self, angle_rad: f64) -> Place {
        let (count, first_rad) = (self.angles_rad.len(), self.angles_rad[0]);
        let mut from_first_rad = libm::fmod(angle_rad - first_rad, TAU);
        if from_first_rad < 0.0 {
            from_first_rad += TAU;
        }
        let at = |k: usize| self.angles_rad[k] - first_rad;
        let last_rad = at(count - 1);
        if from_first_rad <= last_rad {
            return place(count, at, from_first_rad);
        }
        let share = (from_first_rad - last_rad) / (TAU - last_rad);
        Place { low: count - 1, high: 0, share: fenderline_contact::number::lesser(share, 1.0) }
    }

    fn in_row(&self, row: usize, at: Place) -> [f64; 3] {
        let row = &self.values[row * self.angles_rad.len()..];
        if at.low == at.high {
            return row[at.low];
        }
        mixed(row[at.low], row[at.high], at.share)
    }
}

fn mixed(one: [f64; 3], two: [f64; 3], share: f64) -> [f64; 3] {
    core::array::from_fn(|k| one[k] + share * (two[k] - one[k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one_side() -> LoadTable {
        let values = vec![[-3.0, 0.0, 0.0], [1.0, 8.0, 4.0], [5.0, 0.0, 0.0]];
        LoadTable::new(vec![1.0], vec![0.0, 0.5 * PI, PI], values, Sides::Mirrored).unwrap()
    }

    #[test]
    fn a_mirrored_table_is_the_same_on_both_sides_to_the_bit() {
        let table = one_side();
        for step in 0..=720 {
            let angle_rad = (f64::from(step) - 360.0).to_radians();
            let ([x, y, n], [mx, my, mn]) = (table.at(angle_rad, None), table.at(-angle_rad, None));
            assert_eq!([x, y, n], [mx, -my, -mn], "{angle_rad}");
        }
        assert_eq!(table.at(0.25 * PI, Some(2.0)), [-1.0, 4.0, 2.0]);
        assert_eq!(table.at(PI, None), [5.0, 0.0, 0.0]);
    }

    #[test]
    fn a_whole_turn_closes_without_a_jump_and_repeats() {
        let angles = vec![-2.0, -0.5, 1.0, 2.5];
        let values = vec![[1.0, -4.0, 0.5], [-2.0, -1.0, 3.0], [2.0, 6.0, -1.0], [4.0, 2.0, 2.0]];
        let table = LoadTable::new(vec![2.0], angles.clone(), values.clone(), Sides::Both).unwrap();
        for (angle_rad, value) in angles.iter().zip(&values) {
            for turns in [-2.0, 0.0, 3.0] {
                let at = table.at(angle_rad + turns * TAU, None);
                assert!(at.iter().zip(value).all(|(a, b)| (a - b).abs() < 1e-12), "{at:?}");
            }
        }
        // Half of the way from 2.5 rad, past π, to −2 rad.
        let middle = table.at(0.5 * (2.5 - 2.0 + TAU), None);
        assert!((middle[1] + 1.0).abs() < 1e-12, "{middle:?}");
        let mut last = table.at(-4.0, None);
        for step in 1..=8000 {
            let now = table.at(-4.0 + 0.001 * f64::from(step), None);
            assert!((0..3).all(|k| (now[k] - last[k]).abs() < 0.02), "step {step}");
            last = now;
        }
    }

    #[test]
    fn depths_are_joined_by_lines_and_held_beyond_the_ends() {
        let at = |size: f64| [[-size, 0.0, 0.0], [0.0, size, 0.0], [size, 0.0, 0.0]];
        let values = [at(4.0), at(2.0)].concat();
        let angles = vec![0.0, 0.5 * PI, PI];
        let table = LoadTable::new(vec![1.1, 3.1], angles, values, Sides::Mirrored).unwrap();
        for (ratio, size) in
            [(Some(1.0), 4.0), (Some(1.1), 4.0), (Some(2.1), 3.0), (Some(9.0), 2.0), (None, 2.0)]
        {
            let [_, sway, _] = table.at(0.5 * PI, ratio);
            assert!((sway - size).abs() < 1e-12, "{ratio:?}: {sway}");
        }
    }

    #[test]
    fn axes_that_do_not_fit_are_refused() {
        let values = || vec![[0.0; 3]; 3];
        let new = LoadTable::new;
        assert!(new(vec![1.0], vec![0.0, 1.0, 3.0], values(), Sides::Mirrored).is_err());
        assert!(new(vec![1.0], vec![0.0, 1.0, TAU], values(), Sides::Both).is_err());
        assert!(new(vec![1.0], vec![0.0, 1.0, 1.0], values(), Sides::Both).is_err());
        assert!(new(vec![1.0, 2.0], vec![0.0, 1.0, 2.0], values(), Sides::Both).is_err());
        assert!(new(vec![1.0], vec![0.0, 1.0], vec![[0.0; 3]; 2], Sides::Both).is_err());
        let nan = vec![[0.0; 3], [0.0, f64::NAN, 0.0], [0.0; 3]];
        assert!(new(vec![1.0], vec![0.0, 1.0, 2.0], nan, Sides::Both).is_err());
    }
}
