/** A harbour tug: fendering all round, wheelhouse with windows to all sides, winch and staple, two funnels, mast. */
import type { Arrangement } from "./arrangement";
import { type Paint, type Parts, railing, windowBand } from "./fittings";
import type { Spot } from "./solids";
import type { Pair } from "../protocol";

const RUBBER = 0x17181a;
const BUFF = 0xd2a35a;

export const TUG_PAINT: Paint = {
  bottom: 0x6e2620,
  side: 0x14181c,
  deck: 0x4d5f55,
  house: 0xe6e3d8,
  funnel: 0xc8641e,
};

export function tugParts(ship: Arrangement, paint: Paint, { painted, panes }: Parts): void {
  const { hull, house, bridge, deck_m, length_m } = ship;
  const small = length_m / 32;
  const at = (forward: number, up: number, side: 1 | -1): Spot => hull.side(forward, up, side);
  // A rubber belt round the sheer, thick at the bow.
  const stations = hull.stations(26);
  for (const side of [1, -1] as const)
    for (let i = 0; i + 1 < stations.length; i++) {
      const [a, b] = [stations[i] ?? 0, stations[i + 1] ?? 0];
      const fore = (a - hull.aft_m) / length_m > 0.8;
      const spot = (f: number): Spot => {
        const [x, y] = at(f, hull.deck_m(f), side);
        return [x, y, hull.deck_m(f) - 0.45 * small];
      };
      painted.post(spot(a), spot(b), (fore ? 0.48 : 0.26) * small, RUBBER, {
        sides: 8,
        caps: i === 0,
      });
      if (fore) {
        const lower = (f: number): Spot => {
          const up = hull.deck_m(f) - 1.3 * small;
          const [x, y] = at(f, up, side);
          return [x, y, up];
        };
        painted.post(lower(a), lower(b), 0.42 * small, RUBBER, { sides: 8, caps: false });
      }
    }
  // The belt goes round a bow that ends flat.
  for (const [down, radius] of [
    [0.45, 0.48],
    [1.3, 0.42],
  ] as const) {
    const up = hull.deck_m(hull.fore_m) - down * small;
    painted.post(at(hull.fore_m, up, -1), at(hull.fore_m, up, 1), radius * small, RUBBER, {
      sides: 8,
    });
  }
  // Tyres along the sides.
  for (const side of [1, -1] as const)
    for (let share = 0.14; share < 0.78; share += 0.085) {
      const f = hull.aft_m + share * length_m;
      const [x, y] = at(f, hull.deck_m(f) - 0.7 * small, side);
      painted.post(
        [x, y, hull.deck_m(f) - 0.75 * small],
        [x, y + side * 0.3 * small, hull.deck_m(f) - 0.75 * small],
        0.55 * small,
        RUBBER,
        { sides: 10 },
      );
    }
  const floor = house.bridge_deck_m;
  const mid = (deck_m + floor) / 2;
  // House in two storeys, its upper one narrower.
  const ring = (aft: number, fore: number, half: number, cut: number): Pair[] => [
    [aft, -half],
    [fore - cut, -half],
    [fore, -half + cut],
    [fore, half - cut],
    [fore - cut, half],
    [aft, half],
  ];
  painted.prism(
    ring(house.aft_m, house.fore_m + 0.06 * length_m, house.half_m, 1.4 * small),
    deck_m,
    mid,
    paint.house,
    0x7d8a80,
  );
  painted.prism(
    ring(
      house.aft_m + 0.05 * length_m,
      house.fore_m + 0.02 * length_m,
      house.half_m * 0.8,
      1.2 * small,
    ),
    mid,
    floor,
    paint.house,
    0x7d8a80,
  );
  for (const side of [-1, 1]) {
    windowBand(
      panes,
      [house.aft_m + 1, side * house.half_m],
      [house.fore_m, side * house.half_m],
      [0, side],
      [deck_m + 1.1 * small, deck_m + 1.6 * small],
      { wide: 0.5, gap: 1.4 },
    );
    railing(painted, [
      [house.aft_m + 0.4, side * (house.half_m - 0.1), mid],
      [house.fore_m + 0.04 * length_m, side * (house.half_m - 0.1), mid],
    ]);
  }
  // The wheelhouse: eight sides, windows from the knee to the roof.
  const { fore_m: fore, aft_m: aft, half_m: half, height_m: tall } = bridge;
  const eight = (grow: number): Pair[] => {
    const [f, a, h, c] = [fore + grow, aft - grow, half + grow, 0.45 * half];
    return [
      [a, -h + c],
      [a + c, -h],
      [f - c, -h],
      [f, -h + c],
      [f, h - c],
      [f - c, h],
      [a + c, h],
      [a, h - c],
    ];
  };
  painted.frustum(eight(-0.15 * small), eight(0), floor, floor + 0.32 * tall, paint.house);
  painted.frustum(
    eight(0),
    eight(0.18 * small),
    floor + 0.32 * tall,
    floor + tall,
    paint.house,
    paint.house,
    paint.house,
  );
  painted.prism(
    eight(0.5 * small),
    floor + tall,
    floor + tall + 0.2 * small,
    paint.house,
    0x8b948f,
    0xb9bdb6,
  );
  const corners = eight(0.09 * small);
  corners.forEach((a, i) => {
    const b = corners[(i + 1) % corners.length] ?? a;
    const [df, ds] = [b[0] - a[0], b[1] - a[1]];
    const long = Math.hypot(df, ds);
    const outward: Pair = [ds / long, -df / long];
    const middle: Pair = [(a[0] + b[0]) / 2 - (fore + aft) / 2, (a[1] + b[1]) / 2];
    const facing: Pair =
      outward[0] * middle[0] + outward[1] * middle[1] < 0 ? [-outward[0], -outward[1]] : outward;
    const off: Pair = [facing[0] * 0.1 * small, facing[1] * 0.1 * small];
    windowBand(
      panes,
      [a[0] + off[0], a[1] + off[1]],
      [b[0] + off[0], b[1] + off[1]],
      facing,
      [floor + 0.38 * tall, floor + 0.93 * tall],
      { wide: 1.1 * small, gap: 0.16 * small, colour: 0x10191f },
    );
  });
  // Funnels abaft the wheelhouse, mast on its roof.
  for (const side of [-1, 1]) {
    const s = side * house.half_m * 0.72;
    painted.post(
      [house.aft_m + 0.9, s, mid],
      [house.aft_m + 0.9, s, floor + 0.75 * tall],
      0.55 * small,
      paint.funnel,
      { sides: 10 },
    );
    painted.post(
      [house.aft_m + 0.9, s, floor + 0.75 * tall],
      [house.aft_m + 0.7, s, floor + tall],
      0.35 * small,
      0x1c1c1c,
      { sides: 8 },
    );
  }
  const roof = floor + tall + 0.2 * small;
  const stem = (fore + aft) / 2 - 0.6 * small;
  const top = ship.mast_m;
  painted.post([stem, 0, roof], [stem, 0, top], 0.16 * small, BUFF, { upper_m: 0.08 * small });
  for (const side of [-1, 1])
    painted.post(
      [stem - 1.2 * small, side * 0.9 * small, roof],
      [stem, 0, roof + 0.6 * (top - roof)],
      0.08 * small,
      BUFF,
      { sides: 5 },
    );
  painted.box(
    [stem - 0.1, -1.1 * small, roof + 0.45 * (top - roof)],
    [stem + 0.1, 1.1 * small, roof + 0.45 * (top - roof) + 0.15],
    0xf2f2ee,
  );
  painted.post(
    [fore - 0.6, half * 0.4, roof],
    [fore - 0.6, half * 0.4, roof + 0.8 * small],
    0.3 * small,
    0xd8d8d2,
  );
  // Winch and staple on the foredeck: the towline comes out here.
  const fd = hull.deck_m(hull.aft_m + 0.85 * length_m);
  const winch = hull.aft_m + 0.79 * length_m;
  painted.box(
    [winch - 1.2 * small, -1.5 * small, fd - 0.6],
    [winch + 1.2 * small, 1.5 * small, fd + 0.4 * small],
    0x5b6258,
  );
  painted.post(
    [winch, -1.3 * small, fd + 0.9 * small],
    [winch, 1.3 * small, fd + 0.9 * small],
    0.75 * small,
    0x8f9a8d,
    { sides: 12 },
  );
  const staple = hull.aft_m + 0.93 * length_m;
  for (const side of [-1, 1])
    painted.post(
      [staple, side * 0.7 * small, fd - 0.5],
      [staple, side * 0.5 * small, fd + 1.7 * small],
      0.22 * small,
      BUFF,
    );
  painted.post(
    [staple, -0.6 * small, fd + 1.7 * small],
    [staple, 0.6 * small, fd + 1.7 * small],
    0.24 * small,
    BUFF,
  );
  // Towing hook aft.
  painted.post(
    [hull.aft_m + 0.22 * length_m, 0, deck_m],
    [hull.aft_m + 0.22 * length_m, 0, deck_m + 1 * small],
    0.35 * small,
    BUFF,
  );
}
