//! Geometry of a single contact (docs/contact_model.md, section 1; §3.1 of the paper).
//!
//! All coordinates are in the frame of the first body of a pair, so that no digits are lost far from the chart's
//! origin.

pub(crate) mod apart;
pub(crate) mod axis;
pub(crate) mod box_tree;
pub(crate) mod clip;
pub(crate) mod convex;
pub(crate) mod edge;
pub(crate) mod extent;
pub(crate) mod gap;
pub(crate) mod halfplanes;
pub(crate) mod lens;
pub(crate) mod ring;
pub(crate) mod shapes;
pub(crate) mod through;
pub(crate) mod warm;
