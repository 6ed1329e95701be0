//! Keys of wind, current, waves, water and banks.

use fenderline_sim::Rain;
use fenderline_sim::environment::BankMethod;
use fenderline_sim::hydro::Squat;
use serde_json::json;

use super::bottom::{BOTTOM, BottomKey};
use super::chart::{ChartOriginKey, PLACE};
use super::long_waves::{LONG_WAVES, LongWavesKey};
use super::passing::{INTERACTION, InteractionKey};
use super::quantities::{DIRECTION, POSITION, SEED};
use crate::choices::{Choice, Choices};
use crate::held::{Flag, ListOf, Number, OneOf, TableOf, Text, Vector};
use crate::spec::Absent::{Is, Means, Refused, Unless};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static ENVIRONMENT: TableSpec = TableSpec {
    what: "an environment",
    doc: "Wind, current, waves and water; they act on vessels.",
    keys: EnvironmentKey::ALL,
    rules: Some(|| {
        json!({
            "not": { "required": ["depth", "bottom"] },
            "dependentRequired": { "place": ["start_time"] },
            "dependentSchemas": {
                "squat": { "anyOf": [{ "required": ["depth"] }, { "required": ["bottom"] }] }
            },
            "if": {
                "required": ["long_waves"],
                "properties": { "long_waves": { "required": ["height"] } }
            },
            "then": { "anyOf": [{ "required": ["depth"] }, { "required": ["bottom"] }] }
        })
    }),
};

static RAINS: Choices<Rain> = Choices(&[
    Choice { word: Rain::Light.word(), value: Rain::Light, doc: "some 2 mm in an hour" },
    Choice { word: Rain::Moderate.word(), value: Rain::Moderate, doc: "some 5 mm in an hour" },
    Choice { word: Rain::Heavy.word(), value: Rain::Heavy, doc: "10 mm in an hour or more" },
]);

