//! Orders to a tug in words, and the conversion of the words to an order with force, direction and position.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use fenderline_contact::{BodyState, Outline, Rotation, Vec2, vec2};

use super::action::Action;
use super::arguments::{Arguments, Value};
use super::error::OrderError;
use super::table::OrderName;
use crate::setup::Setup;
use crate::world::LineEnd;

/// A type with a word for each value.
pub trait Word: Copy + PartialEq + 'static {
    /// All values.
    const ALL: &'static [Self];

    /// The word.
    fn word(self) -> &'static str;

    /// The value that a word stands for; `None` if no value has this word.
    #[must_use]
    fn of_word(word: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|one| one.word() == word)
    }
}

macro_rules! words {
    ($type:ident: $($name:ident = $word:literal),*) => {
        impl Word for $type {
            const ALL: &'static [$type] = &[$($type::$name),*];

            fn word(self) -> &'static str {
                match self {
                    $($type::$name => $word),*
                }
            }
        }
    };
}

words!(TugWord: Push = "push", Pull = "pull", Stop = "stop", StandOff = "stand_off");
words!(Lead: Square = "square", Forward = "forward", Aft = "aft");
words!(SidePlace:
    Nearest = "nearest",
    PortShoulder = "port shoulder", PortMidships = "port midships", PortQuarter = "port quarter",
    StarboardShoulder = "starboard shoulder", StarboardMidships = "starboard midships",
    StarboardQuarter = "starboard quarter");

/// The order to a tug.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TugWord {
    /// The tug pushes at the ship's side.
    Push,
    /// The tug pulls on the line.
    Pull,
    /// The tug gives no force: a vector tug stands by, and a tug that is a vessel stays at the ship's side.
    Stop,
    /// The tug keeps clear of the ship's side. A vector tug stands by.
    StandOff,
}

/// The direction of a tug relative to the ship's side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Lead {
    /// Perpendicular to the side.
    #[default]
    Square,
    /// 45° from the direction square to the ship's side, towards the ship's bow. For a tug on the centre line, 45° to
    /// starboard.
    Forward,
    /// 45° from the direction square to the ship's side, towards the ship's stern. For a tug on the centre line, 45° to
    /// port.
    Aft,
}

/// A position at a ship's side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SidePlace {
    /// The one of the six other positions that is nearest to the tug.
    #[default]
    Nearest,
    /// 0.3 of the length forward of midship, to port.
    PortShoulder,
    /// Midship, to port.
    PortMidships,
    /// 0.3 of the length aft of midship, to port.
    PortQuarter,
    /// 0.3 of the length forward of midship, to starboard.
    StarboardShoulder,
    /// Midship, to starboard.
    StarboardMidships,
    /// 0.3 of the length aft of midship, to starboard.
    StarboardQuarter,
}

/// An order to a tug in words.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TugWords {
    /// The order.
    pub word: TugWord,
    /// Force divided by the tug's bollard pull, 0 to 1.
    pub power: f64,
    /// Direction of the tug relative to the ship's side. Only a pull, and the push of a vector tug, use this direction.
    pub lead: Lead,
    /// Position at the ship's side of a tug that is a vessel.
    pub place: SidePlace,
}

/// A vector tug nearer to the centre line than this share of the half beam acts along the centre line, at bow or stern.
const CENTRE_SHARE: f64 = 0.3;
/// Distance between the sides of the ship and of a tug that stands off parallel to the ship (m).
const STAND_OFF_M: f64 = 25.0;

impl SidePlace {
    /// Distance of the place forward of midship, divided by the ship's length, and the side of the place: 1 to
    /// starboard, −1 to port.
    fn share_and_side(self) -> Option<(f64, f64)> {
        Some(match self {
            SidePlace::Nearest => return None,
            SidePlace::PortShoulder => (0.3, -1.0),
            SidePlace::PortMidships => (0.0, -1.0),
            SidePlace::PortQuarter => (-0.3, -1.0),
            SidePlace::StarboardShoulder => (0.3, 1.0),
            SidePlace::StarboardMidships => (0.0, 1.0),
            SidePlace::StarboardQuarter => (-0.3, 1.0),
        })
    }

    /// The point on a ship's outline, in the ship's frame; `None` if the ship has no side there.
    #[must_use]
    pub fn on(self, outline: &Outline, length_m: f64) -> Option<Vec2> {
        let (share, side) = self.share_and_side()?;
        let along_m = share * length_m;
        side_at(outline, along_m, side).map(|across_m| vec2(along_m, across_m))
    }

