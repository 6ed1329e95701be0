//! Finds where a TOML text is nested too deeply. The TOML parser reports that a text is nested too deeply, but not
//! where.

use crate::place::Span;

/// Deepest nesting of brackets and braces that the TOML parser accepts, and largest number of names in a dotted key.
const DEEPEST: usize = 80;

/// Place of the bracket, brace or dot that nests one level too deep; `None` if the text is not nested too deeply.
pub fn too_deep(text: &str) -> Option<Span> {
    let bytes = text.as_bytes();
    let (mut at, mut depth, mut dots) = (0, 0_usize, 0);
    while let Some(byte) = bytes.get(at) {
        match byte {
            b'"' | b'\'' => {
                at = after_string(bytes, at);
                continue;
            }
            b'#' => {
                at += bytes[at..].iter().take_while(|b| **b != b'\n').count();
                continue;
            }
            b'[' | b'{' => (depth, dots) = (depth + 1, 0),
            b']' | b'}' => (depth, dots) = (depth.saturating_sub(1), 0),
            b'\n' | b',' | b'=' => dots = 0,
            b'.' => dots += 1,
            _ => {}
        }
        if depth > DEEPEST || dots >= DEEPEST {
            return Some(at..at + 1);
        }
        at += 1;
    }
    None
}

/// The position after the string that begins with the quote at `start`; the end of the text if the string is not
/// closed.
fn after_string(bytes: &[u8], start: usize) -> usize {
    let quote = bytes[start];
    let is_long = bytes[start..].starts_with(&[quote; 3]);
    let mut at = start + if is_long { 3 } else { 1 };
    while let Some(byte) = bytes.get(at) {
        match byte {
            b'\\' if quote == b'"' => at += 1,
            b'\n' if !is_long => return at,
            byte if *byte == quote && !is_long => return at + 1,
            _ if is_long && bytes[at..].starts_with(&[quote; 3]) => return at + 3,
            _ => {}
        }
        at += 1;
    }
    bytes.len()
}

#[cfg(test)]
mod tests {
    use super::{DEEPEST, too_deep};

    #[test]
    fn the_first_bracket_or_dot_too_many_is_found() {
        let nested = format!("a = 1 # [[[\nb = {}", "[".repeat(DEEPEST + 1));
        assert_eq!(too_deep(&nested).map(|span| span.start), Some(nested.len() - 1));
        let dotted = format!("a = \"[\"\n{}b = 1", "a.".repeat(DEEPEST));
        assert_eq!(too_deep(&dotted).map(|span| span.start), Some(8 + 2 * DEEPEST - 1));
        let strings = format!("a = '''{0}'''\nb = \"\\\"{0}\"\nc = '{0}'", "[".repeat(200));
        assert_eq!(too_deep(&strings), None);
        assert_eq!(too_deep(&"a = [[1.5, 2.5], [3.5]]\n".repeat(100)), None);
    }
}
