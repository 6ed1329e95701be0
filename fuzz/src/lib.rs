//! Shared by the fuzz targets: bytes read as numbers, and convex polygons made from them.

pub mod input;
pub mod polygon;
