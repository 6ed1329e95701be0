//! Writes `web/src/protocol.ts` from the messages of this crate, and fails if the file is not as the messages are.
//!
//! `cargo xtask protocol` writes the file.

use std::fmt::Write;

use fenderline_author::{BerthingSide, NewBerth, NewExercise, NewShip, NewTugs, NewWeather};
use fenderline_sim::chart::{ChartKind, MarkColour, MarkMeaning, MarkShape, MarkSide};
use fenderline_sim::order::{Lead, SidePlace, TugWord, Word};
use fenderline_sim::{Fault, Rain, ShipType};
use ts_rs::{Config, TS};

use crate::action::{AnchorFault, CommandLimits, OtherAction};
use crate::approach::Light;
use crate::ghost::Ghost;
use crate::message;
use crate::request::{Conduct, Control, Creation};

const FILE: &str = "../../web/src/protocol.ts";
/// What the file has besides the types of the messages.
const HEAD: &str = r#"/**
 * The messages between server and page over the websocket `/live?token=…`: JSON text, one message a frame.
 *
 * Written from the messages in `crates/live/src` by `cargo xtask protocol`: change them there, not here.
 * Orders are in `orders.ts`. Units are SI: metres, seconds, radians, newtons, joules, kilograms. Earth-fixed places are
 * [north, east]; headings and bearings are from north, positive to starboard; body-fixed places are [forward, starboard].
 */

import type { Order } from "./orders";

/** A place or a vector: [north, east] or [forward, starboard]. */
export type Pair = [number, number];

/** State of a body: [north, east, heading, velocity north, velocity east, yaw rate]. */
export type BodyNow = [number, number, number, number, number, number];

/**
 * A harmonic of the sea: amplitude a [m], wave number k north and east [rad/m], angular frequency ω [rad/s], phase ε [rad]. The
 * height of the surface is the sum of a cos(ωt − k·x + ε).
 */
export type Wave = [a: number, north: number, east: number, omega: number, phase: number];

/** A point of a path: [t_s, north, east, heading]. */
export type PathPoint = [t_s: number, north: number, east: number, heading: number];

export type FromServer = Hello | Frame | Past | Reply;

/** Up to ten times a second: the predicted paths of up to three ships without further orders. */
export type Prediction = Extract<Reply, { type: "prediction" }>;
/** An answer to the command `trial`. */
export type Trial = Extract<Reply, { type: "trial" }>;
/** For instructors only: what is planned, by time, whenever the plan has changed. */
export type Planned = Extract<Reply, { type: "planned" }>;
export type Ack = Extract<Reply, { type: "ack" }>;
export type Refused = Extract<Reply, { type: "refused" }>;
export type Notice = Extract<Reply, { type: "notice" }>;

/** A tick as pages get it. The page interpolates between the last two frames. */
export type Frame = FrameOfAll & {
  /** For the instructor only: the marks of the exercise. */
  marks?: ExerciseMarks;
  /** The events since the last frame. */
  events: EventNow[];
};

/** What a page sends. */
export interface Command {
  type: "command";
  /** The page chooses the number; the answer has the same number. */
  id: number;
  action: Action;
}

/** Every command: an order of the table, or one of the others. */
export type Action = Order | OtherAction;
export type OtherAction = RecordedAction | Conduct;
/** An order to a tug in words. */
export type TugOrder = Extract<RecordedAction, { do: "tug" }>;
/** What a trial takes: an order of the table, or an order to a tug in words. */
export type TrialOrder = Order | TugOrder;

/** How grave a verdict or a finding is; `failed`: something broke or was struck, or the results are not valid. */
export type Gravity = "ok" | "note" | "attention" | "failed";
"#;

/// The TypeScript name of words, the words themselves, and what they are.
fn words(into: &mut String, name: &str, about: &str, words: impl Iterator<Item = &'static str>) {
    let all: Vec<String> = words.map(|word| format!("\"{word}\"")).collect();
    write!(into, "\n/** {about} */\nexport type {name} = {};\n", all.join(" | "))
        .expect("a string");
}

/// The words of a type.
fn all<W: Word>() -> impl Iterator<Item = &'static str> {
    W::ALL.iter().map(|word| word.word())
}

/// The text with each comment of one line in one line.
fn short_comments(text: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for line in text.lines() {
        let one = match lines.as_slice() {
            [.., open, words] if line.trim() == "*/" && open.trim() == "/**" => {
                let words = words.trim().trim_start_matches("* ");
                Some(format!("{}{words} */", open.replace("/**", "/** ")))
            }
            _ => None,
        };
        match one {
            Some(one) => {
                lines.truncate(lines.len() - 2);
                lines.push(one);
            }
            None => lines.push(line.to_owned()),
        }
    }
    lines.join("\n")
}

/// The declaration of a type with its comment.
fn declaration<T: TS + 'static>(into: &mut String, config: &Config) {
    let docs = T::docs().unwrap_or_default();
    let known = T::decl(config);
    let (word, rest) = known.split_once(" = ").expect("a declaration");
    // A message has its word in `type` as its name.
    let name = match word {
        "type hello" => "type Hello",
        "type frame" => "type FrameOfAll",
        "type history" => "type Past",
        name => name,
    };
    let text = short_comments(&format!("\n{docs}export {name} = {rest}\n"));
    writeln!(into, "{text}").expect("a string");
}

