//! Reads the data files that a scenario names, except fender and vessel files. The program reads these data files once,
//! before it builds the set-up.

use std::collections::BTreeMap;

use fenderline_keys::checked::{Item, Table, Value};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::sources::Sources;
use fenderline_keys::spec::Kind;

/// The text of each data file, by the file's name in the scenario.
#[derive(Debug, Default)]
pub(crate) struct Files(BTreeMap<String, String>);

/// Help in the error for a file that cannot be read.
pub(crate) const FILE_HELP: &str = "the path of the file starts from the folder of the scenario";

impl Files {
    /// Reads every file that the scenario's tables name.
    pub(crate) fn read(
        sources: &Sources<'_>,
        file: &Table,
        read: &mut dyn FnMut(&str) -> Result<String, String>,
    ) -> Result<Files, ScenarioError> {
        let mut files = Files::default();
        files.read_of(sources, file, read)?;
        Ok(files)
    }

    /// The text of a file that a key of the kind [`Kind::FileName`] or [`Kind::FileNames`] names.
    pub(crate) fn text(&self, name: &str) -> &str {
        self.0
            .get(name)
            .unwrap_or_else(|| unreachable!("the file {name} was read with the scenario"))
    }

    fn read_of(
        &mut self,
        sources: &Sources<'_>,
        table: &Table,
        read: &mut dyn FnMut(&str) -> Result<String, String>,
    ) -> Result<(), ScenarioError> {
        for item in &table.items {
            match &item.value {
                Value::Table(inner) => self.read_of(sources, inner, read)?,
                Value::Named(named) => {
                    for (_, inner) in named {
                        self.read_of(sources, inner, read)?;
                    }
                }
                Value::List(list) => {
                    for inner in list {
                        self.read_of(sources, inner, read)?;
                    }
                }
                Value::Text(name) if is_file_name(table, item.name) => {
                    self.read_one(sources, (table, item), name, read)?;
                }
                Value::Texts(names) if is_file_name(table, item.name) => {
                    for name in names {
                        self.read_one(sources, (table, item), name, read)?;
                    }
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn read_one(
        &mut self,
        sources: &Sources<'_>,
        (table, item): (&Table, &Item),
        name: &str,
        read: &mut dyn FnMut(&str) -> Result<String, String>,
    ) -> Result<(), ScenarioError> {
        if self.0.contains_key(name) {
            return Ok(());
        }
        let text = read(name).map_err(|why| {
            let path = table.path_to(item);
            let message = format!("`{path}`: cannot read {why}");
            sources.error(&item.span, &path, message).with_help(FILE_HELP)
        })?;
        self.0.insert(name.to_owned(), text);
        Ok(())
    }
}

fn is_file_name(table: &Table, name: &str) -> bool {
    table.spec.key(name).is_some_and(|key| matches!(key.kind, Kind::FileName | Kind::FileNames))
}
