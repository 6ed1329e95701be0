//! `fenderline manoeuvre`: standard manoeuvres of a vessel of the data, with the measures of ITTC and IMO.
//!
//! `catalogue` has the manoeuvres, `conditions` what the user ordered, `depth` water that is not deep, `trials` carries them
//! through, `imo` knows what
//! MSC.137(76) asks, `section` is what comes out; `printed`, `json` and `track` show it.

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

use crate::cli::ManoeuvreArgs;
use crate::failure::Failure;
use crate::terminal::{say, say_json};
use crate::vessels::{found, library};

use catalogue::Manoeuvre;
use conditions::{Conditions, Sea};
use section::Section;

/// Carries out the manoeuvres that `args` asks for and prints their measures.
///
/// # Errors
/// A vessel that is not known, a manoeuvre or an option that she cannot have, a manoeuvre that does not end, files that cannot be
/// written.
pub(crate) fn manoeuvre(args: &ManoeuvreArgs) -> Result<(), Failure> {
    let library = library(&args.file)?;
    let vessel = found(&library, &args.vessel)?.trial();
    let sea = Sea::of(&vessel);
    let chosen = catalogue::chosen(args.manoeuvre, &vessel, args.speed.is_some())?;
    let conditions = Conditions::checked(args, &vessel, &chosen)?;
    let sections = sections(&vessel, &chosen, &sea, &conditions)?;
    // The tracks first: what is printed is then the last thing that can fail.
    let written = args.out.as_deref().map(|folder| write(folder, &sections)).transpose()?;
    if args.json {
        say_json(&json::text(&args.vessel, &vessel, &sea, &conditions, &sections))?;
    } else {
        say(&printed::text(args.manoeuvre, &chosen, &vessel, &sea, &conditions, &sections))?;
    }
    match (written, args.out.as_deref(), args.json) {
        (Some(names), Some(folder), false) => {
            say(&format!("\nin {}: {}\n", folder.display(), names.join(", ")))
        }
        _ => Ok(()),
    }
}

/// Every manoeuvre, in shallow water beside deep water where the user asks about it.
fn sections(
    vessel: &Vessel,
    chosen: &[Manoeuvre],
    sea: &Sea,
    conditions: &Conditions,
) -> Result<Vec<Section>, Failure> {
    let deep = Model3::new(vessel.ship, sea.water);
    let carried_out = |vessel: &Vessel, model: &Model3, conditions: &Conditions| {
        let mut sections = Vec::new();
        for manoeuvre in chosen {
            sections.extend(trials::carry_out(*manoeuvre, vessel, model, sea, conditions)?);
        }
        Ok::<_, Failure>(sections)
    };
    let Some(shallow) = &conditions.shallow else {
        return carried_out(vessel, &deep, conditions);
    };
    // She is pushed as hard in either water.
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
