//! Mooring lines: ropes, tails, winches, and cables in a catenary.
//!
//! A [`Line`] is the part of a mooring line that does not change in a run, checked once. A [`LineState`] is the
//! changing part of a mooring line: plain data that can be copied, compared and replayed. [`Line::step`] takes the
//! positions of a line's two ends and returns the forces on them. Mooring lines are quasi-static: they have no inertia,
//! drag or bending stiffness. A rope has the same load curve for loading and unloading, so that only the winch
//! dissipates energy.
//!
//! By OCIMF's guideline MEG4 the design break force of a line is 100 to 105 % of the ship design minimum breaking load
//! (MBL), that of a tail 125 to 130 % (found in public summaries; the guideline was not read). By MEG4, the working
//! load of a line is 55 % (wire) or 50 % (synthetic) of its break load. By MEG4, winch brakes are set to render at 60 %
//! of the ship design MBL.
//!
//! ```
//! use fenderline_ship::mooring::*;
//! // Once: HMPE with a nylon tail on a winch, tensioned to 10 t.
//! let main = Rope { break_load_n: 1e6, curve: RopeCurve::hmpe() };
//! let nylon = Rope { break_load_n: 1.25e6, curve: RopeCurve::nylon() };
//! let setup = LineSetup {
//!     name: "fore spring".into(),
//!     kind: LineKind::Light {
//!         main,
//!         tail: Some(Tail { rope: nylon, length_m: 11.0 }),
//!         details: LineDetails::default(),
//!     },
//!     inboard_end: InboardEnd::Winch(Winch::of_design(1e6, 150.0)),
//!     initial_length: InitialLength::FromPretension(100e3),
//! };
//! let ends = LineEnds { ship_m: [120.0, 20.0, 8.0], shore_m: [70.0, 25.0, 3.0] };
//! let (line, mut state) = Line::new(setup, &ends)?;
//! // In each step: the ends and the winch order give the force on the ship at her fairlead.
//! let load = line.step(&mut state, &ends, WinchOrder::Hold, 0.1);
//! assert!((load.tension_n - 100e3).abs() < 1e-3);
//! assert!(load.on_ship_n[0] < 0.0);
//! # Ok::<(), MooringError>(())
//! ```

mod catenary;
mod ends;
mod error;
mod line;
mod rope;
mod sag;
mod setup;
mod solve;
mod winch;

pub use catenary::{Cable, Catenary, catenary};
pub use ends::LineEnds;
pub use error::{MooringError, RopeError};
pub use line::{Line, LineLoad, LineState};
pub use rope::{Rope, RopeCurve};
pub use setup::{InboardEnd, InitialLength, LineDetails, LineKind, LineSetup, OnDeck, Tail};
pub use winch::{ConstantTension, Winch, WinchOrder, WinchReport};
