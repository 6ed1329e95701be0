/** The view out of the window: known answers of its geometry, without a renderer. */
import { readFileSync } from "node:fs";
import { Group, Mesh, MeshBasicMaterial, PerspectiveCamera, Vector3 } from "three";
import { describe, expect, test } from "vitest";
import { LEVEL, aim, fixedIn, stand } from "../src/bridge/aim";
import { arrangementOf, kindOf } from "../src/bridge/arrangement";
import { aboard, toPicture } from "../src/bridge/axes";
import { BIGHT_M, area2, bollard, inset, isInside, quaysOf } from "../src/bridge/berth";
import { cut, width } from "../src/bridge/blocks";
import { catenary, parameterByLength } from "../src/bridge/catenary";
import { seatOn, vertical } from "../src/bridge/eyes";
import { deckHeight } from "../src/bridge/heights";
import { Fenders, faceOff, shapeOf } from "../src/bridge/fenders";
import { breadthOf } from "../src/bridge/hull";
import { atAnchor, bearingFrom, isSeen, lampsOf, mastheads, underWay } from "../src/bridge/lamps";
import { density, lightOf } from "../src/bridge/light";
import { type Look, lookOf } from "../src/bridge/look";
import { mark } from "../src/bridge/marks";
import { PAINTS, shipParts } from "../src/bridge/ship";
import { Solids } from "../src/bridge/solids";
import { TUG_PAINT } from "../src/bridge/tug";
import { FINE, shareDrawn } from "../src/bridge/sea";
import { sunAt } from "../src/bridge/sun";
import { FEW, drawnOf, significant, surface } from "../src/bridge/waves";
import { add, onEarth, turned } from "../src/geometry";
import type {
  BodyNow,
  ChartInfo,
  FenderInfo,
  FenderNow,
  Pair,
  TugInfo,
  TugNow,
  Wave,
} from "../src/protocol";
import { type TugPlace, tugPlace } from "../src/vector_tug";

const DEG = Math.PI / 180;
const [WIDE, HIGH] = [1280, 720];

/** The bulk carrier of `scenarios/live/harbour.toml`. */
const BULKER: Pair[] = [
  [-93, -9],
  [-84, -13.5],
  [-68, -15],
  [58, -15],
  [74, -12.5],
  [86, -6.5],
  [92, 0],
  [86, 6.5],
  [74, 12.5],
  [58, 15],
  [-68, 15],
  [-84, 13.5],
  [-93, 9],
];
const VESSEL = { title: "bulker", length_m: 180, beam_m: 30, draught_m: 10.5, is_tug: false };
const TUG: Pair[] = [
  [-16, -4.5],
  [-13, -6],
  [6, -6],
  [13, -4],
  [16, -1.5],
  [16, 1.5],
  [13, 4],
  [6, 6],
  [-13, 6],
  [-16, 4.5],
];
const LOOK: Look = {
  eye: "bridge",
  vessel: 0,
  bollard: 0,
  turn_rad: 0,
  raise_rad: 0,
  view_rad: null,
  off_m: 300,
  lifted_m: 0,
  fender: null,
  marks: false,
  panorama_rad: null,
};
const ORIGIN: Pair = [1000, -2000];

/** Where the camera draws a place of the picture [px]. */
function drawn(camera: PerspectiveCamera, at: Vector3): Pair {
  const { x, y } = at.clone().project(camera);
  return [((x + 1) / 2) * WIDE, ((1 - y) / 2) * HIGH];
}

/**
 * The same by hand, for a level ship: distance ahead, to the right and up from an eye that looks along a bearing with an
 * elevation, by trigonometry alone.
 */
function byHand(
  eye: [north: number, east: number, up: number],
  [bearing, elevation, view]: [number, number, number],
  at: [north: number, east: number, up: number],
): Pair {
  const [n, e, u] = [at[0] - eye[0], at[1] - eye[1], at[2] - eye[2]];
  const flat = n * Math.cos(bearing) + e * Math.sin(bearing);
  const right = e * Math.cos(bearing) - n * Math.sin(bearing);
  const ahead = flat * Math.cos(elevation) + u * Math.sin(elevation);
  const above = u * Math.cos(elevation) - flat * Math.sin(elevation);
  const focal = HIGH / 2 / Math.tan(view / 2);
  return [WIDE / 2 + (focal * right) / ahead, HIGH / 2 - (focal * above) / ahead];
}

const near = (found: Pair, wanted: Pair) => {
  expect(Math.abs(found[0] - wanted[0])).toBeLessThan(1);
  expect(Math.abs(found[1] - wanted[1])).toBeLessThan(1);
};

