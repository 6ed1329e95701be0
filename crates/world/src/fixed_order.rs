//! The order of summation. A floating-point sum depends on the order of its terms, so forces are summed in the order of
//! names, not in the order of the scenario file.

use crate::setup::body::BodySetup;
use crate::setup::load::Load;
use crate::world::setup::WorldSetup;

/// The order of summation: indices of the parts of a set-up, sorted by name.
#[derive(Clone, Debug)]
pub struct SumOrder {
    /// Indices of the bodies.
    pub bodies: Vec<usize>,
    /// Indices of the vessels.
    pub vessels: Vec<usize>,
    /// Indices of the vector tugs.
    pub tugs: Vec<usize>,
    /// Indices of the mooring lines.
    pub lines: Vec<usize>,
    /// Indices of the anchors.
    pub anchors: Vec<usize>,
}

impl SumOrder {
    /// Finds the order of summation for a set-up.
    pub fn new(world: &WorldSetup, bodies: &[BodySetup]) -> SumOrder {
        SumOrder {
            bodies: by_name(bodies.iter().map(|body| body.name.as_str())),
            vessels: by_name(world.vessels.iter().map(|of| bodies[of.body].name.as_str())),
            tugs: by_name(world.tugs.iter().map(|of| of.tug.name.as_str())),
            lines: by_name(world.lines.iter().map(|of| of.line.name.as_str())),
            anchors: by_name(world.anchors.iter().map(|of| of.gear.name.as_str())),
        }
    }
}

/// Indices of the names in sorted order; equal names keep their order.
fn by_name<'n>(names: impl Iterator<Item = &'n str>) -> Vec<usize> {
    let names: Vec<&str> = names.collect();
    let mut places: Vec<usize> = (0..names.len()).collect();
    places.sort_by_key(|&place| names[place]);
    places
}

/// Sorts loads by their values, because loads have no names. Two loads that compare equal are identical.
pub fn sort_loads(loads: &mut [Load]) {
    let key = |load: &Load| {
        let Load { body: _, force_n, moment_nm, from_s, until_s } = *load;
        [from_s, until_s, force_n.x, force_n.y, moment_nm]
    };
    loads.sort_by(|one, other| {
        let pairs = key(one).into_iter().zip(key(other));
        let by_number = pairs.map(|(one, other)| one.total_cmp(&other));
        by_number.fold(one.body.cmp(&other.body), std::cmp::Ordering::then)
    });
}

#[cfg(test)]
mod tests {
    use fenderline_contact::vec2;

    use super::*;

    #[test]
    fn the_order_is_that_of_the_names() {
        assert_eq!(by_name(["spring", "aft", "head"].into_iter()), [1, 2, 0]);
        assert_eq!(by_name(["a", "b", "a"].into_iter()), [0, 2, 1]);
    }

    #[test]
    fn loads_are_sorted_the_same_way_from_any_order() {
        let load = |body, north_n, from_s| Load {
            body,
            force_n: vec2(north_n, 0.0),
            moment_nm: 0.0,
            from_s,
            until_s: f64::INFINITY,
        };
        let mut one = [load(1, 1.0, 0.0), load(0, 3.0, 0.0), load(0, 2.0, 0.0), load(0, 1.0, 5.0)];
        let mut other = [one[3], one[2], one[0], one[1]];
        sort_loads(&mut one);
        sort_loads(&mut other);
        assert_eq!(one, other);
    }
}
