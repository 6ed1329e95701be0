/** Ships: hull, deck, house, bridge and cargo as one list of triangles, and their windows as another. */
import { type Arrangement, STOREY_M } from "./arrangement";
import { containers } from "./containers";
import { smooth } from "./axes";
import { BOOT_M } from "./hull";
import { type Paint, type Parts, railing, windowBand } from "./fittings";
import { isLong, mastheads } from "./lamps";
import { Solids, type Spot } from "./solids";
import { tugParts } from "./tug";
import type { Pair } from "../protocol";

const WHITE = 0xe9ebe8;
const STEEL = 0x8d9499;
const BUFF = 0xc79a55;
const HATCH = 0x705448;

export const PAINTS: Paint[] = [
  { bottom: 0x7d2a22, side: 0x36414d, deck: 0x6a4a42, house: WHITE, funnel: 0x1f4d7a },
  { bottom: 0x7d2a22, side: 0x1f3f66, deck: 0x4f6154, house: WHITE, funnel: 0xb5552a },
  { bottom: 0x74302a, side: 0x3c3f42, deck: 0x5f6a60, house: 0xe6e2d4, funnel: 0x29543c },
];

/** Height of the bulwark at the bow [m]. */
const BULWARK_M = 1.2;
const TUG_BULWARK_M = 0.9;

/** `fairleads`: places of the fairleads of the lines, as (forward, to starboard, above the water) [m]. */
export function shipParts(ship: Arrangement, paint: Paint, fairleads: Spot[] = []): Parts {
  const parts: Parts = { painted: new Solids(), panes: new Solids() };
  hullParts(ship, paint, parts.painted);
  if (ship.kind === "tug") tugParts(ship, paint, parts);
  else {
    houseParts(ship, paint, parts);
    mooringDeck(ship, parts.painted);
    for (const at of fairleads) fairlead(ship, at, parts.painted);
    if (ship.kind === "container") containers(ship, parts.painted);
    else if (ship.kind === "tanker") pipes(ship, parts.painted);
    else if (ship.kind === "ro-ro") garage(ship, paint, parts);
    else if (ship.kind === "bulk") holds(ship, parts.painted);
  }
  return parts;
}