/** A cone on a quay. */
const CONE: FenderInfo = {
  name: "cone_1",
  body: 0,
  at_m: [-10, 0],
  facing_rad: -90 * DEG,
  width_m: 2.4,
  projection_m: 1.9,
  height_m: 3.2,
  above_water_m: 2.6,
  floating: false,
  family: "cone",
  cones_m: [],
  rated_deflection_m: 1.15,
  rated_reaction_n: 1.5e6,
  rated_energy_j: 1.3e6,
};

/** Middle of the highest corners of a part, in its axes. */
function topOf(solids: Solids): Vector3 {
  const all = Array.from(
    { length: solids.positions.length / 3 },
    (_, i) => new Vector3(...solids.positions.slice(3 * i, 3 * i + 3)),
  );
  const high = Math.max(...all.map(({ y }) => y));
  const top = all.filter(({ y }) => y > high - 1e-6);
  return top.reduce((sum, each) => sum.add(each), new Vector3()).divideScalar(top.length);
}

describe("a camera on the starboard wing", () => {
  const ship: BodyNow = [1400, -1700, 20 * DEG, 0, 0, 0];
  const arrangement = arrangementOf(VESSEL, BULKER);
  const seat = seatOn(arrangement, "starboard-wing");
  const group = new Group();
  stand(group, ORIGIN, ship, LEVEL);
  const camera = new PerspectiveCamera(40, WIDE / HIGH, 0.3, 70_000);
  const look = { ...LOOK, turn_rad: 25 * DEG, raise_rad: -4 * DEG };
  aim(camera, seat, group.matrixWorld, look);
  const eye = onEarth(ship, seat.at);
  const gaze: [number, number, number] = [
    20 * DEG + seat.bearing_rad + look.turn_rad,
    seat.elevation_rad + look.raise_rad,
    seat.view_rad,
  ];
  const quay: BodyNow = [1460, -1640, 20 * DEG, 0, 0, 0];
  const shore = new Group();
  stand(shore, ORIGIN, quay, LEVEL);

  test("draws a bollard where its place says", () => {
    const solids = new Solids();
    bollard([25, 1.5], 3.5, solids);
    const found = drawn(camera, topOf(solids).applyMatrix4(shore.matrixWorld));
    const [n, e] = onEarth(quay, [25, 1.5]);
    near(found, byHand([...eye, seat.up_m], gaze, [n, e, 3.5 + 0.55]));
  });

  test("draws the face of a pressed fender where its deflection says", () => {
    const info = CONE;
    const now: FenderNow = {
      deflection_m: 0.62,
      reaction_n: 6e5,
      energy_j: 3e5,
      of_energy: 0.2,
      of_reaction: 0.4,
      peak_of_energy: 0.2,
      peak_of_reaction: 0.4,
      failed: false,
      over_rated: false,
      touched: true,
    };
    const fenders = new Fenders(
      [info],
      () => shore,
      () => false,
      new MeshBasicMaterial(),
    );
    fenders.tick([now]);
    shore.updateMatrixWorld(true);
    expect(faceOff(info, now)).toBeCloseTo(1.28, 12);
    // The outermost corners of rubber and panel are the face.
    const corners: Vector3[] = [];
    shore.traverse((each) => {
      if (!(each instanceof Mesh)) return;
      const places = each.geometry.getAttribute("position");
      for (let i = 0; i < places.count; i++)
        corners.push(new Vector3().fromBufferAttribute(places, i).applyMatrix4(each.matrixWorld));
    });
    const outward = aboard([0, -1], 0);
    const far = (at: Vector3) => {
      const local = shore.worldToLocal(at.clone());
      return local.x * outward[0] + local.z * outward[2];
    };
    const most = Math.max(...corners.map(far));
    expect(most).toBeCloseTo(1.28, 6);
    const face = corners.filter((at) => far(at) > most - 1e-6);
    const middle = face
      .reduce((sum, each) => sum.add(each), new Vector3())
      .divideScalar(face.length);
    const [n, e] = onEarth(quay, [-10, -1.28]);
    near(drawn(camera, middle), byHand([...eye, seat.up_m], gaze, [n, e, 2.6]));
    // The panel is as high and as wide as the run's face.
    const rises = face.map(({ y }) => y);
    expect(Math.max(...rises) - Math.min(...rises)).toBeGreaterThan(3.1);
    expect(Math.max(...rises) - Math.min(...rises)).toBeLessThan(3.2 + 1e-9);
  });

  test("draws a quay, its fenders and its bollards lower by the rise of the tide, a floating fender not", () => {
    const quays = new Group();
    stand(quays, ORIGIN, quay, fixedIn(1.4));
    const floating = { ...CONE, floating: true, family: "pneumatic", above_water_m: 0.5 };
    const fenders = new Fenders(
      [CONE, floating],
      () => quays,
      () => false,
      new MeshBasicMaterial(),
    );
    fenders.tick([], 1.4);
    quays.updateMatrixWorld(true);
    const [fixed, afloat] = quays.children.map((mount) => mount.getWorldPosition(new Vector3()).y);
    expect(fixed).toBeCloseTo(2.6 - 1.4, 9);
    expect(afloat).toBeCloseTo(0.5, 9);
    const solids = new Solids();
    bollard([25, 1.5], 3.5, solids);
    expect(topOf(solids).applyMatrix4(quays.matrixWorld).y).toBeCloseTo(3.5 + 0.55 - 1.4, 9);
  });

  test("draws a buoy where the chart has it", () => {
    const feature = { ...BUOY, colour: "green", side: "starboard" } as ChartInfo;
    const solids = new Solids();
    mark(feature, [2100 - ORIGIN[0], -900 - ORIGIN[1]], solids);
    const top = topOf(solids);
    near(drawn(camera, top), byHand([...eye, seat.up_m], gaze, [2100, -900, top.y]));
  });
});

