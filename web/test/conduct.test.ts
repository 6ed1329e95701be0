/** What vessels do, as their lights tell it. */
import { expect, test } from "vitest";
import { type Conduct, conductOf } from "../src/bridge/conduct";
import type { Frame, Hello } from "../src/protocol";

/** A ship (body 0), a tug (body 1) and a quay (body 2), with an anchor, a line to the quay and a towline. */
const HELLO = {
  bodies: [{ fixed: false }, { fixed: false }, { fixed: true }],
  vessels: [
    { body: 0, is_tug: false },
    { body: 1, is_tug: true },
  ],
  bollards: [{ body: 2 }],
  anchors: [{ ship: 0 }],
  lines: [
    { ship: 0, end: null, is_towline: false },
    { ship: 0, end: { body: 1 }, is_towline: true },
    { ship: 1, end: { body: 2 }, is_towline: false },
  ],
} as unknown as Hello;

interface Of {
  speed_mps?: number;
  aground?: boolean;
  anchor?: string;
  dragging?: boolean;
  /** Lines that are fast. */
  fast?: number[];
}

function conduct(vessel: number, of: Of): Conduct {
  const frame = {
    vessels: [0, 1].map(() => ({
      aground: of.aground ?? false,
    })),
    anchors: [{ state: of.anchor ?? "housed", dragging: of.dragging ?? false }],
    lines: [0, 1, 2].map((i) => ({
      state: of.fast?.includes(i) ? "fast" : "aboard",
      bollard: i === 0 && of.fast?.includes(0) ? 0 : null,
    })),
  } as unknown as Frame;
  return conductOf(vessel, vessel, HELLO, frame, [0, 0, 0, of.speed_mps ?? 0, 0, 0]);
}

test("a moored ship is made fast, and one that comes in with a line ashore is under way", () => {
  expect(conduct(0, { fast: [0] })).toBe("made_fast");
  expect(conduct(0, { fast: [0], speed_mps: 1 })).toBe("under_way");
});

// A ship that sheered about her anchor faster than 0.3 m/s changed to the lights of a ship under way, on each swing.
test("a ship that sheers about her anchor stays at anchor, and one that drags or goes is under way", () => {
  expect(conduct(0, { anchor: "on_bottom", speed_mps: 0.6 })).toBe("at_anchor");
  expect(conduct(0, { anchor: "on_bottom", speed_mps: 1.5 })).toBe("under_way");
  expect(conduct(0, { anchor: "on_bottom", dragging: true })).toBe("under_way");
  expect(conduct(0, { anchor: "housed" })).toBe("under_way");
});

test("a ship aground is neither at anchor nor under way", () => {
  expect(conduct(0, { aground: true, anchor: "on_bottom" })).toBe("aground");
});

test("a tug tows by a towline, whichever end is hers, and not by her own line to a quay", () => {
  expect(conduct(1, { fast: [1], speed_mps: 2 })).toBe("tows");
  expect(conduct(1, { fast: [2], speed_mps: 2 })).toBe("under_way");
  expect(conduct(1, { fast: [2] })).toBe("made_fast");
  expect(conduct(0, { fast: [1], speed_mps: 2 })).toBe("under_way");
});
