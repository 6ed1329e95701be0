//! Logs of many layouts.
