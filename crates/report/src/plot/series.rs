//! Series of points, and the thinning of a long series to a number of points that can be drawn.

use fenderline_contact::number::greater;

/// A point of a series, in the units of the chart's axes. A point whose `y` is NaN breaks the line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Value on the horizontal axis.
    pub x: f64,
    /// Value on the vertical axis.
    pub y: f64,
}

/// The way in which a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Drawn {
    Line,
    Marks,
    LineAndMarks,
    /// Many small dots.
    Dots,
    /// A filled area, whose border the points are.
    Band,
}

/// One named line or set of marks of a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    pub(super) name: String,
    pub(super) points: Vec<Point>,
    pub(super) drawn: Drawn,
    pub(super) style: Option<usize>,
}

impl Series {
    /// Makes a series that is a line through `points`, which are in the order of x.
    pub fn line(name: &str, points: Vec<Point>) -> Series {
        Series { name: name.to_owned(), points, drawn: Drawn::Line, style: None }
    }

    /// Makes a series with a mark at each point, without a line.
    pub fn marks(name: &str, points: Vec<Point>) -> Series {
        Series { name: name.to_owned(), points, drawn: Drawn::Marks, style: None }
    }

    /// Makes a series with a small dot at each point, for many points.
    pub fn dots(name: &str, points: Vec<Point>) -> Series {
        Series { name: name.to_owned(), points, drawn: Drawn::Dots, style: None }
    }

    /// Makes a series that is the area between a lower and an upper line, each in the order of x.
    pub fn band(name: &str, lower: Vec<Point>, upper: Vec<Point>) -> Series {
        let points = lower.into_iter().chain(upper.into_iter().rev()).collect();
        Series { name: name.to_owned(), points, drawn: Drawn::Band, style: None }
    }

    /// Adds a mark at each point to the line of the series.
    pub fn with_marks(mut self) -> Series {
        self.drawn = Drawn::LineAndMarks;
        self
    }

    /// Gives the series colour, dash and mark number `style`, in place of those by its order in the chart, so that the
    /// marks of a reference can have the colour of their line.
    pub fn styled(mut self, style: usize) -> Series {
        self.style = Some(style);
        self
    }

    /// The series with the y of its points multiplied by `factor`.
    pub fn scaled(mut self, factor: f64) -> Series {
        for point in &mut self.points {
            point.y *= factor;
        }
        self
    }

    /// The series with the function `map` applied to every point.
    pub fn mapped(mut self, map: impl Fn(&Point) -> Point) -> Series {
        for point in &mut self.points {
            *point = map(point);
        }
        self
    }

    /// The largest |y| of the points; 0 for a series without points.
    pub fn largest(&self) -> f64 {
        self.points.iter().map(|p| p.y.abs()).filter(|y| y.is_finite()).fold(0.0, greater)
    }
}

/// Keeps a series of any length in bounded memory: of the samples within one bucket the first, lowest, highest and last
/// are kept, so that no peak is lost. When the memory is full, neighbouring buckets are merged, which halves the number
/// of buckets.
#[derive(Clone, Debug)]
pub struct Decimator {
    /// The two ends of the stretch before the first sample in which the value is zero. Merging buckets does not touch
    /// these two points.
    rest: Option<[Point; 2]>,
    buckets: Vec<Bucket>,
    samples_per_bucket: u64,
    samples_in_last: u64,
}

/// Largest number of buckets, each of at most four points.
const BUCKETS: usize = 1000;

#[derive(Clone, Copy, Debug)]
struct Bucket {
    first: Point,
    low: Point,
    high: Point,
    last: Point,
}

impl Bucket {
    fn of(sample: Point) -> Bucket {
        Bucket { first: sample, low: sample, high: sample, last: sample }
    }

    fn with(self, later: Bucket) -> Bucket {
        Bucket {
            first: self.first,
            low: if later.low.y < self.low.y { later.low } else { self.low },
            high: if later.high.y > self.high.y { later.high } else { self.high },
            last: later.last,
        }
    }
}

impl Default for Decimator {
    fn default() -> Decimator {
        Decimator::new()
    }
}

impl Decimator {
    /// Makes a decimator without samples.
    pub fn new() -> Decimator {
        Decimator { rest: None, buckets: Vec::new(), samples_per_bucket: 1, samples_in_last: 0 }
    }

    /// Notes that the value is zero from 0 until `x`, where the samples begin. The line is drawn at zero up to `x`, but
    /// these zeros do not count as samples.
    pub fn rest_until(&mut self, x: f64) {
        self.rest = Some([0.0, x].map(|x| Point { x, y: 0.0 }));
    }

    /// Adds a sample of finite values; x must not be less than that of the sample before.
    pub fn push(&mut self, x: f64, y: f64) {
        let sample = Bucket::of(Point { x, y });
        match self.buckets.last_mut() {
            Some(last) if self.samples_in_last < self.samples_per_bucket => {
                *last = last.with(sample);
                self.samples_in_last += 1;
            }
            _ => {
                if self.buckets.len() == BUCKETS {
                    self.halve();
                }
                self.buckets.push(sample);
                self.samples_in_last = 1;
            }
        }
    }

    fn halve(&mut self) {
        let merged = self.buckets.chunks(2).map(|two| match two {
            [a, b] => a.with(*b),
            rest => rest[0],
        });
        self.buckets = merged.collect();
        self.samples_per_bucket *= 2;
    }

    /// The points that are kept, at most four for each bucket, in the order of x.
    pub fn points(&self) -> Vec<Point> {
        let mut points: Vec<Point> = Vec::with_capacity(self.buckets.len());
        points.extend(self.rest.into_iter().flatten());
        for bucket in &self.buckets {
            let (a, b) = if bucket.low.x <= bucket.high.x {
                (bucket.low, bucket.high)
            } else {
                (bucket.high, bucket.low)
            };
            for point in [bucket.first, a, b, bucket.last] {
                if points.last() != Some(&point) {
                    points.push(point);
                }
            }
        }
        points
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_series_is_kept_whole() {
        let mut store = Decimator::new();
        for i in 0..500 {
            store.push(f64::from(i), f64::from(i * i));
        }
        let points = store.points();
        assert_eq!(points.len(), 500);
        assert_eq!(points[20], Point { x: 20.0, y: 400.0 });
    }

    #[test]
    fn peaks_survive_a_long_run() {
        let mut store = Decimator::new();
        for i in 0..1_000_000 {
            let y = match i {
                123_457 => 99.0,
                765_431 => -77.0,
                _ => f64::from(i % 7),
            };
            store.push(f64::from(i), y);
        }
        let points = store.points();
        assert!(points.len() <= 4 * BUCKETS);
        assert!(points.contains(&Point { x: 123_457.0, y: 99.0 }));
        assert!(points.contains(&Point { x: 765_431.0, y: -77.0 }));
        assert!(points.windows(2).all(|w| w[0].x <= w[1].x));
        assert_eq!(points.first().map(|p| p.x), Some(0.0));
        assert_eq!(points.last().map(|p| p.x), Some(999_999.0));
    }

    #[test]
    fn a_rest_before_a_long_series_stays_flat() {
        let mut store = Decimator::new();
        store.rest_until(99.0);
        for i in 100..20_000 {
            store.push(f64::from(i), f64::from(i % 7));
        }
        let points = store.points();
        assert_eq!(points[..2], [0.0, 99.0].map(|x| Point { x, y: 0.0 }));
        assert_eq!(points[2].x, 100.0);
    }
}
