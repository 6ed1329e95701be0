//! `cargo xtask sentences SEED [COUNT] [PATH...]`: draws sentences at random, for a reader who has not seen the code.
//!
//! The reader says each sentence again in other words. A sentence that cannot be said again is a riddle, and is mended.
//! Beside the sentence stands what every reader of the book and of rustdoc has in sight: the paragraph of the sentence,
//! and the declaration that a doc comment describes, without the body of the declaration.
//! Sentences come from doc comments, from texts in the code (errors, columns, help) and from Markdown documents.
//! Sentences from tests are left out. A `PATH` limits the draw to files whose paths begin with it.

use std::path::Path;
use std::process::{Command, ExitCode};

use crate::command::run_quietly;

/// Number of sentences that are drawn if no count is given.
pub(crate) const COUNT: usize = 50;
/// A shorter sentence, such as "Name of the body.", is not drawn.
const FEWEST_WORDS: usize = 5;
/// The declaration around a field or a method is looked for in at most this number of lines above it.
const MOST_LINES_UP: usize = 400;
/// Abbreviations whose full stop does not end a sentence.
const ABBREVIATIONS: [&str; 15] = [
    "al.", "cf.", "e.g.", "eq.", "Eq.", "eqs.", "Eqs.", "Fig.", "Figs.", "i.e.", "No.", "p.",
    "pp.", "ref.", "vol.",
];
/// Documents of the past, which stay as they were and are not drawn from.
const LEFT_OUT: [&str; 2] = ["CHANGELOG.md", "docs/before_0.1.0.md"];

/// A sentence of the repository, and the file and line where it begins.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Sentence {
    file: String,
    line: usize,
    /// Kind of text: `doc`, `text` or `document`.
    kind: &'static str,
    words: String,
    /// The whole paragraph, if it has more words than the sentence.
    paragraph: Option<String>,
    /// The declaration that a doc comment describes, with the outer declaration in which it stands put before it.
    declaration: Option<String>,
}

/// A paragraph of one kind: its lines with their numbers.
#[derive(Default)]
struct Paragraph {
    lines: Vec<(usize, String)>,
    /// The row of the table whose cell the paragraph is.
    row: Option<String>,
}

