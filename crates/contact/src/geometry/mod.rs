//! Geometry of one contact (docs/contact_model.md, section 1; §3.1 of the paper).
//!
//! Everything here happens in the frame of the first body of a pair, so that neither the distance
//! to the chart's origin nor the size of the port costs a digit.

pub(crate) mod axis;
pub(crate) mod clip;
pub(crate) mod convex;
pub(crate) mod edge;
pub(crate) mod gap;
pub(crate) mod halfplanes;
pub(crate) mod lens;
pub(crate) mod ring;
pub(crate) mod through;
pub(crate) mod warm;
