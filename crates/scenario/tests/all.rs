//! All tests of the crate, as one program: cargo links it once. `cargo test -p fenderline-scenario --test all NAME::` runs those of one
//! file.

#![recursion_limit = "256"]

mod adrift;
mod air_draught;
mod all_but_stopped;
mod anchors;
mod any_text;
mod approach;
mod bad_fenders;
mod bad_hydrodynamics;
mod bad_input;
mod banks;
mod berthing;
mod bottom;
mod bounded_file;
mod chart;
mod chart_of_s57;
mod chart_projection;
mod coefficients;
#[path = "support/data_with_mistakes.rs"]
mod data_with_mistakes;
mod environment;
mod exercise;
mod exercise_at_anchor;
mod fenders;
mod flexible_dolphins;
mod friction_holds_surge;
mod friction_in_long_waves;
mod good_input;
mod growth;
mod hull_by_height;
mod hydrodynamic_data;
mod independent_coupled_method;
mod independent_paper_method;
mod limits;
mod long_passage;
mod long_waves;
#[path = "support/long_passage.rs"]
mod made_up_passage;
mod moored_in_waves;
mod mooring_operations;
mod new_exercise;
mod order_of_tables;
mod order_under_way;
mod overrides;
mod panels;
mod passing;
mod plan;
mod plausible;
mod points_of_attack;
mod quay_line;
mod rows;
mod schema;
mod seakeeping;
mod shores;
mod tanker_in_a_current;
mod tide;
mod tugs;
mod unloading;
mod vessels;
mod waves_between;
mod without_effect;
mod worlds;