const BUOY: ChartInfo = {
  kind: "buoy",
  name: "1",
  depth_m: null,
  deepest_m: null,
  clearance_m: null,
  colour: "red",
  side: "port",
  meaning: "lateral",
  form: null,
  character: null,
  period_s: null,
  sector_rad: null,
  range_m: null,
  shape: "point",
  lines: [[[0, 0]]],
};

test("three windows of a panorama meet at their edges", () => {
  const group = new Group();
  stand(group, ORIGIN, [1000, -2000, 0.3, 0, 0, 0], LEVEL);
  const seat = seatOn(arrangementOf(VESSEL, BULKER), "bridge");
  const edge = (turn: number, x: number) => {
    const camera = new PerspectiveCamera(40, 16 / 9, 0.3, 70_000);
    aim(camera, seat, group.matrixWorld, {
      ...LOOK,
      turn_rad: turn * DEG,
      panorama_rad: 60 * DEG,
    });
    return new Vector3(x, 0, 0.5).unproject(camera).sub(camera.position).normalize();
  };
  expect(edge(-60, 1).distanceTo(edge(0, -1))).toBeLessThan(1e-6);
  expect(edge(0, 1).distanceTo(edge(60, -1))).toBeLessThan(1e-6);
  expect(vertical(90 * DEG, 1)).toBeCloseTo(90 * DEG, 12);
});

test("each family of fenders has its shape, and the deck lies under the bollards", () => {
  const shape = (family: string | null, floating = false) => shapeOf({ family, floating });
  expect(
    ["cone", "cone SPC", "pneumatic", "unit element", "V leg"].map((family) => shape(family)),
  ).toEqual(["cone", "cone", "pneumatic", "element", "leg"]);
  expect(["cell", "arch", "cylindrical", "foam filled"].map((family) => shape(family))).toEqual([
    "cell",
    "arch",
    "cylinder",
    "foam",
  ]);
  expect([shape(null), shape(null, true), shape("ours")]).toEqual(["block", "pneumatic", "block"]);
  for (const family of [
    null,
    "cone",
    "cell",
    "V leg",
    "unit element",
    "arch",
    "cylinder",
    "foam",
  ]) {
    const on = new Group();
    const info = { ...CONE, family, cones_m: [-0.6, 0.6] };
    const fenders = new Fenders(
      [info],
      () => on,
      () => false,
      new MeshBasicMaterial(),
    );
    fenders.tick([]);
    on.updateMatrixWorld(true);
    const corners: Vector3[] = [];
    on.traverse((each) => {
      if (!(each instanceof Mesh)) return;
      const places = each.geometry.getAttribute("position");
      for (let i = 0; i < places.count; i++)
        corners.push(new Vector3().fromBufferAttribute(places, i).applyMatrix4(each.matrixWorld));
    });
    // It faces to port: outward is −x in the axes of the body.
    const out = corners.map(({ x }) => -x);
    expect(Math.max(...out), `${family}: face`).toBeCloseTo(1.9, 6);
    expect(Math.min(...out), `${family}: mounting`).toBeGreaterThan(-1e-9);
    expect(corners.every(({ x, y, z }) => [x, y, z].every(Number.isFinite))).toBe(true);
  }
  expect(deckHeight([4, 0, 4.5], [9], 3.5)).toBeCloseTo(4 - BIGHT_M, 12);
  expect(deckHeight([], [], 3.5)).toBe(3.5);
  expect(deckHeight([0], [5.2], 3.5)).toBeCloseTo(5.4, 12);
});