/** Shell, transom and deck. */
export function hullParts({ hull, kind }: Arrangement, paint: Paint, to: Solids): void {
  const { draught_m, levels } = hull.form;
  const stations = hull.stations(44);
  const rail = kind === "tug" ? TUG_BULWARK_M : 0;
  for (const side of [1, -1] as const) {
    const column = (forward: number): Spot[] => {
      const heights = hull.heights(hull.deck_m(forward) + rail);
      return heights.map((up) => hull.side(forward, up, side));
    };
    const columns = stations.map(column);
    to.plate(
      columns,
      (j, i) => ((columns[j]?.[i]?.[2] ?? 0) < BOOT_M ? paint.bottom : paint.side),
      ([forward]) => {
        const bow = smooth(hull.fore_m - 4, hull.fore_m, forward);
        const stern = smooth(-hull.aft_m - 2, -hull.aft_m, -forward);
        return [bow - stern, side * (1 - 0.9 * Math.max(bow, stern)) + side * 0.1, 0];
      },
    );
  }
  // Transom and stem join both sides where the outline ends flat.
  for (const [end, out] of [
    [hull.aft_m, -1],
    [hull.fore_m, 1],
  ] as const) {
    const wall = out > 0 && kind !== "tug" ? BULWARK_M : rail;
    const deck = hull.deck_m(end);
    const below = levels.length > 0 ? hull.heights(deck) : [-draught_m * 0.6, 0, BOOT_M, deck];
    const heights = [...below, deck + wall];
    const [starboard, port] = ([1, -1] as const).map((side) =>
      heights.map((up) => hull.side(end, up, side)),
    );
    heights.forEach((_, k) => {
      const corners = [starboard?.[k], starboard?.[k + 1], port?.[k + 1], port?.[k]];
      if (!corners.every((corner) => corner !== undefined)) return;
      const colour = (heights[k] ?? 0) < BOOT_M ? paint.bottom : paint.side;
      to.face(corners, [out, 0, 0], colour);
      if (k + 2 === heights.length) to.face(corners, [-out, 0, 0], paint.deck);
    });
  }
  const across = (forward: number, up: number): Spot[] => {
    const [p, s] = [hull.side(forward, up, -1), hull.side(forward, up, 1)];
    return [p, [p[0], 0, up], s];
  };
  const decks = [...stations, ...hull.stations(120).filter((f) => f > hull.fore_m * 0.6)].toSorted(
    (a, b) => a - b,
  );
  to.plate(
    decks.map((f) => across(f, hull.deck_m(f))),
    () => paint.deck,
    () => [0, 0, 1],
  );
  // Inside of the bulwark, at the bow of ships and all round a tug.
  const walled = decks.filter(
    (f) => kind === "tug" || f > hull.aft_m + 0.9 * (hull.fore_m - hull.aft_m),
  );
  const height = kind === "tug" ? rail : BULWARK_M;
  for (const side of [1, -1] as const) {
    const low = walled.map((f) => hull.side(f, hull.deck_m(f), side));
    const high = walled.map((f): Spot => {
      const [at, wide] = hull.side(f, hull.deck_m(f), side);
      return [at, wide, hull.deck_m(f) + height];
    });
    for (const [out, colour] of [
      [1, paint.side],
      [-1, paint.deck],
    ] as const)
      to.plate(
        [low, high],
        () => colour,
        () => [0, side * out, 0],
      );
  }
}

/** House, wheelhouse with wings, funnel, mast. */
function houseParts(ship: Arrangement, paint: Paint, { painted, panes }: Parts): void {
  const { house, deck_m, kind } = ship;
  const base = kind === "ro-ro" ? house.bridge_deck_m - STOREY_M : deck_m;
  const storeys = Math.max(1, Math.round((house.bridge_deck_m - base) / STOREY_M));
  const storey = (house.bridge_deck_m - base) / storeys;
  for (let i = 0; i < storeys; i++) {
    const [low, high] = [base + i * storey, base + (i + 1) * storey];
    // The house becomes a little smaller upwards.
    const [shrink, front] = [kind === "passenger" ? 0 : 0.02 * i, 0.25 * i];
    const [aft, fore] = [
      house.aft_m + 0.4 * i,
      house.fore_m - (kind === "passenger" ? front * 6 : 0),
    ];
    const half = house.half_m * (1 - shrink);
    painted.box([aft, -half, low], [fore, half, high], paint.house, 0x9aa39d);
    painted.box(
      [aft - 0.5, -half - 0.7, high - 0.14],
      [fore + 0.2, half + 0.7, high],
      paint.house,
      0x7f8a84,
    );
    const band: Pair = [low + storey * 0.42, low + storey * 0.72];
    const look = kind === "passenger" ? { wide: 2.2, gap: 0.5 } : { wide: 0.75, gap: 2 };
    windowBand(panes, [fore, -half], [fore, half], [1, 0], band, look);
    windowBand(panes, [aft, -half], [aft, half], [-1, 0], band, look);
    for (const side of [-1, 1])
      windowBand(panes, [aft, side * half], [fore, side * half], [0, side], band, look);
    if (i > 0)
      for (const side of [-1, 1])
        railing(painted, [
          [aft - 0.5, side * (half + 0.65), low],
          [fore, side * (half + 0.65), low],
        ]);
  }
  wheelhouse(ship, paint, { painted, panes });
  // Funnel abaft the house, mast on the wheelhouse.
  const top = house.bridge_deck_m + 1.2 * STOREY_M;
  const long = Math.min(10, 0.5 * (house.fore_m - house.aft_m) + 2);
  const back =
    kind === "ro-ro" || (kind === "container" && ship.length_m > 260)
      ? ship.hull.aft_m + 0.14 * ship.length_m
      : house.aft_m + 0.4 * storeys;
  const from = kind === "ro-ro" ? deck_m : kind === "passenger" ? house.bridge_deck_m : deck_m;
  const wide = Math.min(3.5, 0.13 * ship.beam_m);
  const ring = (grow: number): Pair[] => [
    [back - long - grow, -wide],
    [back - grow, -wide - grow],
    [back - grow, wide + grow],
    [back - long - grow, wide],
  ];
  if (kind === "bulk" || kind === "tanker" || kind === "container")
    painted.box(
      [back - long - 3, -wide - 3, from],
      [back, wide + 3, from + 2 * STOREY_M],
      paint.house,
      0x9aa39d,
    );
  painted.frustum(ring(0), ring(-0.4), from, top, paint.funnel, 0x222222);
  painted.prism(
    ring(-0.2).map(([f, s]): Pair => [f, s * 1.02]),
    top - 3.2,
    top - 1.2,
    WHITE,
  );
  for (const side of [-0.5, 0.5])
    painted.post(
      [back - long / 2, side * wide, top],
      [back - long / 2, side * wide, top + 1.3],
      0.5,
      0x222222,
    );
}

