//! Limits the number of connections to the server. A new connection always gets a place. If there are too many
//! connections, the address that has the most loses its oldest connection. A crowd of slow connections therefore shuts
//! nobody out, and loses its own places first.

use std::collections::BTreeMap;
use std::net::IpAddr;
use std::sync::{Arc, Mutex, PoisonError};

use tokio::sync::Notify;

/// A peer, whose connections are all counted together. A peer is one IPv4 address, or the /64 network of an IPv6
/// address.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Peer(u128);

impl Peer {
    pub(crate) fn of(address: IpAddr) -> Peer {
        Peer(match address.to_canonical() {
            IpAddr::V4(v4) => u128::from(v4.to_bits()),
            // An IPv4 address has none of these high bits.
            IpAddr::V6(v6) => v6.to_bits() >> 64 << 64 | 1 << 63,
        })
    }
}

/// The places for connections to the server, whose number is limited.
#[derive(Debug)]
pub(crate) struct Connections {
    most: usize,
    inside: Mutex<Inside>,
}

#[derive(Debug, Default)]
struct Inside {
    next: u64,
    /// The connections that hold a place, in the order in which they came.
    all: Vec<(u64, Peer, Arc<Notify>)>,
}

/// The place that one connection holds, of the limited number of places. Dropping the [`Place`] frees the place for
/// another connection.
#[derive(Debug)]
pub(crate) struct Place {
    connections: Arc<Connections>,
    number: u64,
    asked_out: Arc<Notify>,
}

impl Connections {
    pub(crate) fn of(most: usize) -> Arc<Connections> {
        Arc::new(Connections { most, inside: Mutex::default() })
    }

    /// Takes a place. If there is no free place, asks another connection to leave.
    pub(crate) fn enter(self: &Arc<Connections>, peer: Peer) -> Place {
        let asked_out = Arc::new(Notify::new());
        let mut inside = self.inside.lock().unwrap_or_else(PoisonError::into_inner);
        let number = inside.next;
        inside.next += 1;
        inside.all.push((number, peer, Arc::clone(&asked_out)));
        if inside.all.len() > self.most {
            let first = first_of_the_most(&inside.all);
            let (.., out) = inside.all.remove(first);
            out.notify_one();
        }
        drop(inside);
        Place { connections: Arc::clone(self), number, asked_out }
    }

    fn leave(&self, number: u64) {
        let mut inside = self.inside.lock().unwrap_or_else(PoisonError::into_inner);
        inside.all.retain(|(other, ..)| *other != number);
    }
}

impl Place {
    /// Waits until a new connection needs the place.
    pub(crate) async fn asked_out(&self) {
        self.asked_out.notified().await;
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        self.connections.leave(self.number);
    }
}

/// Index of the connection that leaves: the oldest of the address with the most connections.
fn first_of_the_most(all: &[(u64, Peer, Arc<Notify>)]) -> usize {
    let mut counts = BTreeMap::<Peer, usize>::new();
    for (_, peer, _) in all {
        *counts.entry(*peer).or_default() += 1;
    }
    let most = counts.values().copied().max().unwrap_or(0);
    all.iter().position(|(_, peer, _)| counts[peer] == most).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn peer(text: &str) -> Peer {
        Peer::of(text.parse().expect("an address"))
    }

    fn is_asked_out(place: &Place) -> bool {
        let now = std::pin::pin!(place.asked_out());
        let mut context = std::task::Context::from_waker(std::task::Waker::noop());
        now.poll(&mut context).is_ready()
    }

    #[test]
    fn a_new_connection_replaces_the_oldest_of_the_largest_peer() {
        let connections = Connections::of(4);
        let alone = connections.enter(peer("192.0.2.1"));
        let many: Vec<Place> = (0..3).map(|_| connections.enter(peer("192.0.2.2"))).collect();
        let newcomer = connections.enter(peer("192.0.2.3"));
        assert!(is_asked_out(&many[0]));
        assert!([&alone, &many[1], &many[2], &newcomer].iter().all(|place| !is_asked_out(place)));
        drop(many);
        let more: Vec<Place> = (0..2).map(|_| connections.enter(peer("192.0.2.4"))).collect();
        assert!(!is_asked_out(&alone) && !is_asked_out(&newcomer) && more.len() == 2);
    }

    #[test]
    fn an_ipv6_network_of_64_bits_is_one_peer() {
        assert_eq!(peer("2001:db8:1:2::1"), peer("2001:db8:1:2:ffff::9"));
        assert_ne!(peer("2001:db8:1:2::1"), peer("2001:db8:1:3::1"));
        assert_eq!(peer("::ffff:192.0.2.1"), peer("192.0.2.1"));
        assert_ne!(peer("192.0.2.1"), peer("192.0.2.2"));
    }
}
