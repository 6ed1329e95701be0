//! HTTP: the page's files, and the way to the websocket.

use std::pin::Pin;
use std::sync::{Arc, PoisonError};
use std::time::Duration;

use axum::body::Body;
use axum::extract::ws::{WebSocket, WebSocketUpgrade};
use axum::extract::{Request, State};
use axum::http::header::{
    CACHE_CONTROL, CONNECTION, CONTENT_SECURITY_POLICY, CONTENT_TYPE, REFERRER_POLICY,
    X_CONTENT_TYPE_OPTIONS,
};
use axum::http::{HeaderMap, Method, StatusCode, Uri};
use axum::response::{IntoResponse as _, Response};
use axum::routing::any;
use axum::{Extension, Router};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::{TcpListener, TcpStream};
use tokio::time::timeout;

use super::client;
use super::crowd::{Crowd, Peer};
use super::door::Door;
use super::hub::Hub;
use super::page::Page;

/// Connections that are not websockets yet, at a time: beyond it the one that has waited for longest goes.
const MOST_CONNECTIONS: usize = 256;
/// Websockets that are being told why they are closed, at a time.
const MOST_TURNED_AWAY: usize = 64;
/// The time for a request's head, and for a whole connection up to its answer or its websocket.
const HEAD: Duration = Duration::from_secs(5);
const WHOLE: Duration = Duration::from_secs(30);
/// The largest message of a page (bytes).
const LARGEST_MESSAGE: usize = 16 << 10;
/// What waits to be written to one websocket at most (bytes).
const MOST_WAITING: usize = 4 << 20;

/// What every request needs.
pub(crate) struct Site {
    pub(crate) hub: Arc<Hub>,
    pub(crate) page: Page,
    pub(crate) door: Door,
    /// Those whose websocket is opened only to be told why it is closed.
    pub(crate) turned_away: Arc<Crowd>,
}

impl Site {
    pub(crate) fn new(hub: Arc<Hub>, page: Page, door: Door) -> Site {
        Site { hub, page, door, turned_away: Crowd::of(MOST_TURNED_AWAY) }
    }
}

/// Serves until the task is dropped.
pub(crate) async fn serve(listener: TcpListener, site: Arc<Site>) {
    let app = Router::new().route("/live", any(live)).fallback(file).with_state(Arc::clone(&site));
    let crowd = Crowd::of(MOST_CONNECTIONS);
    loop {
        let (stream, peer) = match listener.accept().await {
            Ok((stream, from)) => (stream, Peer::of(from.ip())),
            Err(e) => {
                // Out of file descriptors, most likely: they come back as connections end.
                site.hub.log.refused(&format!("cannot accept a connection: {e}"));
                tokio::time::sleep(Duration::from_millis(100)).await;
                continue;
            }
        };
        let place = crowd.enter(peer);
        let (app, site) = (app.clone(), Arc::clone(&site));
        tokio::spawn(async move {
            tokio::select! {
                _ = timeout(WHOLE, connection(stream, app, peer)) => {}
                () = place.asked_out() => {
                    site.hub.log.refused("ended a connection: there are too many of them");
                }
            }
        });
    }
}

/// One connection, up to its answer or its websocket.
async fn connection(stream: TcpStream, app: Router, peer: Peer) {
    // Small frames at once.
    let _ = stream.set_nodelay(true);
    let app = app.layer(Extension(peer));
    let _ = hyper::server::conn::http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(HEAD)
        .max_buf_size(LARGEST_MESSAGE)
        .serve_connection(TokioIo::new(stream), TowerToHyperService::new(app))
        .with_upgrades()
        .await;
}

fn refused(site: &Site, why: &'static str) -> Response {
    site.hub.log.refused(&format!("refused a request: {why}"));
    plain(StatusCode::FORBIDDEN, why)
}

/// A line of text, and nothing else that a browser might take it for.
fn plain(status: StatusCode, text: &'static str) -> Response {
    (status, [(X_CONTENT_TYPE_OPTIONS, "nosniff"), (CONNECTION, "close")], text).into_response()
}

/// The websocket: own pages and programs with a token.
async fn live(
    State(site): State<Arc<Site>>,
    Extension(peer): Extension<Peer>,
    headers: HeaderMap,
    uri: Uri,
    upgrade: WebSocketUpgrade,
) -> Response {
    if let Err(why) = site.door.origin(&headers) {
        return refused(&site, why);
    }
    let upgrade = upgrade
        .max_message_size(LARGEST_MESSAGE)
        .max_frame_size(LARGEST_MESSAGE)
        .read_buffer_size(LARGEST_MESSAGE)
        .write_buffer_size(0)
        .max_write_buffer_size(MOST_WAITING);
    let token = uri.query().unwrap_or("").split('&').find_map(|pair| pair.strip_prefix("token="));
    let role = {
        let tokens = site.hub.tokens.read().unwrap_or_else(PoisonError::into_inner);
        tokens.role(token.unwrap_or(""))
    };
    let Some(role) = role else {
        site.hub.log.refused("refused a websocket: its token opens nothing");
        return upgrade.on_upgrade(told_and_closed(&site, peer, client::turn_away));
    };
    let Some(seat) = site.hub.seat(&role, peer) else {
        site.hub.log.refused("refused a client: all seats are taken");
        return upgrade.on_upgrade(told_and_closed(&site, peer, client::full));
    };
    let hub = Arc::clone(&site.hub);
    upgrade.on_upgrade(async move |socket| {
        client::serve(socket, hub, role).await;
        drop(seat);
    })
}

/// Tells a websocket why it is closed; not longer than there is room for those.
fn told_and_closed<F: Future<Output = ()> + Send + 'static>(
    site: &Site,
    peer: Peer,
    tell: impl FnOnce(WebSocket) -> F + Send + 'static,
) -> impl FnOnce(WebSocket) -> Pin<Box<dyn Future<Output = ()> + Send>> + Send + 'static {
    let place = site.turned_away.enter(peer);
    move |socket| {
        Box::pin(async move {
            tokio::select! {
                () = tell(socket) => {}
                () = place.asked_out() => {}
            }
        })
    }
}

/// A file of the page.
async fn file(State(site): State<Arc<Site>>, request: Request) -> Response {
    let host = match site.door.host(request.headers()) {
        Ok(host) => host,
        Err(why) => return refused(&site, why),
    };
    if !matches!(*request.method(), Method::GET | Method::HEAD) {
        return plain(StatusCode::METHOD_NOT_ALLOWED, "pages are only read");
    }
    let Some(file) = site.page.file(request.uri().path()) else {
        return plain(StatusCode::NOT_FOUND, "there is no such file");
    };
    // Nothing from elsewhere: no script, no frame, no form. The websocket's address is named, as older browsers do
    // not count it as one's own. Styles are set by scripts, on elements.
    let policy = format!(
        "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; \
         font-src 'self'; connect-src 'self' ws://{host} wss://{host}; manifest-src 'self'; \
         base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    );
    let headers = [
        (CONTENT_TYPE, file.content_type),
        (CONTENT_SECURITY_POLICY, policy.as_str()),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        // The address has a token in it.
        (REFERRER_POLICY, "no-referrer"),
        (CACHE_CONTROL, "no-cache"),
        // A place for the next one.
        (CONNECTION, "close"),
    ];
    (headers, Body::from(file.bytes.clone())).into_response()
}
