//! Variables of a campaign.

use std::path::PathBuf;

use toml::Spanned;
use toml::de::DeValue;

use super::kinds::{FamilyKind, PlanKind, Read};
use super::law::{Law, LawFamily};
use super::number;
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::origin::Origin;
use fenderline_keys::overrides::Override;
use fenderline_keys::sources::{Sources, Span, quoted};

/// What differs from run to run.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Name of the variable.
    pub name: String,
    /// Source of the variable's values, in words.
    pub source: Option<String>,
    /// How the variable gets its value.
    pub draw: Draw,
}

/// How a variable gets its value in a run.
#[derive(Clone, Debug, PartialEq)]
pub enum Draw {
    /// One of several choices; at least one.
    Choices(Vec<Choice>),
    /// A number by a law.
    Law(Law, Target),
    /// One of the measured values of a file.
    Measured {
        /// The file.
        file: PathBuf,
        /// Its column.
        column: String,
        /// Where the value goes.
        target: Target,
    },
    /// A formula of other variables.
    Expression {
        /// Its text.
        text: String,
        /// Where the value goes.
        target: Target,
    },
    /// The value of a column of the campaign's table.
    Column {
        /// Name of the column.
        column: String,
        /// Where the value goes.
        target: Target,
    },
}

/// Where the numbers of a variable go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Target {
    /// Keys of the scenario; none for a variable that only others use.
    pub keys: Vec<String>,
    /// Unit of the numbers; empty for SI, and for plain numbers.
    pub unit: String,
    /// Whether an empty unit in the file says that the numbers are plain.
    pub is_plain: bool,
    /// Where the campaign's file has keys and law, for errors.
    pub origins: TargetOrigins,
}

/// Places in the campaign's file of a variable's keys, and of its values.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TargetOrigins {
    /// Of each key.
    pub keys: Vec<Origin>,
    /// Place of the distribution, the expression or the column; `None` only if the campaign was not read from a file.
    pub values: Option<Origin>,
}

impl Target {
    /// The value of the keys for a number, written as for `--set`.
    #[must_use]
    pub fn value(&self, number: f64) -> String {
        match self.unit.as_str() {
            "" => format!("{number}"),
            unit => format!("{number} {unit}"),
        }
    }
}

/// A value of a variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The value or the name, as written in the file.
    pub label: String,
    /// The keys that the choice sets.
    pub changes: Vec<Change>,
    /// Weight of the choice in a random plan; not negative.
    pub weight: f64,
}

/// A change of a scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// KEY=VALUE, written as for `--set`.
    pub text: String,
    /// The same, read.
    pub set: Override,
}

impl Variable {
    /// The choices of the variable; empty for a variable with a law, a file, a column or an expression.
    #[must_use]
    pub fn choices(&self) -> &[Choice] {
        match &self.draw {
            Draw::Choices(choices) => choices,
            _ => &[],
        }
    }

    /// The numbers of the choices' labels and their unit, as of "9 m" and "12 m"; `None` if a label is no number, if
    /// units differ, and without choices.
    #[must_use]
    pub fn numbers(&self) -> Option<(Vec<f64>, &str)> {
        let parts = self.choices().iter().map(|choice| number::split(&choice.label).ok());
        let parts: Vec<(f64, &str)> = parts.collect::<Option<_>>()?;
        let (_, unit) = *parts.first()?;
        let is_one_unit = parts.iter().all(|(_, other)| *other == unit);
        is_one_unit.then(|| (parts.iter().map(|(number, _)| *number).collect(), unit))
    }
}

/// Keys that only a law has.
const OF_LAWS: [&str; 13] = [
    "mean",
    "standard_deviation",
    "log_mean",
    "log_standard_deviation",
    "location",
    "scale",
    "shape",
    "lower",
    "mode",
    "upper",
    "at_least",
    "at_most",
    "quantiles",
];

