//! Sends the session's past to pages that were opened later or loaded again.

use std::time::{Duration, Instant};

use fenderline_live::message::Role;
use fenderline_live::{Cast, Refusal, message};

use super::Engine;
use crate::claims::ClientId;

/// A client may ask for the past once within this time, because the answer has a hundred kilobytes.
const BETWEEN: Duration = Duration::from_secs(1);

impl Engine {
    /// Sends a client the past of a ship up to the present tick. The ship is that of the client's role, or the ship
    /// that `named` names.
    ///
    /// # Errors
    /// Fails if the client asked for the past a moment ago. Also fails if the ship does not exist, or if the role may
    /// not see her past.
    pub(super) fn send_history(
        &mut self,
        client: ClientId,
        named: Option<&str>,
        now: Instant,
    ) -> Result<(), Refusal> {
        let Some(of) = self.clients.get_mut(&client) else { return Ok(()) };
        let vessel = charted(&of.role, named, self.session.cast())?;
        if of.asked.is_some_and(|at| now < at + BETWEEN) {
            return Err(Refusal::new("the past of the session was sent a moment ago"));
        }
        of.asked = Some(now);
        let (session, version) = (&self.session, self.session.history_version());
        let as_shown = matches!(of.role, Role::Pilot { .. });
        let text = self.history.text(version, (vessel, as_shown), || {
            session.history(vessel, &of.role).map(|history| message::text(&history).into())
        })?;
        // The queue is full, so the client does not read. Its connection is about to be closed for that reason.
        let _ = of.out.try_send(text);
        Ok(())
    }
}

/// The vessel whose past a client with this role gets. The strip charts of another ship could show what fog hides. Only
/// the instructor gets the strip charts of every ship.
fn charted(role: &Role, named: Option<&str>, cast: &Cast) -> Result<Option<usize>, Refusal> {
    let index = |name: &str| cast.vessels.iter().position(|vessel| vessel == name);
    let own = match role {
        Role::Pilot { vessel } => cast.ship_of(vessel),
        Role::Tugmaster { tug } => cast.served_by(tug),
        Role::Instructor | Role::Observer => cast.ship_of(&None),
    };
    match named {
        None => Ok(own.and_then(index)),
        Some(name) if own == Some(name) || *role == Role::Instructor => match index(name) {
            Some(vessel) => Ok(Some(vessel)),
            None => Err(Refusal::new(format_args!("there is no vessel `{name}`"))),
        },
        Some(name) => {
            Err(Refusal::new(format_args!("the strip charts of {name} are not for your link")))
        }
    }
}
