//! Checks which keys of a row of fenders may be given together.

use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::keys::fender_row::FenderRowKey;
use fenderline_keys::sources::Sources;
use fenderline_keys::typed_key::AnyKey;

type RowKey = AnyKey<FenderRowKey>;

const NOT_TOGETHER: [(RowKey, &[RowKey]); 3] = [
    (
        FenderRowKey::DOLPHINS.any(),
        any_keys![FenderRowKey: ON, WALL, QUAY_LINE, FROM_CORNER, LAST, SPACING, NUMBER],
    ),
    (FenderRowKey::QUAY_LINE.any(), any_keys![FenderRowKey: WALL, FIRST, LAST, FACING]),
    (FenderRowKey::WALL.any(), any_keys![FenderRowKey: FIRST, LAST]),
];
const ONLY_WITH: [(RowKey, &[RowKey]); 4] = [
    (FenderRowKey::OUTLINE.any(), any_keys![FenderRowKey: DOLPHINS]),
    (FenderRowKey::HEADING.any(), any_keys![FenderRowKey: DOLPHINS]),
    (FenderRowKey::DOLPHIN.any(), any_keys![FenderRowKey: DOLPHINS]),
    (FenderRowKey::FROM_CORNER.any(), any_keys![FenderRowKey: WALL, QUAY_LINE]),
];
const NEEDS: [(RowKey, &[RowKey]); 3] = [
    (FenderRowKey::DOLPHINS.any(), any_keys![FenderRowKey: OUTLINE]),
    (FenderRowKey::QUAY_LINE.any(), any_keys![FenderRowKey: SPACING]),
    (FenderRowKey::WALL.any(), any_keys![FenderRowKey: SPACING, NUMBER]),
];

/// Refuses a row whose keys place the row in two ways, or do not suffice to place the row.
pub(crate) fn check_placing(
    sources: &Sources<'_>,
    row: Of<'_, FenderRowKey>,
) -> Result<(), ScenarioError> {
    let refuse = |item: Entry<'_, _>, message: String, help: &str| {
        let error = sources.error(&item.key_span, &row.path_to(item), message);
        Err(error.with_help(help))
    };
    for (one, others) in NOT_TOGETHER {
        let other = others.iter().find_map(|other| row.item(*other));
        if let (Some(_), Some(item)) = (row.item(one), other) {
            let message = format!("`{}` does not go together with `{one}`", row.path_to(item));
            return refuse(item, message, "keep only one of the two keys");
        }
    }
    for (name, with) in ONLY_WITH {
        if let (Some(item), None) = (row.item(name), row.first_of(with)) {
            let words: Vec<String> = with.iter().map(|key| format!("`{key}`")).collect();
            let with = words.join(" or ");
            let message = format!("`{}` is for rows with {with}", row.path_to(item));
            return refuse(item, message, &format!("remove `{name}` or give {with}"));
        }
    }
    for (name, needs) in NEEDS {
        let missing = needs.iter().find(|needed| row.item(**needed).is_none());
        if let (Some(_), Some(missing)) = (row.item(name), missing) {
            let path = row.path_of(*missing);
            let error = sources.error(&row.span, &path, format!("`{path}` is missing"));
            return Err(error.with_help(format!("a row with `{name}` needs `{missing}`")));
        }
    }
    Ok(())
}
