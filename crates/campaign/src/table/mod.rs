//! Tables of many runs in files, read by columns.
