//! Columns and summary quantities of a way along a passage plan agree with each other.

use fenderline_contact::number::{greater, lesser};
use fenderline_results::{InMemory, KeptValues, Tables, WorldTotals};
use fenderline_scenario::{Override, Scenario};
use fenderline_sim::Simulation;

#[test]
fn the_summary_has_the_extremes_of_the_columns() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/harbours/bend.toml");
    let set = ["time.duration=60 s", "output.interval=0", "output.tables=[\"vessels\"]"];
    let set: Vec<Override> = set.iter().map(|set| Override::parse(set).unwrap()).collect();
    let Scenario { setup, output, .. } = Scenario::load(file.as_ref(), &set).unwrap();
    let mut simulation = Simulation::new(setup).unwrap();
    let energy = simulation.energy();
    let mut tables = Tables::start(&InMemory, simulation.setup(), energy, &output).unwrap();
    let mut totals = WorldTotals::new(simulation.setup());
    while !simulation.is_done() {
        let step = simulation.step().unwrap();
        tables.write(&step).unwrap();
        totals.add(&step);
    }
    let tables = tables.finish().unwrap();
    let vessels = tables.iter().find(|table| table.name == "vessels").unwrap();
    let column = |name: &str| {
        let column = vessels.columns.iter().find(|column| column.name == name).unwrap();
        let KeptValues::Floats(values) = &column.values else { panic!("{name}") };
        assert_eq!(values.len(), 120);
        values.clone()
    };
    let (fore_m, aft_m) = (column("under_keel_fore_m"), column("under_keel_aft_m"));
    let least_m = fore_m.iter().chain(&aft_m).copied().fold(f64::INFINITY, lesser);
    let [ship] = totals.vessels.as_slice() else { panic!("one vessel") };
    // Channel of 13 m, tide of 0.8 m, draught of 10.5 m, and squat.
    assert!(least_m > 2.0 && least_m < 3.3, "{least_m}");
    assert_eq!(ship.under_keel_m.unwrap().value, least_m);
    let off_m = column("cross_track_m").into_iter().map(f64::abs).fold(0.0, greater);
    assert!(off_m > 0.0);
    assert_eq!(ship.cross_track_m.unwrap().value.abs(), off_m);
}