table_keys! {
    /// Keys of an environment.
    pub EnvironmentKey {
        DEPTH: Number = key(
            "depth",
            Kind::Quantity(DEPTH),
            Means("deep water"),
            "Depth of the water below datum; negative if the bottom is above datum. Shallow water \
             changes hull forces and added mass and makes a vessel squat; a vessel is aground if \
             the depth is less than draught plus squat. The corrections for shallow water are \
             valid from a depth of 1.2 draughts on; below 1.1 draughts they keep their values for \
             1.1 draughts.",
            &["\"14 m\""],
        ),
        BOTTOM: TableOf<BottomKey> = key(
            "bottom",
            Kind::Table(&BOTTOM),
            Means("the water is as deep everywhere as `depth` says"),
            "Depth of the water by place, instead of `depth`. The formulas of waves, which need a single \
             depth, use the median of the depths in the water.",
            &["{ chart = \"interpolated\", outside = \"30 m\" }"],
        ),
        WATER_DENSITY: Number = key(
            "water_density",
            Kind::Quantity(Quantity { measure: &unit::DENSITY, low: 900.0, high: 1300.0 }),
            Is("1025"),
            "Density of the water.",
            &["\"1025 kg/m^3\""],
        ),
        AIR_DENSITY: Number = key(
            "air_density",
            Kind::Quantity(Quantity { measure: &unit::DENSITY, low: 0.5, high: 2.0 }),
            Is("1.225"),
            "Density of the air. OCIMF's wind formulas are used with an air density of 1.28 kg/m³ \
             (which we read in a user's calculation, not in the guideline).",
            &["\"1.28 kg/m^3\""],
        ),
        SQUAT: OneOf<Option<Squat>> = key(
            "squat",
            Kind::Choice(&SQUATS),
            Means("\"icorels\" if `depth` or `bottom` is given"),
            "Sinkage of a vessel under way in shallow water, by one of PIANC's formulas for open \
             water, or with the blockage of a channel. The formulas of squat give the sinkage of \
             the deepest point of the hull; in the program the whole hull sinks by this amount, \
             without trim.",
            &["\"icorels\""],
        ),
        TIDE: TableOf<TideKey> = key(
            "tide",
            Kind::Table(&TIDE),
            Means("the water level is at datum"),
            "Level of the water above datum. The level of the tide is added to `depth`; heights on \
             bodies that do not float (`above_water` of a fender, `bollard_height` of a line) \
             count from datum.",
            &["{ level = \"1.8 m\" }"],
        ),
        WIND: TableOf<WindKey> = key("wind", Kind::Table(&WIND), Means("no wind"), "Wind.", &[]),
        CURRENT: TableOf<CurrentKey> = key(
            "current",
            Kind::Table(&CURRENT),
            Means("no current"),
            "Current.",
            &[],
        ),
        WAVES: TableOf<WavesKey> = key(
            "waves",
            Kind::Table(&WAVES),
            Means("no waves"),
            "Waves.",
            &[],
        ),
        LONG_WAVES: TableOf<LongWavesKey> = key(
            "long_waves",
            Kind::Table(&LONG_WAVES),
            Means("no long waves"),
            "Long waves at a berth: infragravity waves or a seiche.",
            &[],
        ),
        INTERACTION: TableOf<InteractionKey> = key(
            "interaction",
            Kind::Table(&INTERACTION),
            Is("{}"),
            "How the flow of water about vessels and passing ships pushes other vessels.",
            &[],
        ),
        VISIBILITY: Number = key(
            "visibility",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 50.0, high: 50e3 }),
            Means("clear"),
            "How far people see in a live session: the pages of pilot and tugmasters do not show ships that are farther \
             away.",
            &["\"500 m\""],
        ),
        RAIN: OneOf<Rain> = key(
            "rain",
            Kind::Choice(&RAINS),
            Means("no rain"),
            "Rain in the view out of the window of live pages. How far people see is `visibility`; no force depends on \
             the rain.",
            &["\"moderate\""],
        ),
        START_TIME: Text = key(
            "start_time",
            Kind::Text,
            Means("the palette of the page says whether it is day, dusk or night"),
            "Date and time at the start of the run, with the offset from universal time: the view out of the window of live \
             pages has the sun of this time. No force depends on the time.",
            &["\"2026-06-21T05:30+02:00\""],
        ),
        PLACE: TableOf<ChartOriginKey> = key(
            "place",
            Kind::Table(&PLACE),
            Means("the origin of the chart; without such an origin `start_time` needs the place"),
            "Latitude and longitude of the scenario's origin, for the sun at `start_time`.",
            &["{ latitude = \"53.52 deg\", longitude = \"9.94 deg\" }"],
        ),
        BANK: ListOf<BankKey> = key(
            "bank",
            Kind::List(&BANK),
            Is("[]"),
            "UNVALIDATED. Banks that attract a vessel under way; the key `method` of each bank \
             chooses the formula of its force. A bank alone does not stop a vessel: add a fixed \
             body with the shape of the bank.",
            &["[{ from = [-500, 40], to = [500, 40] }]"],
        ),
    }
}

static TIDE: TableSpec = TableSpec {
    what: "a tide",
    doc: "Level of the water above datum: a constant `level`, constituents about a mean `level`, \
          or a `file`. A vessel's hull forces, squat and under-keel clearance follow the tide. The \
          tide does not change added mass and the depth in the formulas of waves: both keep their \
          values at the start.",
    keys: TideKey::ALL,
    rules: Some(|| {
        json!({ "oneOf": [
            { "required": ["level"], "properties": { "file": false } },
            { "required": ["file"], "properties": { "level": false, "constituent": { "maxItems": 0 } } }
        ] })
    }),
};

table_keys! {
    /// Keys of a tide.
    pub TideKey {
        LEVEL: Number = key(
            "level",
            Kind::Quantity(LEVEL),
            Unless("`file` is given"),
            "Level of the water above datum; if the tide has constituents, the mean level.",
            &["\"1.8 m\""],
        ),
        CONSTITUENT: ListOf<ConstituentKey> = key(
            "constituent",
            Kind::List(&CONSTITUENT),
            Is("[]"),
            "Constituents of the tide. Each constituent adds amplitude x cos(2 pi t / period - \
             lag) to the water level.",
            &["[{ amplitude = \"1.5 m\", period = \"12.4206 h\", lag = \"90 deg\" }]"],
        ),
        FILE: Text = key(
            "file",
            Kind::FileName,
            Unless("`level` is given"),
            "The water level in time: a CSV file beside the scenario with the columns t_s and \
             level_m. The level is linear between the rows, and constant before the first and \
             after the last row.",
            &["\"tide.csv\""],
        ),
    }
}

const DEPTH: Quantity = Quantity { measure: &unit::LENGTH, low: -30.0, high: 12_000.0 };
const LEVEL: Quantity = Quantity { measure: &unit::LENGTH, low: -30.0, high: 30.0 };

