//! Writes the table of a made-up campaign and its report: `cargo run -p fenderline-campaign --example campaign_page -- DIR [RUNS]`.

#[path = "../tests/support/mod.rs"]
mod support;

use std::path::PathBuf;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().unwrap_or_else(|| "out/campaign_page".to_owned()));
    let runs = arguments.next().map_or(Ok(5000), |runs| runs.parse())?;
    std::fs::create_dir_all(&folder)?;
    let path = folder.join("runs.csv");
    std::fs::write(&path, support::table(runs))?;
    std::fs::write(folder.join("report.html"), support::report(&path)?)?;
    println!("in {}: runs.csv, report.html", folder.display());
    Ok(())
}
