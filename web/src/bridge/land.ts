/**
 * Land and structures of the chart. A chart has outlines without heights: coasts rise over a bank of stones to level ground
 * with trees, quays stand as high as fixed bodies, buildings have heights that are usual. Pontoons float.
 */
import { InstancedMesh, Matrix4, Mesh, Quaternion, Vector3 } from "three";
import { CONCRETE, area2, inset, isInside, sides } from "./berth";
import { BANK, BANK_FOOT_M, bankOf, block, cut, width } from "./blocks";
import { geometryOf } from "./fenders";
import { chance } from "./fittings";
import { BELOW_DECKS_M, type Site } from "./heights";
import { type Shared, type Surface, paintwork } from "./paintwork";
import { Solids, type Spot } from "./solids";
import { PONTOON_M, structures } from "./structures";
import { minus } from "../geometry";
import type { ChartInfo, Hello, Pair } from "../protocol";

/** The crest of a bank of which the chart has only a line lies so far below ground [m]. */
const CREST_BELOW_M = 1;
const GRASS = 0x575f43;
const STONE = 0x77716a;
const ASPHALT = 0x6f6d68;
/** Trees stand no farther from the origin [m]. */
const WOODS_M = 5000;
export const MOST_TREES = 1600;

/** Distance of a place from a ring [m]. */
function offRing(ring: Pair[], [n, e]: Pair): number {
  return Math.min(
    ...ring.map((a, i) => {
      const b = ring[(i + 1) % ring.length] ?? a;
      const [dn, de] = [b[0] - a[0], b[1] - a[1]];
      const share = ((n - a[0]) * dn + (e - a[1]) * de) / (dn * dn + de * de || 1);
      const t = Math.min(1, Math.max(0, share));
      return Math.hypot(n - a[0] - t * dn, e - a[1] - t * de);
    }),
  );
}

/** Whether a chart's quay is a fixed body of the scenario, which is drawn with its fenders. */
function isBody(ring: Pair[], bodies: Pair[][]): boolean {
  return bodies.some((outline) =>
    ring.every((at) => outline.some((p) => Math.hypot(p[0] - at[0], p[1] - at[1]) < 0.5)),
  );
}

/** What stands on the ground, with heights above datum, and what floats, with heights above the water. */
export interface Parts {
  ground: Solids;
  built: Solids;
  afloat: Solids;
  woods: Wood[];
}

interface Wood {
  ring: Pair[];
  area: number;
}

/** Land and structures of a chart. */
export function landOf(chart: ChartInfo[], site: Site): Parts {
  const { origin, heights } = site;
  const fixed = site.fixed.map(({ ring }) => ring);
  const parts: Parts = {
    ground: new Solids(),
    built: new Solids(),
    afloat: new Solids(),
    woods: [],
  };
  const { ground, built, afloat } = parts;
  const quay_m = heights.quay_m - BELOW_DECKS_M;
  const hasArea = chart.some(({ kind, shape }) => kind === "coast" && shape === "area");
  for (const feature of chart) {
    const rings = feature.lines.map((ring) => ring.map((at) => minus(at, origin)));
    const outer = rings[0];
    if (!outer || outer.length < 2) continue;
    if (feature.shape === "area" && outer.length >= 3) {
      const isDrawn = isBody(feature.lines[0] ?? [], fixed);
      if (feature.kind === "coast") coast(outer, rings.slice(1), heights.ground_m, parts);
      else if (feature.kind === "quay" && !isDrawn)
        block(outer, [-9, quay_m], CONCRETE, 0x8f8c84, built);
      else if (feature.kind === "pontoon" && !isDrawn)
        block(outer, PONTOON_M, 0x8c8f8d, 0x9a958a, afloat);
      else if (feature.kind === "building") {
        const tall = 8 + 6 * chance(outer[0]?.[0] ?? 0, outer[0]?.[1] ?? 0);
        block(outer, [0, heights.ground_m + tall], 0xa8a49a, 0x6f6a66, built);
      }
    } else if (feature.shape === "line" && feature.kind === "coast" && !hasArea)
      bank(
        rings.filter((line) => line.length > 1),
        heights.ground_m - CREST_BELOW_M,
        ground,
      );
  }
  structures(chart, site, parts);
  return parts;
}

export interface Land {
  ashore: (Mesh | InstancedMesh)[];
  afloat: Mesh[];
}

export function land({ chart }: Hello, site: Site, shared: Shared, most_trees = MOST_TREES): Land {
  const { ground, built, afloat, woods } = landOf(chart, site);
  const mesh = (of: Solids, surface: Surface) =>
    of.triangles > 0 ? [new Mesh(geometryOf(of), paintwork(shared, surface))] : [];
  const near = site.fixed.map(({ ring }) => ring.map((at) => minus(at, site.origin)));
  const trees = plant(woods, near, most_trees);
  const land: Land = {
    ashore: [
      ...mesh(ground, "ground"),
      ...mesh(built, "concrete"),
      ...(trees.length > 0 ? [forest(trees, site.heights.ground_m, shared)] : []),
    ],
    afloat: mesh(afloat, "concrete"),
  };
  for (const each of [...land.ashore, ...land.afloat]) each.receiveShadow = true;
  return land;
}