static CONSTITUENT: TableSpec = TableSpec {
    what: "a constituent of a tide",
    doc: "One constituent of a tide.",
    keys: ConstituentKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a constituent of a tide.
    pub ConstituentKey {
        AMPLITUDE: Number = key(
            "amplitude",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 30.0 }),
            Refused,
            "Amplitude: half the range.",
            &["\"1.5 m\""],
        ),
        PERIOD: Number = key(
            "period",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 60.0, high: 1e9 }),
            Refused,
            "Period of the constituent; the period of the tidal constituent M2 is 12.4206 h.",
            &["\"12.4206 h\""],
        ),
        LAG: Number = key(
            "lag",
            Kind::Quantity(DIRECTION),
            Is("0"),
            "Phase lag of the constituent; with a lag of 0, the constituent has its high water at \
             the start.",
            &["\"90 deg\""],
        ),
    }
}

static WIND: TableSpec = TableSpec {
    what: "a wind",
    doc: "Wind at 10 m height: `speed` and `from`, or a `file`.",
    keys: WindKey::ALL,
    rules: Some(|| {
        json!({ "oneOf": [
            { "required": ["speed", "from"], "properties": { "file": false } },
            {
                "required": ["file"],
                "properties": {
                    "speed": false, "from": false, "gusts": false, "gust_admittance": false, "seed": false
                }
            }
        ] })
    }),
};

table_keys! {
    /// Keys of a wind.
    pub WindKey {
        SPEED: Number = key(
            "speed",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 0.0, high: 120.0 }),
            Unless("`file` is given"),
            "Mean speed.",
            &["\"12 m/s\""],
        ),
        FROM: Number = key(
            "from",
            Kind::Quantity(DIRECTION),
            Unless("`file` is given"),
            "Direction from which the wind comes, clockwise from north.",
            &["\"270 deg\""],
        ),
        FILE: Text = key(
            "file",
            Kind::FileName,
            Unless("`speed` and `from` of the wind are given"),
            "A wind that changes in time: a CSV file beside the scenario with the columns t_s, \
             speed_mps and from_deg. The wind changes linearly between the rows, its direction by \
             the shorter turn; before the first and after the last row the wind is constant.",
            &["\"wind.csv\""],
        ),
        GUSTS: Flag = key(
            "gusts",
            Kind::Flag,
            Means("no gusts"),
            "Adds gusts by the NPD spectrum of ISO 19901-1.",
            &["true"],
        ),
        GUST_ADMITTANCE: Flag = key(
            "gust_admittance",
            Kind::Flag,
            Means("true"),
            "Whether the mean of the gusts over a vessel's length and height acts on the vessel \
             (aerodynamic admittance). If false, each gust acts on the whole vessel at once.",
            &["false"],
        ),
        SEED: Number = key(
            "seed",
            Kind::Quantity(SEED),
            Means("1"),
            "Seed of the gusts: the same seed gives the same wind.",
            &["7"],
        ),
    }
}

static CURRENT: TableSpec = TableSpec {
    what: "a current",
    doc: "A current: uniform and steady (`speed`, `towards`), by depth (`profile`), or by place \
        and time (`file`). The current at a vessel's centre of gravity, averaged over her draught, \
        acts on the vessel.",
    keys: CurrentKey::ALL,
    rules: Some(|| {
        json!({ "oneOf": [
            { "required": ["speed", "towards"], "properties": { "profile": false, "file": false } },
            {
                "required": ["profile"],
                "properties": {
                    "profile": { "minItems": 1 }, "speed": false, "towards": false, "file": false
                }
            },
            {
                "required": ["file"],
                "properties": { "speed": false, "towards": false, "profile": false }
            }
        ] })
    }),
};

