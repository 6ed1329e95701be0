//! Prints NMEA and AIS sentences of every kind, each after a line of JSON with the values that the sentence holds.
//! `check.py` compares the two.

use fenderline_nautical::{
    GeoPoint, Instruments, Moment, PositionReport, Shaft, ShipData, ais_position, ais_ship_data,
    instruments,
};

fn main() {
    for (number, (latitude_deg, longitude_deg)) in
        [(35.3, 139.7), (-33.86, -70.25), (0.0, 0.0), (59.999_999_9, -179.999_999)]
            .into_iter()
            .enumerate()
    {
        let turn = number as f64;
        let place = GeoPoint { latitude_deg, longitude_deg };
        let (heading_rad, ground_mps) = (6.2 - turn, [2.0 - turn, 0.3]);
        let course_rad = heading_rad + libm::atan2(ground_mps[1], ground_mps[0]);
        let of = Instruments {
            at: Moment { year: 2026, month: 11, day: 21, seconds: 3661.5 + turn },
            place,
            heading_rad,
            course_rad,
            turn_radps: 0.002 * (turn - 1.5),
            ground_mps,
            water_mps: [1.8 - turn, 0.2],
            stern_mps: [-0.4, -0.3],
            wind_over_deck: (1.0 + turn, 12.5),
            true_wind: (1.2 + turn, 10.0),
            depth_m: Some((15.0, 9.0)),
            rudder_rad: Some(-0.35 + 0.2 * turn),
            shafts: vec![Shaft { number: 0, rps: 0.8 - turn }],
        };
        println!(
            "{{\"lat\":{latitude_deg},\"lon\":{longitude_deg},\"heading\":{},\"turn\":{},\"ahead\":{},\"across\":{},\
             \"water\":{},\"wind\":{},\"true_wind\":{},\"rudder\":{},\"rpm\":{}}}",
            of.heading_rad.to_degrees(),
            of.turn_radps.to_degrees() * 60.0,
            of.ground_mps[0],
            of.ground_mps[1],
            of.water_mps[0],
            of.wind_over_deck.0.to_degrees(),
            of.true_wind.0.to_degrees(),
            of.rudder_rad.unwrap_or(0.0).to_degrees(),
            of.shafts[0].rps * 60.0,
        );
        instruments(&of).iter().for_each(|text| print!("{text}"));
        let report = PositionReport {
            mmsi: 999_000_001 + number as u32,
            status: 0,
            turn_radps: of.turn_radps,
            speed_mps: libm::hypot(of.ground_mps[0], of.ground_mps[1]),
            place,
            course_rad,
            heading_rad: of.heading_rad,
            second: 7,
            radio: 0,
        };
        let data = ShipData {
            mmsi: report.mmsi,
            imo: 0,
            call_sign: "FENDER".into(),
            name: "Container ship, 298 m".into(),
            kind: 70,
            extent_m: [150.0, 148.0, 23.0, 23.0],
            device: 1,
            arrival: (0, 0, 24, 60),
            draught_m: 9.0,
            destination: "BERTH".into(),
        };
        let own = number == 0;
        ais_position(&report, own).iter().for_each(|text| print!("{text}"));
        ais_ship_data(&data, own, number as u8).iter().for_each(|text| print!("{text}"));
    }
}