    /// The position at a ship's side that is nearest to a point in the ship's frame.
    #[must_use]
    pub fn nearest(at_m: Vec2, outline: &Outline, length_m: f64) -> Option<SidePlace> {
        let mut nearest: Option<(f64, SidePlace)> = None;
        for &place in SidePlace::ALL {
            let Some(side_m) = place.on(outline, length_m) else { continue };
            let off_m = (side_m - at_m).length();
            if nearest.is_none_or(|(least_m, _)| off_m < least_m) {
                nearest = Some((off_m, place));
            }
        }
        nearest.map(|(_, place)| place)
    }
}

/// The ordinate of a hull's outline on one side (1 to starboard, −1 to port) at a distance forward of the ship's origin
/// (m).
fn side_at(outline: &Outline, along_m: f64, side: f64) -> Option<f64> {
    let vertices = outline.vertices();
    let edges = vertices.iter().zip(vertices.iter().cycle().skip(1));
    let crossings = edges.filter_map(|(from, to)| {
        let crosses = (from.x - along_m) * (to.x - along_m) <= 0.0 && from.x != to.x;
        crosses.then(|| from.y + (to.y - from.y) * (along_m - from.x) / (to.x - from.x))
    });
    crossings.fold(None, |widest: Option<f64>, y| match widest {
        Some(before) if y * side <= before * side => Some(before),
        _ => Some(y),
    })
}

/// Direction of the force of a tug that pushes or pulls at a point of a ship: measured from the ship's bow, positive to
/// starboard (rad). At a side, a push acts inwards and a pull outwards. On the centre line, a tug at the stern pushes
/// ahead and pulls astern; a tug at the bow pushes astern and pulls ahead.
fn direction_rad(at_m: Vec2, pulls: bool, lead: Lead, beam_m: f64) -> f64 {
    let lead = match lead {
        Lead::Square => 0.0,
        Lead::Forward => 1.0,
        Lead::Aft => -1.0,
    };
    if libm::fabs(at_m.y) < 0.5 * CENTRE_SHARE * beam_m {
        let (outward_rad, sign) = if at_m.x < 0.0 { (PI, -1.0) } else { (0.0, 1.0) };
        let force_rad = if pulls { outward_rad } else { outward_rad + PI };
        return libm::remainder(force_rad + lead * FRAC_PI_4 * sign, 2.0 * PI);
    }
    let side = if (at_m.y > 0.0) == pulls { 1.0 } else { -1.0 };
    side * FRAC_PI_2 * (1.0 - 0.5 * lead)
}

impl TugWords {
    /// The order to a vector tug.
    ///
    /// # Errors
    /// As [`OrderName::build`].
    pub fn for_vector_tug(&self, tug: usize, setup: &Setup) -> Result<Action, OrderError> {
        let Some(of) = setup.world.tugs.get(tug) else {
            return OrderName::StandBy.build(tug, &Arguments::new(), setup);
        };
        let (name, at_m, pulls) = match self.word {
            TugWord::Push => (OrderName::Push, of.tug.push_at_m, false),
            TugWord::Pull => (OrderName::Pull, of.tug.pull_at_m, true),
            TugWord::Stop | TugWord::StandOff => {
                return OrderName::StandBy.build(tug, &Arguments::new(), setup);
            }
        };
        let ship = &setup.world.vessels[of.vessel].ship.particulars;
        let arguments = Arguments::new()
            .number("force", self.power * of.tug.envelope.bollard_pull_n)
            .number("direction", direction_rad(at_m, pulls, self.lead, ship.beam_m));
        name.build(tug, &arguments, setup)
    }