/// The variable of a table.
pub(super) fn read(
    sources: &Sources<'_>,
    name: &str,
    table: &Table,
    plan: PlanKind,
) -> Read<Variable> {
    let reader = Reader { sources, name, table };
    let draw = reader.draw(plan)?;
    let source = table.item("source").map(|item| item.text().to_owned());
    Ok(Variable { name: name.to_owned(), source, draw })
}

struct Reader<'r, 's> {
    sources: &'r Sources<'s>,
    name: &'r str,
    table: &'r Table,
}

impl Reader<'_, '_> {
    fn draw(&self, plan: PlanKind) -> Read<Draw> {
        let given = |name: &str| self.given(name);
        let ways: Vec<&Item> = ["values", "choice", "distribution", "expression"]
            .into_iter()
            .filter_map(given)
            .collect();
        if let [_, second, ..] = ways[..] {
            let names = ways.iter().map(|item| format!("`{}`", item.name)).collect::<Vec<_>>();
            return self.refused(
                second,
                format!("does not go together: the variable has {}", names.join(" and ")),
            );
        }
        let of_law = OF_LAWS.into_iter().filter_map(given).next();
        if let (Some(item), None) = (of_law, given("distribution")) {
            return self.refused(item, "belongs to a `distribution`, which is missing".to_owned());
        }
        match ways.first().map(|item| item.name) {
            Some("values") => self.values().map(Draw::Choices),
            Some("choice") => self.several().map(Draw::Choices),
            Some("distribution") => self.distribution(plan),
            Some(_) => {
                let item = self.table.given("expression");
                let text = item.text().to_owned();
                Ok(Draw::Expression { text, target: self.target(None, &item.span)? })
            }
            None if plan == PlanKind::Table => {
                let column = self.table.item("column").map_or(self.name, Item::text).to_owned();
                let span = self.given("column").map_or(&self.table.span, |item| &item.span);
                Ok(Draw::Column { column, target: self.target(None, span)? })
            }
            None => self.missing(),
        }
    }

    /// A key that the file gives.
    fn given(&self, name: &str) -> Option<&Item> {
        self.table.item(name).filter(|item| !item.is_default)
    }

    fn refused<T>(&self, item: &Item, message: String) -> Read<T> {
        let path = self.table.path_of(item.name);
        Err(self.sources.error(&item.span, &path, format!("`{path}` {message}")))
    }

    fn missing<T>(&self) -> Read<T> {
        let missing = if self.keys()?.is_empty() { "key" } else { "values" };
        let path = self.table.path_of(missing);
        let error = self.sources.error(&self.table.span, &path, format!("`{path}` is missing"));
        Err(error.with_help(
            "give `key` with `values`, a `distribution` or an `expression`, or a [variable.NAME.choice.NAME] for each value",
        ))
    }

    fn keys(&self) -> Read<Vec<(String, Origin)>> {
        let several = self.table.given("keys");
        match self.table.item("key") {
            Some(_) if !several.texts().is_empty() => {
                self.refused(several, "does not go together with `key`".to_owned())
            }
            Some(key) => Ok(vec![(key.text().to_owned(), self.sources.origin(&key.span))]),
            None => {
                Ok(several.texts().iter().cloned().zip(origins(self.sources, several)).collect())
            }
        }
    }

    /// Keys and unit; `found` is the unit of the numbers that were read, `values` the place of the values.
    fn target(&self, found: Option<String>, values: &Span) -> Read<Target> {
        let (keys, key_origins): (Vec<String>, Vec<Origin>) = self.keys()?.into_iter().unzip();
        let values = self.sources.origin(values);
        for (key, origin) in keys.iter().zip(&key_origins) {
            Override::from_files((key, origin.clone()), ("0", values.clone()))?;
        }
        let own = self.table.item("unit");
        if let (Some(item), Some(found)) = (own, &found)
            && item.text() != found
        {
            return self.refused(
                item,
                format!("is {}, but a number of the law is in {found}", quoted(item.text())),
            );
        }
        let is_plain = own.is_some_and(|item| item.text().is_empty());
        let unit = own.map(|item| item.text().to_owned()).or(found).unwrap_or_default();
        let origins = TargetOrigins { keys: key_origins, values: Some(values) };
        Ok(Target { keys, unit, is_plain, origins })
    }

