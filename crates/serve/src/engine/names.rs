//! Keeps the names of the people at the pages, and the seat of each page: the role and the secret by which the server
//! knows the page again after it was reloaded.

use fenderline_live::message::Role;
use fenderline_live::{LONGEST_NAME, Refusal};

use super::Engine;
use super::client::Client;
use crate::claims::{ClientId, Seat};
use crate::kept_seats::SECRET_DIGITS;
use crate::role_words::role_words;

impl Engine {
    /// Sets the name of the person at a page. The person gets back the controls that were left when the connection
    /// broke.
    ///
    /// # Errors
    /// Refuses a name that is empty, too long, or has control characters.
    pub(super) fn name(
        &mut self,
        client: ClientId,
        role: &Role,
        name: &str,
    ) -> Result<(), Refusal> {
        let name = name.trim();
        let length = name.chars().count();
        if length == 0 || length > LONGEST_NAME || name.chars().any(char::is_control) {
            return Err(Refusal::new(format_args!("a name has 1 to {LONGEST_NAME} characters")));
        }
        // If two people with one name have the same role, a number distinguishes them.
        let is_program = self.clients.get(&client).is_some_and(Client::is_program);
        let words = role_words(role) + if is_program { ", program" } else { "" };
        let numbers = (1..).map(|number| match number {
            1 => format!("{name} ({words})"),
            _ => format!("{name} {number} ({words})"),
        });
        let is_taken = |label: &String| {
            self.clients.iter().any(|(id, other)| *id != client && other.label == *label)
        };
        let mut free = numbers.filter(|label| !is_taken(label));
        let Some(label) = free.next() else {
            unreachable!("there are always more numbers than clients")
        };
        let Some(own) = self.clients.get_mut(&client) else {
            return Err(Refusal::new("the client has left"));
        };
        if own.label == label {
            return Ok(());
        }
        let former = std::mem::replace(&mut own.label, label.clone());
        if self.claims.name(client, &label) {
            self.greet_all();
        }
        self.notify_all(&format!("{former} is {label}"));
        Ok(())
    }

    /// Gives a reloaded page the controls and the label that it had before. The page shows by its secret `key` that it
    /// is the same page. A copy of a page has the same secret, but gets nothing while the first page is connected.
    ///
    /// # Errors
    /// Fails if the key does not consist of hexadecimal digits, or if a connected page has the same secret.
    pub(super) fn seat(
        &mut self,
        client: ClientId,
        role: &Role,
        key: String,
    ) -> Result<(), Refusal> {
        if key.len() != SECRET_DIGITS || !key.bytes().all(|byte| byte.is_ascii_hexdigit()) {
            return Err(Refusal::new(format_args!(
                "the secret key of a page has {SECRET_DIGITS} hexadecimal digits"
            )));
        }
        let seat = Seat { role: role.clone(), key };
        let mut others = self.clients.iter().filter(|(id, _)| **id != client);
        if others
            .any(|(_, other)| other.role == seat.role && other.seat.as_ref() == Some(&seat.key))
        {
            return Err(Refusal::new("another page has this seat"));
        }
        let left = self.claims.label_of(&seat).map(str::to_owned);
        let is_free = |label: &String| self.clients.values().all(|other| other.label != *label);
        let left = left.filter(is_free);
        let Some(own) = self.clients.get_mut(&client) else {
            return Err(Refusal::new("the client has left"));
        };
        own.seat = Some(seat.key.clone());
        let former = own.label.clone();
        if let Some(label) = left {
            own.label = label;
        }
        let label = own.label.clone();
        if self.claims.back(client, &label, &seat) {
            self.greet_all();
            self.notify_all(&format!("{former} is now {label}, who is back"));
        }
        Ok(())
    }
}
