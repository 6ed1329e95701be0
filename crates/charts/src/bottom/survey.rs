//! Reads depth surveys: ESRI ASCII grids, and files with rows of x, y and z.

use fenderline_contact::{Vec2, vec2};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::keys::bottom::SurveyValues;
use fenderline_keys::sources::{Sources, Span, quoted};

use super::placed::Place;

/// Largest number of values of a survey.
const MOST_VALUES: usize = 4_000_000;
/// Smallest and largest depth or height that a survey may contain (m).
const VALUES_M: [f64; 2] = [-12_000.0, 12_000.0];

/// A depth survey, converted to the coordinates of the scenario.
pub(super) struct Survey {
    pub(super) form: Form,
    /// Whether the values in the file are depths or heights, and how the program knows.
    pub(super) values: Values,
}

/// The places and depths of a survey: a square grid, or single points.
pub(super) enum Form {
    /// A square grid along north and east: the place of its south-western node (m), the side of a cell (m), the numbers
    /// of nodes to the north and to the east, and the depths (m, NaN without data). In the list of depths, the index to
    /// the north varies fastest.
    Grid { origin_m: Vec2, cell_m: f64, columns: usize, rows: usize, depths_m: Vec<f64> },
    /// Single points, each with its place (m) and its depth (m).
    Points(Vec<(Vec2, f64)>),
}

/// Whether the values of a survey are depths or heights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Values {
    /// The values are depths below datum: the scenario says so, or no more values are negative than positive.
    Depths,
    /// The values are heights above datum, because the scenario says so.
    Heights,
    /// The values are taken as heights above datum, because more values are negative than positive.
    FoundHeights,
}

/// Reads the text of a survey; `key` is the scenario's key that names the file.
///
/// # Errors
/// Fails if the file has a mistake (the error names the line), if a place is too far from the scenario's origin, or if
/// the file has no data.
pub(super) fn read(
    (name, text): (&str, &str),
    key: &str,
    place: &Place,
    values: Option<SurveyValues>,
) -> Result<Survey, ScenarioError> {
    let file = File { sources: Sources::new(name, text, &[]), text, key };
    let first = file.lines().next().map(|(_, line)| line.to_ascii_lowercase()).unwrap_or_default();
    let mut survey = match first.starts_with("ncols") {
        true => file.grid(place)?,
        false => file.points(place)?,
    };
    survey.turn(values);
    let known = match &survey.form {
        Form::Grid { depths_m, .. } => depths_m.iter().any(|depth_m| !depth_m.is_nan()),
        Form::Points(points) => points.len() >= 3,
    };
    if !known {
        return Err(file
            .sources
            .file_error("the survey has no data: it needs three points or more"));
    }
    Ok(survey)
}

impl Survey {
    /// Decides whether the values are depths or heights, and turns heights into depths by changing their sign.
    fn turn(&mut self, values: Option<SurveyValues>) {
        let depths: Vec<&mut f64> = match &mut self.form {
            Form::Grid { depths_m, .. } => depths_m.iter_mut().collect(),
            Form::Points(points) => points.iter_mut().map(|(_, depth_m)| depth_m).collect(),
        };
        let [below, above] = [|of: f64| of < 0.0, |of: f64| of > 0.0]
            .map(|is| depths.iter().filter(|value| is(***value)).count());
        self.values = match values {
            Some(SurveyValues::Depths) => Values::Depths,
            Some(SurveyValues::Heights) => Values::Heights,
            None if below > above => Values::FoundHeights,
            None => Values::Depths,
        };
        if self.values != Values::Depths {
            depths.into_iter().for_each(|value| *value = -*value);
        }
    }
}

/// The text of a survey file.
struct File<'a> {
    sources: Sources<'a>,
    text: &'a str,
    key: &'a str,
}

/// The head of an ESRI ASCII grid file, which says how many values follow and where they lie.
struct Head {
    columns: usize,
    rows: usize,
    /// Coordinates x and y of the centre of the south-western cell.
    x: f64,
    y: f64,
    cell: f64,
    no_data: Option<f64>,
}

impl<'a> File<'a> {
    /// The lines of the file that are neither empty nor comments, each with its place in the text.
    fn lines(&self) -> impl Iterator<Item = (Span, &'a str)> {
        let text = self.text;
        let mut start = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        let rest = &text[start..];
        rest.split_inclusive('\n').filter_map(move |line| {
            let at = start;
            start += line.len();
            let trimmed = line.trim();
            let begin = at + (line.len() - line.trim_start().len());
            let is_said = !trimmed.is_empty() && !trimmed.starts_with('#');
            is_said.then_some((begin..begin + trimmed.len(), trimmed))
        })
    }