describe("a line", () => {
  /** The lowest point of a catenary of a length, by bisection of the length alone. */
  function lowest(span: number, rise: number, length: number): number {
    let [short, long] = [1e-3, 1e6];
    const of = (a: number) => {
      const half = span / (2 * a);
      if (half > 300) return Number.POSITIVE_INFINITY;
      return Math.sqrt(rise ** 2 + (2 * a * Math.sinh(half)) ** 2);
    };
    for (let i = 0; i < 200; i++) {
      const middle = Math.sqrt(short * long);
      if (of(middle) > length) short = middle;
      else long = middle;
    }
    const a = short;
    // From the lower end the lowest point is where the slope is zero.
    const m = span / 2 - a * Math.asinh(rise / (2 * a * Math.sinh(span / (2 * a))));
    return m <= 0 || m >= span ? Math.min(0, rise) : -a * (Math.cosh(m / a) - 1);
  }

  test.each([
    [40, 3, 44],
    [60, 8, 63],
    [25, -2, 40],
    [100, 0, 100.5],
  ])("%d m across and %d m up hangs as low as its %d m let it", (span, rise, length_m) => {
    const points = catenary(
      [5, 10, -3],
      [5 + span * 0.6, 10 + rise, -3 + span * 0.8],
      { tension_n: 0, length_m, weight_npm: 40 },
      28,
    );
    const low = Math.min(...points.map(([, y]) => y)) - 10;
    expect(Math.abs(low - lowest(span, rise, length_m))).toBeLessThan(0.05);
    const long = points.reduce((sum, at, i) => {
      const before = points[i - 1];
      return before ? sum + Math.hypot(...at.map((v, k) => v - (before[k] ?? 0))) : 0;
    }, 0);
    expect(long).toBeGreaterThan(length_m * 0.995);
    expect(long).toBeLessThan(length_m * 1.000001);
  });

  test("under tension sags by weight times span² over eight times the tension", () => {
    const points = catenary(
      [0, 5, 0],
      [50, 5, 0],
      { tension_n: 1e5, length_m: 49.9, weight_npm: 40 },
      28,
    );
    const sag = 5 - Math.min(...points.map(([, y]) => y));
    expect(sag).toBeCloseTo((40 * 50 ** 2) / (8 * 1e5), 3);
  });

  test("that is no longer than the way has no catenary", () => {
    expect(parameterByLength(50, 0, 50)).toBeNull();
    expect(parameterByLength(50, 0, 40)).toBeNull();
    const points = catenary(
      [0, 5, 0],
      [50, 5, 0],
      { tension_n: 0, length_m: 40, weight_npm: 40 },
      28,
    );
    expect(points.every(([, y]) => y === 5)).toBe(true);
  });

  test("begins and ends at its fairlead and its bollard", () => {
    const [from, to] = [
      [1, 2, 3],
      [30, 6, -8],
    ] as const;
    for (const tension_n of [0, 500, 5e4, 5e6]) {
      const points = catenary([...from], [...to], { tension_n, length_m: 36, weight_npm: 30 }, 28);
      for (const [found, wanted] of [
        [points[0], from],
        [points.at(-1), to],
      ] as const)
        wanted.forEach((v, k) => expect(found?.[k]).toBeCloseTo(v, 6));
    }
  });
});