table_keys! {
    /// Keys of a current.
    pub CurrentKey {
        SPEED: Number = key(
            "speed",
            Kind::Quantity(CURRENT_SPEED),
            Unless("`profile` or `file` of the current is given"),
            "Speed of a uniform and steady current.",
            &["\"0.5 kn\""],
        ),
        TOWARDS: Number = key(
            "towards",
            Kind::Quantity(DIRECTION),
            Unless("`profile` or `file` of the current is given"),
            "Direction in which the current runs, clockwise from north.",
            &["\"10 deg\""],
        ),
        PROFILE: ListOf<LayerKey> = key(
            "profile",
            Kind::List(&LAYER),
            Means("the current is the same at every depth"),
            "The current at several depths, from the surface downwards: it is linear between the \
             depths, and constant above the first and below the last depth.",
            &[
                "[{ depth = 0, speed = 0.6, towards = 0 }, { depth = 15, speed = 0.1, towards = 0 \
                 }]",
            ],
        ),
        FILE: Text = key(
            "file",
            Kind::FileName,
            Unless("`speed` and `towards`, or `profile`, of the current are given"),
            "A current by place and time: a CSV file beside the scenario. The columns north_mps \
             and east_mps, or speed_mps and towards_deg, give the velocity; without the columns \
             north_m and east_m the current is uniform, and without the column t_s it is steady. \
             The file has one row for each combination of north_m, east_m and t_s, in any order. \
             The current is interpolated linearly in time and bilinearly in place; outside the \
             grid it has the value at the edge of the grid.",
            &["\"current.csv\""],
        ),
    }
}

const CURRENT_SPEED: Quantity = Quantity { measure: &unit::SPEED, low: 0.0, high: 15.0 };

static LAYER: TableSpec = TableSpec {
    what: "a layer of a current",
    doc: "The current at one depth.",
    keys: LayerKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a layer of a current.
    pub LayerKey {
        DEPTH: Number = key(
            "depth",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 12_000.0 }),
            Refused,
            "Depth of the layer of current below the surface. Each layer must be deeper than the layer before.",
            &["\"5 m\""],
        ),
        SPEED: Number = key(
            "speed",
            Kind::Quantity(CURRENT_SPEED),
            Refused,
            "Speed.",
            &["\"0.5 kn\""],
        ),
        TOWARDS: Number = key(
            "towards",
            Kind::Quantity(DIRECTION),
            Refused,
            "Direction in which the current runs, clockwise from north.",
            &["\"10 deg\""],
        ),
    }
}

static WAVES: TableSpec = TableSpec {
    what: "a sea",
    doc: "Waves: a sea with a JONSWAP spectrum, or one regular wave.",
    keys: WavesKey::ALL,
    rules: Some(|| {
        json!({ "not": {
            "required": ["regular", "spreading"], "properties": { "regular": { "const": true } }
        } })
    }),
};

table_keys! {
    /// Keys of a sea.
    pub WavesKey {
        HEIGHT: Number = key(
            "height",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 30.0 }),
            Refused,
            "Significant wave height, or height of the regular wave.",
            &["\"1.2 m\""],
        ),
        PERIOD: Number = key(
            "period",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.5, high: 40.0 }),
            Refused,
            "Peak period of the spectrum, or period of the regular wave.",
            &["\"8 s\""],
        ),
        FROM: Number = key(
            "from",
            Kind::Quantity(DIRECTION),
            Refused,
            "Direction from which the waves come, clockwise from north.",
            &["\"240 deg\""],
        ),
        REGULAR: Flag = key(
            "regular",
            Kind::Flag,
            Is("false"),
            "If true, the sea is one regular wave instead of a spectrum.",
            &["true"],
        ),
        PEAKEDNESS: Number = key(
            "peakedness",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 10.0 }),
            Is("3.3"),
            "JONSWAP's gamma.",
            &["3.3"],
        ),
        SPREADING: Number = key(
            "spreading",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 100.0 }),
            Means("long crests: all waves run in one direction"),
            "For a short-crested sea: exponent n of a cos^n spreading of the wave energy about the \
             mean direction; 2 for a wind sea, more for swell. The mean wave forces in short \
             crests are smaller than in long crests. A regular wave may not have this key.",
            &["2"],
        ),
        SEED: Number = key("seed", Kind::Quantity(SEED), Is("1"), "Seed of the phases.", &["7"]),
    }
}

