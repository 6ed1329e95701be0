//! All tests of the crate in one program, so that cargo links only once. `cargo test -p fenderline-sim --test all
//! NAME::` runs the tests of one file.

mod anchor;
mod banks;
mod banks_by_place;
mod depth_by_place;
mod env_moored;
mod env_mooring;
mod env_tug;
mod env_water;
mod env_waves;
mod env_wind;
mod fenders;
mod hydro_continuity;
mod hydro_estimates;
mod hydro_formulas;
mod hydro_manoeuvres;
mod hydro_model3;
mod hydro_shallow;
mod identities;
mod paper_method_gains_energy;
mod passing_ships;
mod same_bits;
#[path = "support/ships.rs"]
mod ships;
mod support;
mod vessel_ledger;
mod world_vessel;
