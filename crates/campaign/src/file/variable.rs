//! Variables of a campaign.

use std::path::PathBuf;

use toml::Spanned;
use toml::de::DeValue;

use super::kinds::{FamilyKind, PlanKind, Read};
use super::law::{Law, LawFamily};
use super::number;
use crate::file::keys::variable::{ChoiceKey, QuantileKey, VariableKey};
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::held::{Text, Texts};
use fenderline_keys::origin::Origin;
use fenderline_keys::overrides::Override;
use fenderline_keys::sources::{Sources, Span, quoted};
use fenderline_keys::typed_key::{AnyKey, Anything, Key};

/// A variable of a campaign: what differs from run to run.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Name of the variable.
    pub name: String,
    /// Source of the variable's values, in words.
    pub source: Option<String>,
    /// How the variable gets its value in each run.
    pub draw: Draw,
}

/// The way in which a variable gets its value in a run.
#[derive(Clone, Debug, PartialEq)]
pub enum Draw {
    /// The value is one of several choices; there is at least one choice.
    Choices(Vec<Choice>),
    /// The value is a number drawn from a probability law.
    Law(Law, Target),
    /// The value is one of the measured values of a file.
    Measured {
        /// The file.
        file: PathBuf,
        /// Its column.
        column: String,
        /// Where the value goes.
        target: Target,
    },
    /// The value is computed by a formula of other variables.
    Expression {
        /// Its text.
        text: String,
        /// Where the value goes.
        target: Target,
    },
    /// The value stands in a column of the campaign's table.
    Column {
        /// Name of the column.
        column: String,
        /// Where the value goes.
        target: Target,
    },
}

/// The scenario keys that get the numbers of a variable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Target {
    /// Keys of the scenario that get the number; none for a variable that only the formulas of other variables use.
    pub keys: Vec<String>,
    /// Unit of the numbers; empty for SI, and for plain numbers.
    pub unit: String,
    /// Whether the file gives an empty unit, which says that the numbers have no unit.
    pub is_plain: bool,
    /// Places of the keys and the law in the campaign's file, for error messages.
    pub origins: TargetOrigins,
}

/// Places of a variable's keys and of its values in the campaign's file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TargetOrigins {
    /// Of each key.
    pub keys: Vec<Origin>,
    /// Place of the distribution, the expression or the column in the campaign's file; `None` only if the campaign was
    /// not read from a file.
    pub values: Option<Origin>,
}

impl Target {
    /// The text of a number for the variable's keys, written as for `--set`.
    #[must_use]
    pub fn value(&self, number: f64) -> String {
        match self.unit.as_str() {
            "" => format!("{number}"),
            unit => format!("{number} {unit}"),
        }
    }
}

/// A choice: one of the values of a variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The value or the name of the choice, as written in the file.
    pub label: String,
    /// The changes of the scenario that the choice makes.
    pub changes: Vec<Change>,
    /// Weight of the choice in a random plan; not negative.
    pub weight: f64,
}

/// A change of a scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// The change as text KEY=VALUE, written as for `--set`.
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

    /// The numbers of the choices' labels and their unit, as in "9 m" and "12 m"; `None` if a label is no number, if
    /// the units differ, or if there are no choices.
    #[must_use]
    pub fn numbers(&self) -> Option<(Vec<f64>, &str)> {
        let parts = self.choices().iter().map(|choice| number::split(&choice.label).ok());
        let parts: Vec<(f64, &str)> = parts.collect::<Option<_>>()?;
        let (_, unit) = *parts.first()?;
        let is_one_unit = parts.iter().all(|(_, other)| *other == unit);
        is_one_unit.then(|| (parts.iter().map(|(number, _)| *number).collect(), unit))
    }
}

/// A parameter of a probability law.
type Parameter = Key<VariableKey, Text>;

/// Parameters without a unit.
const PLAIN: [Parameter; 3] =
    [VariableKey::SHAPE, VariableKey::LOG_MEAN, VariableKey::LOG_STANDARD_DEVIATION];

