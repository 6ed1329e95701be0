//! Knows which client holds which control of the session. A control has at most one holder at a time.

use std::collections::BTreeMap;

use fenderline_live::message::{Claim, Role};
use fenderline_live::{Control, Refusal};

use crate::kept_seats::KeptHolder;

/// Number of a client. A client number is never used twice.
pub(crate) type ClientId = u64;

#[derive(Clone, Debug, PartialEq)]
struct Holder {
    client: ClientId,
    label: String,
    /// False if the holder has disconnected. Others may take the control of a holder who has disconnected.
    connected: bool,
    /// The seat of the page that the holder has left, if the holder has disconnected.
    left: Option<Seat>,
    /// True if the holder is a program. People may take the control of a program.
    is_program: bool,
}

/// The seat of a page: its role and its secret. The page keeps the secret `key` when the page is reloaded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Seat {
    pub(crate) role: Role,
    pub(crate) key: String,
}

impl Holder {
    fn connected(client: ClientId, label: &str, is_program: bool) -> Holder {
        Holder { client, label: label.to_owned(), connected: true, left: None, is_program }
    }

    fn is_left_by(&self, seat: &Seat) -> bool {
        !self.connected && self.left.as_ref() == Some(seat)
    }
}

/// A client number that no client has. The number stands for a holder from a former run of the server.
const NOBODY: ClientId = 0;

/// Controls and their holders.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Claims(BTreeMap<Control, Holder>);

impl Claims {
    /// Releases all controls.
    pub(crate) fn clear(&mut self) {
        self.0.clear();
    }

    /// Restores the holders of controls from a former run of the session. The restored holders count as disconnected
    /// until they give their names again.
    pub(crate) fn restore(&mut self, holders: &[KeptHolder]) {
        for KeptHolder { control, label } in holders {
            let holder = Holder::connected(NOBODY, label, false);
            self.0.insert(control.clone(), Holder { connected: false, ..holder });
        }
    }

    /// All people who hold controls, connected or not, for the file that keeps them. A program is not kept: the control
    /// of a program that has gone is free.
    pub(crate) fn kept(&self) -> Vec<KeptHolder> {
        let holder = |(control, holder): (&Control, &Holder)| KeptHolder {
            control: control.clone(),
            label: holder.label.clone(),
        };
        self.0.iter().filter(|(_, holder)| !holder.is_program).map(holder).collect()
    }

    /// Checks that a control is free, left by its holder, or held by the client `client`.
    ///
    /// # Errors
    /// The error is a text that names the holder of the control.
    pub(crate) fn may_use(&self, control: &Control, client: ClientId) -> Result<(), Refusal> {
        match self.0.get(control) {
            Some(holder) if holder.connected && holder.client != client && holder.is_program => {
                Err(Refusal::new(format_args!(
                    "{} holds this control: take the control before you give orders",
                    holder.label
                )))
            }
            Some(holder) if holder.connected && holder.client != client => {
                Err(Refusal::new(format_args!(
                    "{} holds this control, and must release it first; the instructor can take it",
                    holder.label
                )))
            }
            _ => Ok(()),
        }
    }

    /// Checks that a controller, which takes a control without asking for it, may use the control: the control is free
    /// or the controller holds it. A control that a person has left waits for a person.
    ///
    /// # Errors
    /// The error is a text that names the holder of the control.
    pub(crate) fn is_free(&self, control: &Control, client: ClientId) -> Result<(), Refusal> {
        match self.0.get(control) {
            Some(holder) if holder.client != client => Err(Refusal::new(format_args!(
                "{} has this control, and must release it first",
                holder.label
            ))),
            _ => Ok(()),
        }
    }

    /// True if a connected program holds a control.
    pub(crate) fn is_held_by_program(&self, control: &Control) -> bool {
        self.0.get(control).is_some_and(|holder| holder.is_program)
    }

    /// The connected client that holds a control.
    pub(crate) fn holder(&self, control: &Control) -> Option<ClientId> {
        self.0.get(control).filter(|holder| holder.connected).map(|holder| holder.client)
    }

    pub(crate) fn holds(&self, control: &Control, client: ClientId) -> bool {
        self.0.get(control).is_some_and(|holder| holder.client == client)
    }

    /// Gives a control to a client if the control is free or its holder has left. With `by_force`, the client gets the
    /// control even if another client holds it. Returns the former holder of the control, if that was another client;
    /// `None` if nothing changed.
    ///
    /// # Errors
    /// The error is a text that names the holder of the control.
    pub(crate) fn take(
        &mut self,
        control: Control,
        (client, label, is_program): (ClientId, &str, bool),
        by_force: bool,
    ) -> Result<Option<ClientId>, Refusal> {
        if !by_force {
            self.may_use(&control, client)?;
        }
        let holder = Holder::connected(client, label, is_program);
        let former = self.0.insert(control, holder);
        Ok(former.filter(|f| f.connected && f.client != client).map(|f| f.client))
    }

    /// Changes the label of a client at its controls, and gives the client the controls that a disconnected holder with
    /// this label left. Returns true if the label or the holder of a control changed.
    pub(crate) fn name(&mut self, client: ClientId, label: &str) -> bool {
        let mut changed = false;
        for holder in self.0.values_mut() {
            let returns = !holder.connected && holder.label == label;
            if returns || holder.client == client && holder.label != label {
                *holder = Holder::connected(client, label, holder.is_program);
                changed = true;
            }
        }
        changed
    }

    /// Releases a control. Returns true if the client held the control.
    pub(crate) fn release(&mut self, control: &Control, client: ClientId) -> bool {
        let held = self.holds(control, client);
        if held {
            self.0.remove(control);
        }
        held
    }

