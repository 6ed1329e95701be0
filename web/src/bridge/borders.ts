/** The borders of land and quays of a chart, to find lines that run along them. */
import { area2 } from "./berth";
import { length, minus, nearestOn, times } from "../geometry";
import type { Pair } from "../protocol";

/** Side of a cell of the index of edges [m]. */
const CELL_M = 50;

/** An edge of a border. `inward`: unit vector to the inside of the area; `deep_m`: breadth of the bank behind the edge, `null` without. */
export interface Edge {
  from: Pair;
  to: Pair;
  inward: Pair;
  deep_m: number | null;
}

export class Borders {
  private readonly cells = new Map<string, Edge[]>();

  /** Adds the outer ring of an area, or a hole in it. */
  add(ring: Pair[], isOuter: boolean, deep_m: number | null): void {
    const sign = area2(ring) > 0 === isOuter ? 1 : -1;
    ring.forEach((from, i) => {
      const to = ring[(i + 1) % ring.length] ?? from;
      const long = length(minus(to, from));
      if (long <= 0) return;
      const inward = times([-(to[1] - from[1]), to[0] - from[0]], sign / long);
      const edge = { from, to, inward, deep_m };
      // A long edge is taken step by step.
      const steps = Math.ceil(long / CELL_M) + 1;
      let last = "";
      for (let step = 0; step <= steps; step++) {
        const share = step / steps;
        const key = keyOf([
          Math.floor((from[0] + (to[0] - from[0]) * share) / CELL_M),
          Math.floor((from[1] + (to[1] - from[1]) * share) / CELL_M),
        ]);
        if (key === last) continue;
        last = key;
        const cell = this.cells.get(key);
        if (cell) cell.push(edge);
        else this.cells.set(key, [edge]);
      }
    });
  }

  /** The nearest edge within a distance of a place, which is less than a cell. */
  near(at: Pair, within_m: number): Edge | null {
    const cell: Pair = [Math.floor(at[0] / CELL_M), Math.floor(at[1] / CELL_M)];
    let [found, nearest_m]: [Edge | null, number] = [null, within_m];
    for (const n of [-1, 0, 1])
      for (const e of [-1, 0, 1])
        for (const edge of this.cells.get(keyOf([cell[0] + n, cell[1] + e])) ?? []) {
          const off_m = length(minus(at, nearestOn(edge.from, edge.to, at)));
          if (off_m <= nearest_m) [found, nearest_m] = [edge, off_m];
        }
    return found;
  }
}

const keyOf = ([n, e]: Pair): string => `${n} ${e}`;