/// Keys that only a variable with a probability law has.
const OF_LAWS: &[AnyKey<VariableKey>] = any_keys![
    VariableKey: MEAN, STANDARD_DEVIATION, LOG_MEAN, LOG_STANDARD_DEVIATION, LOCATION, SCALE,
    SHAPE, LOWER, MODE, UPPER, AT_LEAST, AT_MOST, QUANTILES
];

/// Reads the variable of a table `[variable.NAME]`.
pub(super) fn read(
    sources: &Sources<'_>,
    name: &str,
    table: Of<'_, VariableKey>,
    plan: PlanKind,
) -> Read<Variable> {
    let reader = Reader { sources, name, table };
    let draw = reader.draw(plan)?;
    let source = table.item(VariableKey::SOURCE).map(|item| item.text().to_owned());
    Ok(Variable { name: name.to_owned(), source, draw })
}

struct Reader<'r, 's> {
    sources: &'r Sources<'s>,
    name: &'r str,
    table: Of<'r, VariableKey>,
}

impl Reader<'_, '_> {
    fn draw(&self, plan: PlanKind) -> Read<Draw> {
        let given = |key: &AnyKey<VariableKey>| self.given(*key);
        let ways = any_keys![VariableKey: VALUES, CHOICE, DISTRIBUTION, EXPRESSION];
        let ways: Vec<Entry<'_, Anything>> = ways.iter().filter_map(given).collect();
        if let [_, second, ..] = ways[..] {
            let names = ways.iter().map(|item| format!("`{}`", item.name)).collect::<Vec<_>>();
            return self.refused(second, |path| {
                format!("`{path}` does not go together: the variable has {}", names.join(" and "))
            });
        }
        let of_law = OF_LAWS.iter().find_map(given);
        if let (Some(item), None) = (of_law, self.given(VariableKey::DISTRIBUTION)) {
            return self.refused(item, |path| {
                format!("`{path}` belongs to a `distribution`, which is missing")
            });
        }
        match ways.first() {
            Some(item) if item.is(VariableKey::VALUES) => self.values().map(Draw::Choices),
            Some(item) if item.is(VariableKey::CHOICE) => self.several().map(Draw::Choices),
            Some(item) if item.is(VariableKey::DISTRIBUTION) => self.distribution(plan),
            Some(_) => {
                let item = self.table.given(VariableKey::EXPRESSION);
                let text = item.text().to_owned();
                Ok(Draw::Expression { text, target: self.target(None, &item.span)? })
            }
            None if plan == PlanKind::Table => {
                let column =
                    self.table.item(VariableKey::COLUMN).map_or(self.name, Entry::text).to_owned();
                let span = self
                    .given(VariableKey::COLUMN)
                    .map_or(&self.table.span, |item| &item.item().span);
                Ok(Draw::Column { column, target: self.target(None, span)? })
            }
            None => self.missing(),
        }
    }

