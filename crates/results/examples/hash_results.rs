//! Runs scenarios and prints a hash of each one's results: every bit of every number in every table. Equal hashes on
//! two systems show that their results are equal. `cargo xtask same-bits-everywhere` runs this example on five systems.
//!
//! Each argument is a scenario file, with keys to replace after semicolons:
//! `hash_results "scenarios/oblique_hit.toml;time.duration=5 s"`.

use std::error::Error;
use std::path::Path;

use fenderline_contact::hash::Fnv1a;
use fenderline_results::{InMemory, KeptValues, Tables};
use fenderline_scenario::{Override, Scenario};
use fenderline_sim::Simulation;

fn main() -> Result<(), Box<dyn Error>> {
    for case in std::env::args().skip(1) {
        let mut parts = case.split(';');
        let file = parts.next().expect("`split` gives a part");
        let changes = parts.map(Override::parse).collect::<Result<Vec<_>, _>>()?;
        let Scenario { setup, output, .. } = Scenario::load(Path::new(file), &changes)?;
        let mut simulation = Simulation::new(setup)?;
        let energy = simulation.energy();
        let mut tables = Tables::start(&InMemory, simulation.setup(), energy, &output)?;
        while !simulation.is_done() {
            tables.write(&simulation.step()?)?;
        }
        let (mut hash, mut numbers) = (Fnv1a::default(), 0_usize);
        for column in tables.finish()?.iter().flat_map(|table| &table.columns) {
            match &column.values {
                KeptValues::Floats(values) => {
                    numbers += values.len();
                    values.iter().for_each(|value| hash.word(value.to_bits()));
                }
                KeptValues::Texts { codes, words } => {
                    codes.iter().for_each(|code| hash.bytes(words[*code as usize].as_bytes()));
                }
                KeptValues::Flags(values) => {
                    values.iter().for_each(|value| hash.bytes(&[u8::from(*value)]));
                }
                KeptValues::Counts(values) => {
                    values.iter().for_each(|value| hash.word(u64::from(*value)));
                }
            }
        }
        println!("{:016x} {numbers} {case}", hash.finish());
    }
    Ok(())
}
