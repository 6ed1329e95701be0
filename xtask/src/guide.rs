//! Reads guides whose code snippets together form one program, and which state the program's output.

/// A guide.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Guide {
    /// The program: all snippets of the guide in its language, joined.
    pub(crate) program: String,
    /// The output that the guide states: its last code block of the language `text`.
    printed: String,
}

impl Guide {
    /// Reads the fenced code blocks of `language` in a Markdown text.
    ///
    /// # Errors
    /// Fails if the text has no code block of the language, states no output, or has a block without an end.
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
                "the guide has no complete program in {language}, or does not state its output"
            ));
        }
        Ok(Guide { program, printed })
    }

    /// Checks that the program printed the output that the guide states.
    ///
    /// # Errors
    /// If the outputs differ, the error has both texts.
    pub(crate) fn expects(&self, printed: &str) -> Result<(), String> {
        if printed == self.printed {
            return Ok(());
        }
        Err(format!(
            "the guide states the output\n{}\nbut its program prints\n{printed}",
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
