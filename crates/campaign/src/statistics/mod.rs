//! Statistics of the numbers of many runs: exceedance, design values, fits, sensitivity.
