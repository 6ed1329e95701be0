//! Sentences over TCP and UDP, for chart programs. Only out: what they say is not read.

use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use tokio::io::AsyncWriteExt as _;
use tokio::net::{TcpListener, TcpStream, UdpSocket};
use tokio::sync::watch;
use tokio::time::timeout;

use super::crowd::{Crowd, Peer};
use super::hub::{Hub, Said};

/// Chart programs at a time, the one that has been there for longest goes beyond it; and how long one may take nothing.
const MOST: usize = 32;
const SLOW: Duration = Duration::from_secs(10);

/// Serves who connects; a connection that takes nothing is closed.
pub(crate) async fn tcp(listener: TcpListener, hub: Arc<Hub>) {
    let crowd = Crowd::of(MOST);
    loop {
        let Ok((stream, from)) = listener.accept().await else {
            tokio::time::sleep(Duration::from_millis(100)).await;
            continue;
        };
        let place = crowd.enter(Peer::of(from.ip()));
        let hub = Arc::clone(&hub);
        tokio::spawn(async move {
            tokio::select! {
                () = tell(stream, hub.said.subscribe()) => {}
                () = place.asked_out() => hub.log.refused("ended a chart program: there are too many of them"),
            }
        });
    }
}

async fn tell(mut stream: TcpStream, mut said: watch::Receiver<Said>) {
    while said.changed().await.is_ok() {
        let text = said.borrow_and_update().as_ref().map(|all| all.concat());
        let Some(text) = text else { continue };
        if !matches!(timeout(SLOW, stream.write_all(text.as_bytes())).await, Ok(Ok(()))) {
            return;
        }
    }
}

/// Sends every sentence as a datagram of its own.
pub(crate) async fn udp(socket: UdpSocket, to: SocketAddr, hub: Arc<Hub>) {
    let mut said = hub.said.subscribe();
    while said.changed().await.is_ok() {
        let all = said.borrow_and_update().clone();
        for sentence in all.iter().flat_map(|all| all.iter()) {
            // Nobody there is no mistake: they may come yet.
            let _ = socket.send_to(sentence.as_bytes(), to).await;
        }
    }
}