describe("navigation lights", () => {
  const ship = arrangementOf(VESSEL, BULKER);
  /** Colours that an eye at a bearing from the bow sees, far off. */
  const seen = (bearing_deg: number, lamps = underWay(ship, false)) => {
    const eye = aboard([1e5 * Math.cos(bearing_deg * DEG), 1e5 * Math.sin(bearing_deg * DEG)], 10);
    return lamps
      .filter(({ at, arc }) => isSeen(arc, bearingFrom(at, eye)))
      .map(({ colour }) => colour);
  };

  test("sidelights are seen from right ahead to 112.5° and not beyond", () => {
    const green = underWay(ship, false).find(({ colour }) => colour === "green");
    const red = underWay(ship, false).find(({ colour }) => colour === "red");
    for (const [lamp, side] of [
      [green, 1],
      [red, -1],
    ] as const) {
      const sees = (degrees: number) => isSeen(lamp?.arc ?? null, side * degrees * DEG);
      expect([0, 1, 45, 90, 112.5].every(sees)).toBe(true);
      expect([112.6, 135, 180, -3, -90].some(sees)).toBe(false);
    }
    expect(green?.at[0]).toBeGreaterThan(0);
    expect(red?.at[0]).toBeLessThan(0);
  });

  // The lights stand at the ends of the wings, and an eye right ahead saw neither.
  test("a ship right ahead shows both sidelights", () => {
    for (const ahead_m of [800, 1852, 5000]) {
      const colours = underWay(ship, false)
        .filter(({ at, arc }) => isSeen(arc, bearingFrom(at, aboard([ahead_m, 0], 15))))
        .map(({ colour }) => colour);
      expect(colours.toSorted()).toEqual(["green", "red", "white", "white"]);
    }
  });

  // A ferry showed her two lights above each other, as a tug with a tow does.
  test("masthead lights are far apart, wherever the bridge is, and the after light is higher", () => {
    for (const kind of ["bulk", "tanker", "container", "ro-ro", "passenger"] as const)
      for (const length_m of [60, 120, 200, 300, 400]) {
        const of = { ...VESSEL, kind, length_m, beam_m: length_m / 6.5, draught_m: length_m / 20 };
        const half = of.beam_m / 2;
        const [aft, fore] = [-length_m / 2, length_m / 2];
        const outline: Pair[] = [
          [aft, -half],
          [fore - half, -half],
          [fore, 0],
          [fore - half, half],
          [aft, half],
        ];
        const lights = mastheads(arrangementOf(of, outline));
        const name = `${kind} of ${length_m} m`;
        expect(lights.fore[0] - lights.aft[0], name).toBeGreaterThan(
          0.59 * Math.min(100, length_m / 2),
        );
        expect(lights.aft[1] - lights.fore[1], name).toBeGreaterThanOrEqual(4.5 - 1e-9);
        expect(lights.aft[0], name).toBeGreaterThan(aft);
      }
  });

  test("a ship of 180 m shows two masthead lights ahead and one light astern", () => {
    expect(seen(20).toSorted()).toEqual(["green", "white", "white"]);
    expect(seen(-20).toSorted()).toEqual(["red", "white", "white"]);
    expect(seen(180)).toEqual(["white"]);
    const masts = underWay(ship, false).filter(
      ({ colour, arc }) => colour === "white" && arc?.[0] !== 112.5 * DEG,
    );
    const [fore, aft] = masts.toSorted((a, b) => a.at[2] - b.at[2]);
    // The after light is higher: the lights tell which way she heads.
    expect((aft?.at[1] ?? 0) - (fore?.at[1] ?? 0)).toBeGreaterThanOrEqual(4.5 - 1e-9);
  });

  test("a tug with a line shows two masthead lights and yellow over white astern", () => {
    const tug = arrangementOf(
      { ...VESSEL, title: "tug", length_m: 30, beam_m: 12, draught_m: 4.5, is_tug: true },
      TUG,
    );
    expect(seen(20, underWay(tug, true)).toSorted()).toEqual(["green", "white", "white"]);
    expect(seen(180, underWay(tug, true)).toSorted()).toEqual(["white", "yellow"]);
    expect(seen(20, underWay(tug, false)).toSorted()).toEqual(["green", "white"]);
  });

  test("at anchor lights are seen all round, the forward light higher", () => {
    const lamps = atAnchor(ship);
    for (const bearing of [0, 90, 180, 270])
      expect(seen(bearing, lamps)).toEqual(["white", "white"]);
    expect(lamps[0]?.at[1] ?? 0).toBeGreaterThan(lamps[1]?.at[1] ?? 0);
  });

  test("aground she shows two red lights too, and made fast none", () => {
    const { aground, made_fast } = lampsOf(ship);
    expect(seen(90, aground).toSorted()).toEqual(["red", "red", "white", "white"]);
    expect(made_fast).toEqual([]);
  });

  test("a sector that passes north is seen on both sides of north", () => {
    expect(isSeen([350 * DEG, 10 * DEG], 355 * DEG)).toBe(true);
    expect(isSeen([350 * DEG, 10 * DEG], 5 * DEG)).toBe(true);
    expect(isSeen([350 * DEG, 10 * DEG], 20 * DEG)).toBe(false);
  });
});

