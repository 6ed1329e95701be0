//! Rate limits.

use fenderline_contact::number::lesser;

use std::time::Instant;

/// A token bucket.
#[derive(Clone, Debug)]
pub(crate) struct Bucket {
    per_s: f64,
    most: f64,
    left: f64,
    at: Instant,
}

impl Bucket {
    /// A limit that starts with its whole burst, from the rate (per second) and the size of a burst.
    pub(crate) fn new(per_s: f64, most: f64, now: Instant) -> Bucket {
        Bucket { per_s, most, left: most, at: now }
    }

    /// Takes one use of what the limit counts; false if no use is left at present.
    pub(crate) fn take(&mut self, now: Instant) -> bool {
        let seconds = now.saturating_duration_since(self.at).as_secs_f64();
        self.at = now;
        self.left = lesser(self.left + seconds * self.per_s, self.most);
        if self.left < 1.0 {
            return false;
        }
        self.left -= 1.0;
        true
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[test]
    fn a_bucket_limits_bursts_and_the_rate() {
        let start = Instant::now();
        let mut bucket = Bucket::new(10.0, 5.0, start);
        let taken = |bucket: &mut Bucket, at| (0..100).filter(|_| bucket.take(at)).count();
        assert_eq!(taken(&mut bucket, start), 5);
        assert_eq!(taken(&mut bucket, start + Duration::from_millis(310)), 3);
        assert_eq!(taken(&mut bucket, start + Duration::from_secs(60)), 5);
    }
}
