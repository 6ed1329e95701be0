/**
 * What of a chart is solid or can strike a mast: quays and pontoons of which the chart has only the line, dolphins, bridges and
 * overhead cables. Heights of what stands on the ground count from datum, those of pontoons from the water.
 */
import { CONCRETE, fixedParts, isInside } from "./berth";
import { bankOf, block, cut } from "./blocks";
import { Borders } from "./borders";
import { BELOW_DECKS_M, type Site } from "./heights";
import { isMooringBuoy, ownColour } from "./marks";
import type { Colour, Solids, Spot } from "./solids";
import { type Reach, normalOf, stripsAlong } from "./strips";
import { add, dot, length, minus, nearestOn, times } from "../geometry";
import type { ChartInfo, Pair } from "../protocol";

/** Width of a quay or pontoon of which the chart has only the line: that of the run's strips without `solid_width` [m]. */
const STRIP_M = 4;
/** Strips stand a hand back, so that the front of a body at the same place does not flicker [m]. */
const BACK_M = 0.05;
/** A line that turns no more from a border runs along the border: least cosine. */
const ALONG = 0.7;
/** A strip before a bank reaches so far over the bank's crest [m]. */
const OVER_CREST_M = 0.5;
const BELOW_M = -9;
/** A pontoon's bottom and deck above the water [m]. */
export const PONTOON_M: Pair = [-1, 0.9];
/** Width of a bridge of which the chart has only the line, and how thick bridges are [m]. */
const BRIDGE_M = 10;
const BRIDGE_THICK_M = 1.8;
const ROAD: Colour = 0x6f6d68;
const GIRDER: Colour = 0x8d9296;
const PILE: Colour = 0x4a4f4e;
const IRON: Colour = 0x23282b;
const DECK: Colour = 0x8f8c84;
/** A mooring point no farther from a fixed body is a part of the body [m]. */
const ON_BODY_M = 3;

/** Draws the structures of a chart that `landOf` has not drawn. */
export function structures(
  chart: ChartInfo[],
  site: Site,
  { built, afloat }: { built: Solids; afloat: Solids },
): void {
  const near = (line: Pair[]) => line.map((at) => minus(at, site.origin));
  const fixed = site.fixed.map(({ ring, deck_m }) => ({ ring: near(ring), deck_m }));
  const { quay_m } = site.heights;
  const under_m = quay_m - BELOW_DECKS_M;
  const quays = bordersOf(chart, ["coast", "quay"], site);
  const pontoons = bordersOf(chart, ["pontoon"], site);
  for (const feature of chart) {
    const { kind, shape, lines, clearance_m } = feature;
    const outer = near(lines[0] ?? []);
    const first = outer[0];
    if (!first) continue;
    if (kind === "quay" && shape === "line")
      for (const { ring, from, to } of stripsAlong(outer, (a, b) => reachOf(quays, a, b))) {
        // The wall is no higher than a body that stands there.
        const decks = fixed.filter((body) => touches(body.ring, from, to));
        const top_m = Math.min(under_m, ...decks.map(({ deck_m }) => deck_m - BELOW_DECKS_M));
        built.prism(ring, BELOW_M, top_m, CONCRETE, DECK);
      }
    else if (kind === "pontoon" && shape === "line")
      for (const { ring } of stripsAlong(outer, (a, b) => reachOf(pontoons, a, b)))
        afloat.prism(ring, ...PONTOON_M, 0x8c8f8d, 0x9a958a);
    else if (kind === "mooring" && shape === "point") {
      if (isMooringBuoy(feature)) mooringBuoy(first, ownColour(feature), afloat);
      else if (!fixed.some(({ ring }) => isOn(ring, first))) pile(first, quay_m, built);
    } else if (kind === "mooring" && shape === "area" && outer.length >= 3) {
      if (!fixed.some(({ ring }) => isOn(ring, first))) fixedParts(outer, quay_m, cut, built);
    } else if (kind === "bridge" && clearance_m !== null && shape !== "point") {
      const rings =
        shape === "area"
          ? [outer]
          : stripsAlong(outer, () => [BRIDGE_M / 2, BRIDGE_M / 2]).map(({ ring }) => ring);
      for (const ring of rings) slab(ring, site.high_water_m + clearance_m, built);
    }
  }
}