    fn values(&self) -> Read<Vec<Choice>> {
        let values = self.table.given("values");
        let keys = self.keys()?;
        if keys.is_empty() {
            return self.missing();
        }
        if let Some(unit) = self.table.item("unit") {
            return self.refused(
                unit,
                "does not go together with `values`, which have units themselves".to_owned(),
            );
        }
        let weights = match self.given("weights") {
            None => vec![1.0; values.texts().len()],
            Some(item) if item.texts().len() != values.texts().len() => {
                let (own, wanted) = (item.texts().len(), values.texts().len());
                return self.refused(item, format!("has {own} numbers for {wanted} values"));
            }
            Some(item) => {
                let one = |text: &String| match text.parse::<f64>() {
                    Ok(weight) if weight >= 0.0 && weight.is_finite() => Ok(weight),
                    _ => self.refused(
                        item,
                        format!("has {}, which is not a number from 0", quoted(text)),
                    ),
                };
                item.texts().iter().map(one).collect::<Read<Vec<f64>>>()?
            }
        };
        let one = |((value, origin), weight): ((&String, Origin), f64)| {
            let change = |(key, key_origin): &(String, Origin)| {
                let text = format!("{key}={value}");
                let set = Override::from_files((key, key_origin.clone()), (value, origin.clone()))?;
                Ok(Change { text, set })
            };
            let changes = keys.iter().map(change).collect::<Read<Vec<Change>>>()?;
            Ok(Choice { label: value.clone(), changes, weight })
        };
        let each = values.texts().iter().zip(origins(self.sources, values));
        let choices = each.zip(weights).map(one).collect::<Read<Vec<Choice>>>()?;
        self.checked(choices, values)
    }

    fn several(&self) -> Read<Vec<Choice>> {
        if let Some(item) = self.table.item("key").or(self.given("keys")) {
            return self.refused(item, "does not go together with `choice`".to_owned());
        }
        let item = self.table.given("choice");
        let one = |(label, choice): &(String, Table)| {
            let changes = changes(self.sources, &choice.path_of("set"), choice.given("set"))?;
            Ok(Choice { label: label.clone(), changes, weight: *choice.given("weight").number() })
        };
        let choices = item.named().iter().map(one).collect::<Read<Vec<Choice>>>()?;
        self.checked(choices, item)
    }

    /// Checks that the choices differ, and that at least one choice can be drawn.
    fn checked(&self, choices: Vec<Choice>, item: &Item) -> Read<Vec<Choice>> {
        if choices.is_empty() {
            return self.refused(item, "is empty".to_owned());
        }
        for (index, choice) in choices.iter().enumerate() {
            if choices[..index].iter().any(|other| other.label == choice.label) {
                return self.refused(item, format!("has {} twice", quoted(&choice.label)));
            }
        }
        if !choices.iter().any(|choice| choice.weight > 0.0) {
            return self.refused(item, "has no weight above 0: nothing can be drawn".to_owned());
        }
        Ok(choices)
    }

