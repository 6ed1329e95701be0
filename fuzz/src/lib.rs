//! What the fuzz targets share: bytes read as numbers, and convex polygons made of them.

pub mod input;
pub mod polygon;
