//! Decides which commands each role may give.

use fenderline_live::message::Role;
use fenderline_live::{Action, Cast, Conduct, Control, Helm, Refusal};

/// What a command needs besides a role that may give it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Needs {
    /// The client must hold the control. If nobody holds the control, the client takes it with the command.
    Helm(Control),
    /// No other client may hold the control. The client does not take the control with the command.
    NobodyAt(Control),
    /// Nothing.
    Nothing,
}

/// Checks whether a role may give a command, and returns what else the command needs.
///
/// # Errors
/// The error is the reason why the command is refused.
pub(crate) fn for_action(role: &Role, action: &Action, cast: &Cast) -> Result<Needs, Refusal> {
    let helm = cast.helm(action);
    match (role, helm) {
        // The alarm book knows whose alarm it is.
        (_, Helm::Alarm) => Ok(Needs::Nothing),
        (Role::Observer, _) => Err(Refusal::new("an observer gives no commands")),
        (Role::Instructor, Helm::Of(control)) => Ok(Needs::NobodyAt(control)),
        (Role::Instructor, Helm::Line(_) | Helm::World | Helm::Board | Helm::Notes) => {
            Ok(Needs::Nothing)
        }
        (_, Helm::Notes) => Err(Refusal::new("only the instructor writes notes")),
        (_, Helm::World) => Err(Refusal::new("only the instructor sets weather and faults")),
        (_, Helm::Of(control)) if may_claim(role, &control, cast) => Ok(Needs::Helm(control)),
        // A name that does not exist is refused when the command is carried out.
        (Role::Pilot { .. }, Helm::Of(control)) if !cast.controls().contains(&control) => {
            Ok(Needs::NobodyAt(control))
        }
        (Role::Pilot { vessel }, Helm::Of(control)) => match may_order(role, &control, cast) {
            true => Ok(Needs::NobodyAt(control)),
            false => Err(not_hers(vessel, cast)),
        },
        (Role::Pilot { vessel }, Helm::Line(ends)) => match works_line(vessel, &ends, cast) {
            true => Ok(Needs::Nothing),
            false => Err(not_hers(vessel, cast)),
        },
        (Role::Pilot { .. }, Helm::Board) => Ok(Needs::Nothing),
        (Role::Tugmaster { tug }, Helm::Line(ends)) if ends.contains(tug) => Ok(Needs::Nothing),
        (Role::Tugmaster { tug }, _) => {
            Err(Refusal::new(format_args!("the master of {tug} commands that tug only")))
        }
    }
}

/// True if a client with the role may hold the control.
pub(crate) fn may_claim(role: &Role, control: &Control, cast: &Cast) -> bool {
    match (role, control) {
        (_, Control::Session(_)) | (Role::Observer, _) => false,
        (Role::Instructor, _) => true,
        (Role::Pilot { vessel }, Control::Vessel(name)) => {
            !cast.is_tug(name) && cast.ship_of(vessel) == Some(name)
        }
        (Role::Pilot { .. }, Control::Tug(_)) => false,
        (Role::Tugmaster { tug }, Control::Vessel(name) | Control::Tug(name)) => name == tug,
    }
}

/// True if a role may give orders to a control while nobody holds that control.
pub(crate) fn may_order(role: &Role, control: &Control, cast: &Cast) -> bool {
    match role {
        Role::Instructor => true,
        Role::Pilot { vessel } => match control {
            Control::Vessel(name) => cast.is_tug(name) && serves(vessel, name, cast),
            Control::Tug(name) => serves(vessel, name, cast),
            Control::Session(_) => false,
        },
        Role::Tugmaster { .. } | Role::Observer => false,
    }
}

/// True if the tug serves the ship of the pilot.
fn serves(pilot: &Option<String>, tug: &str, cast: &Cast) -> bool {
    cast.served_by(tug).is_some_and(|ship| cast.ship_of(pilot) == Some(ship))
}

/// True if a pilot may work a line that has the given vessels at its ends. One end of the line must be on the pilot's
/// ship. The pilot of the own ship may also work lines that lead to no other ship.
fn works_line(pilot: &Option<String>, ends: &[String], cast: &Cast) -> bool {
    let own = cast.ship_of(pilot);
    let is_own = ends.iter().any(|end| own == Some(end));
    let of_others = ends.iter().any(|end| cast.other_ships().contains(end));
    is_own || pilot.is_none() && !of_others
}