    fn distribution(&self, plan: PlanKind) -> Read<Draw> {
        let item = self.table.given("distribution");
        if matches!(plan, PlanKind::FullFactorial | PlanKind::Table) {
            return self.refused(
                item,
                "goes with a random plan: \"Monte Carlo\", \"Latin hypercube\" or \"Sobol\""
                    .to_owned(),
            );
        }
        match item.choice::<FamilyKind>() {
            FamilyKind::Empirical => {
                if let Some(item) = OF_LAWS.into_iter().find_map(|name| self.given(name)) {
                    return self.refused(
                        item,
                        "does not go with an \"empirical\" distribution".to_owned(),
                    );
                }
                let Some(file) = self.table.item("file") else {
                    return self.refused(
                        item,
                        "\"empirical\" needs a `file` of measured values".to_owned(),
                    );
                };
                let column = self.table.item("column").map_or(self.name, Item::text).to_owned();
                Ok(Draw::Measured {
                    file: PathBuf::from(file.text()),
                    column,
                    target: self.target(None, &file.span)?,
                })
            }
            FamilyKind::Law(family) => {
                if let Some(file) = self.table.item("file") {
                    return self
                        .refused(file, "goes with an \"empirical\" distribution alone".to_owned());
                }
                let mut numbers = Numbers { reader: self, unit: None };
                let law = numbers.law(item, family)?;
                let unit = numbers.unit;
                Ok(Draw::Law(law, self.target(unit, &item.span)?))
            }
        }
    }
}

/// The parameters of a law, and their common unit.
struct Numbers<'n, 'r, 's> {
    reader: &'n Reader<'r, 's>,
    unit: Option<String>,
}

impl Numbers<'_, '_, '_> {
    /// A parameter in the variable's unit.
    fn measured(&mut self, item: &Item) -> Read<f64> {
        let (value, unit) = match number::split(item.text()) {
            Ok(split) => split,
            Err(why) => {
                return self.reader.refused(item, format!("must be a number with its unit: {why}"));
            }
        };
        match &self.unit {
            Some(first) if first != unit => {
                let (first, unit) = (quoted(first), quoted(unit));
                self.reader.refused(
                    item,
                    format!("is in {unit}, another parameter in {first}: write one unit"),
                )
            }
            _ => {
                self.unit = Some(unit.to_owned());
                Ok(value)
            }
        }
    }

    /// A parameter without a unit.
    fn plain(&self, item: &Item) -> Read<f64> {
        match number::split(item.text()) {
            Ok((value, "")) => Ok(value),
            _ => self.reader.refused(item, "must be a number without a unit".to_owned()),
        }
    }

    fn law(&mut self, item: &Item, family: LawFamily) -> Read<Law> {
        let table = self.reader.table;
        let of_family: &[&[&str]] = match family {
            LawFamily::Normal => &[&["mean", "standard_deviation"]],
            LawFamily::Lognormal => {
                &[&["mean", "standard_deviation"], &["log_mean", "log_standard_deviation"]]
            }
            LawFamily::Weibull => &[&["mean", "standard_deviation"], &["scale", "shape"]],
            LawFamily::Gumbel => &[&["mean", "standard_deviation"], &["location", "scale"]],
            LawFamily::Uniform => &[&["mean", "standard_deviation"], &["lower", "upper"]],
            LawFamily::Triangular => &[&["lower", "mode", "upper"]],
        };
        let parameters = OF_LAWS.into_iter().filter(|name| !name.starts_with("at_"));
        let given: Vec<&str> =
            parameters.filter(|name| self.reader.given(name).is_some()).collect();
        let way = match given[..] {
            ["quantiles"] => None,
            _ => {
                let fits = |way: &&&[&str]| {
                    way.len() == given.len() && way.iter().all(|name| given.contains(name))
                };
                let Some(way) = of_family.iter().find(fits) else {
                    let mut ways: Vec<String> = of_family
                        .iter()
                        .map(|way| {
                            way.iter()
                                .map(|name| format!("`{name}`"))
                                .collect::<Vec<_>>()
                                .join(" and ")
                        })
                        .collect();
                    if family != LawFamily::Triangular {
                        ways.push("two `quantiles`".to_owned());
                    }
                    let given = match given[..] {
                        [] => "nothing".to_owned(),
                        _ => given
                            .iter()
                            .map(|name| format!("`{name}`"))
                            .collect::<Vec<_>>()
                            .join(", "),
                    };
                    let message = format!(
                        "\"{}\" needs {}; given is {given}",
                        family.word(),
                        ways.join(", or ")
                    );
                    return self.reader.refused(item, message);
                };
                Some(*way)
            }
        };
        let law = match way {
            None => {
                let quantiles = table.given("quantiles");
                let [one, other] = quantiles.list() else {
                    return self.reader.refused(quantiles, "must be two".to_owned());
                };
                let mut read = |table: &Table| -> Read<(f64, f64)> {
                    Ok((*table.given("probability").number(), self.measured(table.given("value"))?))
                };
                Law::by_quantiles(family, [read(one)?, read(other)?])
            }
            Some(way) => {
                let mut values = Vec::new();
                for name in way {
                    let own = table.given(name);
                    let is_plain = *name == "shape" || name.starts_with("log_");
                    values.push(if is_plain { self.plain(own)? } else { self.measured(own)? });
                }
                match (family, way[0], &values[..]) {
                    (LawFamily::Normal, _, [a, b]) => Law::normal(*a, *b),
                    (LawFamily::Lognormal, "mean", [a, b]) => Law::lognormal(*a, *b),
                    (LawFamily::Lognormal, _, [a, b]) => Law::lognormal_by_logarithm(*a, *b),
                    (LawFamily::Weibull, "mean", [a, b]) => Law::weibull_by_moments(*a, *b),
                    (LawFamily::Weibull, _, [a, b]) => Law::weibull(*a, *b),
                    (LawFamily::Gumbel, "mean", [a, b]) => Law::gumbel_by_moments(*a, *b),
                    (LawFamily::Gumbel, _, [a, b]) => Law::gumbel(*a, *b),
                    (LawFamily::Uniform, "mean", [a, b]) => Law::uniform_by_moments(*a, *b),
                    (LawFamily::Uniform, _, [a, b]) => Law::uniform(*a, *b),
                    (LawFamily::Triangular, _, [a, b, c]) => Law::triangular(*a, *b, *c),
                    other => unreachable!("{other:?}"),
                }
            }
        };
        let mut bound = |name: &str| -> Read<Option<f64>> {
            self.reader.given(name).map(|item| self.measured(item)).transpose()
        };
        let (lowest, highest) = (bound("at_least")?, bound("at_most")?);
        let law = law.and_then(|law| match (lowest, highest) {
            (None, None) => Ok(law),
            _ => law.within(lowest, highest),
        });
        match law {
            Ok(law) => Ok(law),
            Err(why) => {
                let path = table.path_of("distribution");
                Err(self.reader.sources.error(&item.span, &path, format!("`{path}`: {why}")))
            }
        }
    }
}

