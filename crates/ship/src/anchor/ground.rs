//! The holding power of anchor and chain on the bottom.

use fenderline_contact::number::greater;

use super::gear::AnchorGear;
use crate::mooring::{Cable, catenary};

/// Share of the holding power that an anchor keeps, by the sine of the angle between its shank and the bottom. The sine
/// of the shank's angle is 1 divided by the scope of a straight chain. The shares of the holding power are from
/// Casey's table, for scopes from 10 to 2. For larger angles of the shank we assume a straight line to zero at a right
/// angle.
const BY_UPLIFT: [[f64; 2]; 8] = [
    [0.1, 1.0],
    [1.0 / 7.0, 0.91],
    [1.0 / 6.0, 0.85],
    [0.2, 0.77],
    [0.25, 0.67],
    [1.0 / 3.0, 0.53],
    [0.5, 0.35],
    [1.0, 0.0],
];

/// Share of its holding power that an anchor keeps when the chain lifts the shank. `sine` is the sine of the angle
/// between shank and bottom.
#[must_use]
pub fn uplift_share(sine: f64) -> f64 {
    let Some(upper) = BY_UPLIFT.iter().position(|point| point[0] >= sine) else { return 0.0 };
    if upper == 0 {
        return 1.0;
    }
    let ([x0, y0], [x1, y1]) = (BY_UPLIFT[upper - 1], BY_UPLIFT[upper]);
    y0 + (y1 - y0) * (sine - x0) / (x1 - x0)
}

/// Forces of the chain between hawse pipe and anchor.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pull {
    /// Horizontal tension of the chain (N), which is the same along the whole chain.
    pub(super) horizontal_n: f64,
    /// Downward force of the chain on the hawse pipe (N).
    pub(super) down_n: f64,
    /// Upward force of the chain on the anchor (N); 0 while chain lies on the bottom.
    pub(super) uplift_n: f64,
    /// Length of the chain that lies on the bottom (m).
    pub(super) on_bottom_m: f64,
}

impl Pull {
    /// Tension of the chain at the hawse pipe (N).
    pub(super) fn tension_n(&self) -> f64 {
        libm::hypot(self.horizontal_n, self.down_n)
    }
}

/// The chain of an anchor that lies on the bottom.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ground<'a> {
    pub(super) gear: &'a AnchorGear,
    /// Height of the hawse pipe above the bottom (m).
    pub(super) rise_m: f64,
    /// Weight of the chain in water per length (N/m), and weight of the anchor in water (N).
    pub(super) chain_npm: f64,
    pub(super) anchor_n: f64,
}

impl Ground<'_> {
    /// Forces of the chain at the given horizontal distance between anchor and hawse pipe.
    pub(super) fn pull(&self, chain_m: f64, span_m: f64) -> Pull {
        let chain = self.gear.chain();
        let cable = Cable {
            length_m: chain_m,
            axial_stiffness_n: chain.stiffness_npm(chain_m) * chain_m,
            weight_npm: self.chain_npm,
        };
        let form = catenary(&cable, span_m, self.rise_m, true);
        Pull {
            horizontal_n: form.horizontal_n,
            down_n: form.upper_vertical_n,
            uplift_n: greater(form.lower_vertical_n, 0.0),
            on_bottom_m: form.on_bottom_m,
        }
    }

    /// The horizontal pull that anchor and chain can hold (N). `factor` is the anchor's holding power divided by its
    /// weight.
    pub(super) fn holding_n(&self, pull: &Pull, factor: f64) -> f64 {
        let sine = match pull.uplift_n > 0.0 {
            true => pull.uplift_n / libm::hypot(pull.horizontal_n, pull.uplift_n),
            false => 0.0,
        };
        factor * self.gear.anchor_weight_n() * uplift_share(sine)
            + self.gear.chain_friction * self.chain_npm * pull.on_bottom_m
    }

    /// By how much a pull on the chain exceeds what anchor and chain hold, along the bottom or upwards (N).
    pub(super) fn excess_n(&self, pull: &Pull, factor: f64) -> f64 {
        let along_n = pull.horizontal_n - self.holding_n(pull, factor);
        greater(along_n, pull.uplift_n - self.anchor_n)
    }

    /// The largest distance up to `span_m` at which anchor and chain hold the pull of the chain (m).
    pub(super) fn holding_span_m(&self, chain_m: f64, span_m: f64, factor: f64) -> f64 {
        let excess_n = |span_m: f64| self.excess_n(&self.pull(chain_m, span_m), factor);
        let near_m = greater(span_m - 0.5, 0.0);
        let (mut held_m, mut dragged_m) = match excess_n(near_m) <= 0.0 {
            true => (near_m, span_m),
            false => (0.0, near_m),
        };
        // Bisection to 1e-9 m: the excess grows with the distance.
        while dragged_m - held_m > 1e-9 {
            let middle_m = held_m.midpoint(dragged_m);
            if middle_m <= held_m || middle_m >= dragged_m {
                break;
            }
            if excess_n(middle_m) > 0.0 {
                dragged_m = middle_m;
            } else {
                held_m = middle_m;
            }
        }
        held_m
    }

    /// The shortest chain, from `chain_m` to the whole chain, with which the tension at the hawse pipe is at most
    /// `limit_n` (m). If no length of chain is enough, the result is the whole chain.
    pub(super) fn rendered_m(&self, chain_m: f64, span_m: f64, limit_n: f64) -> f64 {
        let (mut tight_m, mut slack_m) = (chain_m, self.gear.chain_length_m);
        if self.pull(slack_m, span_m).tension_n() > limit_n {
            return slack_m;
        }
        while slack_m - tight_m > 1e-9 {
            let middle_m = tight_m.midpoint(slack_m);
            if middle_m <= tight_m || middle_m >= slack_m {
                break;
            }
            if self.pull(middle_m, span_m).tension_n() > limit_n {
                tight_m = middle_m;
            } else {
                slack_m = middle_m;
            }
        }
        slack_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_share_follows_the_table_and_only_falls() {
        assert_eq!(uplift_share(0.0), 1.0);
        assert_eq!(uplift_share(0.1), 1.0);
        assert!((uplift_share(0.2) - 0.77).abs() < 1e-15);
        assert!((uplift_share(0.75) - 0.175).abs() < 1e-15);
        assert_eq!(uplift_share(1.0), 0.0);
        let shares: Vec<f64> = (0..=100).map(|k| uplift_share(f64::from(k) / 100.0)).collect();
        assert!(shares.is_sorted_by(|a, b| a >= b));
    }
}
