/** The bearing over the view out of the window, with and without a frozen compass. */
import { expect, test } from "vitest";
import { bearingOf } from "../src/bridge/bearing";
import type { Look } from "../src/bridge/look";
import type { BodyNow, Hello } from "../src/protocol";

const DEG = Math.PI / 180;
const LOOK: Look = {
  eye: "bridge",
  vessel: 0,
  bollard: 0,
  turn_rad: 0,
  raise_rad: 0,
  view_rad: null,
  off_m: 320,
  lifted_m: 0,
  fender: null,
  marks: false,
  panorama_rad: null,
};
/** The own ship is body 1, the tug that is a vessel body 2; a vector tug serves the ship. */
const HELLO = {
  vessels: [{ body: 1 }, { body: 2 }],
  tugs: [{ vessel: 0 }],
  bollards: [{ body: 0 }],
  fenders: [{ body: 0 }, { body: 1 }],
} as unknown as Hello;

const heading = (deg: number): BodyNow => [0, 0, deg * DEG, 0, 0, 0];
const seen = [heading(0), heading(50), heading(200)];
const frozen = [heading(0), heading(40), heading(200)];

function words(look: Partial<Look>, true_deg: number, shown = frozen) {
  const { bearing_rad, side_rad } = bearingOf(
    { ...LOOK, ...look },
    true_deg * DEG,
    HELLO,
    shown,
    seen,
  );
  const round = (rad: number) => Math.round(rad / DEG);
  return [round(bearing_rad), side_rad === null ? null : round(side_rad)];
}

test("the caption of the view gave the true heading away while the compass was frozen", () => {
  expect(words({}, 80), "30° to starboard of the shown 40°").toEqual([70, 30]);
  expect(words({}, 50)).toEqual([40, 0]);
  expect(words({ eye: "port-wing" }, 20)).toEqual([10, -30]);
  expect(words({ eye: "free" }, 95), "the free eye turns with the ship").toEqual([85, null]);
  expect(words({ eye: "tug", vessel: 2 }, 140), "a vector tug lies as the ship does").toEqual([
    130,
    null,
  ]);
  expect(words({ eye: "free", fender: 1 }, 140), "a fender on the ship").toEqual([130, null]);
});

test("what does not turn with the ship has its true bearing", () => {
  expect(words({ eye: "tug", vessel: 1 }, 210), "a tug with a compass of her own").toEqual([
    210, 10,
  ]);
  expect(words({ eye: "bollard" }, 95)).toEqual([95, null]);
  expect(words({ eye: "free", fender: 0 }, 95), "a fender on the quay").toEqual([95, null]);
});

test("with a compass that works the bearing is the true one", () => {
  expect(words({}, 80, seen)).toEqual([80, 30]);
});
