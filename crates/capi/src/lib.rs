//! The contact engine for programs in C.
