/**
 * Depths of the chart in four shades, as an electronic chart has them: water that is too shallow for the ship to float in, water
 * without the clearance that the mariner asks for, safe water, and water so deep that she hardly feels the bottom. The safety
 * contour between the second and the third is drawn bold. Depths are below chart datum, without tide.
 */
import type { Palette } from "../palette";
import type { ChartInfo, Pair } from "../protocol";

/** Water deeper than this many draughts is drawn as deep. */
const DEEP_DRAUGHTS = 2;
/** So far from an edge it is asked which areas lie on its sides [m]. */
const BESIDE_M = 0.5;
/** Time in a drawing for finding what lies beside edges [ms]. */
const BUDGET_MS = 6;

/** Depths at which the shades change [m]. */
export interface Limits {
  /** The ship's draught. */
  shallow_m: number;
  /** Draught and clearance. */
  safety_m: number;
  deep_m: number;
}

export function limits(draught_m: number, clearance_m: number): Limits {
  const safety_m = draught_m + clearance_m;
  return { shallow_m: draught_m, safety_m, deep_m: Math.max(DEEP_DRAUGHTS * draught_m, safety_m) };
}

export function depthColour(depth_m: number, of: Limits, colours: Palette): string {
  if (depth_m < 0) return colours.drying;
  if (depth_m < of.shallow_m) return colours.shallow;
  if (depth_m < of.safety_m) return colours.medium;
  return depth_m < of.deep_m ? colours.safe : colours.water;
}

const isDepth = ({ kind, shape }: ChartInfo): boolean =>
  shape === "area" && (kind === "depth_area" || kind === "dredged_area");

/** An area with the box around it. */
interface Area {
  feature: ChartInfo;
  path: Path2D;
  box: [north: number, east: number, north: number, east: number];
}

function boxOf(rings: Pair[][]): Area["box"] {
  const box: Area["box"] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [n, e] of rings.flat()) {
    box[0] = Math.min(box[0], n);
    box[1] = Math.min(box[1], e);
    box[2] = Math.max(box[2], n);
    box[3] = Math.max(box[3], e);
  }
  return box;
}

const sizeOf = ({ box }: Area): number => (box[2] - box[0]) * (box[3] - box[1]);

/** The edges of areas of depth, each with the depths on its sides. Found bit by bit, as large charts have many edges. */
export class Depths {
  /** In the order in which they are filled: dredged areas over others, small ones over large ones. */
  readonly areas: readonly Area[];
  private readonly edges: [Pair, Pair][] = [];
  private readonly sides: { ends: [Pair, Pair]; low_m: number; high_m: number }[] = [];
  private done = 0;
  private contour: { safety_m: number; until: number; path: Path2D } | null = null;

  constructor(
    chart: readonly ChartInfo[],
    pathOf: (feature: ChartInfo) => Path2D,
    private readonly to: CanvasRenderingContext2D,
  ) {
    this.areas = chart
      .filter(isDepth)
      .map((feature) => ({ feature, path: pathOf(feature), box: boxOf(feature.lines) }))
      .toSorted(
        (a, b) =>
          Number(a.feature.kind === "dredged_area") - Number(b.feature.kind === "dredged_area") ||
          sizeOf(b) - sizeOf(a),
      );
    // Areas of a chart share their edges.
    const seen = new Set<string>();
    for (const { feature } of this.areas)
      for (const ring of feature.lines)
        ring.forEach((from, i) => {
          const till = ring[(i + 1) % ring.length] ?? from;
          const [a, b] = [from.join(), till.join()];
          const key = a < b ? `${a} ${b}` : `${b} ${a}`;
          if (seen.has(key)) return;
          seen.add(key);
          this.edges.push([from, till]);
        });
  }

  /** The least depth of the water at a place; `null`: no area of depth is there. */
  private at(n: number, e: number): number | null {
    for (let i = this.areas.length - 1; i >= 0; i--) {
      const area = this.areas[i];
      if (!area) continue;
      const [south, west, north, east] = area.box;
      if (n < south || n > north || e < west || e > east) continue;
      // Lines of a path are asked as they are, without the camera's transform.
      if (this.to.isPointInPath(area.path, e, n, "evenodd")) return area.feature.depth_m ?? 0;
    }
    return null;
  }

  private find(): void {
    if (this.done === this.edges.length) return;
    const begun = performance.now();
    this.to.save();
    this.to.resetTransform();
    while (this.done < this.edges.length && performance.now() - begun < BUDGET_MS) {
      const ends = this.edges[this.done++];
      if (!ends) continue;
      const [[n1, e1], [n2, e2]] = ends;
      const long = Math.hypot(n2 - n1, e2 - e1);
      if (long === 0) continue;
      const [n, e] = [(n1 + n2) / 2, (e1 + e2) / 2];
      const [across_n, across_e] = [(-(e2 - e1) / long) * BESIDE_M, ((n2 - n1) / long) * BESIDE_M];
      const [left, right] = [
        this.at(n + across_n, e + across_e),
        this.at(n - across_n, e - across_e),
      ];
      if (left === null || right === null || left === right) continue;
      this.sides.push({ ends, low_m: Math.min(left, right), high_m: Math.max(left, right) });
    }
    this.to.restore();
  }

  /** The safety contour, in earth axes: where safe water meets water that is not. Towards land it has no line. */
  safetyContour(safety_m: number): Path2D {
    this.find();
    if (this.contour?.safety_m !== safety_m)
      this.contour = { safety_m, until: 0, path: new Path2D() };
    const { path } = this.contour;
    for (; this.contour.until < this.sides.length; this.contour.until++) {
      const side = this.sides[this.contour.until];
      if (!side || side.low_m >= safety_m || side.high_m < safety_m) continue;
      const [[n1, e1], [n2, e2]] = side.ends;
      path.moveTo(e1, n1);
      path.lineTo(e2, n2);
    }
    return path;
  }
}
