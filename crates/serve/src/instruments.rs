//! Makes the sentences of the ships' instruments for chart programs.

use fenderline_contact::{BodyState, Rotation, Vec2, vec2};
use fenderline_live::{Session, Shown};
use fenderline_nautical::{
    ChartOrigin, GeoPoint, Instruments, Moment, PositionReport, Shaft, ShipData, ais_position,
    ais_ship_data, instruments,
};
use fenderline_sim::VesselSetup;

/// Maritime identity (MMSI) of the first ship. No country has the digits 999 (known from memory), so that no real ship
/// has these numbers.
const FIRST_MMSI: u32 = 999_000_001;
/// Number of rounds of sentences between two reports of ship data. Real ships send their ship data every six minutes.
const SHIP_DATA_EVERY: u64 = 10;
/// A ship with a line made fast reports that she is moored if her speed is below this (m/s). The speed below which a
/// ship reports that she is moored is our choice.
const MOORED_MPS: f64 = 0.2;

/// A vessel as her instruments report her. The antenna of the vessel is at midship.
struct Vessel<'s> {
    index: usize,
    of: &'s VesselSetup,
    state: &'s BodyState,
    /// Distance of the vessel's centre of gravity forward of midship (m).
    ahead_m: f64,
    /// True velocity of the vessel's midship over ground: ahead and to starboard (m/s).
    ground: Vec2,
    /// The values that the vessel's compass, log and satellite receiver show. They may be frozen.
    shown: Shown,
}

impl<'s> Vessel<'s> {
    fn of(session: &'s Session, index: usize) -> Vessel<'s> {
        let simulation = session.simulation();
        let of = &simulation.setup().world.vessels[index];
        let state = &simulation.states()[of.body];
        let ahead_m = of.ship.particulars.centre_of_gravity_m;
        let own = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps);
        let ground = vec2(own.x, own.y - ahead_m * state.yaw_rate_radps);
        Vessel { index, of, state, ahead_m, ground, shown: session.shown(index) }
    }

    fn place(&self, origin: &ChartOrigin) -> GeoPoint {
        let at = self.shown.midship_m;
        origin.place(at.x, at.y)
    }

    fn mmsi(&self) -> u32 {
        FIRST_MMSI + self.index as u32
    }

    /// The AIS report. The other data of AIS are what the instruments show. The crew sets the navigational status by
    /// hand from what they see.
    fn position_report(
        &self,
        session: &Session,
        origin: &ChartOrigin,
        at: &Moment,
    ) -> PositionReport {
        let simulation = session.simulation();
        let lines = simulation.setup().world.lines.iter().zip(simulation.lines());
        let is_fast = lines
            .filter(|(setup, _)| setup.ship == self.of.body)
            .any(|(_, line)| line.line.as_ref().is_some_and(|(_, state)| !state.parted));
        let Shown { heading_rad, turn_radps, speeds, .. } = self.shown;
        PositionReport {
            mmsi: self.mmsi(),
            status: match simulation.vessels()[self.index].aground {
                true => 6,
                false if is_fast && self.ground.length() < MOORED_MPS => 5,
                false => 0,
            },
            turn_radps,
            speed_mps: libm::hypot(speeds.ground_mps[0], speeds.ground_mps[1]),
            place: self.place(origin),
            course_rad: speeds.course_rad,
            heading_rad,
            second: (at.seconds % 60.0) as u8,
            radio: 0,
        }
    }

    fn ship_data(&self, session: &Session) -> ShipData {
        let body = &session.simulation().setup().bodies[self.of.body];
        let (least, most) = body.outline.bounds();
        ShipData {
            mmsi: self.mmsi(),
            imo: 0,
            call_sign: String::new(),
            name: body.name.replace('_', " "),
            kind: if session.cast().is_tug[self.index] { 52 } else { 70 },
            extent_m: [most.x + self.ahead_m, -least.x - self.ahead_m, -least.y, most.y],
            device: 1,
            arrival: (0, 0, 24, 60),
            draught_m: self.of.ship.particulars.draught_m,
            destination: String::new(),
        }
    }