fn not_hers(pilot: &Option<String>, cast: &Cast) -> Refusal {
    let ship = cast.ship_of(pilot).unwrap_or("no ship");
    Refusal::new(format_args!(
        "the pilot of {ship} commands that ship, her lines and her tugs only"
    ))
}

/// Checks that a role may give a command about the session. Whether the client may claim a control is checked when the
/// client takes it.
///
/// # Errors
/// The error is the reason why the command is refused.
pub(crate) fn for_conduct(role: &Role, conduct: &Conduct) -> Result<(), Refusal> {
    // The orders in a trial are checked one by one.
    let own = matches!(
        conduct,
        Conduct::Claim { .. }
            | Conduct::Release { .. }
            | Conduct::Name { .. }
            | Conduct::Seat { .. }
            | Conduct::Trial { .. }
            | Conduct::Give { .. }
            | Conduct::History { .. }
    );
    if own || *role == Role::Instructor {
        return Ok(());
    }
    Err(Refusal::new("only the instructor may give this command"))
}

#[cfg(test)]
mod tests {
    use fenderline_live::{NamedOrder, OtherAction};
    use fenderline_sim::OrderName;

    use super::*;

    #[test]
    fn each_role_may_give_its_own_commands_only() {
        let text = include_str!("../../../scenarios/berth/asd_tugs_push_alongside.toml");
        let scenario = fenderline_scenario::Scenario::parse(text, "a.toml").expect("a scenario");
        let cast = Cast::of(&scenario.setup);
        assert_eq!(cast.tug_names(), ["forward_tug", "after_tug"]);
        let master = Role::Tugmaster { tug: "forward_tug".into() };
        let vessel = |name: &str| Control::Vessel(name.into());
        let rudder =
            |name: &str| NamedOrder::new(OrderName::Rudder, name).number("angle", 0.0).into();
        let hands = |name: &str| NamedOrder::new(OrderName::Hands, name).into();
        let wind = Action::from(OtherAction::Wind { speed_mps: 1.0, from_rad: 0.0, over_s: 0.0 });
        let limit = Action::from(OtherAction::ApproachLimit { speed_mps: 0.2 });
        let note = Action::from(OtherAction::Note { text: String::new() });
        let line = Action::from(NamedOrder::new(OrderName::LetGo, "none"));
        for (role, action, needs) in [
            (&Role::PILOT, rudder("ship"), Some(Needs::Helm(vessel("ship")))),
            (&Role::PILOT, hands("after_tug"), Some(Needs::NobodyAt(vessel("after_tug")))),
            (&Role::PILOT, line.clone(), Some(Needs::Nothing)),
            (&Role::PILOT, wind.clone(), None),
            (&Role::PILOT, limit.clone(), Some(Needs::Nothing)),
            (&Role::PILOT, note.clone(), None),
            (&Role::Observer, note.clone(), None),
            (&Role::Instructor, note, Some(Needs::Nothing)),
            (&master, limit, None),
            (&master, hands("forward_tug"), Some(Needs::Helm(vessel("forward_tug")))),
            (&master, hands("after_tug"), None),
            (&master, rudder("ship"), None),
            (&master, line.clone(), None),
            (&master, wind.clone(), None),
            (&Role::Observer, rudder("ship"), None),
            (&Role::Observer, line.clone(), None),
            (&Role::Observer, wind.clone(), None),
            (&Role::Instructor, rudder("ship"), Some(Needs::NobodyAt(vessel("ship")))),
            (&Role::Instructor, wind, Some(Needs::Nothing)),
            (&Role::Instructor, line, Some(Needs::Nothing)),
        ] {
            assert_eq!(for_action(role, &action, &cast).ok(), needs, "{role:?} {action:?}");
        }
        for role in [&Role::PILOT, &master, &Role::Observer] {
            for conduct in
                [Conduct::Pause {}, Conduct::Load { file: "x".into() }, Conduct::Branch {}]
            {
                assert!(for_conduct(role, &conduct).is_err(), "{role:?} {conduct:?}");
            }
        }
        assert!(for_conduct(&Role::Instructor, &Conduct::Pause {}).is_ok());
        assert!(!may_claim(&Role::Instructor, &Control::Session(true), &cast));
    }
}
