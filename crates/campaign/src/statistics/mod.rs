//! Statistics of the numbers of many runs: exceedance, design values, fits, sensitivity. Pure functions of samples.
//!
//! A [`Sample`] holds the values in order, with their weights if the runs were drawn by importance sampling. Every
//! estimate comes with an [`Interval`]; the doc of each function says which kind of interval. No function of this
//! module draws random numbers: the same values give the same bits.

pub mod convergence;
pub mod correlation;
pub mod design;
pub mod exceedance;
pub mod fit;
mod interval;
mod moments;
mod normal;
pub mod operability;
mod probability;
mod quantile;
pub mod return_value;
mod sample;

pub use interval::{Confidence, Estimate, Interval};
pub use moments::{Measured, Moments};
pub use probability::{binomial, share_above, wilson};
pub use quantile::{Quantile, quantile, value_exceeded};
pub use sample::{Sample, SampleError};
