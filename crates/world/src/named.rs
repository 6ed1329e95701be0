//! Names of bodies, fenders and other things of a set-up, as sentences use them.

/// A name with the kind of the named thing before it, as in `Fender north`, unless the name already begins with this
/// kind, as in `fender_9`.
#[must_use]
pub fn called(kind: &str, name: &str) -> String {
    let begins = name.get(..kind.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(kind));
    if begins { name.to_owned() } else { format!("{kind} {name}") }
}

#[cfg(test)]
mod tests {
    use super::called;

    #[test]
    fn a_name_is_not_said_twice() {
        assert_eq!(called("Fender", "north"), "Fender north");
        assert_eq!(called("Fender", "fender_9"), "fender_9");
        assert_eq!(called("fender", "Fender 9"), "Fender 9");
        assert_eq!(called("Line", "é"), "Line é");
        assert_eq!(called("Fender", "fend"), "Fender fend");
    }
}