/// The changes of a list of KEY=VALUE.
pub(super) fn changes(sources: &Sources<'_>, path: &str, item: &Item) -> Read<Vec<Change>> {
    let one = |(text, origin): (&String, Origin)| {
        let read = match text.split_once('=') {
            Some((key, value)) => {
                Override::from_files((key, origin.clone()), (value, origin.clone()))
            }
            None => Override::parse(text),
        };
        let read = read.map(|set| Change { text: text.clone(), set });
        read.map_err(|error| {
            let message = format!("`{path}`: {}: {}", quoted(text), error.message());
            let help = "write KEY=VALUE, as in \"time.step=0.5 s\"";
            sources.error(&item.span, path, message).with_help(help).at_origin(&origin)
        })
    };
    item.texts().iter().zip(origins(sources, item)).map(one).collect()
}

/// Where each text of a list is.
fn origins(sources: &Sources<'_>, item: &Item) -> Vec<Origin> {
    let whole = || vec![sources.origin(&item.span); item.texts().len()];
    if item.is_default {
        return whole();
    }
    match DeValue::parse(&sources.text[item.span.clone()]).map(Spanned::into_inner) {
        Ok(DeValue::Array(nodes)) => {
            let start = item.span.start;
            let one = |span: Span| sources.origin(&(start + span.start..start + span.end));
            nodes.iter().map(|node| one(node.span())).collect()
        }
        // The reader has read the value as a list.
        _ => whole(),
    }
}
