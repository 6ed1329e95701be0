//! Sentences over TCP and UDP, for chart programs. Only out: what they say is not read.

use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use tokio::io::AsyncWriteExt as _;
use tokio::net::{TcpListener, TcpStream, UdpSocket};
use tokio::sync::{Semaphore, watch};
use tokio::time::timeout;

use super::hub::Hub;

/// Chart programs at a time, and how long one may take nothing.
const MOST: usize = 16;
const SLOW: Duration = Duration::from_secs(10);

/// The sentences of the last second.
pub(crate) type Said = Option<Arc<[String]>>;

/// Serves who connects; a connection that takes nothing is closed.
pub(crate) async fn tcp(listener: TcpListener, hub: Arc<Hub>) {
    let places = Arc::new(Semaphore::new(MOST));
    loop {
        let Ok((stream, _)) = listener.accept().await else {
            tokio::time::sleep(Duration::from_millis(100)).await;
            continue;
        };
        let Ok(place) = Arc::clone(&places).try_acquire_owned() else {
            hub.log.refused("refused a chart program: too many of them");
            continue;
        };
        let said = hub.said.subscribe();
        tokio::spawn(async move {
            tell(stream, said).await;
            drop(place);
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
