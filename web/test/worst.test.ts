/** The moment of the largest fender load, for the picture in the report. */
import { expect, test } from "vitest";
import { wordsOf } from "../src/bridge/moment";
import type { Frame, Hello, RunState } from "../src/protocol";
import { Worst, hadMore, mostLoaded } from "../src/worst";

/** Two fenders of a quay, and one of a tug. */
const HELLO = {
  vessels: [
    { body: 0, is_tug: false },
    { body: 2, is_tug: true },
  ],
  fenders: [
    {
      name: "cone_1",
      body: 1,
      rated_reaction_n: 1e6,
      rated_energy_j: 1e6,
      rated_deflection_m: 1.2,
    },
    {
      name: "fender_2",
      body: 1,
      rated_reaction_n: 1e6,
      rated_energy_j: null,
      rated_deflection_m: null,
    },
    {
      name: "bow",
      body: 2,
      rated_reaction_n: null,
      rated_energy_j: null,
      rated_deflection_m: null,
    },
  ],
} as unknown as Hello;

/** A frame whose fenders have these shares of their rating. */
function frame(tick: number, loads: number[], branch = 0, peaks = loads): Frame {
  const fenders = loads.map((load, i) => ({
    of_energy: load,
    of_reaction: Math.min(1, 1.5 * load),
    energy_j: 1e6 * load,
    reaction_n: 1e6 * load,
    deflection_m: load,
    peak_of_energy: peaks[i] ?? 0,
    peak_of_reaction: 0,
  }));
  const branches = [
    { id: 0, from_tick: 0, ends_tick: 0, parent: null },
    { id: 1, from_tick: 150, ends_tick: 0, parent: 0 },
  ];
  return { tick, t_s: tick / 10, fenders, run: { branch, branches } } as unknown as Frame;
}
const run = (branch: number): RunState => frame(0, [], branch).run;

test("the largest load is that of a fender, not of a tug's bow", () => {
  expect(mostLoaded(frame(1, [0.2, 0.3, 0.9]), HELLO)).toMatchObject({ fender: 1 });
  expect(mostLoaded(frame(1, [0, 0, 0.9]), HELLO)).toBeNull();
  // At its full reaction from two thirds on, the fender is still pressed further.
  expect(mostLoaded(frame(1, [0.9, 0, 0]), HELLO)?.load).toBe(0.9);
});

test("of a run the largest is found, of a branch only what came before it and in it", () => {
  const worst = new Worst();
  expect(worst.found(run(0))).toBeNull();
  for (const [tick, load] of [
    [50, 0.1],
    [100, 0.4],
    [120, 0.3],
    [200, 0.8],
    [300, 0.2],
  ] as const)
    worst.hear(frame(tick, [load, 0, 0]), HELLO);
  expect(worst.found(run(0))?.frame.tick).toBe(200);
  // The branch begins at tick 150: 200 is not of it.
  expect(worst.found(run(1))?.frame.tick).toBe(100);
  worst.hear(frame(160, [0, 0.5, 0], 1), HELLO);
  expect(worst.found(run(1))).toMatchObject({ fender: 1, load: 0.75 });
  // Seen again after a rewind, in another order.
  worst.hear(frame(100, [0.4, 0, 0]), HELLO);
  expect(worst.found(run(0))?.frame.tick).toBe(200);
  worst.clear();
  expect(worst.found(run(1))).toBeNull();
});

test("a page that was opened after the peak knows that it has not seen the peak", () => {
  const seen = mostLoaded(frame(400, [0.3, 0, 0]), HELLO);
  if (!seen) throw new Error("a fender is loaded");
  expect(hadMore(seen, frame(500, [0.1, 0, 0], 0, [0.9, 0, 0]), HELLO)).toBe(true);
  expect(hadMore(seen, frame(500, [0.1, 0, 0], 0, [0.301, 0, 5]), HELLO)).toBe(false);
});

test("the words of the picture have time, fender, reaction and deflection", () => {
  const at = (tick: number, loads: number[]) => {
    const moment = mostLoaded(frame(tick, loads), HELLO);
    return moment && wordsOf(moment);
  };
  expect(at(934, [0.812, 0, 0])).toBe(
    "93.4 s: fender cone 1; reaction 812 kN, 100 % of the rated; energy 812 kJ, 81 % of the rated; deflection 0.81 m of 1.20 m.",
  );
  expect(at(36_000, [0, 0.5, 0])).toBe(
    "1:00:00: fender 2; reaction 500 kN, 75 % of the rated; energy 500 kJ; deflection 0.50 m.",
  );
});
