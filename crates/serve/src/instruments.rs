//! The sentences of the ships' instruments for chart programs.

use fenderline_contact::{BodyState, Rotation, Vec2, vec2};
use fenderline_live::Session;
use fenderline_nautical::{
    ChartOrigin, GeoPoint, Instruments, Moment, PositionReport, Shaft, ShipData, ais_position,
    ais_ship_data, instruments,
};
use fenderline_sim::VesselSetup;

/// MMSI of the first ship. No country has 999 (recalled), so that no real ship has these numbers.
const FIRST_MMSI: u32 = 999_000_001;
/// Rounds between two reports of ship data. On the air they come every six minutes.
const SHIP_DATA_EVERY: u64 = 10;
/// A ship with a line made fast that is slower than this reports herself as moored (m/s); our choice.
const MOORED_MPS: f64 = 0.2;

/// A vessel as its instruments report it. The antenna is amidships.
struct Vessel<'s> {
    index: usize,
    of: &'s VesselSetup,
    state: &'s BodyState,
    /// Centre of gravity forward of midship (m).
    ahead_m: f64,
    /// Velocity over ground at midship, ahead and to starboard (m/s).
    ground: Vec2,
}

impl<'s> Vessel<'s> {
    fn of(session: &'s Session, index: usize) -> Vessel<'s> {
        let simulation = session.simulation();
        let of = &simulation.setup().world.vessels[index];
        let state = &simulation.states()[of.body];
        let ahead_m = of.ship.particulars.centre_of_gravity_m;
        let own = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps);
        let ground = vec2(own.x, own.y - ahead_m * state.yaw_rate_radps);
        Vessel { index, of, state, ahead_m, ground }
    }

    fn place(&self, origin: &ChartOrigin) -> GeoPoint {
        let at = self.state.pose().apply(vec2(-self.ahead_m, 0.0));
        origin.place(at.x, at.y)
    }

    fn mmsi(&self) -> u32 {
        FIRST_MMSI + self.index as u32
    }

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
        let speed_mps = self.ground.length();
        PositionReport {
            mmsi: self.mmsi(),
            status: match simulation.vessels()[self.index].aground {
                true => 6,
                false if is_fast && speed_mps < MOORED_MPS => 5,
                false => 0,
            },
            turn_radps: self.state.yaw_rate_radps,
            speed_mps,
            place: self.place(origin),
            course_rad: self.state.heading_rad + libm::atan2(self.ground.y, self.ground.x),
            heading_rad: self.state.heading_rad,
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
        let water = self.of.velocity(self.state, environment, t_s);
        let air = environment.wind.as_ref().map_or(Vec2::ZERO, |wind| wind.velocity(10.0, t_s));
        let air = attitude.apply_inverse(air);
        let (least, _) = simulation.setup().bodies[self.of.body].outline.bounds();
        let stern_mps = (least.x + self.ahead_m) * self.state.yaw_rate_radps;
        let propelled = self.of.ship.propulsion.is_some();
        Instruments {
            at,
            place: self.place(origin),
            heading_rad: self.state.heading_rad,
            turn_radps: self.state.yaw_rate_radps,
            ground_mps: [self.ground.x, self.ground.y],
            water_mps: [water.surge_mps, water.sway_mps],
            stern_mps: [water.sway_mps + stern_mps, self.ground.y + stern_mps],
            wind_over_deck: from_and_speed(air - self.ground),
            true_wind: from_and_speed(air),
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

/// Direction from which a wind comes, from the bow (rad), and its speed (m/s), from its velocity in the ship's axes.
fn from_and_speed(air: Vec2) -> (f64, f64) {
    (libm::atan2(-air.y, -air.x), air.length())
}

/// MMSI of a ship that passes: after those of the vessels.
fn mmsi_of_traffic(session: &Session, index: usize) -> u32 {
    FIRST_MMSI + (session.simulation().vessels().len() + index) as u32
}

/// The report of a ship that passes on a track of her own.
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

/// Name and size of a ship that passes on a track of her own.
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

/// One round of sentences: the own ship's instruments and her AIS, then the AIS of all others. `round` counts the rounds.
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
    use fenderline_live::Source;

    use super::*;

    /// The bits of a position report of another ship, which fits into one sentence: ITU-R M.1371, as characters of six bits.
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

    /// The same with a sign.
    fn signed(bits: &[bool]) -> i64 {
        number(bits) - if bits[0] { 1 << bits.len() } else { 0 }
    }

    fn origin() -> ChartOrigin {
        let at = GeoPoint { latitude_deg: 35.3, longitude_deg: 139.7 };
        ChartOrigin::new(at).expect("within the chart")
    }

    /// MMSI, speed (kn), latitude (°), heading (°) of all position reports of a round.
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

    #[test]
    fn traffic_is_in_the_ais_with_its_speed_place_and_heading() {
        let text = include_str!("../../../scenarios/live/two_pilots_in_a_fairway.toml");
        let none = |name: &str| Err(format!("{name}: none is needed"));
        let (source, _) = Source::collect("a.toml", text.to_owned(), vec![], none).expect("good");
        let mut session = Session::open(source).expect("a set-up");
        let names: Vec<&str> =
            session.info().traffic.iter().map(|ship| ship.name.as_str()).collect();
        let place = names.iter().position(|name| *name == "container_ship").expect("she is there");
        let mmsi = i64::from(FIRST_MMSI) + 2 + place as i64;
        let of = |session: &Session| {
            let reports = reports(session, 1);
            // The coaster and both ships that pass; the own ship is in a sentence of her own kind.
            assert_eq!(reports.len(), 3, "{reports:?}");
            *reports.iter().find(|report| report.0 == mmsi).expect("she reports")
        };
        let (_, speed_kn, before, heading) = of(&session);
        assert!((speed_kn - 11.0).abs() < 0.06 && heading == 0, "{speed_kn} kn, {heading}°");
        for _ in 0..1200 {
            session.step().expect("a step");
        }
        let (_, _, after, _) = of(&session);
        // 11 kn for two minutes are 11/30 of a nautical mile, a minute of latitude, within the reports' 1/10000 of a minute
        // and half a percent: a minute is 1849 m here, not 1852.
        let minutes = 60.0 * (after - before);
        assert!((minutes - 11.0 / 30.0).abs() < 0.002, "{minutes}");
        // Her name and size come every tenth round.
        let origin = origin();
        let data = |round| {
            let all = sentences(&session, &origin, Moment::from_unix(1.8e9), round);
            all.iter().filter(|text| text.starts_with("!AIVDM,2,1,")).count()
        };
        assert_eq!((data(1), data(10)), (0, 3));
    }
}
