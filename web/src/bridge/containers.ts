/** Containers on deck, in bays. Hatch covers carry them, and lashing bridges stand between the bays. */
import type { Arrangement } from "./arrangement";
import { smooth } from "./axes";
import { chance } from "./fittings";
import type { Colour, Solids, Spot } from "./solids";

/** Colours of containers. */
const BOXES: Colour[] = [
  0x47617a, 0x7d4a3f, 0x53685a, 0x9a8152, 0x7b7f83, 0x5a3d43, 0x3a4d61, 0x8f6043, 0xb9bab5,
  0x44595a,
];

/** Size of a container with the room about it [m]. */
const WIDE_M = 2.5;
const HIGH_M = 2.6;
const LONG_M = 12.2;
/** Distance from bay to bay [m]. */
const PITCH_M = 14.3;

/** A bay: stacks side by side, each with so many containers. */
export interface Bay {
  /** Number of the bay from aft. */
  number: number;
  aft_m: number;
  fore_m: number;
  /** Half the breadth of the deck that the bay covers [m]. */
  half_m: number;
  /** Height of the hatch covers above the water [m]. */
  base_m: number;
  /** Containers in each stack, from port to starboard. */
  tiers: number[];
}

/** The bays of a ship; none where the house and the funnel stand. */
export function baysOf({ hull, house, length_m, deck_m, bridge }: Arrangement): Bay[] {
  const base_m = deck_m + 2.2;
  const first = hull.aft_m + 0.03 * length_m;
  return Array.from({ length: Math.floor((0.9 * length_m) / PITCH_M) }).flatMap(
    (_, number): Bay[] => {
      const aft_m = first + number * PITCH_M;
      const fore_m = aft_m + LONG_M;
      if (fore_m > house.aft_m - 2 && aft_m < house.fore_m + 2.5) return [];
      const funnel = hull.aft_m + 0.11 * length_m;
      if (length_m > 260 && Math.abs(aft_m + LONG_M / 2 - funnel) < 14) return [];
      const half_m = Math.min(...hull.breadth(aft_m), ...hull.breadth(fore_m)) - 0.4;
      const rows = Math.floor((2 * half_m) / WIDE_M);
      if (rows < 2) return [];
      // Lower towards the bow, so that the bridge sees the water.
      const sight =
        (house.bridge_deck_m + 1 - base_m) *
        (1 - 0.55 * smooth(0, 1, (aft_m - bridge.fore_m) / (0.5 * length_m)));
      const room = aft_m > house.fore_m ? sight - 1.5 : house.bridge_deck_m - base_m;
      const most = Math.max(1, Math.min(7, Math.floor(room / HIGH_M)));
      const tiers = Array.from({ length: rows }, (_, row) =>
        Math.max(1, most - Math.floor(2.4 * chance(number, row, length_m) ** 3)),
      );
      return [{ number, aft_m, fore_m, half_m, base_m, tiers }];
    },
  );
}

/** Height above the water below which a bay hides everything: the top of its lowest stack [m]. */
export const hiddenBelow_m = ({ base_m, tiers }: Bay): number =>
  base_m + HIGH_M * Math.min(...tiers);

/** Boxes with the faces that can be seen, hatch coamings and lashing bridges. */
export function containers(ship: Arrangement, to: Solids): void {
  const { deck_m } = ship;
  for (const bay of baysOf(ship)) {
    const { aft_m, fore_m, half_m, base_m } = bay;
    to.box([aft_m - 0.2, -half_m, deck_m], [fore_m + 0.2, half_m, base_m], 0x3d4a44);
    stacks(bay, to);
    const top = base_m + 2 * HIGH_M;
    for (const s of [-half_m, -half_m / 2, 0, half_m / 2, half_m])
      to.box([fore_m + 0.5, s - 0.2, deck_m], [fore_m + 1.1, s + 0.2, top], 0x55605b);
    to.box([fore_m + 0.4, -half_m, top - 0.2], [fore_m + 1.2, half_m, top], 0x55605b);
  }
}

/** Ends, tops and outer sides of the stacks: the faces between stacks are never seen. */
function stacks({ number, aft_m: a, fore_m: b, base_m, tiers }: Bay, to: Solids): void {
  tiers.forEach((count, row) => {
    const s = (row - 0.5 * tiers.length) * WIDE_M;
    const t = s + WIDE_M - 0.06;
    for (let tier = 0; tier < count; tier++) {
      const colour = BOXES[Math.floor(chance(number, row, tier, 7) * BOXES.length)] ?? 0x555555;
      const [low, top] = [base_m + tier * HIGH_M, base_m + (tier + 1) * HIGH_M - 0.04];
      const end = (f: number): Spot[] => [
        [f, s, low],
        [f, t, low],
        [f, t, top],
        [f, s, top],
      ];
      const side = (y: number): Spot[] => [
        [a, y, low],
        [b, y, low],
        [b, y, top],
        [a, y, top],
      ];
      to.face(end(b), [1, 0, 0], colour);
      to.face(end(a), [-1, 0, 0], colour);
      if (tier === count - 1)
        to.face(
          [
            [a, s, top],
            [b, s, top],
            [b, t, top],
            [a, t, top],
          ],
          [0, 0, 1],
          colour,
        );
      if (tier >= (tiers[row - 1] ?? 0)) to.face(side(s), [0, -1, 0], colour);
      if (tier >= (tiers[row + 1] ?? 0)) to.face(side(t), [0, 1, 0], colour);
    }
  });
}
