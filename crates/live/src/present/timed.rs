//! Writes loads, passing ships and events, which all have times, into the scenario file. The times in the scenario file
//! count from the present.

use fenderline_author::Edit;
use fenderline_contact::number::greater;
use fenderline_sim::order::Word;
use fenderline_sim::{Change, Fault, Setup, Simulation};

use super::written::{degrees, quoted, rounded};

/// Writes loads and passing ships into the file, with times from now on.
pub(super) fn edit(simulation: &Simulation, edits: &mut Vec<Edit>) {
    let (setup, t_s) = (simulation.setup(), simulation.time_s());
    // Begins with the last load, because removing a load changes the numbers of those behind it.
    for (index, load) in setup.loads.iter().enumerate().rev() {
        let index = index.to_string();
        if load.until_s <= t_s {
            edits.push(Edit::remove(&["load", &index]));
            continue;
        }
        let from_s = rounded(greater(load.from_s - t_s, 0.0), 3).to_string();
        edits.push(Edit::set(&["load", &index, "from"], from_s));
        if load.until_s.is_finite() {
            let until_s = rounded(load.until_s - t_s, 3).to_string();
            edits.push(Edit::set(&["load", &index, "until"], until_s));
        }
    }
    for ship in &setup.world.flow.passing {
        let of = |key| ["passing", ship.name.as_str(), key];
        let pace = &ship.track.pace;
        edits.push(Edit::set(&of("time"), rounded(pace.at_first_s() - t_s, 3).to_string()));
        if pace.speeds().len() > 1 {
            let row = |(at_s, speed_mps)| format!("[{}, {}]", rounded(at_s - t_s, 3), speed_mps);
            let rows: Vec<String> = pace.speeds().map(row).collect();
            edits.push(Edit::set(&of("speeds"), format!("[{}]", rows.join(", "))));
        }
    }
}

/// The events of a scenario file that begins now: the faults that are on, and the events that wait, each with its time
/// from now (s).
pub(super) fn events(simulation: &Simulation, waiting: Vec<(f64, Change)>) -> Vec<String> {
    let mut all: Vec<(f64, Change)> = Vec::new();
    for (vessel, state) in simulation.vessels().iter().enumerate() {
        let faults = state.faults;
        let on = Fault::ALL.iter().copied().filter(|fault| faults.has(*fault));
        all.extend(on.map(|fault| (0.0, Change::Fault { vessel, fault, on: true })));
        let units = simulation.setup().world.vessels[vessel].unit_names().count();
        let tripped = (0..units).filter(|unit| faults.tripped.has(*unit));
        all.extend(tripped.map(|unit| (0.0, Change::Thruster { vessel, unit, on: true })));
    }
    for (line, state) in simulation.lines().iter().enumerate() {
        // The first step makes the line fast; it parts in the next step.
        let after_s = simulation.setup().step_s;
        all.extend(state.has_parted().then_some((after_s, Change::PartLine(line))));
    }
    for (tug, state) in simulation.tugs().iter().enumerate() {
        all.extend(state.out.then_some((0.0, Change::TugOut { tug, on: true })));
    }
    all.extend(simulation.changes_to_come());
    all.extend(waiting);
    all.iter().map(|(at_s, change)| table(*at_s, change, simulation.setup())).collect()
}

/// Formats an event as an inline table.
fn table(at_s: f64, change: &Change, setup: &Setup) -> String {
    let vessel = |index: usize| quoted(&setup.bodies[setup.world.vessels[index].body].name);
    let ends = |on: bool| if on { "" } else { ", ends = true" };
    let what = match *change {
        Change::Wind { speed_mps, from_rad, over_s } => format!(
            "wind = {{ speed = {}, from = {}, over = {} }}",
            rounded(speed_mps, 6),
            degrees(from_rad),
            rounded(over_s, 3)
        ),
        Change::Current { speed_mps, to_rad, over_s, .. } => format!(
            "current = {{ speed = {}, towards = {}, over = {} }}",
            rounded(speed_mps, 6),
            degrees(to_rad),
            rounded(over_s, 3)
        ),
        Change::Visibility { distance_m, over_s } => {
            let distance =
                distance_m.map_or(String::new(), |m| format!("distance = {}, ", rounded(m, 2)));
            format!("visibility = {{ {distance}over = {} }}", rounded(over_s, 3))
        }
        Change::Fault { vessel: index, fault, on } => {
            format!("vessel = {}, fault = \"{}\"{}", vessel(index), fault.word(), ends(on))
        }
        Change::Thruster { vessel: index, unit, on } => {
            let name = setup.world.vessels[index].unit_names().nth(unit).unwrap_or_default();
            format!("vessel = {}, thruster_out = {}{}", vessel(index), quoted(name), ends(on))
        }
        Change::PartLine(line) => {
            format!("line_parts = {}", quoted(&setup.world.lines[line].line.name))
        }
        Change::TugOut { tug, on } => {
            format!("tug_out = {}{}", quoted(&setup.world.tugs[tug].tug.name), ends(on))
        }
    };
    format!("{{ at = {}, {what} }}", rounded(greater(at_s, 0.0), 3))
}