describe("a hull", () => {
  const { hull } = arrangementOf(VESSEL, BULKER);

  test("has the breadth of its outline at each corner, and between them on straight sides", () => {
    const breadth = breadthOf(BULKER);
    for (const [forward, starboard] of BULKER)
      expect(breadth(forward)[starboard >= 0 ? 1 : 0]).toBeCloseTo(Math.abs(starboard), 9);
    for (const forward of [-60, -10, 0, 33, 50])
      for (const wide of breadth(forward)) expect(wide).toBeCloseTo(15, 9);
    for (let forward = -93; forward <= 92; forward += 0.5)
      for (const wide of breadth(forward)) expect(wide).toBeLessThanOrEqual(15 + 1e-9);
  });

  test("keeps the outline amidships from the bilge to the deck", () => {
    for (const up of [-7, -3, 0, 2, 5])
      for (const side of [1, -1] as const) {
        const [forward, wide] = hull.side(20, up, side);
        expect(forward).toBeCloseTo(20, 9);
        expect(wide).toBeCloseTo(15 * side, 9);
      }
    expect(hull.side(20, -10.5, 1)[1]).toBeLessThan(15);
  });

  test("meets the water at her waterline when she heels, trims and squats", () => {
    const now: BodyNow = [1400, -1700, 20 * DEG, 0, 0, 0];
    const attitude = { heel_rad: 2 * DEG, trim_rad: -0.5 * DEG, sunk_m: 0.4 };
    const group = new Group();
    stand(group, ORIGIN, now, attitude);
    for (const [forward, starboard] of [
      [80, 9],
      [0, -15],
      [-70, 15],
    ] as const) {
      const at = new Vector3(...aboard([forward, starboard], 0)).applyMatrix4(group.matrixWorld);
      // Bow down, heel to starboard and squat bring a place lower.
      const wanted =
        -0.4 + forward * Math.sin(-0.5 * DEG) - starboard * Math.sin(2 * DEG) * Math.cos(0.5 * DEG);
      expect(Math.abs(at.y - wanted)).toBeLessThan(0.05);
      const [n, e] = onEarth(now, [forward, starboard]);
      const [x, , z] = toPicture(ORIGIN, [n, e], 0);
      expect(Math.hypot(at.x - x, at.z - z)).toBeLessThan(0.05);
    }
  });

  test("is closed by triangles without holes in their numbers", () => {
    const outlines: [Pair[], typeof VESSEL][] = [
      [BULKER, VESSEL],
      [BULKER, { ...VESSEL, title: "Container ship, 180 m" }],
      [BULKER, { ...VESSEL, title: "Tanker" }],
      [BULKER, { ...VESSEL, title: "Ro-ro ferry" }],
      [BULKER, { ...VESSEL, title: "Cruise ship" }],
      [TUG, { ...VESSEL, title: "tug", length_m: 30, beam_m: 12, draught_m: 4.5, is_tug: true }],
      [
        [
          [-1, -0.2],
          [1, -0.2],
          [1.2, 0],
          [1, 0.2],
          [-1, 0.2],
        ],
        { ...VESSEL, title: "model", length_m: 2, beam_m: 0.4, draught_m: 0.1 },
      ],
    ];
    for (const [outline, vessel] of outlines) {
      const fairleads: [number, number, number][] = [[outline[0]?.[0] ?? 0, 0, 6]];
      const made = shipParts(arrangementOf(vessel, outline), PAINTS[0] ?? TUG_PAINT, fairleads);
      for (const { positions, normals } of [made.painted, made.panes]) {
        expect(positions.every(Number.isFinite)).toBe(true);
        expect(normals.every(Number.isFinite)).toBe(true);
        expect(positions.length).toBe(normals.length);
      }
      expect(made.painted.triangles).toBeLessThan(40_000);
    }
  });

  test("is of the type that her title says", () => {
    expect(kindOf({ title: "Container ship, 298 m", is_tug: false })).toBe("container");
    expect(kindOf({ title: "KVLCC2, 320 m", is_tug: false })).toBe("tanker");
    expect(kindOf({ title: "ASD tug, 32 m, 60 t bollard pull", is_tug: true })).toBe("tug");
    expect(kindOf({ title: "bulker", is_tug: false })).toBe("bulk");
    expect(kindOf({ title: "bulker", is_tug: false, kind: "ro-ro" })).toBe("ro-ro");
  });

  test("has her bridge where the scenario says", () => {
    const conning = { at_m: [-50, 3] as Pair, eye_above_water_m: 31 };
    const ship = arrangementOf({ ...VESSEL, conning }, BULKER);
    const seat = seatOn(ship, "bridge");
    expect([seat.at, seat.up_m]).toEqual([[-50, 3], 31]);
    // The front of the wheelhouse is just behind the eye, its deck below.
    expect(ship.bridge.fore_m).toBeCloseTo(-50.4, 9);
    expect(ship.house.bridge_deck_m).toBeCloseTo(31 - 1.75, 9);
  });
});

