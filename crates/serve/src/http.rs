//! Serves the files of the page over HTTP, and opens websockets.

use std::pin::Pin;
use std::sync::{Arc, PoisonError};
use std::time::Duration;

use axum::body::{Body, Bytes};
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
use fenderline_live::message::Role;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::{TcpListener, TcpStream};
use tokio::time::timeout;

use super::client;
use super::connections::{Connections, Peer};
use super::hub::{Hub, Kind};
use super::known_hosts::KnownHosts;
use super::page::Page;

/// Largest number of connections that are not websockets yet. If there are more connections that are not websockets, an
/// old one is closed (see `connections`).
const MOST_CONNECTIONS: usize = 256;
/// Largest number of websockets that are open only to be told why they are closed.
const MOST_TURNED_AWAY: usize = 64;
/// Time limits: one for the head of a request, one for a whole connection until it is answered or becomes a websocket.
const HEAD_TIMEOUT: Duration = Duration::from_secs(5);
const CONNECTION_TIMEOUT: Duration = Duration::from_secs(30);
/// The largest message that a page may send (bytes).
const LARGEST_MESSAGE: usize = 16 << 10;
/// Largest number of bytes that wait to be written to one websocket.
const MOST_WAITING: usize = 4 << 20;

/// The data that the answer to every request needs.
pub(crate) struct Site {
    pub(crate) hub: Arc<Hub>,
    pub(crate) page: Page,
    pub(crate) known_hosts: KnownHosts,
    /// Websockets that are open only to be told why they are closed.
    pub(crate) turned_away: Arc<Connections>,
}

impl Site {
    pub(crate) fn new(hub: Arc<Hub>, page: Page, known_hosts: KnownHosts) -> Site {
        Site { hub, page, known_hosts, turned_away: Connections::of(MOST_TURNED_AWAY) }
    }
}

/// Accepts connections until the task is dropped.
pub(crate) async fn serve(listener: TcpListener, site: Arc<Site>) {
    let app = Router::new()
        .route("/live", any(live))
        .route("/report", any(report))
        .route("/model", any(model))
        .fallback(file)
        .with_state(Arc::clone(&site));
    let connections = Connections::of(MOST_CONNECTIONS);
    loop {
        let (stream, peer) = match listener.accept().await {
            Ok((stream, from)) => (stream, Peer::of(from.ip())),
            Err(e) => {
                // Most likely no file descriptors are left. They become free as connections end.
                site.hub.log.refused(&format!("the server cannot accept a connection: {e}"));
                tokio::time::sleep(Duration::from_millis(100)).await;
                continue;
            }
        };
        let place = connections.enter(peer);
        let (app, site) = (app.clone(), Arc::clone(&site));
        tokio::spawn(async move {
            tokio::select! {
                _ = timeout(CONNECTION_TIMEOUT, connection(stream, app, peer)) => {}
                () = place.asked_out() => {
                    site.hub.log.refused("a connection was ended: the server has too many of them");
                }
            }
        });
    }
}

/// Serves one connection until it is answered or becomes a websocket.
async fn connection(stream: TcpStream, app: Router, peer: Peer) {
    // Sends small frames at once.
    let _ = stream.set_nodelay(true);
    let app = app.layer(Extension(peer));
    let _ = hyper::server::conn::http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(HEAD_TIMEOUT)
        .max_buf_size(LARGEST_MESSAGE)
        .serve_connection(TokioIo::new(stream), TowerToHyperService::new(app))
        .with_upgrades()
        .await;
}

fn refused(site: &Site, why: &'static str) -> Response {
    site.hub.log.refused(&format!("refused a request: {why}"));
    plain(StatusCode::FORBIDDEN, why)
}

/// An answer that is one line of text. A header tells browsers to treat the answer as plain text.
fn plain(status: StatusCode, text: &'static str) -> Response {
    (status, [(X_CONTENT_TYPE_OPTIONS, "nosniff"), (CONNECTION, "close")], text).into_response()
}

/// Opens a websocket for a page of this server or for a program. Both need a token.
async fn live(
    State(site): State<Arc<Site>>,
    Extension(peer): Extension<Peer>,
    headers: HeaderMap,
    uri: Uri,
    upgrade: WebSocketUpgrade,
) -> Response {
    if let Err(why) = site.known_hosts.origin(&headers) {
        return refused(&site, why);
    }
    let upgrade = upgrade
        .max_message_size(LARGEST_MESSAGE)
        .max_frame_size(LARGEST_MESSAGE)
        .read_buffer_size(LARGEST_MESSAGE)
        .write_buffer_size(0)
        .max_write_buffer_size(MOST_WAITING);
    let Some(role) = role(&site, &uri) else {
        site.hub.log.refused("a websocket was refused: its token is unknown");
        return upgrade.on_upgrade(turn_away(&site, peer, client::turn_away));
    };
    let Some(seat) = site.hub.seat(&role, peer) else {
        site.hub.log.refused("a client was refused: all seats are taken");
        return upgrade.on_upgrade(turn_away(&site, peer, client::turn_away_full));
    };
    let hub = Arc::clone(&site.hub);
    let kind = if is_program(&uri) { Kind::Program } else { Kind::Page };
    upgrade.on_upgrade(async move |socket| {
        client::serve(socket, hub, role, kind).await;
        drop(seat);
    })
}

