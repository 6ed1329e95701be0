//! The example logs of many layouts, and the table and page that they give.

use fenderline_measured::{
    Berthings, Flag, LogKind, Mapping, Page, berthings, page, read_log, table,
};
use fenderline_nautical::{ChartOrigin, GeoPoint};

use crate::support::berth_for;

macro_rules! example {
    ($log:literal, $mapping:literal) => {
        found(
            include_str!(concat!("../../../examples/measured/", $log)),
            include_str!(concat!("../../../examples/measured/", $mapping)),
        )
    };
}

fn found(log: &str, mapping: &str) -> Berthings {
    let mapping = Mapping::parse(mapping, "mapping.toml").expect("a mapping");
    let at = GeoPoint { latitude_deg: 51.95, longitude_deg: 4.05 };
    let origin = ChartOrigin::new(at).expect("a place");
    let read = read_log(log, "log", &mapping, Some(&origin));
    berthings(vec![read], &mapping, &berth_for).expect("the berth is good")
}

/// Touch speeds by `make_logs.py` (cm/s), and the largest difference.
fn has_speeds(found: &Berthings, wanted_cmps: &[f64], within_cmps: f64) {
    let speeds: Vec<f64> = found.all.iter().map(|own| 100.0 * own.touch.centre_mps.value).collect();
    assert_eq!(speeds.len(), wanted_cmps.len(), "{speeds:?}, {:?}", found.remarks);
    for (own, wanted) in speeds.iter().zip(wanted_cmps) {
        assert!((own - wanted).abs() < within_cmps, "{speeds:?}");
    }
}

#[test]
fn three_docking_logs_of_different_layouts_are_read() {
    let laser = example!("laser.csv", "laser.toml");
    has_speeds(&laser, &[8.5, 12.0, 6.2, 15.2, 10.4], 1.0);
    assert!(laser.all.iter().all(|own| own.kind == LogKind::Docking && own.run.is_ok()));
    // The second ship is lighter by her mapping.
    assert!(laser.berths[1].displacement_t() < 0.75 * laser.berths[0].displacement_t());
    let (heads, rows) = table(&laser);
    let place = heads.iter().position(|head| head.name == "Tide (m)").expect("kept");
    assert_eq!(rows[1].cells[place].number(), Some(1.4));
    assert!(rows.iter().all(|row| row.cells.len() == heads.len()));
    let feet = example!("feet.csv", "feet.toml");
    has_speeds(&feet, &[11.0, 7.0, 9.5], 1.0);
    assert!(feet.remarks.iter().any(|remark| remark.text.contains("out of order")));
    let portable = example!("portable.tsv", "portable.toml");
    has_speeds(&portable, &[7.5, 13.5], 1.0);
    assert!(!portable.all[0].flags.contains(&Flag::PlaceAssumed));
    let of = Page { title: "a <berth>", logs: &["laser.csv".to_owned()], notices: &[] };
    let page = page(&of, &laser);
    for words in ["a &lt;berth&gt;", "<svg", "Most used fender", "first touch", "place assumed"] {
        assert!(page.contains(words), "{words}");
    }
    assert!(!page.contains("NaN") && !page.contains("inf"));
}

#[test]
fn an_nmea_and_an_ais_log_are_read() {
    let nmea = example!("pilot_unit.nmea", "pilot_unit.toml");
    has_speeds(&nmea, &[11.0], 1.0);
    assert!(
        nmea.remarks.iter().any(|remark| remark.text.contains("check sum")),
        "{:?}",
        nmea.remarks
    );
    let ais = example!("ais.nmea", "ais.toml");
    assert_eq!(ais.all.len(), 1, "{:?}", ais.remarks);
    let own = &ais.all[0];
    // AIS alone is coarse: the stated deviation covers the truth, and is wide.
    assert!((own.touch.centre_mps.value - 0.13).abs() < 3.0 * own.touch.centre_mps.sd, "{own:?}");
    assert!(own.touch.speed_mps.sd > 0.002);
    assert_eq!(own.mmsi, Some(244_000_123));
    for flag in [Flag::Coarse, Flag::ZeroedAtRest] {
        assert!(own.flags.contains(&flag), "{:?}", own.flags);
    }
    assert!(
        ais.remarks.iter().any(|remark| remark.text.contains("MADE UP TUG")),
        "{:?}",
        ais.remarks
    );
}