describe("the sea", () => {
  const { sea, places } = JSON.parse(
    readFileSync(new URL("sea.json", import.meta.url), "utf8"),
  ) as { sea: Wave[]; places: [north: number, east: number, t_s: number, height: number][] };

  test("is at bow, side and stern as high as the sea of the run", () => {
    expect(places.length).toBe(3);
    for (const [north, east, t_s, height] of places) {
      expect(Math.abs(surface(sea, north, east, t_s) - height)).toBeLessThan(1e-6);
      // As a graphics card draws it: single precision about an origin near the ship, harmonics that fade with the distance.
      const [x, z] = [Math.fround(east - ORIGIN[1]), Math.fround(ORIGIN[0] - north)];
      const drawn = drawnOf(sea, sea.length).reduce((sum, [a, kn, ke, omega, phase]) => {
        const at = (omega * t_s + phase - kn * ORIGIN[0] - ke * ORIGIN[1]) % (2 * Math.PI);
        const share = shareDrawn(150, Math.hypot(kn, ke), FINE);
        const turn = Math.fround(Math.fround(-ke * x) + Math.fround(kn * z) + Math.fround(at));
        return Math.fround(sum + Math.fround(share * a) * Math.fround(Math.cos(turn)));
      }, 0);
      expect(Math.abs(drawn - height)).toBeLessThan(0.05);
    }
  });

  test("without a graphics card lacks less than a seventh of its height", () => {
    const few = drawnOf(sea, FEW);
    const left = sea.filter((wave) => !few.includes(wave));
    expect(significant(sea)).toBeCloseTo(1.5, 6);
    expect(significant(few) ** 2 + significant(left) ** 2).toBeCloseTo(1.5 ** 2, 6);
    expect(significant(left) / significant(sea)).toBeLessThan(1 / 7);
    expect(drawnOf([], FEW)).toEqual([]);
    expect(surface([], 1, 2, 3)).toBe(0);
  });
});

describe("the sun", () => {
  const unix = (text: string) => Date.parse(text) / 1000;
  const at = (text: string, latitude: number, longitude: number) => {
    const sun = sunAt(unix(text), latitude * DEG, longitude * DEG);
    return [sun.azimuth_rad / DEG, sun.elevation_rad / DEG] as const;
  };

  test("stands where the example of NREL's solar position algorithm has it", () => {
    // Reda and Andreas, NREL/TP-560-34302, appendix A.5: zenith 50.11162°, azimuth 194.34024°, Golden, Colorado.
    const [azimuth, elevation] = at("2003-10-17T12:30:30-07:00", 39.742476, -105.1786);
    expect(Math.abs(azimuth - 194.34024)).toBeLessThan(0.02);
    expect(Math.abs(elevation - (90 - 50.11162))).toBeLessThan(0.02);
  });

  test("has the declination of Meeus' example 25.a, seen from the pole", () => {
    // 13 October 1992, 0 h dynamical time: −7.78507°. Below the horizon the air lifts nothing.
    const [, elevation] = at("1992-10-12T23:59:01Z", 90, 0);
    expect(Math.abs(elevation + 7.78507)).toBeLessThan(0.002);
  });

  test("is on the horizon at the times of tables, and in the zenith under the tropic", () => {
    // London, 21 June: sunrise 04:43, sunset 21:21 (BST), when the upper edge is on the horizon: the middle is 0.27° lower.
    for (const time of ["04:43", "21:21"])
      expect(Math.abs(at(`2026-06-21T${time}:00+01:00`, 51.5, -0.13)[1] + 0.27)).toBeLessThan(0.5);
    // The solstice of 2026: 21 June, 08:24; at noon of the place the sun is overhead at 23.44° north.
    const [, high] = at("2026-06-21T12:01:50Z", 23.44, 0);
    expect(high).toBeGreaterThan(89.5);
    // Southern summer: at noon the sun is in the north.
    const [azimuth] = at("2026-12-21T12:00:00+10:00", -38, 150);
    expect(Math.min(azimuth, 360 - azimuth)).toBeLessThan(4);
  });
});

test("sun and moon cast shadows, the dusk between them does not", () => {
  const shadows = (elevation: number) =>
    lightOf({ azimuth_rad: 0, elevation_rad: elevation * DEG }).shadows;
  expect([40, 5, -2.5, -6, -25].map(shadows)).toEqual([1, 1, 0, 0, 1]);
});

