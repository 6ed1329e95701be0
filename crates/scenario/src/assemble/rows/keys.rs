//! Which keys of a row go together.

use fenderline_keys::checked::{Item, Table};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::sources::Sources;

const NOT_TOGETHER: [(&str, &[&str]); 2] = [
    ("dolphins", &["on", "wall", "from_corner", "last", "spacing", "number"]),
    ("wall", &["first", "last"]),
];
const ONLY_WITH: [(&str, &str); 4] = [
    ("outline", "dolphins"),
    ("heading", "dolphins"),
    ("dolphin", "dolphins"),
    ("from_corner", "wall"),
];
const NEEDS: [(&str, &[&str]); 2] = [("dolphins", &["outline"]), ("wall", &["spacing", "number"])];

/// Refuses keys that place a row in two ways, or not enough of them.
pub(crate) fn check_placing(sources: &Sources<'_>, row: &Table) -> Result<(), ScenarioError> {
    let refuse = |item: &Item, message: String, help: &str| {
        let path = row.path_of(item.name);
        let error = sources.error(&item.key_span, &path, format!("`{path}` {message}"));
        Err(error.with_help(help))
    };
    for (one, others) in NOT_TOGETHER {
        let other = others.iter().find_map(|other| row.item(other));
        if let (Some(_), Some(item)) = (row.item(one), other) {
            return refuse(
                item,
                format!("does not go together with `{one}`"),
                "keep one of the two",
            );
        }
    }
    for (name, with) in ONLY_WITH {
        if let (Some(item), None) = (row.item(name), row.item(with)) {
            let help = format!("remove it or give `{with}`");
            return refuse(item, format!("is for rows with `{with}`"), &help);
        }
    }
    for (name, needs) in NEEDS {
        let missing = needs.iter().find(|needed| row.item(needed).is_none());
        if let (Some(_), Some(missing)) = (row.item(name), missing) {
            let path = row.path_of(missing);
            let error = sources.error(&row.span, &path, format!("`{path}` is missing"));
            return Err(error.with_help(format!("a row with `{name}` needs it")));
        }
    }
    Ok(())
}