/// Draws and prints sentences of the tracked files.
pub(crate) fn sentences_command(seed: u64, count: usize, paths: &[&str]) -> ExitCode {
    match tracked_sentences(paths) {
        Ok(all) => {
            for (number, sentence) in draw(&all, seed, count).iter().enumerate() {
                let Sentence { file, line, kind, words, paragraph, declaration } = sentence;
                println!("{:>3}  {file}:{line} ({kind})\n     {words}", number + 1);
                if let Some(declaration) = declaration {
                    println!("     [describes: {declaration}]");
                }
                if let Some(paragraph) = paragraph {
                    println!("     [in the paragraph: {paragraph}]");
                }
            }
            println!("\ndrawn from {} sentences with seed {seed}", all.len());
            ExitCode::SUCCESS
        }
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn tracked_sentences(paths: &[&str]) -> Result<Vec<Sentence>, String> {
    let listed = run_quietly(Command::new("git").args(["ls-files", "--", "*.rs", "*.md"]))?;
    let wanted = |name: &&str| paths.is_empty() || paths.iter().any(|path| name.starts_with(path));
    let mut all = Vec::new();
    for name in listed.lines().filter(wanted) {
        // A file that is deleted and not yet committed is still listed.
        let Ok(text) = std::fs::read_to_string(name) else { continue };
        all.extend(of_file(name, &text));
    }
    Ok(all)
}

fn of_file(name: &str, text: &str) -> Vec<Sentence> {
    let is_rust = Path::new(name).extension().is_some_and(|ending| ending == "rs");
    let is_of_tests = name.split('/').any(|part| matches!(part, "tests" | "tests.rs"));
    if LEFT_OUT.contains(&name) || is_of_tests {
        return Vec::new();
    }
    let mut found = Vec::new();
    let mut add = |kind, paragraphs: Vec<Paragraph>| {
        for paragraph in paragraphs {
            let whole = paragraph.words();
            let last = paragraph.lines.last().map_or(0, |(line, _)| *line);
            let declaration = if kind == "doc" { declaration_after(text, last) } else { None };
            for (line, words) in paragraph.sentences() {
                found.push(Sentence {
                    file: name.to_owned(),
                    line,
                    kind,
                    paragraph: (whole != words).then(|| whole.clone()),
                    words,
                    declaration: declaration.clone(),
                });
            }
        }
    };
    if is_rust {
        let text = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
        add("doc", markdown(&doc_lines(text)));
        add("text", literals(text));
    } else {
        let lines: Vec<(usize, &str)> = (1..).zip(text.lines()).collect();
        add("document", markdown(&lines));
    }
    found
}

/// Lines of doc comments without their marks; each line of code gives an empty line.
fn doc_lines(source: &str) -> Vec<(usize, &str)> {
    let stripped = |line| {
        let line = str::trim_start(line);
        line.strip_prefix("///").or_else(|| line.strip_prefix("//!")).unwrap_or("")
    };
    (1..).zip(source.lines().map(stripped)).collect()
}

/// The first declaration below the line `last` of a doc comment, with the outer declaration in whose braces it stands
/// put before it. `None` for the comment of a whole file.
fn declaration_after(source: &str, last: usize) -> Option<String> {
    let is_doc = |line: &str| line.trim_start().starts_with("//");
    let is_attribute = |line: &str| line.trim_start().starts_with("#[");
    let lines: Vec<&str> = source.lines().collect();
    if lines.get(last.checked_sub(1)?)?.trim_start().starts_with("//!") {
        return None;
    }
    let skipped = |line: &&str| is_doc(line) || is_attribute(line) || line.trim().is_empty();
    let below = last + lines[last..].iter().take_while(|line| skipped(line)).count();
    let own = lines.get(below)?;
    let indent = |line: &str| line.len() - line.trim_start().len();
    let around = lines[..below].iter().rev().filter(|line| !skipped(line));
    let around = around.take(MOST_LINES_UP).find(|line| indent(line) < indent(own));
    let head = |line: &str| line.trim().trim_end_matches(['{', '(', ',', ' ']).to_owned();
    Some(match around {
        Some(around) if indent(own) > 0 => format!("{}: {}", head(around), head(own)),
        _ => head(own),
    })
}

/// Paragraphs, list items and table cells of a Markdown text, without code, headings and tags.
fn markdown(lines: &[(usize, &str)]) -> Vec<Paragraph> {
    let mut found = Vec::new();
    let mut open = Paragraph::default();
    let mut in_code = false;
    for &(number, line) in lines {
        let line = line.trim();
        // Code, and equations between lines of `$$`.
        let is_fence = line.starts_with("```") || line == "$$";
        in_code ^= is_fence;
        let is_row = line.starts_with('|') && line.ends_with('|');
        if is_fence || in_code || is_row || line.is_empty() || line.starts_with(['#', '<']) {
            found.push(std::mem::take(&mut open));
            if is_row && !in_code {
                let cell = |cell: &str| Paragraph {
                    lines: vec![(number, cell.trim().to_owned())],
                    row: Some(line.to_owned()),
                };
                found.extend(line.split('|').map(cell));
            }
            continue;
        }
        let item = line.split_once(' ').filter(|(mark, _)| is_list_mark(mark));
        if item.is_some() {
            found.push(std::mem::take(&mut open));
        }
        open.lines.push((number, item.map_or(line, |(_, rest)| rest).to_owned()));
    }
    found.push(open);
    found
}

/// Whether a word begins an item of a list: `-`, `*` or a number with a full stop.
fn is_list_mark(word: &str) -> bool {
    let number = word.strip_suffix('.').unwrap_or_default();
    matches!(word, "-" | "*" | ">")
        || (!number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()))
}

/// String literals of a Rust source that are prose.
fn literals(source: &str) -> Vec<Paragraph> {
    let mut found = Vec::new();
    let mut rest = source;
    let line_of = |rest: &str| 1 + source[..source.len() - rest.len()].matches('\n').count();
    while let Some(at) = rest.find(['"', '/', '\'']) {
        let before = rest[..at].chars().next_back();
        rest = &rest[at..];
        if rest.starts_with("//") {
            rest = rest.find('\n').map_or("", |end| &rest[end..]);
        } else if rest.starts_with('"') {
            let line = line_of(rest);
            let raw = matches!(before, Some('r' | '#'));
            let (text, after) = literal(&rest[1..], raw);
            rest = after;
            if is_prose(&text) {
                let lines = text.split('\n').map(|part| (line, part.trim().to_owned()));
                found.push(Paragraph { lines: lines.collect(), row: None });
            }
        } else if rest.starts_with("'\"'") || rest.starts_with("'\\") {
            rest = rest.get(3..).unwrap_or("");
        } else {
            rest = &rest[1..];
        }
    }
    found
}

/// The text of a literal whose opening quotation mark was read, and the source after the literal.
fn literal(source: &str, raw: bool) -> (String, &str) {
    let mut text = String::new();
    let mut chars = source.char_indices();
    while let Some((at, c)) = chars.next() {
        match c {
            '"' => return (text, &source[at + 1..]),
            '\\' if !raw => match chars.next() {
                // The end of the line and the indent of the next are no part of the text.
                Some((next, '\n')) => {
                    let indent = source[next + 1..].chars().take_while(|c| c.is_whitespace());
                    let skipped = indent.count();
                    if skipped > 0 {
                        chars.nth(skipped - 1);
                    }
                }
                Some((_, 'n')) => text.push('\n'),
                Some((_, other)) => text.push(other),
                None => break,
            },
            _ => text.push(c),
        }
    }
    (text, "")
}

/// Whether a text reads as sentences: nearly all of its words are words or placeholders, and it has no mark-up.
fn is_prose(text: &str) -> bool {
    let is_word = |word: &&str| {
        let word = word.trim_matches(|c: char| ",.;:()`'\"{}".contains(c));
        !word.is_empty() && word.chars().all(|c| c.is_alphanumeric() || "'’-_.%/[]".contains(c))
    };
    let words: Vec<&str> = text.split_whitespace().collect();
    let plain = words.iter().filter(|word| is_word(word)).count();
    words.len() >= FEWEST_WORDS && plain * 10 >= words.len() * 9 && !text.contains("</")
}

impl Paragraph {
    /// All words of the paragraph, or of the row of the table, in one line.
    fn words(&self) -> String {
        if let Some(row) = &self.row {
            return row.clone();
        }
        let words = self.lines.iter().flat_map(|(_, line)| line.split_whitespace());
        words.collect::<Vec<_>>().join(" ")
    }

    /// Sentences of the paragraph that are long enough, each with the number of its first line.
    fn sentences(&self) -> Vec<(usize, String)> {
        let words: Vec<(usize, &str)> = self
            .lines
            .iter()
            .flat_map(|(number, line)| line.split_whitespace().map(move |word| (*number, word)))
            .collect();
        let mut found = Vec::new();
        let mut begin = 0;
        for end in 1..=words.len() {
            let begins = words.get(end).map(|(_, word)| *word);
            if !ends_a_sentence(words[end - 1].1, begins) {
                continue;
            }
            if end - begin >= FEWEST_WORDS {
                let said: Vec<&str> = words[begin..end].iter().map(|(_, word)| *word).collect();
                found.push((words[begin].0, said.join(" ")));
            }
            begin = end;
        }
        found
    }
}

/// Whether a sentence ends with the word `word`, which stands before the word `next`.
fn ends_a_sentence(word: &str, next: Option<&str>) -> bool {
    let Some(next) = next else { return true };
    let bare = word.trim_end_matches(['"', ')', '*', '_', '”']);
    let is_initial = bare.len() == 2 && bare.starts_with(char::is_uppercase);
    bare.ends_with(['.', '?', '!'])
        && !is_initial
        && !ABBREVIATIONS.contains(&bare.trim_start_matches('('))
        && next.chars().find(|c| !"\"(*_“[".contains(*c)).is_some_and(|c| !c.is_lowercase())
}

/// `count` sentences in random order without repetition, or all sentences if there are fewer.
fn draw(all: &[Sentence], seed: u64, count: usize) -> Vec<Sentence> {
    let mut left = all.to_vec();
    let mut state = seed;
    let mut drawn = Vec::new();
    while drawn.len() < count && !left.is_empty() {
        let place = (u128::from(next_random(&mut state)) * left.len() as u128) >> 64;
        drawn.push(left.swap_remove(place as usize));
    }
    drawn
}

/// The next number of the random generator SplitMix64 (Steele, Lea and Flood, 2014).
fn next_random(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(name: &str, text: &str) -> Vec<(usize, &'static str, String)> {
        of_file(name, text).into_iter().map(|s| (s.line, s.kind, s.words)).collect()
    }

    fn owned(of: &[(usize, &'static str, &str)]) -> Vec<(usize, &'static str, String)> {
        of.iter().map(|(line, kind, words)| (*line, *kind, (*words).to_owned())).collect()
    }

    #[test]
    fn doc_comments_are_split_into_sentences_with_their_lines() {
        let source = "//! One sentence of five words. Another sentence goes\n//! over two lines, see Fig. 3.\n\
                      /// A sentence about the item.\n/// ```\n/// let this_is_code = not a sentence at all;\n/// ```\n\
                      // An ordinary comment is not drawn.\nfn f() {}\n";
        assert_eq!(
            said("crates/a/src/lib.rs", source),
            owned(&[
                (1, "doc", "One sentence of five words."),
                (1, "doc", "Another sentence goes over two lines, see Fig. 3."),
                (3, "doc", "A sentence about the item."),
            ])
        );
    }

    #[test]
    fn texts_of_errors_and_columns_are_drawn_and_those_of_tests_are_not() {
        let source = "write!(f, \"body `{body}` has no mass: \\\n     give it one\");\n\
                      // \"a comment with some quoted words\"\nlet c = '\"';\n\
                      column(\"t_s\", \"start of the whole interval\");\nlet css = \"a { b: c; d: e } <p> x </p>\";\n\
                      #[cfg(test)]\nmod tests { const T: &str = \"a text of a test here\"; }\n";
        assert_eq!(
            said("crates/a/src/lib.rs", source),
            owned(&[
                (1, "text", "body `{body}` has no mass: give it one"),
                (5, "text", "start of the whole interval"),
            ])
        );
        assert!(said("crates/a/tests/all.rs", source).is_empty());
    }

    #[test]
    fn documents_give_paragraphs_items_and_cells_but_no_code_and_no_headings() {
        let text = "# A heading of many words here\n\nText of J. Smith is here.\n\n- first item of a list\n- second \
                    item of a list\n\n| name | a cell of five words |\n|---|---|\n\n```\ncode is no sentence at all\n```\n";
        assert_eq!(
            said("README.md", text),
            owned(&[
                (3, "document", "Text of J. Smith is here."),
                (5, "document", "first item of a list"),
                (6, "document", "second item of a list"),
                (8, "document", "a cell of five words"),
            ])
        );
    }

    #[test]
    fn a_sentence_has_its_paragraph_and_what_it_describes() {
        let source = "/// A body that does not move at all.\npub struct Quay {\n    /// Its height above the water. Heights are in \
                      metres there.\n    #[serde(default)]\n    pub height_m: f64,\n}\n";
        let found = of_file("crates/a/src/lib.rs", source);
        let declarations: Vec<&str> =
            found.iter().filter_map(|s| s.declaration.as_deref()).collect();
        assert_eq!(
            declarations,
            [
                "pub struct Quay",
                "pub struct Quay: pub height_m: f64",
                "pub struct Quay: pub height_m: f64"
            ]
        );
        assert_eq!(found[0].paragraph, None);
        let whole = "Its height above the water. Heights are in metres there.";
        assert_eq!(found[2].paragraph.as_deref(), Some(whole));
    }

    #[test]
    fn the_same_seed_draws_the_same_sentences_and_none_twice() {
        let sentence = |line| Sentence {
            file: String::new(),
            line,
            kind: "doc",
            words: String::new(),
            paragraph: None,
            declaration: None,
        };
        let all: Vec<Sentence> = (0..100).map(sentence).collect();
        let lines = |seed| draw(&all, seed, 50).iter().map(|s| s.line).collect::<Vec<_>>();
        assert_eq!(lines(1), lines(1));
        assert_ne!(lines(1), lines(2));
        let mut once = lines(3);
        once.sort_unstable();
        once.dedup();
        assert_eq!(once.len(), 50);
        assert_eq!(draw(&all, 1, 1000).len(), 100);
    }
}
