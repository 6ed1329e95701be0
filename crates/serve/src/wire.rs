//! Sends the sentences of the ships' instruments to chart programs over TCP and UDP. The server reads nothing that
//! chart programs send.

use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use tokio::io::AsyncWriteExt as _;
use tokio::net::{TcpListener, TcpStream, UdpSocket};
use tokio::sync::watch;
use tokio::time::timeout;

use super::connections::{Connections, Peer};
use super::hub::{Hub, Sentences};

/// Largest number of chart programs that may be connected over TCP. If more connect, an old chart program is
/// disconnected (see `connections`).
const MOST: usize = 32;
/// A chart program is disconnected if it does not read one round of sentences within this time.
const SEND_TIMEOUT: Duration = Duration::from_secs(10);

/// Serves every chart program that connects over TCP.
pub(crate) async fn tcp(listener: TcpListener, hub: Arc<Hub>) {
    let connections = Connections::of(MOST);
    loop {
        let Ok((stream, from)) = listener.accept().await else {
            tokio::time::sleep(Duration::from_millis(100)).await;
            continue;
        };
        let place = connections.enter(Peer::of(from.ip()));
        let hub = Arc::clone(&hub);
        tokio::spawn(async move {
            tokio::select! {
                () = send_all(stream, hub.sentences.subscribe()) => {}
                () = place.asked_out() => hub.log.refused("a chart program was disconnected: there are too many \
                                                           of them"),
            }
        });
    }
}

async fn send_all(mut stream: TcpStream, mut sentences: watch::Receiver<Sentences>) {
    while sentences.changed().await.is_ok() {
        let text = sentences.borrow_and_update().as_ref().map(|round| round.concat());
        let Some(text) = text else { continue };
        if !matches!(timeout(SEND_TIMEOUT, stream.write_all(text.as_bytes())).await, Ok(Ok(()))) {
            return;
        }
    }
}

/// Sends every instrument sentence as a separate datagram.
pub(crate) async fn udp(socket: UdpSocket, to: SocketAddr, hub: Arc<Hub>) {
    let mut sentences = hub.sentences.subscribe();
    while sentences.changed().await.is_ok() {
        let round = sentences.borrow_and_update().clone();
        for sentence in round.iter().flat_map(|round| round.iter()) {
            // A missing receiver is not an error: the chart program may start later.
            let _ = socket.send_to(sentence.as_bytes(), to).await;
        }
    }
}
