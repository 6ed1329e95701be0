//! What the fuzz targets share: bytes read as numbers, and convex polygons made from them.

pub mod input;
pub mod polygon;