    fn instruments(&self, session: &Session, origin: &ChartOrigin, at: Moment) -> Instruments {
        let simulation = session.simulation();
        let (t_s, environment) = (simulation.time_s(), &simulation.setup().world.environment);
        let vessel = &simulation.vessels()[self.index];
        let attitude = Rotation::from_angle(self.state.heading_rad);
        let air = environment.wind.as_ref().map_or(Vec2::ZERO, |wind| wind.velocity(10.0, t_s));
        let air = attitude.apply_inverse(air);
        let over_deck = air - self.ground;
        let Shown { heading_rad, turn_radps, speeds, .. } = self.shown;
        let ([water_mps, water_across_mps], ground_mps) = (speeds.water_mps, speeds.ground_mps);
        let swing_mps = speeds.stern_mps - ground_mps[1];
        let propelled = self.of.ship.propulsion.is_some();
        Instruments {
            at,
            place: self.place(origin),
            heading_rad,
            course_rad: speeds.course_rad,
            turn_radps,
            ground_mps,
            water_mps: [water_mps, water_across_mps],
            stern_mps: [water_across_mps + swing_mps, speeds.stern_mps],
            wind_over_deck: from_and_speed(over_deck),
            // The true wind is computed from the wind over deck and the shown speed, as instruments do.
            true_wind: from_and_speed(over_deck + vec2(ground_mps[0], ground_mps[1])),
            // The transducer is in the keel.
            depth_m: vessel.under_keel_m.map(|under_m| (under_m, 0.0)),
            rudder_rad: propelled.then_some(vessel.rudder.value),
            shafts: propelled
                .then_some(Shaft { number: 0, rps: vessel.shaft.value })
                .into_iter()
                .collect(),
        }
    }
}

/// Direction from which a wind comes, from the bow (rad), and its speed (m/s). `air` is the velocity of the air in the
/// ship's axes.
fn from_and_speed(air: Vec2) -> (f64, f64) {
    (libm::atan2(-air.y, -air.x), air.length())
}

/// Maritime identity (MMSI) of a passing ship. The MMSIs of passing ships follow those of the vessels.
fn mmsi_of_traffic(session: &Session, index: usize) -> u32 {
    FIRST_MMSI + (session.simulation().vessels().len() + index) as u32
}

/// The AIS position report of a ship that passes on a track of her own.
fn traffic_report(
    session: &Session,
    origin: &ChartOrigin,
    at: &Moment,
    index: usize,
) -> PositionReport {
    let simulation = session.simulation();
    let ship = &simulation.setup().world.flow.passing[index];
    let now = ship.track.at(simulation.time_s());
    let midship = now.pose.position_m;
    PositionReport {
        mmsi: mmsi_of_traffic(session, index),
        status: 0,
        turn_radps: now.yaw_rate_radps,
        speed_mps: now.speed_mps,
        place: origin.place(midship.x, midship.y),
        course_rad: now.heading_rad,
        heading_rad: now.heading_rad,
        second: (at.seconds % 60.0) as u8,
        radio: 0,
    }
}

/// The AIS name and size of a ship that passes on a track of her own.
fn traffic_data(session: &Session, index: usize) -> ShipData {
    let ship = &session.simulation().setup().world.flow.passing[index];
    let extent = |of: fn(&Vec2) -> f64, sign: f64| {
        let all = ship.outline_m.iter().map(of);
        all.map(|m| sign * m).fold(0.0, fenderline_contact::number::greater)
    };
    ShipData {
        mmsi: mmsi_of_traffic(session, index),
        imo: 0,
        call_sign: String::new(),
        name: ship.name.replace('_', " "),
        kind: 70,
        extent_m: [
            extent(|at| at.x, 1.0),
            extent(|at| at.x, -1.0),
            extent(|at| at.y, -1.0),
            extent(|at| at.y, 1.0),
        ],
        device: 1,
        arrival: (0, 0, 24, 60),
        draught_m: ship.hull.draught_m,
        destination: String::new(),
    }
}

