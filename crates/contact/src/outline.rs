//! The outline of a body: a simple polygon, checked, tidied and cut into convex pieces at load.