macro_rules! declarations {
    ($into:expr, $config:expr, $($type:ty),* $(,)?) => {
        $(declaration::<$type>($into, $config);)*
    };
}

/// The whole file, with lines of any length.
fn protocol() -> String {
    use message::*;
    let config = Config::new().with_large_int("number");
    let mut text = HEAD.to_owned();
    write!(
        text,
        "\n/** Number of this protocol. */\nexport const PROTOCOL = {};\n",
        message::PROTOCOL
    )
    .expect("a string");
    let into = &mut text;
    words(
        into,
        "TugWord",
        "Words for a tug. `stop`: no force; `stand_off`: she keeps clear of the side.",
        all::<TugWord>(),
    );
    words(
        into,
        "Lead",
        "Direction of a tug: square to the ship's side, or 45° towards the ship's bow or stern.",
        all::<Lead>(),
    );
    words(
        into,
        "Place",
        "Place of a tug at a ship's side. `VesselInfo.places` has the places of each ship.",
        all::<SidePlace>(),
    );
    words(
        into,
        "Fault",
        "Faults of a vessel. Only instructors are told of frozen instruments.",
        all::<Fault>(),
    );
    words(
        into,
        "ShipType",
        "Types of ships, by which the view draws them.",
        ShipType::ALL.map(ShipType::word).into_iter(),
    );
    words(
        into,
        "Rain",
        "Rain in the view out of the window.",
        Rain::ALL.map(Rain::word).into_iter(),
    );
    words(
        into,
        "ChartKind",
        "Kinds of features of a chart.",
        ChartKind::ALL.map(ChartKind::word).into_iter(),
    );
    words(
        into,
        "MarkColour",
        "Colours of buoys, beacons and lights.",
        MarkColour::ALL.map(MarkColour::word).into_iter(),
    );
    words(
        into,
        "MarkSide",
        "The side of the fairway on which a lateral mark is, for a ship that enters.",
        MarkSide::ALL.map(MarkSide::word).into_iter(),
    );
    words(
        into,
        "MarkMeaning",
        "What a buoy or beacon says, by IALA's system.",
        MarkMeaning::ALL.map(MarkMeaning::word).into_iter(),
    );
    words(
        into,
        "MarkShape",
        "Shapes of buoys and beacons.",
        MarkShape::ALL.map(MarkShape::word).into_iter(),
    );
    declarations!(
        into,
        &config,
        Hello<'static>,
        Role,
        Control,
        Claim,
        Link,
        GalleryEntry,
        DaylightInfo,
        LibraryInfo,
        LibraryVessel,
        FamilyInfo,
        SizeInfo,
        ExerciseInfo,
        PlaceInfo,
        TensionInfo,
        LimitInfo,
        OrderInfo,
        ArgumentInfo,
        TelegraphInfo,
        CommandLimits,
        BerthInfo,
        ChartInfo,
        BodyInfo,
        LevelInfo,
        ModelInfo,
        VesselInfo,
        ConningInfo,
        PlanInfo,
        WaypointInfo,
        WheelOverInfo,
        ThrusterInfo,
        AzimuthInfo,
        FenderInfo,
        LineInfo,
        LineEndInfo,
        AnchorInfo,
        BollardInfo,
        TugInfo,
        TrafficInfo,
        Ghost,
        Frame,
        RunState,
        OpeningNow,
        BranchNow,
        VesselNow,
        PlanNow,
        RudderNow,
        ShareNow,
        AzimuthNow,
        AssistNow,
        AssistState,
        BerthNow,
        BerthEnd,
        Lamp,
        Light,
        FenderNow,
        ContactNow,
        LineNow,
        AnchorNow,
        AnchorFault,
        TugNow,
        PassageNow,
        WindNow,
        CurrentNow,
        WavesNow,
        AlarmNow,
        EventNow,
        VerdictNow,
        FindingNow,
        EyesNow,
        ExerciseNow,
        ConditionNow,
        ExerciseMarks,
        LimitNow,
        History,
        Then,
        Reply,
        PlannedNow,
        ShipPath,
        OtherAction,
        Conduct,
        Creation,
        NewExercise,
        NewBerth,
        NewShip,
        BerthingSide,
        NewTugs,
        NewWeather,
    );
    text
}

/// The text without what a formatter changes.
fn bare(text: &str) -> String {
    let text = text.replace(" * ", " ");
    text.chars().filter(|c| !c.is_whitespace() && !";,\"|()*/".contains(*c)).collect()
}

#[test]
fn the_pages_have_the_types_of_the_messages() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(FILE);
    let wanted = protocol();
    if std::env::var_os("FENDERLINE_WRITE").is_some() {
        std::fs::write(&path, &wanted).expect("the file is written");
    }
    let found = std::fs::read_to_string(&path).expect("web/src/protocol.ts");
    let (found, wanted) = (bare(&found), bare(&wanted));
    let same = found.bytes().zip(wanted.bytes()).take_while(|(a, b)| a == b).count();
    let near =
        |text: &str| text.chars().skip(same.saturating_sub(60)).take(200).collect::<String>();
    assert!(
        found == wanted,
        "web/src/protocol.ts is not as the messages are; `cargo xtask protocol` writes it anew.\nfile:     {}\nmessages: {}",
        near(&found),
        near(&wanted)
    );
}
