//! Checks the headers `Host` and `Origin` of a request.

use std::net::IpAddr;

use axum::http::HeaderMap;
use axum::http::header::{HOST, ORIGIN};

/// The hosts for which the server answers requests.
#[derive(Clone, Debug)]
pub(crate) struct KnownHosts {
    /// True if any IP address is accepted as `Host`. If false, only loopback addresses are accepted.
    pub(crate) remote: bool,
    /// Further host names that are accepted, without ports.
    pub(crate) names: Vec<String>,
}

impl KnownHosts {
    /// Checks the header `Host` of a request and returns it. Accepted are `localhost`, the names that the user gave,
    /// loopback addresses, and with `remote` all IP addresses. The check refuses DNS rebinding, in which another site's
    /// name points to this machine: such a request has the site's own name as `Host`.
    ///
    /// # Errors
    /// The error is the reason why the request is refused.
    pub(crate) fn host<'h>(&self, headers: &'h HeaderMap) -> Result<&'h str, &'static str> {
        let mut all = headers.get_all(HOST).iter();
        let (Some(host), None) = (all.next(), all.next()) else {
            return Err("a request needs exactly one header Host");
        };
        let host = host.to_str().map_err(|_| "malformed Host")?;
        let name = without_port(host).ok_or("malformed Host")?;
        let is_known = name.eq_ignore_ascii_case("localhost")
            || self.names.iter().any(|known| known.eq_ignore_ascii_case(name));
        let address = name.trim_start_matches('[').trim_end_matches(']').parse::<IpAddr>();
        let is_address = address.is_ok_and(|address| self.remote || address.is_loopback());
        if is_known || is_address {
            Ok(host)
        } else {
            Err("this server does not answer requests with that Host")
        }
    }

    /// Checks that a websocket is opened by a page of this server or by a program. Programs send no `Origin`, and need
    /// a token as pages do.
    ///
    /// # Errors
    /// The error is the reason why the websocket is refused.
    pub(crate) fn origin(&self, headers: &HeaderMap) -> Result<(), &'static str> {
        let host = self.host(headers)?;
        for origin in headers.get_all(ORIGIN) {
            let own = origin.to_str().ok().and_then(|origin| {
                origin.strip_prefix("http://").or_else(|| origin.strip_prefix("https://"))
            });
            if own != Some(host) {
                return Err("a page of another origin may not open a websocket");
            }
        }
        Ok(())
    }
}

/// The host without its port. An IPv6 address keeps its brackets when its port is taken off.
fn without_port(host: &str) -> Option<&str> {
    let name = match host.rfind(']') {
        Some(end) => &host[..=end],
        None => host.split(':').next()?,
    };
    let port = host[name.len()..].strip_prefix(':');
    let rest_is_port = match port {
        Some(port) => port.parse::<u16>().is_ok(),
        None => host.len() == name.len(),
    };
    (rest_is_port && !name.is_empty()).then_some(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn headers(host: &str, origin: Option<&str>) -> HeaderMap {
        let mut headers = HeaderMap::new();
        headers.insert(HOST, host.parse().expect("a value"));
        if let Some(origin) = origin {
            headers.insert(ORIGIN, origin.parse().expect("a value"));
        }
        headers
    }

    #[test]
    fn only_own_hosts_and_pages_are_accepted() {
        let local = KnownHosts { remote: false, names: vec![] };
        let remote = KnownHosts { remote: true, names: vec!["bridge.example".into()] };
        for (host, by_local, by_remote) in [
            ("localhost:8090", true, true),
            ("127.0.0.1:8090", true, true),
            ("[::1]:8090", true, true),
            ("LOCALHOST", true, true),
            ("192.168.1.7:8090", false, true),
            ("bridge.example:8090", false, true),
            ("evil.example", false, false),
            ("localhost.evil.example:8090", false, false),
            ("127.0.0.1.evil.example", false, false),
            ("localhost:8090:1", false, false),
            ("localhost:x", false, false),
            ("", false, false),
            ("[::1", false, false),
        ] {
            assert_eq!(local.host(&headers(host, None)).is_ok(), by_local, "{host}");
            assert_eq!(remote.host(&headers(host, None)).is_ok(), by_remote, "{host}");
        }
        for (origin, is_accepted) in [
            (None, true),
            (Some("http://localhost:8090"), true),
            (Some("http://localhost:8091"), false),
            (Some("http://evil.example"), false),
            (Some("null"), false),
            (Some("http://localhost:8090.evil.example"), false),
        ] {
            assert_eq!(
                local.origin(&headers("localhost:8090", origin)).is_ok(),
                is_accepted,
                "{origin:?}"
            );
        }
        assert!(local.host(&HeaderMap::new()).is_err());
    }
}
