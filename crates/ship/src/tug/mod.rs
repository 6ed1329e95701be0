//! Vector tugs. A vector tug is a force on a ship, within the tug's envelope and with the tug's delay and lag.
//!
//! A [`VectorTug`] is the part of a tug that does not change in a run, checked once. A [`TugState`] is the changing
//! part of a vector tug: plain data. [`VectorTug::order`] gives a tug an order, and [`VectorTug::step`] computes the
//! tug's force. A tug that pushes with a bow fender, or that moves on her line, is a vessel with her own body instead.
//!
//! ```
//! use fenderline_contact::vec2;
//! use fenderline_ship::step_time::StepTime;
//! use fenderline_ship::tug::*;
//! let tug = VectorTug {
//!     name: "after tug".into(),
//!     envelope: TugEnvelope {
//!         bollard_pull_n: 588e3,
//!         length_m: 32.0,
//!         beam_m: 13.0,
//!         draught_m: 4.5,
//!         drag_coefficient: 0.73,
//!     },
//!     push_at_m: vec2(-100.0, -23.0),
//!     pull_at_m: vec2(-145.0, 0.0),
//!     delay_s: 10.0,
//!     force_lag_s: 10.0,
//!     direction_lag_s: 20.0,
//! };
//! tug.check()?;
//! let mut state = TugState::default();
//! // To starboard, with half of her bollard pull.
//! let push = TugOrder::Push { force_n: 294e3, direction_rad: std::f64::consts::FRAC_PI_2 };
//! tug.order(&mut state, 0.0, push)?;
//! // Each step: the ship's velocity through the water in her own axes; the force on her.
//! let force = tug.step(&mut state, StepTime { t_s: 10.0, step_s: 0.1 }, vec2(1.0, 0.0), 1025.0);
//! assert!(force.began && force.force[1] > 0.0);
//! # Ok::<(), fenderline_ship::range::OutOfRange>(())
//! ```

mod envelope;
mod state;

pub use envelope::TugEnvelope;
pub use state::{TugForce, TugOrder, TugState, VectorTug};