function coast(outer: Pair[], holes: Pair[][], ground_m: number, { ground, woods }: Parts) {
  const isMole = width(outer) < 25;
  const by = bankOf(outer, ground_m);
  const top = inset(outer, by);
  const ok =
    Math.sign(area2(top)) === Math.sign(area2(outer)) &&
    Math.abs(area2(top)) < Math.abs(area2(outer));
  const crown = ok ? top : outer;
  sides(outer, crown, BANK_FOOT_M, ground_m, STONE, ground);
  const all = [...crown, ...holes.flat()];
  for (const three of cut(crown, holes)) {
    const corners = three.flatMap((k): Spot[] => {
      const at = all[k];
      return at ? [[...at, ground_m]] : [];
    });
    if (corners.length === 3) ground.face(corners, [0, 0, 1], isMole ? ASPHALT : GRASS);
  }
  for (const hole of holes)
    sides(hole.toReversed(), hole.toReversed(), BANK_FOOT_M, ground_m, STONE, ground);
  if (!isMole) woods.push({ ring: outer, area: Math.abs(area2(outer)) / 2 });
}

/** A coast of which the chart has only the line: a bank of stones on it. */
function bank(lines: Pair[][], crest_m: number, to: Solids): void {
  for (const line of lines)
    for (let i = 0; i + 1 < line.length; i++) {
      const [a, b] = [line[i], line[i + 1]];
      if (!a || !b) continue;
      const long = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
      const half = BANK * (crest_m - BANK_FOOT_M);
      const off: Pair = [(-(b[1] - a[1]) / long) * half, ((b[0] - a[0]) / long) * half];
      to.frustum(
        [
          [a[0] - off[0], a[1] - off[1]],
          [b[0] - off[0], b[1] - off[1]],
          [b[0] + off[0], b[1] + off[1]],
          [a[0] + off[0], a[1] + off[1]],
        ],
        [a, b, b, a],
        BANK_FOOT_M,
        crest_m,
        STONE,
      );
    }
}

/** Places of trees: groups on the grass, away from the water and from quays. */
function plant(woods: Wood[], fixed: Pair[][], most: number): Pair[] {
  const places: Pair[] = [];
  const boxes = woods.map(({ ring }) => {
    const axis = (k: 0 | 1): Pair => {
      const all = ring.map((p) => p[k]);
      return [Math.max(-WOODS_M, Math.min(...all)), Math.min(WOODS_M, Math.max(...all))];
    };
    return [axis(0), axis(1)] as const;
  });
  const sizes = boxes.map(([n, e]) => Math.max(0, n[1] - n[0]) * Math.max(0, e[1] - e[0]));
  const sum = sizes.reduce((all, each) => all + each, 0);
  woods.forEach(({ ring }, w) => {
    const [n, e] = boxes[w] ?? [
      [0, 0],
      [0, 0],
    ];
    const groups = Math.round(((most / 6) * (sizes[w] ?? 0)) / Math.max(1, sum));
    for (let g = 0; g < groups; g++) {
      const at: Pair = [
        n[0] + (n[1] - n[0]) * chance(w, g, 1),
        e[0] + (e[1] - e[0]) * chance(w, g, 2),
      ];
      if (!isInside(ring, at) || offRing(ring, at) < 70) continue;
      const many = 3 + Math.floor(14 * chance(w, g, 3));
      for (let k = 0; k < many && places.length < most; k++) {
        const far = 42 * Math.sqrt(chance(w, g, k, 5));
        const angle = 2 * Math.PI * chance(w, g, k, 6);
        const place: Pair = [at[0] + far * Math.cos(angle), at[1] + far * Math.sin(angle)];
        if (fixed.every((body) => offRing(body, place) > 25 && !isInside(body, place)))
          places.push(place);
      }
    }
  });
  return places;
}

function forest(places: Pair[], ground_m: number, shared: Shared): InstancedMesh {
  const tree = new Solids();
  tree.post([0, 0, 0], [0, 0, 2.5], 0.22, 0x4a3a2a, { sides: 3, caps: false });
  tree.ball([0, 0, 4.8], 3, 0x3f5229, 3);
  tree.ball([1, 0.6, 6.8], 2.1, 0x4a5c2e, 3);
  const mesh = new InstancedMesh(geometryOf(tree), paintwork(shared, "leaves"), places.length);
  const matrix = new Matrix4();
  places.forEach(([n, e], i) => {
    const grown = 0.75 + 0.8 * chance(n, e);
    matrix.compose(
      new Vector3(e, ground_m - 0.1, -n),
      new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), 6 * chance(e, n)),
      new Vector3(grown, grown * (0.9 + 0.35 * chance(n, e, 3)), grown),
    );
    mesh.setMatrixAt(i, matrix);
  });
  mesh.frustumCulled = false;
  return mesh;
}