/** Wheelhouse with windows all round, and open wings to the ship's side. */
function wheelhouse(ship: Arrangement, paint: Paint, { painted, panes }: Parts): void {
  const { bridge, house } = ship;
  const floor = house.bridge_deck_m;
  const roof = floor + bridge.height_m;
  const { fore_m: fore, aft_m: aft, half_m: half, wing_m: wing } = bridge;
  painted.box([aft, -half, floor], [fore, half, roof], paint.house, 0x8b948f);
  painted.box(
    [aft - 0.3, -half - 0.3, roof - 0.12],
    [fore + 0.5, half + 0.3, roof + 0.05],
    paint.house,
    0x8b948f,
  );
  const band: Pair = [floor + 0.38 * bridge.height_m, roof - 0.3];
  const look = { wide: 1.3, gap: 0.18, colour: 0x10191f };
  windowBand(panes, [fore, -half], [fore, half], [1, 0], band, look);
  windowBand(panes, [aft, -half], [aft, half], [-1, 0], band, look);
  for (const side of [-1, 1]) {
    windowBand(panes, [aft, side * half], [fore, side * half], [0, side], band, look);
    // The wing: floor, and a bulwark to lean on.
    const [inner, outer] = [side * half, side * wing];
    const back = Math.max(aft, fore - 3.2);
    painted.box([back, inner, floor - 0.25], [fore, outer, floor], paint.house, 0x7f8a84);
    painted.box([fore - 0.1, inner, floor], [fore, outer, floor + 1.15], paint.house);
    painted.box([back, outer - side * 0.1, floor], [fore, outer, floor + 1.15], paint.house);
    painted.box([back, inner, floor], [back + 0.1, outer, floor + 1.15], paint.house);
    // A strut under the wing's end.
    painted.post(
      [fore - 1.6, outer - side * 0.6, floor - 0.2],
      [fore - 1.6, inner, floor - 2.6],
      0.12,
      paint.house,
    );
    // Screens of the sidelights.
    painted.box(
      [fore - 2.2, outer + side * 0.02, floor + 0.2],
      [fore - 0.6, outer + side * 0.3, floor + 0.25],
      side < 0 ? 0x8c1d1d : 0x1c6b34,
    );
  }
  if (isLong(ship)) {
    const { aft: after, post } = mastheads(ship);
    const [at, up] = after;
    if (post)
      painted.post([at, 0, ship.hull.deck_m(at)], [at, 0, up + 0.6], 0.3, WHITE, { upper_m: 0.14 });
  }
  // Mast with radar scanners.
  const at = (fore + aft) / 2;
  const top = ship.mast_m + 0.6;
  painted.post([at, 0, roof], [at, 0, top], 0.32, WHITE, { upper_m: 0.16 });
  painted.box([at - 0.9, -1.9, roof + 2.6], [at + 0.9, 1.9, roof + 2.75], WHITE);
  painted.box([at + 0.3, -1.7, roof + 3.1], [at + 0.5, 1.7, roof + 3.4], 0xf2f2ee);
  painted.box([at + 0.2, -1.1, roof + 4.1], [at + 0.4, 1.1, roof + 4.3], 0xf2f2ee);
  painted.post([at, -1.8, roof + 2.7], [at, -1.8, roof + 4.4], 0.05, STEEL, { sides: 4 });
  painted.post([at, 1.8, roof + 2.7], [at, 1.8, roof + 5.2], 0.05, STEEL, { sides: 4 });
}

