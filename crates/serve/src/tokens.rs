//! Tokens: the secret in each link, and the role that the link opens.

use fenderline_live::message::{Link, Role};
use subtle::ConstantTimeEq as _;

use crate::kept_seats::KeptLink;

/// A token: a role and its secret of 128 bits from the operating system, in hexadecimal.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Token {
    role: Role,
    secret: String,
}

/// The tokens of a server, in the order in which their links are shown.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tokens(Vec<Token>);

impl Tokens {
    /// Makes tokens for the roles that have no token yet. A role that is not in the present scenario keeps its token,
    /// for the next scenario that has the role.
    ///
    /// # Errors
    /// Fails if the operating system gives no random numbers.
    pub(crate) fn add(&mut self, roles: &[Role]) -> Result<(), getrandom::Error> {
        for role in roles {
            if self.0.iter().any(|token| token.role == *role) {
                continue;
            }
            let mut bytes = [0_u8; 16];
            getrandom::fill(&mut bytes)?;
            let secret = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
            self.0.push(Token { role: role.clone(), secret });
        }
        Ok(())
    }

    /// Restores the secrets of a former run of the session, for the roles that have no token yet.
    pub(crate) fn restore(&mut self, links: &[KeptLink]) {
        for KeptLink { role, secret } in links {
            if self.0.iter().all(|token| token.role != *role) {
                self.0.push(Token { role: role.clone(), secret: secret.clone() });
            }
        }
    }

    /// All secrets with their roles, for the file that keeps the links.
    pub(crate) fn kept(&self) -> Vec<KeptLink> {
        let link =
            |token: &Token| KeptLink { role: token.role.clone(), secret: token.secret.clone() };
        self.0.iter().map(link).collect()
    }

    /// The role that a token opens. Comparing tokens takes the same time for all texts, so that an attacker cannot find
    /// a token digit by digit by measuring how long the answer takes.
    pub(crate) fn role(&self, text: &str) -> Option<Role> {
        let mut found = None;
        for token in &self.0 {
            if token.secret.as_bytes().ct_eq(text.as_bytes()).into() {
                found = Some(&token.role);
            }
        }
        found.cloned()
    }

    /// Links to the pages for the given roles, as paths with a token.
    pub(crate) fn links(&self, roles: &[Role]) -> Vec<Link> {
        let wanted = self.0.iter().filter(|token| roles.contains(&token.role));
        let link = |token: &Token| Link {
            role: token.role.clone(),
            path: format!("/?token={}", token.secret),
        };
        wanted.map(link).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_token_opens_its_role_only() {
        let tug = Role::Tugmaster { tug: "a".into() };
        let mut tokens = Tokens::default();
        let roles = [Role::Instructor, Role::PILOT, tug.clone()];
        tokens.add(&roles).expect("random numbers");
        tokens.add(&roles).expect("random numbers");
        let links = tokens.links(&roles);
        assert_eq!(links.len(), 3);
        for link in &links {
            let secret = link.path.strip_prefix("/?token=").expect("a token");
            assert_eq!((secret.len(), tokens.role(secret)), (32, Some(link.role.clone())));
            assert_eq!(tokens.role(&secret[1..]), None);
            assert_eq!(tokens.role(&secret.to_uppercase().replace('A', "b")), None);
        }
        assert_eq!(tokens.role(""), None);
        assert_eq!(tokens.links(&[tug]).len(), 1);
    }
}
