//! Guides whose snippets are one program, and say what it prints.

/// A guide.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Guide {
    /// All snippets of the language, in order.
    pub(crate) program: String,
    /// The last block of the kind `text`.
    printed: String,
}

impl Guide {
    /// The snippets of `language` in a Markdown text: what stands between a line of three backticks with the
    /// language behind them and one of three backticks alone.
    ///
    /// # Errors
    /// No such snippet, none of what is printed, or one without an end.
    pub(crate) fn read(text: &str, language: &str) -> Result<Guide, String> {
        let (mut program, mut printed) = (String::new(), String::new());
        let mut within: Option<&str> = None;
        for line in text.lines() {
            match (within, line.strip_prefix("```")) {
                (None, Some(kind)) => {
                    within = Some(kind);
                    if kind == "text" {
                        printed.clear();
                    }
                }
                (Some(_), Some("")) => within = None,
                (Some(kind), _) if kind == language => program += &format!("{line}\n"),
                (Some("text"), _) => printed += &format!("{line}\n"),
                _ => {}
            }
        }
        if within.is_some() || program.is_empty() || printed.is_empty() {
            return Err(format!(
                "the guide has no whole program in {language}, or not what it prints"
            ));
        }
        Ok(Guide { program, printed })
    }

    /// Did the program print what the guide says?
    ///
    /// # Errors
    /// Both texts.
    pub(crate) fn expects(&self, printed: &str) -> Result<(), String> {
        if printed == self.printed {
            return Ok(());
        }
        Err(format!(
            "the guide says that its program prints\n{}\nit prints\n{printed}",
            self.printed
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::Guide;

    #[test]
    fn snippets_of_one_language_are_one_program() {
        let text = "Do\n```c\nint main(void)\n{\n```\nand\n```c\n}\n```\nby\n```sh\ncc\n```\nIt prints\n```text\n1\n```\n";
        let guide = Guide::read(text, "c").expect("a good guide");
        assert_eq!(guide.program, "int main(void)\n{\n}\n");
        assert_eq!(guide.expects("1\n"), Ok(()));
        assert!(guide.expects("2\n").is_err());
        assert!(Guide::read(text, "python").is_err());
        assert!(Guide::read("```c\nint", "c").is_err());
    }
}
