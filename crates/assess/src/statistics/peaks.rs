//! Statistics of a series of values about its mean.

use fenderline_contact::number::greater;

/// Statistics of one motion. Peaks are counted between crossings of the mean: the largest distance from the mean
/// between two crossings is one peak, and peaks of both sides count. A range goes from a crest to the trough after it,
/// between up-crossings. Values before the first crossing and after the last crossing count only for mean, deviation
/// and maximum.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotionStatistics {
    /// Mean (m or rad). The mean of surge and of sway is measured from the first position that counts.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// Largest distance of the motion from its mean.
    pub maximum: f64,
    /// Mean of the highest third of the peaks; the highest peak or peaks if there are fewer than three. 0 without a
    /// peak.
    pub significant: f64,
    /// Largest range of the motion, from a crest to the next trough.
    pub maximum_range: f64,
    /// Mean of the highest third of the ranges from crest to trough.
    pub significant_range: f64,
    /// Mean time between up-crossings of the mean (s); 0 if there are fewer than two up-crossings.
    pub zero_crossing_s: f64,
    /// Number of peaks.
    pub peaks: u32,
}

impl MotionStatistics {
    /// Computes the statistics of values that are equally spaced in time; `apart_s` is the time between two values.
    pub(super) fn of(values: &[f64], apart_s: f64) -> MotionStatistics {
        if values.is_empty() {
            return MotionStatistics::default();
        }
        let number = values.len() as f64;
        // Sums are taken relative to the first value, so that the mean of a still ship has no rounding error.
        let first = values[0];
        let mean = first + values.iter().map(|value| value - first).sum::<f64>() / number;
        let square: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
        let maximum = values.iter().fold(0.0, |most, value| greater(most, (value - mean).abs()));
        let (mut peaks, mut ranges) = (Vec::new(), Vec::new());
        let mut up_crossings = Vec::new();
        let mut peak: Option<f64> = None;
        for (index, pair) in values.windows(2).enumerate() {
            let [before, now] = [pair[0] - mean, pair[1] - mean];
            if (before < 0.0) != (now < 0.0) {
                if let Some(whole) = peak {
                    // A trough that ends closes a range with the crest before it.
                    if now >= 0.0
                        && let Some(crest) = peaks.last()
                    {
                        ranges.push(crest + whole);
                    }
                    peaks.push(whole);
                }
                if now >= 0.0 {
                    up_crossings.push(index as f64 + before / (before - now));
                }
                peak = Some(now.abs());
            } else if let Some(peak) = &mut peak {
                *peak = greater(*peak, now.abs());
            }
        }
        let crossings = up_crossings.len();
        let zero_crossing_s = match (up_crossings.first(), up_crossings.last()) {
            (Some(first), Some(last)) if crossings > 1 => {
                (last - first) * apart_s / (crossings - 1) as f64
            }
            _ => 0.0,
        };
        let number_of_peaks = peaks.len() as u32;
        MotionStatistics {
            mean,
            deviation: libm::sqrt(square / number),
            maximum,
            maximum_range: ranges.iter().copied().fold(0.0, greater),
            significant_range: highest_third(ranges),
            significant: highest_third(peaks),
            zero_crossing_s,
            peaks: number_of_peaks,
        }
    }
}

/// Mean of the highest third of the values; the number of values in this third is rounded up. The result is 0 if there
/// are no values.
fn highest_third(mut values: Vec<f64>) -> f64 {
    let number = values.len().div_ceil(3);
    if number == 0 {
        return 0.0;
    }
    values.sort_by(|one, other| other.total_cmp(one));
    values[..number].iter().sum::<f64>() / number as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sine of amplitude 2 about 5 with a period of 10 s: deviation 2/√2, all peaks 2, all ranges 4.
    #[test]
    fn a_sine_has_its_amplitude_deviation_and_period() {
        let values: Vec<f64> = (0..10_000)
            .map(|i| 5.0 + 2.0 * libm::sin(0.02 * core::f64::consts::PI * f64::from(i)))
            .collect();
        let found = MotionStatistics::of(&values, 0.1);
        assert!((found.mean - 5.0).abs() < 1e-9);
        assert!((found.deviation - core::f64::consts::SQRT_2).abs() < 1e-9);
        for (value, wanted) in [
            (found.maximum, 2.0),
            (found.significant, 2.0),
            (found.maximum_range, 4.0),
            (found.significant_range, 4.0),
            (found.zero_crossing_s, 10.0),
        ] {
            assert!((value / wanted - 1.0).abs() < 1e-3, "{found:?}");
        }
        assert!((197..=200).contains(&found.peaks), "{found:?}");
    }

    /// By hand: mean 0, crossings after the second value. The peaks are 1, 3, 2 and 6; the highest third of four,
    /// rounded up, is two peaks.
    #[test]
    fn peaks_and_ranges_by_hand() {
        let values = [-4.0, -4.0, 1.0, -3.0, -1.0, 2.0, 2.0, -6.0, 5.0, 8.0];
        let found = MotionStatistics::of(&values, 1.0);
        assert_eq!((found.mean, found.maximum, found.peaks), (0.0, 8.0, 4));
        assert_eq!(found.significant, 0.5 * (6.0 + 3.0));
        // Crest 1 to trough 3, crest 2 to trough 6.
        assert_eq!((found.maximum_range, found.significant_range), (8.0, 8.0));
        assert_eq!(MotionStatistics::of(&[], 1.0), MotionStatistics::default());
        assert_eq!(MotionStatistics::of(&[3.0; 5], 1.0).deviation, 0.0);
    }

    /// Narrow-banded noise has a significant amplitude near twice its deviation: 2.00 by Rayleigh's law
    /// (Longuet-Higgins 1952). The test has sixty harmonics over 10 000 periods. The tolerance is 5 %, because the
    /// spectrum has steps.
    #[test]
    fn a_narrow_band_has_the_significant_value_of_rayleighs_law() {
        let phase = |k: u32| libm::fmod(f64::from(k) * 2.399_963, 2.0 * core::f64::consts::PI);
        let at = |t_s: f64| -> f64 {
            (0..60)
                .map(|k| {
                    libm::cos(
                        (1.0 + 0.002 * f64::from(k) / 6.0 + 1e-5 * f64::from(k * k % 7)) * t_s
                            + phase(k * k + k),
                    )
                })
                .sum()
        };
        let values: Vec<f64> = (0..120_000).map(|i| at(0.5 * f64::from(i))).collect();
        let found = MotionStatistics::of(&values, 0.5);
        let ratio = found.significant / found.deviation;
        assert!((ratio / 2.0 - 1.0).abs() < 0.05, "{ratio}");
    }
}
