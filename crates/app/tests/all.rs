//! All tests of the crate, as one program: cargo links it once. `cargo test -p fenderline --test all NAME::` runs those of one
//! file.

mod approach;
mod attack;
mod attack_files;
mod attack_providers;
mod attack_server;
mod berthings;
mod campaign;
mod campaign_check;
#[path = "serve/client.rs"]
mod client;
mod command_line;
#[path = "../../live/tests/support/damage.rs"]
mod damage;
mod documents;
mod downtime;
mod fender_fit;
mod fenders;
mod fmu;
mod interrupted;
mod limit;
mod live_load;
mod manoeuvre;
mod moored_report;
mod odd_files;
mod odd_texts;
mod one_folder;
mod parquet_tables;
mod program;
mod provider;
mod recordings;
mod serve;
mod serve_limits;
#[path = "serve/server.rs"]
mod server;
mod session_report;
mod statistics;
mod support;
mod validate;
mod verdict;
mod vessels;
mod whole_library;