    /// A key of the variable, if the file gives it.
    fn given<V>(&self, key: Key<VariableKey, V>) -> Option<Entry<'_, V>> {
        self.table.item(key).filter(|item| !item.is_default)
    }

    fn refused<T, V>(&self, item: Entry<'_, V>, message: impl FnOnce(&str) -> String) -> Read<T> {
        let path = self.table.path_to(item);
        Err(self.sources.error(&item.span, &path, message(&path)))
    }

    fn missing<T>(&self) -> Read<T> {
        let missing = match self.keys()?.is_empty() {
            true => VariableKey::KEY.any(),
            false => VariableKey::VALUES.any(),
        };
        let path = self.table.path_of(missing);
        let error = self.sources.error(&self.table.span, &path, format!("`{path}` is missing"));
        Err(error.with_help(
            "give `key` with `values`, a `distribution` or an `expression`, or a [variable.NAME.choice.NAME] for each value",
        ))
    }

    fn keys(&self) -> Read<Vec<(String, Origin)>> {
        let several = self.table.given(VariableKey::KEYS);
        match self.table.item(VariableKey::KEY) {
            Some(_) if !several.texts().is_empty() => {
                self.refused(several, |path| format!("`{path}` does not go together with `key`"))
            }
            Some(key) => Ok(vec![(key.text().to_owned(), self.sources.origin(&key.span))]),
            None => {
                Ok(several.texts().iter().cloned().zip(origins(self.sources, several)).collect())
            }
        }
    }

    /// The keys that a variable sets and their unit; `found` is the unit of the numbers that were read, `values` is the
    /// place of the values in the file.
    fn target(&self, found: Option<String>, values: &Span) -> Read<Target> {
        let (keys, key_origins): (Vec<String>, Vec<Origin>) = self.keys()?.into_iter().unzip();
        let values = self.sources.origin(values);
        for (key, origin) in keys.iter().zip(&key_origins) {
            Override::from_files((key, origin.clone()), ("0", values.clone()))?;
        }
        let own = self.table.item(VariableKey::UNIT);
        if let (Some(item), Some(found)) = (own, &found)
            && item.text() != found
        {
            return self.refused(item, |path| {
                format!(
                    "`{path}` is {}, but a number of the law is in {found}",
                    quoted(item.text())
                )
            });
        }
        let is_plain = own.is_some_and(|item| item.text().is_empty());
        let unit = own.map(|item| item.text().to_owned()).or(found).unwrap_or_default();
        let origins = TargetOrigins { keys: key_origins, values: Some(values) };
        Ok(Target { keys, unit, is_plain, origins })
    }

    fn values(&self) -> Read<Vec<Choice>> {
        let values = self.table.given(VariableKey::VALUES);
        let keys = self.keys()?;
        if keys.is_empty() {
            return self.missing();
        }
        if let Some(unit) = self.table.item(VariableKey::UNIT) {
            return self.refused(unit, |path| {
                format!("`{path}` does not go together with `values`, which have units themselves")
            });
        }
        let weights = match self.given(VariableKey::WEIGHTS) {
            None => vec![1.0; values.texts().len()],
            Some(item) if item.texts().len() != values.texts().len() => {
                let (own, wanted) = (item.texts().len(), values.texts().len());
                return self.refused(item, |path| {
                    format!("`{path}` has {own} numbers for {wanted} values")
                });
            }
            Some(item) => {
                let one = |text: &String| match text.parse::<f64>() {
                    Ok(weight) if weight >= 0.0 && weight.is_finite() => Ok(weight),
                    _ => self.refused(item, |path| {
                        format!("`{path}` has {}, which is not a number from 0", quoted(text))
                    }),
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
        let keys = any_keys![VariableKey: KEY, KEYS];
        if let Some(item) = keys.iter().find_map(|key| self.given(*key)) {
            return self
                .refused(item, |path| format!("`{path}` does not go together with `choice`"));
        }
        let item = self.table.given(VariableKey::CHOICE);
        let one = |(label, choice): (&String, Of<'_, _>)| {
            let changes = changes(
                self.sources,
                &choice.path_of(ChoiceKey::SET),
                choice.given(ChoiceKey::SET),
            )?;
            Ok(Choice {
                label: label.clone(),
                changes,
                weight: *choice.given(ChoiceKey::WEIGHT).number(),
            })
        };
        let choices = item.named().iter().map(one).collect::<Read<Vec<Choice>>>()?;
        self.checked(choices, item)
    }

    /// Checks that the choices differ, and that at least one choice can be drawn.
    fn checked<V>(&self, choices: Vec<Choice>, item: Entry<'_, V>) -> Read<Vec<Choice>> {
        if choices.is_empty() {
            return self.refused(item, |path| format!("`{path}` is empty"));
        }
        for (index, choice) in choices.iter().enumerate() {
            if choices[..index].iter().any(|other| other.label == choice.label) {
                return self
                    .refused(item, |path| format!("`{path}` has {} twice", quoted(&choice.label)));
            }
        }
        if !choices.iter().any(|choice| choice.weight > 0.0) {
            return self.refused(item, |path| {
                format!("`{path}` has no weight above 0: nothing can be drawn")
            });
        }
        Ok(choices)
    }

    fn distribution(&self, plan: PlanKind) -> Read<Draw> {
        let item = self.table.given(VariableKey::DISTRIBUTION);
        if matches!(plan, PlanKind::FullFactorial | PlanKind::Table) {
            return self.refused(item, |path| {
                format!(
                    "`{path}` goes with a random plan: \"Monte Carlo\", \"Latin hypercube\" or \
                     \"Sobol\""
                )
            });
        }
        match item.choice() {
            FamilyKind::Empirical => {
                if let Some(item) = OF_LAWS.iter().find_map(|key| self.given(*key)) {
                    return self.refused(item, |path| {
                        format!("`{path}` does not go with an \"empirical\" distribution")
                    });
                }
                let Some(file) = self.table.item(VariableKey::FILE) else {
                    return self.refused(item, |path| {
                        format!("`{path}` \"empirical\" needs a `file` of measured values")
                    });
                };
                let column =
                    self.table.item(VariableKey::COLUMN).map_or(self.name, Entry::text).to_owned();
                Ok(Draw::Measured {
                    file: PathBuf::from(file.text()),
                    column,
                    target: self.target(None, &file.span)?,
                })
            }
            FamilyKind::Law(family) => {
                if let Some(file) = self.table.item(VariableKey::FILE) {
                    return self.refused(file, |path| {
                        format!("`{path}` goes with an \"empirical\" distribution alone")
                    });
                }
                let mut numbers = Numbers { reader: self, unit: None };
                let law = numbers.law(item, family)?;
                let unit = numbers.unit;
                Ok(Draw::Law(law, self.target(unit, &item.span)?))
            }
        }
    }
}

/// Reads the parameters of a law, which have a common unit.
struct Numbers<'n, 'r, 's> {
    reader: &'n Reader<'r, 's>,
    unit: Option<String>,
}

impl Numbers<'_, '_, '_> {
    /// Reads a parameter of the law in the variable's unit.
    fn measured(&mut self, item: Entry<'_, Text>) -> Read<f64> {
        let (value, unit) = match number::split(item.text()) {
            Ok(split) => split,
            Err(why) => {
                return self.reader.refused(item, |path| {
                    format!("`{path}` must be a number with its unit: {why}")
                });
            }
        };
        match &self.unit {
            Some(first) if first != unit => {
                let (first, unit) = (quoted(first), quoted(unit));
                self.reader.refused(item, |path| {
                    format!(
                        "`{path}` is in {unit}, but another parameter is in {first}: write one unit"
                    )
                })
            }
            _ => {
                self.unit = Some(unit.to_owned());
                Ok(value)
            }
        }
    }

    /// Reads a parameter of the law that has no unit.
    fn plain(&self, item: Entry<'_, Text>) -> Read<f64> {
        match number::split(item.text()) {
            Ok((value, "")) => Ok(value),
            _ => self
                .reader
                .refused(item, |path| format!("`{path}` must be a number without a unit")),
        }
    }

    fn law<V>(&mut self, item: Entry<'_, V>, family: LawFamily) -> Read<Law> {
        let table = self.reader.table;
        let of_family: &[&[Parameter]] = match family {
            LawFamily::Normal => &[&[VariableKey::MEAN, VariableKey::STANDARD_DEVIATION]],
            LawFamily::Lognormal => &[
                &[VariableKey::MEAN, VariableKey::STANDARD_DEVIATION],
                &[VariableKey::LOG_MEAN, VariableKey::LOG_STANDARD_DEVIATION],
            ],
            LawFamily::Weibull => &[
                &[VariableKey::MEAN, VariableKey::STANDARD_DEVIATION],
                &[VariableKey::SCALE, VariableKey::SHAPE],
            ],
            LawFamily::Gumbel => &[
                &[VariableKey::MEAN, VariableKey::STANDARD_DEVIATION],
                &[VariableKey::LOCATION, VariableKey::SCALE],
            ],
            LawFamily::Uniform => &[
                &[VariableKey::MEAN, VariableKey::STANDARD_DEVIATION],
                &[VariableKey::LOWER, VariableKey::UPPER],
            ],
            LawFamily::Triangular => {
                &[&[VariableKey::LOWER, VariableKey::MODE, VariableKey::UPPER]]
            }
        };
        let bounds = any_keys![VariableKey: AT_LEAST, AT_MOST];
        let given: Vec<AnyKey<VariableKey>> = OF_LAWS
            .iter()
            .copied()
            .filter(|key| !bounds.contains(key) && self.reader.given(*key).is_some())
            .collect();
        let way = match given[..] {
            [key] if key == VariableKey::QUANTILES.any() => None,
            _ => {
                let fits = |way: &&&[Parameter]| {
                    way.len() == given.len() && way.iter().all(|key| given.contains(&key.any()))
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
                    return self.reader.refused(item, |path| format!("`{path}` {message}"));
                };
                Some(*way)
            }
        };
        let law = match way {
            None => {
                let quantiles = table.given(VariableKey::QUANTILES);
                let each: Vec<_> = quantiles.list().iter().collect();
                let [one, other] = each[..] else {
                    return self
                        .reader
                        .refused(quantiles, |path| format!("`{path}` must be two quantiles"));
                };
                let mut read = |table: Of<'_, QuantileKey>| -> Read<(f64, f64)> {
                    Ok((
                        *table.given(QuantileKey::PROBABILITY).number(),
                        self.measured(table.given(QuantileKey::VALUE))?,
                    ))
                };
                Law::by_quantiles(family, [read(one)?, read(other)?])
            }
            Some(way) => {
                let mut values = Vec::new();
                for &key in way {
                    let own = table.given(key);
                    let is_plain = PLAIN.contains(&key);
                    values.push(if is_plain { self.plain(own)? } else { self.measured(own)? });
                }
                match (family, way[0] == VariableKey::MEAN, &values[..]) {
                    (LawFamily::Normal, _, [a, b]) => Law::normal(*a, *b),
                    (LawFamily::Lognormal, true, [a, b]) => Law::lognormal(*a, *b),
                    (LawFamily::Lognormal, _, [a, b]) => Law::lognormal_by_logarithm(*a, *b),
                    (LawFamily::Weibull, true, [a, b]) => Law::weibull_by_moments(*a, *b),
                    (LawFamily::Weibull, _, [a, b]) => Law::weibull(*a, *b),
                    (LawFamily::Gumbel, true, [a, b]) => Law::gumbel_by_moments(*a, *b),
                    (LawFamily::Gumbel, _, [a, b]) => Law::gumbel(*a, *b),
                    (LawFamily::Uniform, true, [a, b]) => Law::uniform_by_moments(*a, *b),
                    (LawFamily::Uniform, _, [a, b]) => Law::uniform(*a, *b),
                    (LawFamily::Triangular, _, [a, b, c]) => Law::triangular(*a, *b, *c),
                    other => unreachable!("{other:?}"),
                }
            }
        };
        let mut bound = |name: Parameter| -> Read<Option<f64>> {
            self.reader.given(name).map(|item| self.measured(item)).transpose()
        };
        let (lowest, highest) = (bound(VariableKey::AT_LEAST)?, bound(VariableKey::AT_MOST)?);
        let law = law.and_then(|law| match (lowest, highest) {
            (None, None) => Ok(law),
            _ => law.within(lowest, highest),
        });
        match law {
            Ok(law) => Ok(law),
            Err(why) => {
                let path = table.path_of(VariableKey::DISTRIBUTION);
                Err(self.reader.sources.error(&item.span, &path, format!("`{path}`: {why}")))
            }
        }
    }
}

/// Reads the changes of a list of texts KEY=VALUE.
pub(super) fn changes(
    sources: &Sources<'_>,
    path: &str,
    item: Entry<'_, Texts>,
) -> Read<Vec<Change>> {
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

/// The places of the texts of a list in the file.
fn origins(sources: &Sources<'_>, item: Entry<'_, Texts>) -> Vec<Origin> {
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