/** Overhead cables with a clearance: places on the earth, with the clearance above datum. */
export const cablesOf = (chart: ChartInfo[], { high_water_m }: Site): Spot[][] =>
  chart.flatMap(({ kind, shape, lines, clearance_m }) => {
    const line = lines[0] ?? [];
    if (kind !== "overhead_cable" || shape !== "line" || clearance_m === null || line.length < 2)
      return [];
    return [line.map((at): Spot => [...at, high_water_m + clearance_m])];
  });

/**
 * The borders of areas along which lines of the last of some kinds need no strip, or only a front before the bank of a coast.
 */
function bordersOf(
  chart: ChartInfo[],
  kinds: ChartInfo["kind"][],
  { origin, heights }: Site,
): Borders {
  const borders = new Borders();
  // A chart has many edges, and few charts have lines that need them.
  if (!chart.some(({ kind, shape }) => shape === "line" && kind === kinds.at(-1))) return borders;
  for (const { kind, shape, lines } of chart) {
    if (shape !== "area" || !kinds.includes(kind)) continue;
    lines.forEach((line, i) => {
      const ring = line.map((at) => minus(at, origin));
      const deep_m = kind === "coast" ? bankOf(ring, heights.ground_m) : null;
      borders.add(ring, i === 0, deep_m);
    });
  }
  return borders;
}

/** How far the strip of a line reaches. */
function reachOf(borders: Borders, from: Pair, to: Pair): Reach | null {
  const half_m = STRIP_M / 2 - BACK_M;
  const edge = borders.near(times(add(from, to), 0.5), STRIP_M / 2 + 0.1);
  const normal = normalOf(from, to);
  const side = edge ? dot(edge.inward, normal) : 0;
  if (!edge || Math.abs(side) < ALONG) return [half_m, half_m];
  if (edge.deep_m === null) return null;
  const land_m = edge.deep_m + OVER_CREST_M;
  return side > 0 ? [land_m, -BACK_M] : [-BACK_M, land_m];
}

/** Whether a segment passes a ring, or runs along the ring. */
const touches = (ring: Pair[], from: Pair, to: Pair): boolean =>
  isInside(ring, times(add(from, to), 0.5)) ||
  ring.some((at) => length(minus(at, nearestOn(from, to, at))) < STRIP_M);

/** Whether a place lies in a ring or beside the ring. */
export const isOn = (ring: Pair[], at: Pair): boolean =>
  isInside(ring, at) ||
  ring.some((from, i) => {
    const on = nearestOn(from, ring[(i + 1) % ring.length] ?? from, at);
    return length(minus(at, on)) < ON_BODY_M;
  });

/** A dolphin of which the chart has only the place: a pile with a cap. */
function pile(at: Pair, top_m: number, to: Solids): void {
  to.post([...at, BELOW_M], [...at, top_m - 1.2], 0.8, PILE, { sides: 10, caps: false });
  to.post([...at, top_m - 1.2], [...at, top_m], 1.5, CONCRETE, { sides: 12 });
}

/** A mooring buoy: a drum with an eye. */
function mooringBuoy(at: Pair, colour: Colour, to: Solids): void {
  to.post([...at, -0.6], [...at, 0.9], 1.5, colour, { sides: 16 });
  to.post([...at, 0.9], [...at, 1.3], 0.25, IRON, { sides: 8 });
}

/** A bridge, which ships see from below. */
function slab(ring: Pair[], under_m: number, to: Solids): void {
  block(ring, [under_m, under_m + BRIDGE_THICK_M], GIRDER, ROAD, to);
  for (const three of cut(ring)) {
    const corners = three.flatMap((k): Spot[] => {
      const at = ring[k];
      return at ? [[...at, under_m]] : [];
    });
    if (corners.length === 3) to.face(corners, [0, 0, -1], GIRDER);
  }
}
