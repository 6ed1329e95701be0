/** Names and draught marks on hulls, the jets of thrusters, and what containers hide. */
import { describe, expect, test } from "vitest";
import { arrangementOf } from "../src/bridge/arrangement";
import type { Triple } from "../src/bridge/axes";
import { blocksOf, hides } from "../src/bridge/hidden";
import { type Letter, figuresAbout, letteringOf } from "../src/bridge/lettering";
import { jetOfTug, jetsOf } from "../src/bridge/wash";
import type { Pair } from "../src/protocol";

/** A ship with upright sides amidships, 180 m by 30 m. */
const OUTLINE: Pair[] = [
  [-93, -9],
  [-68, -15],
  [58, -15],
  [86, -6.5],
  [92, 0],
  [86, 6.5],
  [58, 15],
  [-68, 15],
  [-93, 9],
];
const VESSEL = { title: "bulker", length_m: 180, beam_m: 30, draught_m: 10.5, is_tug: false };
const SHIP = arrangementOf(VESSEL, OUTLINE);
const TUG = arrangementOf(
  { title: "tug", length_m: 32, beam_m: 12, draught_m: 4.6, is_tug: true },
  [
    [-16, -4.5],
    [-13, -6],
    [8, -6],
    [16, -1],
    [16, 1],
    [8, 6],
    [-13, 6],
    [-16, 4.5],
  ],
);
const NARROW = () => 0.6;

const middle = ({ corners }: Letter, i: 0 | 1 | 2) =>
  corners.reduce((sum, corner) => sum + corner[i] / 4, 0);

describe("letters on the hull", () => {
  const letters = letteringOf(SHIP, "ever_given", NARROW);

  test("the foot of each figure is at the draught that it names", () => {
    expect(figuresAbout(10.5, 12).slice(0, 6)).toEqual([
      [7.6, "6"],
      [7.8, "8"],
      [8, "8M"],
      [8.2, "2"],
      [8.4, "4"],
      [8.6, "6"],
    ]);
    // With a draught of 10.5 m the marks 10.4 and 10.6 are 0.1 m below and above the water.
    const feet = letters
      .filter((l) => l.character === "4" || l.character === "6")
      .map(({ corners }) => corners[0][2]);
    expect(feet.some((up) => Math.abs(up + 0.1) < 1e-9)).toBe(true);
    expect(feet.some((up) => Math.abs(up - 0.1) < 1e-9)).toBe(true);
    expect(figuresAbout(0.5, 2)[0]).toEqual([0.2, "2"]);
  });

  test("each letter is read from outside, lies on the plating and stands upright", () => {
    for (const ship of [SHIP, TUG])
      for (const letter of letteringOf(ship, "Ever Given", NARROW)) {
        const [a, b, , d] = letter.corners;
        const right = b.map((v, i) => v - (a[i] ?? 0));
        const up = d.map((v, i) => v - (a[i] ?? 0));
        expect(up[2]).toBeGreaterThan(0);
        // Right × up points at the reader. In axes forward, starboard, up, which are left-handed, the sign is the other one.
        const out = (i: number, k: number) =>
          (right[k] ?? 0) * (up[i] ?? 0) - (right[i] ?? 0) * (up[k] ?? 0);
        const atTransom = middle(letter, 0) < ship.hull.aft_m + 3 && Math.abs(right[0] ?? 0) < 1e-9;
        if (atTransom) expect(out(1, 2)).toBeLessThan(0);
        else expect(Math.sign(out(2, 0))).toBe(Math.sign(middle(letter, 1)));
      }
    // Amidships the side is upright, 15 m from the middle.
    const amidships = letters.filter((l) => Math.abs(middle(l, 0)) < 2);
    expect(amidships.length).toBeGreaterThan(40);
    for (const l of amidships.filter((each) => middle(each, 2) > -0.4 * VESSEL.draught_m))
      expect(Math.abs(Math.abs(middle(l, 1)) - 15)).toBeLessThan(0.07);
  });

  test("the name stands at both bows below the deck, and on the transom", () => {
    const capitals = letters.filter(({ character }) => /[EVRGIN]/.test(character));
    expect(capitals.length).toBe(27);
    const spots = capitals.map((l) => [middle(l, 0), middle(l, 1), middle(l, 2)] as const);
    expect(spots.filter(([f]) => f < -85).length).toBe(9);
    for (const side of [-1, 1])
      expect(spots.filter(([f, s]) => f > 50 && s * side > 2).length).toBe(9);
    for (const [f, , up] of spots) {
      expect(up).toBeGreaterThan(1);
      expect(up).toBeLessThan(SHIP.hull.deck_m(f));
    }
  });

  test("a name of any length stays on the hull", () => {
    for (const name of ["", "A", "a name that nobody would paint on a ship of any length at all"])
      for (const { corners } of letteringOf(SHIP, name, NARROW))
        for (const [f, s] of corners) {
          expect(f).toBeGreaterThan(SHIP.hull.aft_m - 0.5);
          expect(f).toBeLessThan(SHIP.hull.fore_m);
          expect(Math.abs(s)).toBeLessThan(15.1);
        }
  });
});

