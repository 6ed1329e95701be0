//! `fenderline manoeuvre`: runs standard manoeuvres of a vessel, and prints the quantities that ITTC and IMO define.
//!
//! Module `catalogue` has the manoeuvres, `conditions` the user's options, `depth` shallow water, and `imo` the limits
//! of MSC.137(76). Module `trials` carries the manoeuvres out; `section` holds the measured results; `printed`, `json`
//! and `track` write these results.

mod catalogue;
mod conditions;
mod crabbing;
mod depth;
mod imo;
mod json;
mod printed;
mod section;
mod track;
mod trials;

use std::path::Path;

use fenderline_sim::hydro::Model3;
use fenderline_sim::hydro::vessels::Vessel;

use crate::cli::{Manoeuvre, ManoeuvreArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{answer, say, say_json};
use crate::vessels::{found, library};

use conditions::{Conditions, Sea};
use section::Section;

/// Carries out the manoeuvres that `args` asks for and prints the measured results.
///
/// # Errors
/// Fails if the vessel is unknown, if a manoeuvre or an option does not apply to her, if a manoeuvre does not end, or
/// if a file cannot be written.
pub(crate) fn manoeuvre(args: &ManoeuvreArgs) -> Result<(), Failure> {
    let library = library(&args.file)?;
    let vessel = found(&library, &args.vessel)?.trial();
    let sea = Sea::of(&vessel);
    let chosen = catalogue::chosen(args.manoeuvre, &vessel, args.speed.is_some())?;
    let conditions = Conditions::checked(args, &vessel, &chosen)?;
    let sections = sections(&vessel, &chosen, &sea, &conditions)?;
    // The tracks first, so that printing is the last thing that can fail.
    let written = args.out.as_deref().map(|folder| write(folder, &sections)).transpose()?;
    if args.json {
        say_json(&json::text(&args.vessel, &vessel, &sea, &conditions, &sections))?;
    } else {
        answer(&printed::text(args.manoeuvre, &chosen, &vessel, &sea, &conditions, &sections))?;
    }
    match (written, args.out.as_deref(), args.json) {
        (Some(names), Some(folder), false) => {
            say(&format!("\nin {}: {}\n", folder.display(), names.join(", ")))
        }
        _ => Ok(()),
    }
}

/// Carries out all chosen manoeuvres in deep water, and in shallow water too if the user asks for it.
fn sections(
    vessel: &Vessel,
    chosen: &[Manoeuvre],
    sea: &Sea,
    conditions: &Conditions,
) -> Result<Vec<Section>, Failure> {
    let deep = Model3::new(vessel.ship, sea.water);
    let waters = 1 + usize::from(conditions.shallow.is_some());
    let mut progress = Progress::of((waters * chosen.len()) as u64, "manoeuvres");
    let mut done = 0;
    let mut carried_out = |vessel: &Vessel, model: &Model3, conditions: &Conditions| {
        let mut sections = Vec::new();
        for manoeuvre in chosen {
            sections.extend(trials::carry_out(*manoeuvre, vessel, model, sea, conditions)?);
            done += 1;
            progress.advance(done);
        }
        Ok::<_, Failure>(sections)
    };
    let Some(shallow) = &conditions.shallow else {
        return carried_out(vessel, &deep, conditions);
    };
    // The push is the same in both.
    let push_n = conditions.push_n.unwrap_or_else(|| crabbing::usual_push_n(&deep));
    let conditions = Conditions { push_n: Some(push_n), ..*conditions };
    let there = shallow.vessel(vessel);
    let model = Model3::new(there.ship, sea.water);
    let both = carried_out(&there, &model, &conditions)?.into_iter().zip(carried_out(
        vessel,
        &deep,
        &conditions,
    )?);
    Ok(both.map(|(there, deep)| depth::beside(there, deep)).collect())
}

fn write(folder: &Path, sections: &[Section]) -> Result<Vec<String>, Failure> {
    let tracks: Vec<_> = sections.iter().flat_map(|section| &section.tracks).collect();
    if tracks.is_empty() {
        return Err(Failure::input("error: --out: none of these manoeuvres has a track"));
    }
    track::write(folder, &tracks)
}
