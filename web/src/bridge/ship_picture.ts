/** What the picture holds of a ship: her mesh, her lamps, what she hides; and the user's model in the place of the mesh. */
import { Group, Mesh } from "three";
import type { Alphabet } from "./alphabet";
import { type Arrangement, type Vessel, arrangementOf, fairleadHeight } from "./arrangement";
import { aboard } from "./axes";
import type { Conduct } from "./conduct";
import { geometryOf } from "./fenders";
import type { Paint } from "./fittings";
import { type Block, blocksOf } from "./hidden";
import { type Lamp, lampsOf } from "./lamps";
import { letteringOf } from "./lettering";
import type { Shared } from "./paintwork";
import { PAINTS, shipParts } from "./ship";
import type { Spot } from "./solids";
import { TUG_PAINT } from "./tug";
import type { LevelInfo, LineInfo, ModelInfo, Pair } from "../protocol";

export interface ShipPicture {
  arrangement: Arrangement;
  /** What hides words behind her. */
  blocks: Block[];
  group: Group;
  /** What is drawn of her, in whose place a model may stand. */
  drawn: Mesh[];
  lamps: Record<Conduct, Lamp[]>;
}

/** Picture of a vessel, or of a ship that passes. */
export interface Ship extends ShipPicture {
  /** Index of the body; −1 for a ship that passes. */
  body: number;
  /** Index in `Hello.vessels`, or in `Hello.traffic`. */
  index: number;
}

/** What all ships are painted with. */
export interface Paints {
  steel: Mesh["material"];
  panes: Mesh["material"];
  alphabet: Alphabet;
}

/** Draws a ship by her type, her size and her outlines. `index` chooses her colours; `lines` are those that she sends ashore. */
export function shipPicture(
  vessel: Vessel & { name: string },
  outline: Pair[],
  index: number,
  { steel, panes, alphabet }: Paints,
  lines: LineInfo[] = [],
): ShipPicture {
  const arrangement = arrangementOf(vessel, outline);
  const paint: Paint =
    arrangement.kind === "tug" ? TUG_PAINT : (PAINTS[index % PAINTS.length] ?? TUG_PAINT);
  const fairleads = lines.map(({ fairlead_m: [forward, side], fairlead_above_water_m }): Spot => [
    forward,
    side,
    fairlead_above_water_m || fairleadHeight(arrangement, forward),
  ]);
  const parts = shipParts(arrangement, paint, fairleads);
  const group = new Group();
  const hull = new Mesh(geometryOf(parts.painted), steel);
  hull.castShadow = hull.receiveShadow = true;
  const letters = alphabet.mesh(letteringOf(arrangement, vessel.name, alphabet.widthOf));
  const drawn = [hull, new Mesh(geometryOf(parts.panes), panes), letters];
  group.add(...drawn);
  return { arrangement, blocks: blocksOf(arrangement), group, drawn, lamps: lampsOf(arrangement) };
}

/** A body without a vessel: her size is that of her outline, her draught that of usual ships. */
export function plainVessel(outline: Pair[], name: string, levels: LevelInfo[] = []): Vessel {
  const span = (axis: 0 | 1) => {
    const all = outline.map((p) => p[axis]);
    return Math.max(...all) - Math.min(...all);
  };
  return {
    title: name,
    length_m: span(0),
    beam_m: span(1),
    // The lowest of several outlines is near the keel.
    draught_m: levels[0] ? Math.max(0.5, -levels[0].height_m) : 0.33 * span(1),
    is_tug: false,
  };
}

/** The reader of models, which is loaded when a model is there; or before, where no server answers later. */
export const loadModels = () => import("./model");

/** Longest reason for which a model is not drawn. */
const LONGEST_WHY = 120;

/**
 * Puts the user's model of a ship in the place of what is drawn of her, when it is loaded, and gives what is wrong with the model, in
 * words; "" if nothing is. `isWanted`: whether the ship is still shown by then.
 */
export async function dress(
  ship: ShipPicture,
  { file, origin_m }: ModelInfo,
  bytes: () => Promise<ArrayBuffer>,
  shared: Shared,
  isWanted: () => boolean,
): Promise<string> {
  try {
    const [{ modelOf }, read] = await Promise.all([loadModels(), bytes()]);
    const { length_m } = ship.arrangement;
    const { group: model, note } = await modelOf(read, { file, length_m }, shared);
    if (!isWanted()) {
      dispose(model);
      return "";
    }
    model.position.set(...aboard(origin_m, 0));
    ship.group.add(model);
    for (const each of ship.drawn) each.visible = false;
    // Of what hides words, only the hull is known.
    ship.blocks = ship.blocks.slice(0, 1);
    return note;
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    return `${file} cannot be drawn (${why.slice(0, LONGEST_WHY)})`;
  }
}

/** Gives back what the meshes of a group hold on the graphics. */
export function dispose(group: Group): void {
  group.traverse((each) => {
    if (!(each instanceof Mesh)) return;
    each.geometry.dispose();
    for (const material of [each.material].flat()) material.dispose();
  });
}
