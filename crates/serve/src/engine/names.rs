//! Names of people: who is at which page.

use fenderline_live::message::Role;
use fenderline_live::{LONGEST_NAME, Refusal};

use super::Engine;
use crate::claims::ClientId;
use crate::role_words::role_words;

impl Engine {
    /// Names the person at a page. She gets back the controls that she left when her connection broke.
    ///
    /// # Errors
    /// A name that is empty, too long, or has control characters.
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
        // Two people of one name in one role are told apart by a number.
        let numbers = (1..).map(|number| match number {
            1 => format!("{name} ({})", role_words(role)),
            _ => format!("{name} {number} ({})", role_words(role)),
        });
        let is_taken = |label: &String| {
            self.clients.iter().any(|(id, other)| *id != client && other.label == *label)
        };
        let mut free = numbers.filter(|label| !is_taken(label));
        let Some(label) = free.next() else { unreachable!("clients are fewer than numbers") };
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
}