    fn error(&self, span: &Span, message: impl Into<String>) -> ScenarioError {
        self.sources.error(span, self.key, message.into())
    }

    fn number(&self, span: &Span, word: &str) -> Result<f64, ScenarioError> {
        let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
        number.ok_or_else(|| self.error(span, format!("{} is not a number", quoted(word))))
    }

    fn value(&self, span: &Span, word: &str) -> Result<f64, ScenarioError> {
        let value = self.number(span, word)?;
        if (VALUES_M[0]..=VALUES_M[1]).contains(&value) {
            return Ok(value);
        }
        let message = format!(
            "a depth or height must be between {} and {} m, but is {value}",
            VALUES_M[0], VALUES_M[1]
        );
        Err(self.error(span, message).with_help(
            "if this number stands for missing data, name it in the head as NODATA_value",
        ))
    }

    /// Reads an ESRI ASCII grid.
    fn grid(&self, place: &Place) -> Result<Survey, ScenarioError> {
        let mut lines = self.lines().peekable();
        let mut said: Vec<(String, f64, Span)> = Vec::new();
        let mut end = 0..0;
        while let Some((span, line)) =
            lines.next_if(|(_, line)| line.starts_with(|c: char| c.is_ascii_alphabetic()))
        {
            let mut words = line.split_whitespace();
            let (key, value) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
            let value = match value.to_ascii_lowercase().as_str() {
                // Some programs write `nan` as the value that stands for missing data.
                "nan" if key.eq_ignore_ascii_case("nodata_value") => f64::NAN,
                _ => self.number(&span, value)?,
            };
            end = span.clone();
            said.push((key.to_ascii_lowercase(), value, span));
        }
        let head = self.head(&said, &end)?;
        let mut values = Vec::with_capacity(head.columns * head.rows);
        for (span, line) in lines {
            for word in line.split_whitespace() {
                if values.len() == head.columns * head.rows {
                    let message =
                        format!("the grid has more than {} × {} values", head.columns, head.rows);
                    return Err(self.error(&span, message));
                }
                let is_none = word.eq_ignore_ascii_case("nan")
                    || head.no_data.is_some_and(|none| word.parse() == Ok(none));
                values.push(if is_none { f64::NAN } else { self.value(&span, word)? });
            }
        }
        if values.len() < head.columns * head.rows {
            let message = format!(
                "the grid has {} values, but {} × {} were announced",
                values.len(),
                head.columns,
                head.rows
            );
            return Err(self.sources.file_error(message));
        }
        self.placed(&head, &values, place, &end)
    }

    fn head(&self, said: &[(String, f64, Span)], end: &Span) -> Result<Head, ScenarioError> {
        let value = |keys: &[&str]| said.iter().find(|(key, ..)| keys.contains(&key.as_str()));
        let needed = |key: &str| {
            let missing = || self.error(end, format!("the head has no `{key}`"));
            value(&[key]).map(|(_, value, _)| *value).ok_or_else(missing)
        };
        let known = [
            "ncols",
            "nrows",
            "xllcorner",
            "yllcorner",
            "xllcenter",
            "yllcenter",
            "cellsize",
            "nodata_value",
        ];
        if let Some((key, _, span)) = said.iter().find(|(key, ..)| !known.contains(&key.as_str())) {
            let error =
                self.error(span, format!("{} is not a key of an ESRI ASCII grid", quoted(key)));
            return Err(error.with_help(
                "the keys of the grid's head are ncols, nrows, xllcorner, yllcorner, cellsize and NODATA_value",
            ));
        }
        let count = |key: &str| {
            let number = needed(key)?;
            let good =
                number >= 2.0 && number <= MOST_VALUES as f64 && libm::trunc(number) == number;
            let message = || {
                format!("`{key}` must be a whole number from 2 to {MOST_VALUES}, but is {number}")
            };
            if good { Ok(number as usize) } else { Err(self.error(end, message())) }
        };
        let (columns, rows) = (count("ncols")?, count("nrows")?);
        if columns * rows > MOST_VALUES {
            let message = format!(
                "the grid has {} values, but at most {MOST_VALUES} are read",
                columns * rows
            );
            return Err(self.error(end, message).with_help(
                "cut the grid to the area of the exercise, or make the grid's cells larger",
            ));
        }
        let cell = needed("cellsize")?;
        if cell <= 0.0 {
            return Err(self.error(end, format!("`cellsize` must be above 0, but is {cell}")));
        }
        let edge = |corner: &str, centre: &str| match value(&[centre]) {
            Some((_, value, _)) => Ok(*value),
            None => Ok(needed(corner)? + 0.5 * cell),
        };
        let no_data = value(&["nodata_value"]).map_or(Some(-9999.0), |(_, value, _)| Some(*value));
        Ok(Head {
            columns,
            rows,
            x: edge("xllcorner", "xllcenter")?,
            y: edge("yllcorner", "yllcenter")?,
            cell,
            no_data: no_data.filter(|none| !none.is_nan()),
        })
    }