describe("the water that units throw away", () => {
  test("a bow thruster that pushes to starboard throws the water out to port", () => {
    const info = { thrusters: [{ name: "bow", along_m: 80, force_n: 1e5 }], azimuths: [] };
    const of = (now: number) =>
      jetsOf(SHIP, info, { thrusters: [{ order: now, now }], azimuths: [] });
    const [jet] = of(0.5);
    expect(jet?.to_rad).toBeCloseTo(-Math.PI / 2);
    expect(jet?.at_m[1]).toBeLessThan(-1);
    expect(of(-1)[0]?.to_rad).toBeCloseTo(Math.PI / 2);
    expect(of(-1)[0]?.at_m[1]).toBeGreaterThan(1);
    expect(of(0)).toEqual([]);
  });

  test("an azimuth unit throws the water against its thrust, and a tug against her force", () => {
    const info = {
      thrusters: [],
      azimuths: [{ name: "port", at_m: [-9, -3] as Pair, bollard_n: 3e5 }],
    };
    const order = { power_order: 1, power: 0.8, direction_order_rad: 0.4, direction_rad: 0.4 };
    const [jet] = jetsOf(TUG, info, { thrusters: [], azimuths: [order] });
    expect(jet?.to_rad).toBeCloseTo(0.4 + Math.PI);
    expect(jet?.at_m).toEqual([-9, -3]);
    expect(jet?.power).toBe(0.8);
    const tug = (pulls: boolean) => jetOfTug(TUG, { force_n: 3e5, pulls }, 6e5)[0];
    // She has her bow to the ship: a push throws the water astern, a pull towards the ship.
    expect(tug(false)?.to_rad).toBeCloseTo(Math.PI);
    expect(tug(true)?.to_rad).toBe(0);
    expect(jetOfTug(TUG, { force_n: 0, pulls: true }, 6e5)).toEqual([]);
  });
});

test("words of a line on the other side of the containers are not written", () => {
  const vessel = { ...VESSEL, title: "container ship" };
  const blocks = blocksOf(arrangementOf(vessel, OUTLINE));
  // Aboard: x to starboard, y up, z astern. From the middle of the bridge wing to places at a quay to starboard.
  const ship = arrangementOf(vessel, OUTLINE);
  const eye: Triple = [ship.bridge.wing_m + 1, ship.house.bridge_deck_m + 1.8, -ship.bridge.fore_m];
  const hidden = (at: Triple) => blocks.some((block) => hides(block, eye, at));
  expect(hidden([25, 3, -60])).toBe(false);
  expect(hidden([-25, 3, -60])).toBe(true);
  // Under the edge of the deck on the far side, and not over the stacks.
  expect(hidden([-25, 60, -60])).toBe(false);
});
