//! Writes lines into the scenario file: on board, fast with their present tension, or made fast later.

use fenderline_author::Edit;
use fenderline_sim::{LineEnd, Mooring, MooringSetup, Simulation};

use super::written::{place, quoted, rounded};

/// Least tension that the scenario file gives as a line's tension (N). For a line with less tension, the scenario file
/// gives the line's length.
const TAUT_N: f64 = 1.0;

/// Writes every line into the scenario file as it is now. A parted line is fast with the least tension at the start of
/// the file, and parts at once.
pub(super) fn edit(simulation: &Simulation, edits: &mut Vec<Edit>, notes: &mut Vec<String>) {
    let world = &simulation.setup().world;
    for (line, setup) in simulation.lines().iter().zip(&world.lines) {
        let of = |key| ["line", setup.line.name.as_str(), key];
        match (&line.line, line.end(setup, &world.bollards)) {
            (Some((_, state)), Some(end)) if line.sent.is_none() => {
                far_end(simulation, setup, end, edits);
                edits.push(Edit::remove(&of("made_fast")));
                let tension_n = line.load.tension_n;
                if state.parted || tension_n >= TAUT_N {
                    let tension_n = if state.parted { TAUT_N } else { tension_n };
                    edits.push(Edit::remove(&of("length")));
                    edits.push(Edit::set(&of("pretension"), rounded(tension_n, 1).to_string()));
                } else {
                    edits.push(Edit::remove(&of("pretension")));
                    let length_m = state.length_m;
                    edits.push(Edit::set(&of("length"), rounded(length_m, 4).to_string()));
                }
            }
            (None, Some(_)) if is_made_fast_later(line, simulation.time_s(), setup) => {
                let in_s = rounded(setup.from_s - simulation.time_s(), 3);
                edits.push(Edit::set(&of("made_fast"), in_s.to_string()));
            }
            // The line is fast from the start, and no step was taken.
            (None, Some(_)) if line.sent.is_none() => {}
            _ => {
                if line.sent.is_some() {
                    notes.push(format!(
                        "The line {} was on its way to a bollard: in the file it is sent anew.",
                        setup.line.name
                    ));
                }
                let keys = [
                    "to",
                    "bollard",
                    "bollard_height",
                    "bitts",
                    "length",
                    "pretension",
                    "made_fast",
                ];
                edits.extend(keys.map(|key| Edit::remove(&of(key))));
            }
        }
    }
}

fn is_made_fast_later(line: &Mooring, t_s: f64, setup: &MooringSetup) -> bool {
    line.sent.is_none() && setup.from_s > t_s
}

/// Sets the keys of the end of a line that is not on the ship.
fn far_end(simulation: &Simulation, setup: &MooringSetup, end: LineEnd, edits: &mut Vec<Edit>) {
    let LineEnd::OnBody { body, at_m, above_water_m } = end else {
        // A scenario cannot describe a line to a fixed place on the earth.
        return;
    };
    let of = |key| ["line", setup.line.name.as_str(), key];
    edits.push(Edit::set(&of("to"), quoted(&simulation.setup().bodies[body].name)));
    edits.push(Edit::remove(&of("bitts")));
    edits.push(Edit::set(&of("bollard"), place(at_m)));
    edits.push(Edit::set(&of("bollard_height"), rounded(above_water_m, 4).to_string()));
}
