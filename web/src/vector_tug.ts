/** Where a vector tug lies, by the place and direction of her force. The plan and the view out of the window draw her there. */
import { add, onEarth, turned } from "./geometry";
import type { BodyNow, Pair, TugInfo, TugNow } from "./protocol";

/** Length of the line of a tug that pulls [m]. */
export const TOW_M = 45;
/** Distances of a tug from the ship's side while she pushes, and while she does nothing [m]. */
const PUSHES_OFF_M = 0.5;
const IDLE_OFF_M = 14;
/** A tug with a larger force works [N]. */
export const WORKS_N = 1e3;

/** Outline in half lengths and half beams. */
const OUTLINE: Pair[] = [
  [-1, -0.75],
  [-0.8, -1],
  [0.35, -1],
  [0.8, -0.62],
  [1, 0],
  [0.8, 0.62],
  [0.35, 1],
  [-0.8, 1],
  [-1, 0.75],
];

/** Outline of a tug with a length and a beam [m]. */
export const tugOutline = ({ length_m, beam_m }: Pick<TugInfo, "length_m" | "beam_m">): Pair[] =>
  OUTLINE.map(([x, y]) => [(x * length_m) / 2, (y * beam_m) / 2]);

export interface TugPlace {
  /** Middle of the tug, north and east [m]. */
  place: Pair;
  /** Heading of the tug: her bow is towards the ship, also while she pulls [rad]. */
  heading_rad: number;
  /** Where her force acts on the ship, in the axes of the ship [m]. */
  at: Pair;
  /** Direction of her force, from the ship's bow [rad]. */
  toward_rad: number;
  works: boolean;
}

/** Where a tug lies beside the ship that she serves. */
export function tugPlace(info: TugInfo, now: TugNow, ship: BodyNow): TugPlace {
  const pulls = now.order === "pull";
  const at = pulls ? info.pull_at_m : info.push_at_m;
  const side = Math.sign(at[1]) || 1;
  const works = now.force_n > WORKS_N || now.order !== "stop";
  const toward_rad = works ? now.direction_rad : (-side * Math.PI) / 2;
  const half_m = info.length_m / 2;
  const off_m = pulls ? TOW_M + half_m : -(half_m + (works ? PUSHES_OFF_M : IDLE_OFF_M));
  return {
    place: onEarth(ship, add(at, turned(toward_rad, [off_m, 0]))),
    heading_rad: ship[2] + toward_rad + (pulls ? Math.PI : 0),
    at,
    toward_rad,
    works,
  };
}
