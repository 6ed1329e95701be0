//! Bad input is named with file and line, and other berthings are kept.
