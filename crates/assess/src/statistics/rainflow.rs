//! Counts the cycles of a line's tension by the rainflow method.

/// Number of bins of a [`Rainflow`] count. Each bin is a twentieth of the break load wide. The last bin also holds all
/// larger ranges.
pub const RAINFLOW_BINS: usize = 20;

/// Cycles of a line's tension by range, counted as the cycles end, by the three-point rules of ASTM E1049 (cited from
/// memory). The ranges are divided by the line's break load.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rainflow {
    /// Turning points of the tension whose cycle has not yet closed.
    turns: Vec<f64>,
    /// Number of cycles in each bin, counted in half cycles.
    halves: [u64; RAINFLOW_BINS],
}

/// Ranges of the tension smaller than this share of the break load do not count as cycles: they are rounding, or the
/// ripple of a winch.
const LEAST: f64 = 0.005;

impl Rainflow {
    pub(super) fn push(&mut self, share: f64) {
        // The last entry is not a turning point yet: it moves as long as the tension goes on in the same direction.
        match self.turns[..] {
            [] => return self.turns.push(share),
            [last] if (share - last).abs() < LEAST => return,
            [_] => return self.turns.push(share),
            [.., before, last] => {
                if (share - last) * (last - before) >= 0.0 {
                    let end = self.turns.len() - 1;
                    self.turns[end] = share;
                } else if (share - last).abs() >= LEAST {
                    self.turns.push(share);
                } else {
                    return;
                }
            }
        }
        self.close();
    }

    /// Counts the tension cycles that the last turning point has closed.
    fn close(&mut self) {
        while let [.., third, second, last] = self.turns[..] {
            let (range, newest) = ((second - third).abs(), (last - second).abs());
            if newest < range {
                return;
            }
            let end = self.turns.len();
            if end == 3 {
                // A range that includes the first point counts as half a cycle.
                add(&mut self.halves, range, 1);
                self.turns.remove(0);
            } else {
                add(&mut self.halves, range, 2);
                self.turns.drain(end - 3..end - 1);
            }
        }
    }

    /// Cycles of the tension by range over break load: the first bin up to 5 %, the second up to 10 %, and so on.
    /// Ranges that are still open count as half cycles.
    #[must_use]
    pub fn cycles(&self) -> [f64; RAINFLOW_BINS] {
        let mut halves = self.halves;
        for pair in self.turns.windows(2) {
            add(&mut halves, (pair[1] - pair[0]).abs(), 1);
        }
        halves.map(|halves| 0.5 * halves as f64)
    }
}

fn add(halves: &mut [u64; RAINFLOW_BINS], range: f64, number: u64) {
    let bin = (range * RAINFLOW_BINS as f64) as usize;
    halves[bin.min(RAINFLOW_BINS - 1)] += number;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The example of ASTM E1049, recalled: −2, 1, −3, 5, −1, 3, −4, 4, −2 has half cycles of 3, 4, 8, 9, 8 and 6, and
    /// a whole cycle of 4. In this test each unit is one bin.
    #[test]
    fn the_example_of_the_standard() {
        let mut found = Rainflow::default();
        for peak in [-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0] {
            // Points on the way that are no turning points.
            found.push(0.051 * (peak - 0.01));
            found.push(0.051 * peak);
        }
        let cycles = found.cycles();
        let wanted = [(3, 0.5), (4, 1.5), (6, 0.5), (8, 1.0), (9, 0.5)];
        for (bin, cycles) in cycles.iter().enumerate() {
            let wanted =
                wanted.iter().find(|(of, _)| *of == bin).map_or(0.0, |(_, cycles)| *cycles);
            assert_eq!(*cycles, wanted, "bin {bin}");
        }
    }

    #[test]
    fn a_steady_tension_has_no_cycles() {
        let mut found = Rainflow::default();
        (0..1000).for_each(|i| found.push(0.3 + 1e-4 * f64::from(i % 2)));
        assert_eq!(found.cycles(), [0.0; RAINFLOW_BINS]);
    }
}
