//! Who gets in: `Host` and `Origin` of a request.

use std::net::IpAddr;

use axum::http::HeaderMap;
use axum::http::header::{HOST, ORIGIN};

/// Which hosts this server answers to.
#[derive(Clone, Debug)]
pub(crate) struct Door {
    /// Beyond loopback: other addresses than that are answered to.
    pub(crate) remote: bool,
    /// Names besides, without ports.
    pub(crate) names: Vec<String>,
}

impl Door {
    /// Checks a request's `Host`: `localhost`, a name that was given, a loopback address, or any address where others
    /// are let in. A page of another site that has its name point here is thus refused: it has a name. The host.
    ///
    /// # Errors
    /// Why it is refused.
    pub(crate) fn host<'h>(&self, headers: &'h HeaderMap) -> Result<&'h str, &'static str> {
        let mut all = headers.get_all(HOST).iter();
        let (Some(host), None) = (all.next(), all.next()) else {
            return Err("one Host is needed");
        };
        let host = host.to_str().map_err(|_| "no such Host")?;
        let name = without_port(host).ok_or("no such Host")?;
        let is_known = name.eq_ignore_ascii_case("localhost")
            || self.names.iter().any(|known| known.eq_ignore_ascii_case(name));
        let address = name.trim_start_matches('[').trim_end_matches(']').parse::<IpAddr>();
        let is_address = address.is_ok_and(|address| self.remote || address.is_loopback());
        if is_known || is_address {
            Ok(host)
        } else {
            Err("this server does not answer to that Host")
        }
    }

    /// Checks that a websocket was opened by a page of this server, or by no page at all: programs send no `Origin`,
    /// and need a token like everybody.
    ///
    /// # Errors
    /// Why it is refused.
    pub(crate) fn origin(&self, headers: &HeaderMap) -> Result<(), &'static str> {
        let host = self.host(headers)?;
        for origin in headers.get_all(ORIGIN) {
            let own = origin.to_str().ok().and_then(|origin| {
                origin.strip_prefix("http://").or_else(|| origin.strip_prefix("https://"))
            });
            if own != Some(host) {
                return Err("a page of another origin opens no websocket here");
            }
        }
        Ok(())
    }
}

/// The host without its port, brackets of an IPv6 address kept.
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
    fn only_our_own_hosts_and_pages_get_in() {
        let near = Door { remote: false, names: vec![] };
        let far = Door { remote: true, names: vec!["bridge.example".into()] };
        for (host, by_near, by_far) in [
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
            assert_eq!(near.host(&headers(host, None)).is_ok(), by_near, "{host}");
            assert_eq!(far.host(&headers(host, None)).is_ok(), by_far, "{host}");
        }
        for (origin, gets_in) in [
            (None, true),
            (Some("http://localhost:8090"), true),
            (Some("http://localhost:8091"), false),
            (Some("http://evil.example"), false),
            (Some("null"), false),
            (Some("http://localhost:8090.evil.example"), false),
        ] {
            assert_eq!(
                near.origin(&headers("localhost:8090", origin)).is_ok(),
                gets_in,
                "{origin:?}"
            );
        }
        assert!(near.host(&HeaderMap::new()).is_err());
    }
}