/// One round of sentences: the own ship's instruments and her AIS, then the AIS of all other ships. `round` is the
/// number of the round, counted from the first.
pub(crate) fn sentences(
    session: &Session,
    origin: &ChartOrigin,
    at: Moment,
    round: u64,
) -> Vec<String> {
    let own = session.cast().own;
    let count = session.simulation().vessels().len();
    let mut all = Vec::new();
    for index in own.into_iter().chain((0..count).filter(|index| own != Some(*index))) {
        let vessel = Vessel::of(session, index);
        let is_own = own == Some(index);
        if is_own {
            all.extend(instruments(&vessel.instruments(session, origin, at)));
        }
        all.extend(ais_position(&vessel.position_report(session, origin, &at), is_own));
        if round.is_multiple_of(SHIP_DATA_EVERY) {
            let sequence = ((round / SHIP_DATA_EVERY + index as u64) % 10) as u8;
            all.extend(ais_ship_data(&vessel.ship_data(session), is_own, sequence));
        }
    }
    for index in 0..session.simulation().setup().world.flow.passing.len() {
        all.extend(ais_position(&traffic_report(session, origin, &at, index), false));
        if round.is_multiple_of(SHIP_DATA_EVERY) {
            let sequence = ((round / SHIP_DATA_EVERY + (count + index) as u64) % 10) as u8;
            all.extend(ais_ship_data(&traffic_data(session, index), false, sequence));
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use fenderline_live::{Action, Fault, NamedOrder, OtherAction, Source};
    use fenderline_sim::OrderName;

    use super::*;

    /// The bits of a position report of another ship, which fits into one sentence. ITU-R M.1371 writes them as
    /// characters of six bits.
    fn bits(sentence: &str) -> Option<Vec<bool>> {
        let payload = sentence.strip_prefix("!AIVDM,1,1,")?.split(',').nth(2)?;
        let six = payload.bytes().map(|byte| match byte - 48 {
            code @ 0..=40 => code,
            code => code - 8,
        });
        Some(six.flat_map(|code| (0..6).rev().map(move |bit| code >> bit & 1 == 1)).collect())
    }

    fn number(bits: &[bool]) -> i64 {
        bits.iter().fold(0, |number, bit| 2 * number + i64::from(*bit))
    }

    /// Reads bits as a number with a sign.
    fn signed(bits: &[bool]) -> i64 {
        number(bits) - if bits[0] { 1 << bits.len() } else { 0 }
    }

    fn origin() -> ChartOrigin {
        let at = GeoPoint { latitude_deg: 35.3, longitude_deg: 139.7 };
        ChartOrigin::new(at).expect("within the chart")
    }

    /// MMSI, speed (kn), latitude (°) and heading (°) of all position reports in a round.
    fn reports(session: &Session, round: u64) -> Vec<(i64, f64, f64, i64)> {
        let origin = origin();
        let all = sentences(session, &origin, Moment::from_unix(1.8e9), round);
        let all = all.iter().filter_map(|sentence| bits(sentence));
        all.filter(|bits| number(&bits[..6]) == 1)
            .map(|bits| {
                let speed_kn = 0.1 * number(&bits[50..60]) as f64;
                let latitude = signed(&bits[89..116]) as f64 / 600_000.0;
                (number(&bits[8..38]), speed_kn, latitude, number(&bits[128..137]))
            })
            .collect()
    }

    fn open(text: &str) -> Session {
        let none = |name: &str| Err(format!("{name}: none is needed"));
        let (source, _) = Source::collect("a.toml", text.to_owned(), vec![], none).expect("good");
        Session::open(source).expect("a set-up")
    }

    fn go(session: &mut Session, steps: usize) {
        for _ in 0..steps {
            session.step().expect("a step");
        }
    }

    /// The cells of the first sentence of a kind, without the check sum.
    fn cells(all: &[String], kind: &str) -> Vec<String> {
        let sentence = all.iter().find(|sentence| sentence.get(3..6) == Some(kind));
        let sentence = sentence.unwrap_or_else(|| panic!("no {kind}"));
        let body = sentence.split('*').next().unwrap_or_default();
        body.split(',').map(str::to_owned).collect()
    }

    #[test]
    fn frozen_instruments_send_what_they_show_and_the_others_the_truth() {
        let text = include_str!("../../../scenarios/live/berthing.toml");
        let mut session = open(text);
        let command = |session: &mut Session, action: Action| {
            session.command("test", 0, action).expect("it is accepted");
        };
        let fault = |fault, on| OtherAction::Fault { vessel: "ship".into(), fault, on }.into();
        let engine = NamedOrder::new(OrderName::Engine, "ship").number("share", 0.9);
        let rudder = NamedOrder::new(OrderName::Rudder, "ship").number("angle", 0.5);
        go(&mut session, 300);
        command(&mut session, engine.into());
        command(&mut session, rudder.into());
        go(&mut session, 300);
        let origin = origin();
        let round = |session: &Session| sentences(session, &origin, Moment::from_unix(1.8e9), 1);
        // The clock of a satellite receiver goes on. In this test it is the same in all rounds.
        for (of, kept, go_on) in [
            (Fault::HeadingFrozen, &["HDT", "ROT"][..], &["RMC", "VTG", "VBW"][..]),
            (Fault::SpeedFrozen, &["VTG", "VBW"], &["HDT", "ROT", "RMC"]),
            (Fault::PositionFrozen, &[], &["HDT", "ROT", "RMC", "VTG", "VBW"]),
        ] {
            let (before, place) = (round(&session), session.shown(0).midship_m);
            command(&mut session, fault(of, true));
            go(&mut session, 300);
            let now = round(&session);
            for kind in kept {
                let expected =
                    if *kind == "ROT" { "0.0".to_owned() } else { cells(&before, kind)[1].clone() };
                assert_eq!(cells(&now, kind)[1], expected, "{of:?}");
            }
            for kind in go_on {
                assert_ne!(cells(&now, kind), cells(&before, kind), "{of:?}: {kind}");
            }
            // Latitude and longitude; course and speed.
            let (rmc, rmc_before) = (cells(&now, "RMC"), cells(&before, "RMC"));
            assert_eq!(rmc[3..7] == rmc_before[3..7], of == Fault::PositionFrozen, "{of:?}");
            assert_eq!(rmc[7..9] == rmc_before[7..9], of == Fault::SpeedFrozen, "{of:?}");
            assert_eq!(session.shown(0).midship_m == place, of == Fault::PositionFrozen);
            // The anemometer is not frozen. The true wind is computed with a wrong speed where the log is frozen.
            assert_ne!(cells(&now, "MWV"), cells(&before, "MWV"), "{of:?}");
            // Other ships get the same values by AIS.
            let (report, truth) = (vessel_report(&session), true_report(&session));
            assert_eq!(report.heading_rad == truth.heading_rad, of != Fault::HeadingFrozen);
            assert_eq!(report.turn_radps == truth.turn_radps, of != Fault::HeadingFrozen);
            assert_eq!(report.speed_mps == truth.speed_mps, of != Fault::SpeedFrozen);
            assert_eq!(report.course_rad == truth.course_rad, of != Fault::SpeedFrozen);
            assert_eq!(report.place == truth.place, of != Fault::PositionFrozen);
            command(&mut session, fault(of, false));
            assert_eq!(vessel_report(&session), true_report(&session), "{of:?} is over");
        }
    }

    /// A ship that swings has no rotation about her centre of gravity in a frozen receiver: the reported position of
    /// her antenna does not move.
    #[test]
    fn the_ais_of_a_tug_with_a_frozen_receiver_stays_where_it_was_and_the_others_go_on() {
        let mut session = open(include_str!("../../../scenarios/live/berthing.toml"));
        go(&mut session, 100);
        let fault = OtherAction::Fault {
            vessel: "forward_tug".into(),
            fault: Fault::PositionFrozen,
            on: true,
        };
        session.command("test", 0, fault.into()).expect("it is accepted");
        let before = reports(&session, 1);
        go(&mut session, 300);
        let after = reports(&session, 1);
        let latitudes =
            |all: &[(i64, f64, f64, i64)]| -> Vec<f64> { all.iter().map(|of| of.2).collect() };
        let (before, after) = (latitudes(&before), latitudes(&after));
        assert_eq!(before.len(), 2, "both tugs; the own ship is in a sentence of her own kind");
        assert_eq!(before[0], after[0]);
        assert_ne!(before[1], after[1]);
    }

    /// The AIS report of the own ship.
    fn vessel_report(session: &Session) -> PositionReport {
        Vessel::of(session, 0).position_report(session, &origin(), &Moment::from_unix(1.8e9))
    }

    /// The AIS report that the own ship would send without a frozen instrument.
    fn true_report(session: &Session) -> PositionReport {
        let mut sound = session.clone();
        for fault in [Fault::HeadingFrozen, Fault::SpeedFrozen, Fault::PositionFrozen] {
            let action = OtherAction::Fault { vessel: "ship".into(), fault, on: false };
            sound.command("test", 0, action.into()).expect("it is accepted");
        }
        vessel_report(&sound)
    }

    #[test]
    fn traffic_is_in_the_ais_with_its_speed_place_and_heading() {
        let text = include_str!("../../../scenarios/live/two_pilots_in_a_fairway.toml");
        let mut session = open(text);
        let names: Vec<&str> =
            session.info().traffic.iter().map(|ship| ship.name.as_str()).collect();
        let place = names.iter().position(|name| *name == "container_ship").expect("she is there");
        let mmsi = i64::from(FIRST_MMSI) + 2 + place as i64;
        let of = |session: &Session| {
            let reports = reports(session, 1);
            // The coaster and both passing ships. The own ship's report is in a sentence of another kind.
            assert_eq!(reports.len(), 3, "{reports:?}");
            *reports.iter().find(|report| report.0 == mmsi).expect("she reports")
        };
        let (_, speed_kn, before, heading) = of(&session);
        assert!((speed_kn - 11.0).abs() < 0.06 && heading == 0, "{speed_kn} kn, {heading}°");
        for _ in 0..1200 {
            session.step().expect("a step");
        }
        let (_, _, after, _) = of(&session);
        // At 11 kn a ship sails 11/30 of a nautical mile in two minutes, and a nautical mile is a minute of latitude.
        // The tolerance covers the reports' resolution of 1/10000 of a minute and half a percent, because here a minute
        // is 1849 m and not 1852 m.
        let minutes = 60.0 * (after - before);
        assert!((minutes - 11.0 / 30.0).abs() < 0.002, "{minutes}");
        // The ships' names and sizes come every tenth round.
        let origin = origin();
        let data = |round| {
            let all = sentences(&session, &origin, Moment::from_unix(1.8e9), round);
            all.iter().filter(|text| text.starts_with("!AIVDM,2,1,")).count()
        };
        assert_eq!((data(1), data(10)), (0, 3));
    }
}