test("at the visibility a twentieth of the contrast is left", () => {
  for (const visibility of [200, 2000, 20_000])
    expect(Math.exp(-density(visibility) * visibility)).toBeCloseTo(0.05, 9);
});

test("a coast is triangles that cover it, and its bank lies inside", () => {
  const ring: Pair[] = [
    [0, 0],
    [0, 400],
    [300, 400],
    [300, 200],
    [120, 200],
    [120, 0],
  ];
  const area = cut(ring)
    .map((three) => Math.abs(area2(three.map((k) => ring[k] ?? [0, 0]))) / 2)
    .reduce((sum, each) => sum + each, 0);
  expect(area).toBeCloseTo(Math.abs(area2(ring)) / 2, 6);
  for (const at of inset(ring, 7)) expect(isInside(ring, at)).toBe(true);
  for (const at of inset(ring.toReversed(), 7)) expect(isInside(ring, at)).toBe(true);
  expect(width(ring)).toBeGreaterThan(25);
});

test("an address asks for a view", () => {
  expect(lookOf("?token=a")).toBeNull();
  expect(lookOf("?view=nowhere")).toBeNull();
  const asked = lookOf("?token=a&view=bridge&bearing=-60&fov=60");
  expect(asked?.eye).toBe("bridge");
  expect(asked?.turn_rad).toBeCloseTo(-60 * DEG, 12);
  expect(asked?.panorama_rad).toBeCloseTo(60 * DEG, 12);
  expect(lookOf("?view=stern&fov=nonsense")).toEqual({
    eye: "stern",
    turn_rad: 0,
    panorama_rad: null,
    lifted_m: 0,
    marks: false,
  });
  expect(lookOf("?view=bridge&eye=1.6&marks")?.lifted_m).toBeCloseTo(-0.15, 12);
  expect(lookOf("?view=bridge&eye=1.6&marks")?.marks).toBe(true);
  // Nobody's eye is that high.
  expect(lookOf("?view=bridge&eye=40")?.lifted_m).toBeCloseTo(1.25, 12);
});

test("a tug pushes with her bow at the ship's side, and pulls over her bow on a line of 45 m", () => {
  const ship: BodyNow = [100, 200, 0.5 * Math.PI, 0, 0, 0];
  const info = {
    length_m: 30,
    beam_m: 10,
    push_at_m: [40, 15],
    pull_at_m: [40, 12],
  } as unknown as TugInfo;
  const now = (order: "push" | "pull", direction_rad: number) =>
    ({ order, force_n: 3e5, direction_rad }) as unknown as TugNow;
  const bow = ({ place, heading_rad }: TugPlace): Pair => add(place, turned(heading_rad, [15, 0]));
  // She heads east: starboard is south. A push from starboard acts to the north.
  const push = bow(tugPlace(info, now("push", -0.5 * Math.PI), ship));
  expect(push[0]).toBeCloseTo(100 - 15.5, 9);
  expect(push[1]).toBeCloseTo(240, 9);
  const pull = bow(tugPlace(info, now("pull", 0.5 * Math.PI), ship));
  expect(pull[0]).toBeCloseTo(100 - 12 - 45, 9);
  expect(pull[1]).toBeCloseTo(240, 9);
});

test("a shore without an outline has quays under its fenders and bollards, with the front at the fenders", () => {
  // Eight fenders that face south along a front to the east, and one far off that faces west.
  const row = Array.from({ length: 8 }, (_, i) => ({
    at_m: [500, 1400 + 36 * i] as Pair,
    facing_rad: Math.PI,
  }));
  const lone = { at_m: [900, 0] as Pair, facing_rad: -0.5 * Math.PI };
  const bollards: Pair[] = [
    [501.5, 1425],
    [514, 1600],
    [0, 0],
  ];
  const rings = quaysOf([...row, lone], bollards);
  expect(rings.length).toBe(3);
  const [quay, post, footing] = rings;
  if (!quay || !post || !footing) throw new Error("three quays");
  for (const at of bollards.slice(0, 2)) expect(isInside(quay, at)).toBe(true);
  // Water before the front, quay behind.
  for (const { at_m } of row) {
    expect(isInside(quay, [at_m[0] - 0.01, at_m[1]])).toBe(false);
    expect(isInside(quay, [at_m[0] + 15.9, at_m[1]])).toBe(true);
  }
  expect(isInside(post, [900, 0.01]) && !isInside(post, [900, -0.01])).toBe(true);
  expect(isInside(footing, [0, 0])).toBe(true);
});
