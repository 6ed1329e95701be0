//! Seats for the clients that open a link. One address cannot take all seats, even if its user passes a link on to
//! others.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use super::connections::Peer;

/// The share of the seats that one address may take: three of every four.
const OF_ONE: (usize, usize) = (3, 4);

/// The seats for clients, whose number is limited.
#[derive(Debug)]
pub(crate) struct Seats {
    most: usize,
    taken: Mutex<BTreeMap<Peer, usize>>,
}

/// A seat. Dropping the [`Seat`] frees the seat for another client.
#[derive(Debug)]
pub(crate) struct Seat {
    seats: Arc<Seats>,
    peer: Peer,
}

impl Seats {
    pub(crate) fn of(most: usize) -> Arc<Seats> {
        Arc::new(Seats { most, taken: Mutex::default() })
    }

    /// Takes a seat. The result is `None` if all seats are taken, or all seats that one address may take.
    pub(crate) fn take(self: &Arc<Seats>, peer: Peer) -> Option<Seat> {
        let mut taken = self.taken.lock().unwrap_or_else(PoisonError::into_inner);
        let (all, own): (usize, usize) =
            (taken.values().sum(), taken.get(&peer).copied().unwrap_or(0));
        if all >= self.most || own >= self.most * OF_ONE.0 / OF_ONE.1 {
            return None;
        }
        taken.insert(peer, own + 1);
        drop(taken);
        Some(Seat { seats: Arc::clone(self), peer })
    }
}

impl Drop for Seat {
    fn drop(&mut self) {
        let mut taken = self.seats.taken.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(own) = taken.get_mut(&self.peer) {
            *own -= 1;
            if *own == 0 {
                taken.remove(&self.peer);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_address_cannot_take_all_seats() {
        let peer = |text: &str| Peer::of(text.parse().expect("an address"));
        let seats = Seats::of(8);
        let mut connections: Vec<Seat> =
            (0..6).filter_map(|_| seats.take(peer("192.0.2.1"))).collect();
        assert!(connections.len() == 6 && seats.take(peer("192.0.2.1")).is_none());
        let other = seats.take(peer("192.0.2.2")).expect("a seat is free");
        assert!(seats.take(peer("192.0.2.3")).is_some());
        drop(other);
        connections.pop();
        assert!(seats.take(peer("192.0.2.1")).is_some());
    }
}