/** Forecastle and poop: windlasses, bitts, foremast, railings along the deck's edge. */
function mooringDeck({ hull, length_m, beam_m }: Arrangement, to: Solids): void {
  const along = (share: number) => hull.aft_m + share * length_m;
  const fore = hull.deck_m(along(0.95));
  for (const side of [-1, 1]) {
    const s = side * 0.13 * beam_m;
    to.box([along(0.945), s - 1.4, fore], [along(0.945) + 2.2, s + 1.4, fore + 0.5], 0x5c6b5e);
    to.post(
      [along(0.945) + 1.1, s - 1.5, fore + 1.1],
      [along(0.945) + 1.1, s + 1.5, fore + 1.1],
      0.8,
      0x4b5a4e,
      { sides: 10 },
    );
  }
  to.post(
    [along(0.93), 0, fore],
    [along(0.93), 0, fore + Math.max(6, 0.055 * length_m)],
    0.3,
    BUFF,
    { upper_m: 0.14 },
  );
  const bitts = (share: number, inset: number) => {
    for (const side of [-1, 1]) {
      const [, wide] = hull.side(along(share), hull.deck_m(along(share)), side as 1 | -1);
      for (const step of [-0.5, 0.5])
        to.post(
          [along(share) + step, wide - side * inset, hull.deck_m(along(share))],
          [along(share) + step, wide - side * inset, hull.deck_m(along(share)) + 0.7],
          0.22,
          0x2a2f33,
        );
    }
  };
  for (const share of [0.02, 0.04, 0.25, 0.7, 0.93, 0.965]) bitts(share, 1.2);
  const stations = Array.from({ length: 25 }, (_, i) => along(0.001 + (0.88 * i) / 24));
  const stern = ([-1, 1] as const).map((side): Spot => {
    const [at, wide] = hull.side(hull.aft_m, hull.deck_m(hull.aft_m), side);
    return [at + 0.12, wide, hull.deck_m(hull.aft_m)];
  });
  railing(to, stern);
  for (const side of [-1, 1] as const)
    railing(
      to,
      stations.map((f) => {
        const [at, wide] = hull.side(f, hull.deck_m(f), side);
        return [at, wide - side * 0.12, hull.deck_m(f)] as Spot;
      }),
    );
}

/** A roller fairlead on a stand, so that a line whose fairlead is higher than the deck does not end in the air. */
function fairlead({ hull }: Arrangement, [forward, side, up]: Spot, to: Solids): void {
  const deck = hull.deck_m(forward);
  if (up < deck) return;
  to.post([forward, side, deck], [forward, side, up - 0.15], 0.2, 0x2a2f33, { upper_m: 0.3 });
  for (const step of [-0.3, 0.3])
    to.post([forward + step, side, up - 0.2], [forward + step, side, up + 0.25], 0.1, STEEL);
}