    /// The order to a tug that is a vessel and works at another vessel. Tug and ship are given by their indices among
    /// the vessels.
    ///
    /// # Errors
    /// The errors of [`OrderName::build`]. Fails if the ship has no side at the place, or if the words are a pull and
    /// the tug has no line to the ship.
    pub fn for_vessel(
        &self,
        tug: usize,
        ship: usize,
        setup: &Setup,
        states: &[BodyState],
    ) -> Result<Action, OrderError> {
        let (own, of) = (&setup.world.vessels[tug], &setup.world.vessels[ship]);
        let force_n = self.power * own.bollard_pull_n();
        if self.word == TugWord::Pull {
            let (line, at_m) = towline(setup, own.body, of.body).ok_or_else(|| {
                OrderError::NoTowline { ship: setup.bodies[of.body].name.clone() }
            })?;
            let direction = direction_rad(at_m, true, self.lead, of.ship.particulars.beam_m);
            let arguments = Arguments::new()
                .with("line", Value::Index(line))
                .number("force", force_n)
                .number("direction", direction);
            return OrderName::PullShip.build(tug, &arguments, setup);
        }
        let (hull, length_m) = (&setup.bodies[of.body], of.ship.particulars.length_m);
        let place = match self.place {
            SidePlace::Nearest => {
                let state = &states[of.body];
                let attitude = Rotation::from_angle(state.heading_rad);
                let here_m = attitude.apply_inverse(states[own.body].position_m - state.position_m);
                SidePlace::nearest(here_m, &hull.outline, length_m)
            }
            place => Some(place),
        };
        let at_m = place.and_then(|place| place.on(&hull.outline, length_m));
        let at_m = at_m.ok_or_else(|| OrderError::NoPlace { ship: hull.name.clone() })?;
        let at_ship = Arguments::new().with("ship", Value::Index(of.body));
        let off_m = STAND_OFF_M + 0.5 * own.ship.particulars.beam_m;
        match self.word {
            TugWord::StandOff => {
                let beside_m = vec2(at_m.x, at_m.y + off_m.copysign(at_m.y));
                let arguments = at_ship.with("at", Value::Place(beside_m));
                OrderName::FollowShip.build(tug, &arguments, setup)
            }
            // A tug that stops pushing stays at the ship's side.
            TugWord::Stop | TugWord::Push | TugWord::Pull => {
                let force_n = if self.word == TugWord::Stop { 0.0 } else { force_n };
                let arguments = at_ship.with("at", Value::Place(at_m)).number("force", force_n);
                OrderName::PushShip.build(tug, &arguments, setup)
            }
        }
    }
}

/// The line between a tug and a ship, given by their bodies, and the point on the ship at which the line is fast.
#[must_use]
pub fn towline(setup: &Setup, tug: usize, ship: usize) -> Option<(usize, Vec2)> {
    setup.world.lines.iter().enumerate().find_map(|(index, line)| {
        let Some(LineEnd::OnBody { body, at_m, .. }) = line.end else { return None };
        match (line.ship, body) {
            (own, far) if own == tug && far == ship => Some((index, at_m)),
            (own, far) if own == ship && far == tug => Some((index, line.fairlead_m)),
            _ => None,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn degrees(at_m: Vec2, pulls: bool, lead: Lead) -> f64 {
        libm::round(direction_rad(at_m, pulls, lead, 32.0).to_degrees())
    }

    #[test]
    fn at_a_side_a_push_acts_inwards_and_a_pull_outwards_and_leads_turn_them() {
        let (port, starboard) = (vec2(70.0, -16.0), vec2(-70.0, 16.0));
        assert_eq!(degrees(port, false, Lead::Square), 90.0);
        assert_eq!(degrees(port, true, Lead::Square), -90.0);
        assert_eq!(degrees(port, false, Lead::Forward), 45.0);
        assert_eq!(degrees(port, false, Lead::Aft), 135.0);
        assert_eq!(degrees(starboard, false, Lead::Square), -90.0);
        assert_eq!(degrees(starboard, true, Lead::Forward), 45.0);
    }

    #[test]
    fn on_the_centre_line_a_tug_pushes_along_the_ship_and_pulls_away_from_her() {
        let astern = vec2(-110.0, 0.0);
        assert_eq!(degrees(astern, false, Lead::Square), 0.0);
        assert_eq!(degrees(astern, true, Lead::Square).abs(), 180.0);
        assert_eq!(degrees(astern, true, Lead::Forward), 135.0);
        assert_eq!(degrees(vec2(110.0, 1.0), true, Lead::Forward), 45.0);
    }

    #[test]
    fn positions_at_the_side_lie_on_the_hull() {
        let points = [[-100.0, -15.0], [70.0, -15.0], [100.0, 0.0], [70.0, 15.0], [-100.0, 15.0]];
        let (outline, _) = Outline::new(&points.map(|[x, y]| vec2(x, y))).expect("a hull");
        for &place in &SidePlace::ALL[1..] {
            let at_m = place.on(&outline, 200.0).expect("a side");
            assert_eq!(at_m.y.abs(), 15.0, "{place:?}");
            assert_eq!(at_m.y > 0.0, place.word().starts_with("starboard"));
            assert_eq!(SidePlace::nearest(at_m * 1.1, &outline, 200.0), Some(place));
        }
        assert_eq!(SidePlace::PortShoulder.on(&outline, 1000.0), None);
    }
}