    /// Converts the values of a grid file to the scenario's coordinates. The first row of the file is the northernmost.
    fn placed(
        &self,
        head: &Head,
        values: &[f64],
        place: &Place,
        end: &Span,
    ) -> Result<Survey, ScenarioError> {
        let [x0, y0] = [head.x, head.y];
        let [x1, y1] = [(head.columns - 1, x0), (head.rows - 1, y0)]
            .map(|(last, first)| first + last as f64 * head.cell);
        for corner in [[x0, y0], [x1, y0], [x0, y1], [x1, y1]] {
            place.check(corner).map_err(|(why, help)| self.error(end, why).with_help(help))?;
        }
        let value =
            |east: usize, north: usize| values[(head.rows - 1 - north) * head.columns + east];
        let form = match place.shift_m() {
            Some(shift_m) => {
                let nodes = (0..head.columns)
                    .flat_map(|east| (0..head.rows).map(move |north| value(east, north)));
                Form::Grid {
                    origin_m: vec2(y0, x0) + shift_m,
                    cell_m: head.cell,
                    columns: head.rows,
                    rows: head.columns,
                    depths_m: nodes.collect(),
                }
            }
            // In metres the cells are not square, or do not lie along north: the centre of each cell becomes a point.
            None => {
                let mut points = Vec::new();
                for north in 0..head.rows {
                    for east in 0..head.columns {
                        let depth_m = value(east, north);
                        if !depth_m.is_nan() {
                            let at = [x0 + east as f64 * head.cell, y0 + north as f64 * head.cell];
                            points.push((place.to_m(at), depth_m));
                        }
                    }
                }
                Form::Points(points)
            }
        };
        Ok(Survey { form, values: Values::Depths })
    }

    /// Reads rows of x, y and z, which are separated by blanks, tabs, commas or semicolons; the first row may name the
    /// columns.
    fn points(&self, place: &Place) -> Result<Survey, ScenarioError> {
        let mut points = Vec::new();
        let mut is_swapped = false;
        for (index, (span, line)) in self.lines().enumerate() {
            let separators = |c: char| c.is_whitespace() || c == ',' || c == ';';
            let mut words = line.split(separators).filter(|word| !word.is_empty());
            let first = words.next().unwrap_or_default();
            let begins = first.trim_start_matches('"').to_ascii_lowercase();
            let is_word = begins.starts_with(|c: char| c.is_ascii_alphabetic());
            // A first row that begins with `nan` is a row of data.
            if index == 0 && is_word && begins != "nan" {
                // The row has the names of the columns.
                let name = first.trim_matches('"').to_ascii_lowercase();
                is_swapped = name.starts_with("lat") || name.starts_with("north") || name == "y";
                continue;
            }
            let (Some(second), Some(third)) = (words.next(), words.next()) else {
                let message = "each row of a survey needs three numbers: x, y and z";
                return Err(self.error(&span, message));
            };
            let mut at = [self.number(&span, first)?, self.number(&span, second)?];
            if is_swapped {
                at.swap(0, 1);
            }
            if third.eq_ignore_ascii_case("nan") {
                continue;
            }
            let depth_m = self.value(&span, third)?;
            place.check(at).map_err(|(why, help)| self.error(&span, why).with_help(help))?;
            if points.len() == MOST_VALUES {
                return Err(self.error(&span, format!("a survey has at most {MOST_VALUES} points")));
            }
            points.push((place.to_m(at), depth_m));
        }
        Ok(Survey { form: Form::Points(points), values: Values::Depths })
    }
}