/// The role that belongs to the token in an address.
fn role(site: &Site, uri: &Uri) -> Option<Role> {
    let token = value(uri, "token=");
    let tokens = site.hub.tokens.read().unwrap_or_else(PoisonError::into_inner);
    tokens.role(token.unwrap_or(""))
}

/// What follows `name` in the query of an address.
fn value<'u>(uri: &'u Uri, name: &str) -> Option<&'u str> {
    uri.query().unwrap_or("").split('&').find_map(|pair| pair.strip_prefix(name))
}

/// True if the client says by its address that it is a program, so that people take controls from it.
fn is_program(uri: &Uri) -> bool {
    uri.query().unwrap_or("").split('&').any(|pair| pair == "program=1")
}

/// Sends the report that the instructor asked for last. The command `report` makes this report. Because the command
/// made the report, fetching it costs no more than sending its bytes.
async fn report(State(site): State<Arc<Site>>, request: Request) -> Response {
    if let Err(why) = site.known_hosts.host(request.headers()) {
        return refused(&site, why);
    }
    if !matches!(*request.method(), Method::GET | Method::HEAD) {
        return plain(StatusCode::METHOD_NOT_ALLOWED, "only the methods GET and HEAD are allowed");
    }
    if role(&site, request.uri()) != Some(Role::Instructor) {
        return refused(&site, "only the instructor's link opens the report");
    }
    let latest = site.hub.report.read().unwrap_or_else(PoisonError::into_inner).clone();
    let Some(latest) = latest else {
        return plain(
            StatusCode::NOT_FOUND,
            "no report was made yet: the instructor's page makes one",
        );
    };
    // The report carries its style and script, and loads nothing.
    let policy = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:; \
                  base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
    let headers = [
        (CONTENT_TYPE, "text/html; charset=utf-8"),
        (CONTENT_SECURITY_POLICY, policy),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (REFERRER_POLICY, "no-referrer"),
        (CACHE_CONTROL, "no-store"),
        (CONNECTION, "close"),
    ];
    (headers, Body::from(latest.as_bytes().to_vec())).into_response()
}

/// Sends the model of a vessel, as the scenario gives it, for the view out of the window: `/model?token=…&vessel=N`.
async fn model(State(site): State<Arc<Site>>, request: Request) -> Response {
    if let Err(why) = site.known_hosts.host(request.headers()) {
        return refused(&site, why);
    }
    if !matches!(*request.method(), Method::GET | Method::HEAD) {
        return plain(StatusCode::METHOD_NOT_ALLOWED, "only the methods GET and HEAD are allowed");
    }
    if role(&site, request.uri()).is_none() {
        return refused(&site, "only the links of the session open its models");
    }
    let vessel = value(request.uri(), "vessel=").and_then(|number| number.parse::<usize>().ok());
    let models = site.hub.models.read().unwrap_or_else(PoisonError::into_inner);
    let Some(Some(model)) = vessel.and_then(|vessel| models.get(vessel)) else {
        return plain(StatusCode::NOT_FOUND, "the session has no model of such a vessel");
    };
    let headers = [
        (CONTENT_TYPE, "model/gltf-binary"),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (REFERRER_POLICY, "no-referrer"),
        (CACHE_CONTROL, "no-store"),
        (CONNECTION, "close"),
    ];
    (headers, Body::from(Bytes::from_owner(Arc::clone(&model.bytes)))).into_response()
}

/// Closes a websocket by the function `close`, which tells the client the reason. If too many other websockets are
/// being closed, closes the websocket without telling the reason.
fn turn_away<F: Future<Output = ()> + Send + 'static>(
    site: &Site,
    peer: Peer,
    close: impl FnOnce(WebSocket) -> F + Send + 'static,
) -> impl FnOnce(WebSocket) -> Pin<Box<dyn Future<Output = ()> + Send>> + Send + 'static {
    let place = site.turned_away.enter(peer);
    move |socket| {
        Box::pin(async move {
            tokio::select! {
                () = close(socket) => {}
                () = place.asked_out() => {}
            }
        })
    }
}

/// Sends a file of the page.
async fn file(State(site): State<Arc<Site>>, request: Request) -> Response {
    let host = match site.known_hosts.host(request.headers()) {
        Ok(host) => host,
        Err(why) => return refused(&site, why),
    };
    if !matches!(*request.method(), Method::GET | Method::HEAD) {
        return plain(StatusCode::METHOD_NOT_ALLOWED, "only the methods GET and HEAD are allowed");
    }
    let Some(file) = site.page.file(request.uri().path()) else {
        return plain(StatusCode::NOT_FOUND, "the page has no such file");
    };
    // The page loads nothing from other sites: no script, no frame, no form. The policy contains the address of the
    // websocket because older browsers do not count it as `self`. It contains `unsafe-inline` because the page's
    // scripts set styles of elements, and `blob:` because the pictures on a model of a ship are parts of its file.
    let policy = format!(
        "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; \
         font-src 'self'; connect-src 'self' blob: ws://{host} wss://{host}; manifest-src 'self'; \
         base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    );
    let headers = [
        (CONTENT_TYPE, file.content_type),
        (CONTENT_SECURITY_POLICY, policy.as_str()),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        // The page's address contains a token.
        (REFERRER_POLICY, "no-referrer"),
        (CACHE_CONTROL, "no-cache"),
        // Makes room for the next connection.
        (CONNECTION, "close"),
    ];
    (headers, Body::from(file.bytes.clone())).into_response()
}