/** Hatches with their covers. Ships have no cranes here, which would stand in the view from the bridge. */
function holds(ship: Arrangement, to: Solids): void {
  const { hull, house, length_m, beam_m, deck_m } = ship;
  const [aft, fore] = [house.fore_m + 0.025 * length_m, hull.aft_m + 0.895 * length_m];
  const count = Math.max(2, Math.round((fore - aft) / 27));
  const pitch = (fore - aft) / count;
  for (let i = 0; i < count; i++) {
    const from = aft + i * pitch + 0.14 * pitch;
    const till = aft + (i + 1) * pitch - 0.06 * pitch;
    const half = Math.min(0.29 * beam_m, 0.72 * Math.min(...hull.breadth(till)));
    to.box([from, -half, deck_m], [till, half, deck_m + 1.5], 0x5d463c);
    to.box(
      [from - 0.3, -half - 0.4, deck_m + 1.5],
      [till + 0.3, half + 0.4, deck_m + 2.3],
      HATCH,
      0x7a5d50,
    );
    for (let k = 1; k < 4; k++) {
      const at = from + ((till - from) * k) / 4;
      to.box(
        [at - 0.12, -half - 0.4, deck_m + 2.3],
        [at + 0.12, half + 0.4, deck_m + 2.5],
        0x5c453b,
      );
    }
  }
}

/** Pipes along the deck, manifold and hose crane amidships. */
function pipes(ship: Arrangement, to: Solids): void {
  const { hull, house, length_m, beam_m, deck_m } = ship;
  const [aft, fore] = [house.fore_m + 4, hull.aft_m + 0.9 * length_m];
  for (const s of [-2.4, -1.2, 0, 1.2, 2.4])
    to.post([aft, s, deck_m + 1], [fore, s, deck_m + 1], 0.3, 0x8f5b45, { sides: 6 });
  to.box([aft, 3.2, deck_m + 1.9], [fore, 4.4, deck_m + 2], 0x9a9d98);
  const middle = hull.aft_m + 0.5 * length_m;
  for (const f of [-6, -3, 0, 3, 6]) {
    to.post(
      [middle + f, -0.42 * beam_m, deck_m + 1.3],
      [middle + f, 0.42 * beam_m, deck_m + 1.3],
      0.32,
      0x8f5b45,
      { sides: 6 },
    );
    for (const side of [-1, 1])
      to.post(
        [middle + f, side * 0.42 * beam_m, deck_m + 1.3],
        [middle + f, side * 0.445 * beam_m, deck_m + 1.3],
        0.5,
        STEEL,
        { sides: 8 },
      );
  }
  to.post([middle + 9, 0, deck_m], [middle + 9, 0, deck_m + 14], 0.8, WHITE);
  to.post([middle + 9, 0, deck_m + 13], [middle - 9, 0, deck_m + 15], 0.4, WHITE, {
    sides: 6,
    upper_m: 0.2,
  });
  const tanks = Math.max(3, Math.round((fore - aft) / 26));
  for (let i = 0; i < tanks; i++)
    for (const side of [-1, 1])
      to.post(
        [aft + ((i + 0.5) * (fore - aft)) / tanks, side * 0.25 * beam_m, deck_m],
        [aft + ((i + 0.5) * (fore - aft)) / tanks, side * 0.25 * beam_m, deck_m + 1.6],
        0.7,
        0x8f5b45,
      );
}

/** The weather deck of a ship that carries vehicles: vents, and a ramp at her quarter. */
function garage(ship: Arrangement, paint: Paint, { painted }: Parts): void {
  const { hull, length_m, beam_m, deck_m } = ship;
  for (let i = 0; i < 9; i++)
    for (const side of [-1, 1])
      painted.box(
        [hull.aft_m + (0.1 + 0.08 * i) * length_m, side * 0.4 * beam_m - 0.8, deck_m],
        [hull.aft_m + (0.1 + 0.08 * i) * length_m + 2.4, side * 0.4 * beam_m + 0.8, deck_m + 2],
        paint.house,
      );
}