static SQUATS: Choices<Option<Squat>> = Choices(&[
    Choice { word: "none", value: None, doc: "no squat" },
    Choice {
        word: "icorels",
        value: Some(Squat::Icorels),
        doc: "ICORELS: 2.4 V/L^2 Fh^2 / sqrt(1 - Fh^2) with the displaced volume V and the Froude number of depth Fh; \
             fades out in deep water",
    },
    Choice {
        word: "barrass",
        value: Some(Squat::Barrass),
        doc: "Barrass's formula for open water: block coefficient x knots^2 / 100, the same at \
              every depth; valid for depths of 1.1 to 1.4 draughts",
    },
    Choice {
        word: "eryuzlu",
        value: Some(Squat::Eryuzlu),
        doc: "formula of Eryuzlu et al. (1994) for open water; valid for depths of 1.1 to 2.5 \
              draughts",
    },
    Choice {
        word: "barrass_channel",
        value: Some(Squat::BarrassChannel),
        doc: "Barrass with the blockage of the channel: block coefficient x S2^(2/3) knots^2.08 / 30, S2 = section of \
              the ship / section of the water around her; if the depth is the same everywhere (`depth`), and in wide \
              water, S2 is computed with the section of open water",
    },
    Choice {
        word: "icorels_channel",
        value: Some(Squat::IcorelsChannel),
        doc: "ICORELS with the blockage of the channel: times Huuska's factor 7.45 s + 0.76, at least 1, with s = 0.98 beam x \
              draught / section of the water; with one depth, and in water wider than 30 beams, the same as \"icorels\"",
    },
]);

static BANK: TableSpec = TableSpec {
    what: "a bank",
    doc: "A straight vertical bank. Its effect is UNVALIDATED.",
    keys: BankKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a bank.
    pub BankKey {
        FROM: Vector = key(
            "from",
            Kind::Vector(POSITION),
            Refused,
            "Position of one end of the bank: north, east.",
            &["[-500, 40]"],
        ),
        TO: Vector = key(
            "to",
            Kind::Vector(POSITION),
            Refused,
            "Position of the other end of the bank: north, east.",
            &["[500, 40]"],
        ),
        METHOD: OneOf<BankMethod> = key(
            "method",
            Kind::Choice(&BANK_METHODS),
            Is("\"norrbin\""),
            "Method for the force of the bank. The method \"image\" takes the vessel's sectional \
             areas from `environment.interaction`.",
            &["\"image\""],
        ),
    }
}

static BANK_METHODS: Choices<BankMethod> = Choices(&[
    Choice {
        word: "norrbin",
        value: BankMethod::Norrbin,
        doc: "Norrbin's formulas for a vertical wall, which draw a vessel to the wall and turn her \
            bow away. We wrote Norrbin's formulas from memory; we could not read a source",
    },
    Choice {
        word: "image",
        value: BankMethod::Image,
        doc: "the flow of the vessel's image behind the wall, for slender ships in potential flow \
            without waves and lift; images in the bottom give the effect of the depth. The force \
            is suction alone, without a moment that turns the bow away. Compared with a panel \
            method, the suction force is 12 to 63 % too small. The force is left out nearer to the \
            bank than an eighth of the beam, at more than 30 degrees to the bank, and for vessels \
            shorter than 3.5 beams",
    },
]);

/// The description of `wave_response`.
pub(super) const WAVE_RESPONSE_DOC: &str = "First-order motion of the vessel in waves by a table \
    of response amplitude operators: a CSV file beside the scenario. The column omega_radps is the \
    frequency of the waves. The column heading_deg is the direction in which the waves run, \
    relative to the bow: 0 for waves from astern, 90 from port, 180 from ahead; waves from \
    starboard follow by mirror symmetry. The columns heave_mpm, roll_degpm and pitch_degpm, and \
    optionally surge_mpm, sway_mpm and yaw_degpm, are the amplitudes of the motions in a wave of 1 \
    m amplitude. The columns heave_phase_deg and so on are the phases of the motions: the lead of \
    the motion's maximum over the passage of the crest amidships. The motions are those of \
    midship, positive as follows: surge forward, sway to starboard, heave DOWN, roll to starboard, \
    pitch bow up, yaw to starboard. The file has one row for each combination of frequency and \
    heading. The operators are linear between the rows; outside the grid the value at the edge of \
    the grid is used.";

pub(super) const HYDRODYNAMICS_DOC: &str = "Hydrodynamic data of the vessel by a panel code: a \
    file beside the scenario file, which the Python module `fenderline.hydrodynamics` makes of \
    files of Capytaine, WAMIT, HAMS, Nemoh or AQWA. With such data the vessel moves in six degrees \
    of freedom by Cummins' equation, with added mass and damping by frequency, exciting forces, \
    mean and slow drift. Fenders and lines act where they are in space, and heave, roll and pitch \
    move them. Mass, centre of gravity and restoring come from the file of hydrodynamic data, in \
    place of `stability`.";
