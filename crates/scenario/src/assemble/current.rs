//! Reads the current: uniform, by depth, or by place and time from a file.

use fenderline_contact::vec2;
use fenderline_sim::environment::current::{Current, CurrentGrid, CurrentProfile};

use super::assembly::{Assembly, Checked};
use super::environment::{DIRECTIONS_DEG, TIMES_S, along};
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::csv::Csv;
use fenderline_keys::held::{Number, TableOf, Text};
use fenderline_keys::keys::environment::{CurrentKey, LayerKey};

/// Columns of a file with the current by place and time.
const COLUMNS: [&str; 7] =
    ["t_s", "north_m", "east_m", "north_mps", "east_mps", "speed_mps", "towards_deg"];
/// Bounds of places (m) and times (s) in a file of the current.
const PLACES_OR_TIMES: [f64; 2] = TIMES_S;
/// Largest speed in a file of the current (m/s).
const FASTEST_MPS: f64 = 15.0;

impl Assembly<'_, '_> {
    pub(super) fn current<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, TableOf<CurrentKey>>,
    ) -> Checked<Current> {
        let of = item.table();
        let velocity = |towards: Entry<'_, Number>, speed: Entry<'_, Number>| {
            along(*towards.number()) * *speed.number()
        };
        if let Some(file) = of.item(CurrentKey::FILE) {
            self.none_of(of, any_keys![CurrentKey: SPEED, TOWARDS, PROFILE], "file")?;
            return self.grid(of, file).map(Current::Grid);
        }
        if let Some(profile) = of.item(CurrentKey::PROFILE) {
            self.none_of(of, any_keys![CurrentKey: SPEED, TOWARDS], "profile")?;
            let layers = profile.list().iter();
            let layers = layers.map(|layer| {
                let (towards, speed) =
                    (layer.given(LayerKey::TOWARDS), layer.given(LayerKey::SPEED));
                (*layer.given(LayerKey::DEPTH).number(), velocity(towards, speed))
            });
            let profile_read = CurrentProfile::new(layers.collect());
            return profile_read
                .map(Current::Layered)
                .map_err(|error| self.refused(of, profile, &error));
        }
        let help = "a current has a `speed` and a `towards`, a `profile`, or a `file`";
        self.all_of(of, any_keys![CurrentKey: SPEED, TOWARDS], help)?;
        Current::uniform(velocity(of.given(CurrentKey::TOWARDS), of.given(CurrentKey::SPEED)))
            .map_err(|error| self.refused(table, item, &error))
    }

    /// A file of currents. Reads a file with the current by place and time. Without a column of time or place the
    /// current does not depend on time or place.
    fn grid(&self, of: Of<'_, CurrentKey>, file: Entry<'_, Text>) -> Checked<CurrentGrid> {
        let key = of.path_of(CurrentKey::FILE);
        let csv = Csv::parse(self.files.text(file.text()), file.text(), &key, &COLUMNS)?;
        let by_place = csv.has("north_m") || csv.has("east_m");
        let by_time = csv.has("t_s");
        let mut columns = Vec::new();
        if by_time {
            columns.push(csv.column("t_s")?);
        }
        if by_place {
            columns.extend([csv.column("north_m")?, csv.column("east_m")?]);
        }
        if columns.is_empty() {
            let message =
                "the file of the current has neither times (t_s) nor places (north_m, east_m)";
            return Err(csv
                .header_error(message)
                .with_help("write `speed` and `towards` instead of a `file`"));
        }
        let by_direction = csv.has("speed_mps") || csv.has("towards_deg");
        if by_direction && (csv.has("north_mps") || csv.has("east_mps")) {
            let message = "give the velocity as north_mps and east_mps or as speed_mps and \
                           towards_deg, not as both";
            return Err(csv.header_error(message));
        }
        let [one, other] = match by_direction {
            true => [csv.column("speed_mps")?, csv.column("towards_deg")?],
            false => [csv.column("north_mps")?, csv.column("east_mps")?],
        };
        for row in 0..csv.row_count() {
            for column in &columns {
                csv.number(row, *column, PLACES_OR_TIMES)?;
            }
        }
        let grid = csv.grid(&columns)?;
        let velocities = grid.rows.iter().map(|&row| {
            Ok(if by_direction {
                let speed_mps = csv.number(row, one, [0.0, FASTEST_MPS])?;
                along(csv.number(row, other, DIRECTIONS_DEG)?.to_radians()) * speed_mps
            } else {
                let bounds = [-FASTEST_MPS, FASTEST_MPS];
                vec2(csv.number(row, one, bounds)?, csv.number(row, other, bounds)?)
            })
        });
        let velocities = velocities.collect::<Checked<Vec<_>>>()?;
        let mut axes = grid.axes.into_iter();
        let mut axis = |is_there: bool| match is_there {
            true => axes.next().unwrap_or_default(),
            false => vec![0.0],
        };
        let (times_s, north_m, east_m) = (axis(by_time), axis(by_place), axis(by_place));
        CurrentGrid::new(times_s, north_m, east_m, velocities)
            .map_err(|error| self.refused(of, file, &error))
    }
}
