/** Marks, land and structures of the chart in the view out of the window. */
import { expect, test } from "vitest";
import { mark } from "../src/bridge/marks";
import { Solids, linearOf } from "../src/bridge/solids";
import type { ChartInfo } from "../src/protocol";

const FEATURE: ChartInfo = {
  kind: "buoy",
  name: "1",
  depth_m: null,
  deepest_m: null,
  clearance_m: null,
  colour: "red",
  side: "port",
  meaning: "lateral",
  form: "spar",
  character: null,
  period_s: null,
  sector_rad: null,
  range_m: null,
  shape: "point",
  lines: [[[0, 0]]],
};

/** Whether a corner has a colour. */
const has = ({ colours }: Solids, colour: number) => {
  const [r, g, b] = linearOf(colour);
  return colours.some(
    (v, k) => k % 3 === 0 && v === r && colours[k + 1] === g && colours[k + 2] === b,
  );
};

test.each(["buoy", "beacon"] as const)(
  "a lateral %s of region B has a topmark of its own colour",
  (kind) => {
    for (const colour of ["red", "green"] as const)
      for (const side of ["port", "starboard"] as const) {
        const solids = new Solids();
        mark({ ...FEATURE, kind, colour, side }, [0, 0], solids);
        expect([has(solids, 0xb3262c), has(solids, 0x14703c)]).toEqual([
          colour === "red",
          colour === "green",
        ]);
      }
  },
);