    /// The label that a page had when it left its controls.
    pub(crate) fn label_of(&self, seat: &Seat) -> Option<&str> {
        let holder = self.0.values().find(|holder| holder.is_left_by(seat))?;
        Some(&holder.label)
    }

    /// Gives a client the controls that its page left, unless others have taken them since. Returns true if the client
    /// got a control.
    pub(crate) fn back(&mut self, client: ClientId, label: &str, seat: &Seat) -> bool {
        let mut changed = false;
        for holder in self.0.values_mut().filter(|holder| holder.is_left_by(seat)) {
            *holder = Holder::connected(client, label, false);
            changed = true;
        }
        changed
    }

    /// Marks the controls of a disconnected client as left, and returns these controls. Until somebody takes these
    /// controls, they keep the client's name and the seat of the client's page. The controls of a program are free.
    pub(crate) fn gone(&mut self, client: ClientId, seat: Option<&Seat>) -> Vec<Control> {
        let mut left = Vec::new();
        for (control, holder) in self.0.iter_mut().filter(|(_, holder)| holder.client == client) {
            holder.connected = false;
            holder.left = seat.cloned();
            left.push(control.clone());
        }
        self.0.retain(|_, holder| holder.connected || !holder.is_program);
        left
    }

    /// The list of controls and holders for pages.
    pub(crate) fn list(&self, controls: &[Control]) -> Vec<Claim> {
        let claim = |control: &Control| {
            let holder = self.0.get(control);
            Claim {
                control: control.clone(),
                holder: holder.map(|holder| holder.label.clone()),
                connected: holder.is_some_and(|holder| holder.connected),
            }
        };
        controls.iter().map(claim).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_control_has_one_holder_until_it_is_released_vacated_or_taken_by_force() {
        let mut claims = Claims::default();
        let helm = || Control::Vessel("ship".into());
        assert_eq!(claims.take(helm(), (1, "pilot 1", false), false), Ok(None));
        assert!(claims.may_use(&helm(), 1).is_ok());
        let refused = claims.take(helm(), (2, "pilot 2", false), false).expect_err("it is held");
        assert_eq!(
            refused.to_string(),
            "pilot 1 holds this control, and must release it first; the instructor can take it"
        );
        assert_eq!(
            (claims.holder(&helm()), claims.holder(&Control::Tug("aft".into()))),
            (Some(1), None)
        );
        assert!(!claims.release(&helm(), 2) && claims.holds(&helm(), 1));
        assert_eq!(claims.take(helm(), (3, "instructor 3", false), true), Ok(Some(1)));
        assert_eq!(claims.gone(3, None), [helm()]);
        assert_eq!(claims.list(&[helm()])[0].holder.as_deref(), Some("instructor 3"));
        assert!(claims.may_use(&helm(), 2).is_ok(), "its holder has left");
        assert_eq!(claims.take(helm(), (2, "pilot 2", false), false), Ok(None));
        assert!(claims.release(&helm(), 2) && !claims.holds(&helm(), 2));
    }

    #[test]
    fn a_page_that_is_loaded_again_gets_back_what_nobody_has_taken() {
        let mut claims = Claims::default();
        let helm = || Control::Vessel("ship".into());
        let tug = || Control::Tug("aft".into());
        let seat = |key: &str| Seat { role: Role::PILOT, key: key.to_owned() };
        for control in [helm(), tug()] {
            assert_eq!(claims.take(control, (1, "pilot 1", false), false), Ok(None));
        }
        assert!(!claims.back(2, "pilot 2", &seat("a")), "its holder is there");
        claims.gone(1, Some(&seat("a")));
        assert_eq!(claims.take(tug(), (3, "pilot 3", false), false), Ok(None));
        assert!(!claims.back(2, "pilot 2", &seat("b")), "another page");
        assert!(!claims.back(2, "pilot 2", &Seat { role: Role::Observer, key: "a".into() }));
        assert_eq!(claims.label_of(&seat("a")), Some("pilot 1"));
        assert!(claims.back(2, "pilot 1", &seat("a")));
        assert_eq!((claims.holder(&helm()), claims.holder(&tug())), (Some(2), Some(3)));
        assert!(!claims.back(4, "pilot 4", &seat("a")), "it is taken");
    }

    #[test]
    fn a_person_takes_the_control_of_a_program_and_a_program_waits_for_a_person() {
        let mut claims = Claims::default();
        let helm = || Control::Vessel("ship".into());
        assert_eq!(claims.take(helm(), (1, "NMEA controller 1", true), false), Ok(None));
        assert!(claims.is_held_by_program(&helm()) && claims.kept().is_empty());
        let refused = claims.may_use(&helm(), 2).expect_err("it is held");
        assert!(refused.to_string().contains("take the control"), "{refused}");
        assert_eq!(claims.take(helm(), (2, "pilot 2", false), true), Ok(Some(1)));
        assert!(claims.is_free(&helm(), 1).is_err());
        claims.gone(2, None);
        assert!(claims.is_free(&helm(), 1).is_err(), "she left it, but it is hers");
        assert_eq!(claims.take(helm(), (3, "pilot 3", false), false), Ok(None));
        assert!(claims.release(&helm(), 3) && claims.is_free(&helm(), 1).is_ok());
        assert_eq!(claims.take(helm(), (1, "NMEA controller 1", true), false), Ok(None));
        assert_eq!(claims.gone(1, None), [helm()]);
        assert_eq!(claims.list(&[helm()])[0].holder, None);
    }
}
