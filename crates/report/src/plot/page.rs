//! The page around charts and tables: one file without external resources.

use core::fmt::Write as _;

use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// A whole page with `title` and `body`, and the title at the foot of each printed page. The page contains its style
/// and script, loads nothing, and is complete without scripts.
pub fn page(title: &str, body: &Markup) -> String {
    page_of(title, title, body)
}

/// Makes a page like [`page`], with `footer` at the foot of each printed page, beside the page number.
pub fn page_of(title: &str, footer: &str, body: &Markup) -> String {
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta http-equiv="Content-Security-Policy"
                    content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:";
                title { (title) }
                style { (PreEscaped(STYLE)) (PreEscaped(footer_style(footer))) }
            }
            body {
                main { (body) }
                script { (PreEscaped(SCRIPT)) }
            }
        }
    }
    .into_string()
}

/// The CSS rule that prints `text` at the foot of each printed page.
fn footer_style(text: &str) -> String {
    let mut rule = String::from("@page { @bottom-left { content: \"");
    for c in text.chars() {
        if c.is_ascii_alphanumeric() || " .,:()/·–".contains(c) {
            rule.push(c);
        } else {
            // An escape of CSS: the text can end neither the string nor the style.
            let _ = write!(rule, "\\{:x} ", u32::from(c));
        }
    }
    rule.push_str("\"; } }");
    rule
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_text_ends_the_style_that_prints_it() {
        let rule = footer_style("a\"</style>\\ é");
        assert_eq!(
            rule,
            "@page { @bottom-left { content: \"a\\22 \\3c /style\\3e \\5c  \\e9 \"; } }"
        );
    }
}
