/**
 * Fenders at the places, heights and sizes of the run, each family with its own shape, pressed by their deflection. The part of
 * rubber is shortened, and the panel moves with the face.
 */
import {
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  Mesh,
  type Material,
  type Object3D,
} from "three";
import { type Colour, Solids, type Spot } from "./solids";
import type { FenderInfo, FenderNow } from "../protocol";

/** Shapes of fenders. `block`: a fender whose reaction the scenario gives, of no family. */
export type Shape =
  "cone" | "cell" | "leg" | "element" | "arch" | "cylinder" | "pneumatic" | "foam" | "block";

/** Words of the families, as the library and fender files of users name them. */
const FAMILIES: [RegExp, Shape][] = [
  [/pneumatic/i, "pneumatic"],
  [/foam/i, "foam"],
  [/cell/i, "cell"],
  [/cone/i, "cone"],
  [/arch/i, "arch"],
  [/\bleg\b/i, "leg"],
  [/element/i, "element"],
  [/cylind/i, "cylinder"],
];

/** The shape of a fender by its family; a floating fender of no family is drawn as a pneumatic one. */
export function shapeOf({ family, floating }: Pick<FenderInfo, "family" | "floating">): Shape {
  const known = FAMILIES.find(([words]) => family !== null && words.test(family))?.[1];
  return known ?? (floating ? "pneumatic" : "block");
}

/** Shapes that press with a panel. */
const PANELLED: ReadonlySet<Shape> = new Set(["cone", "cell", "leg", "element", "block"]);

/** A fixed fender of which the scenario gives no height is drawn with its middle as high [m]. */
const MIDDLE_M = 1.9;
/** Share of its diameter by which a floating fender of no given height lies with its middle above the water. */
const AFLOAT = 0.25;
const PANEL_THICK_M = 0.3;

const RUBBER: Colour = 0x1a1b1d;
const FACING: Colour = 0x2b4a63;
const STEEL: Colour = 0x30363a;

/** Triangles as `three` takes them. */
export function geometryOf(solids: Solids): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(solids.positions, 3));
  geometry.setAttribute("normal", new Float32BufferAttribute(solids.normals, 3));
  geometry.setAttribute("color", new Float32BufferAttribute(solids.colours, 3));
  return geometry;
}

/** Distance of the fender's face from its mounting under a deflection [m]. */
export const faceOff = (info: FenderInfo, now: FenderNow | undefined): number =>
  Math.max(0.15 * info.projection_m, info.projection_m - Math.max(0, now?.deflection_m ?? 0));

/** Height of the middle of a fender's face in the axes of the body that carries it, which rise and fall with its datum [m]. */
export function middleOf(info: FenderInfo): number {
  if (info.above_water_m !== 0) return info.above_water_m;
  return info.floating ? AFLOAT * info.projection_m : MIDDLE_M;
}

interface Built {
  info: FenderInfo;
  mount: Group;
  rubber: Object3D;
  panel: Object3D | null;
  shape: Shape;
  /** Thickness of what stands before the rubber [m]. */
  thick_m: number;
}

export class Fenders {
  private readonly built: (Built | null)[];

  /** `carrier`: the picture of a body by its index, in whose axes the fender lies; `skips`: fenders that a ship has built in. */
  constructor(
    fenders: FenderInfo[],
    carrier: (body: number) => Group | null,
    skips: (fender: FenderInfo) => boolean,
    material: Material,
    private readonly isFixed: (body: number) => boolean = () => true,
  ) {
    this.built = fenders.map((info) => {
      const on = carrier(info.body);
      return on && !skips(info) ? build(info, on, material) : null;
    });
  }

  /** How far each fender is pressed in the picture [m]; `null`: it is not drawn. */
  pressed(): (number | null)[] {
    return this.built.map((each) => {
      if (!each) return null;
      const { info, rubber, panel, shape } = each;
      const long = rubber.scale.z;
      const off = panel ? -panel.position.z : shape === "arch" ? long : long * info.projection_m;
      return info.projection_m - off;
    });
  }

  /** `water_m`: level of the water above datum, on which floating fenders of fixed bodies rise. */
  tick(now: FenderNow[], water_m = 0): void {
    this.built.forEach((each, i) => {
      if (!each) return;
      const { info, mount, rubber, panel, shape, thick_m } = each;
      const off = faceOff(info, now[i]);
      const lifts = info.floating && this.isFixed(info.body);
      mount.position.y = middleOf(info) + (lifts ? water_m : 0);
      const pressed = Math.sqrt(info.projection_m / off);
      // The picture's z runs astern: outward is −z. Rubber that is pressed bulges.
      if (PANELLED.has(shape)) {
        const bulge = 1 + 0.5 * (1 - off / info.projection_m);
        rubber.scale.set(shape === "block" ? 1 : bulge, bulge, Math.max(0.1, off - thick_m));
        if (panel) panel.position.z = -off;
      } else if (shape === "arch") rubber.scale.set(1, pressed, off);
      else rubber.scale.set(1, pressed, off / info.projection_m);
    });
  }
}

function build(info: FenderInfo, on: Group, material: Material): Built {
  const shape = shapeOf(info);
  const rubber = new Solids();
  const thick_m = PANELLED.has(shape) ? Math.min(PANEL_THICK_M, 0.25 * info.projection_m) : 0;
  RUBBERS[shape](rubber, info);
  const mount = new Group();
  const rubberMesh = new Mesh(geometryOf(rubber), material);
  rubberMesh.castShadow = true;
  mount.add(rubberMesh);
  let panel: Mesh | null = null;
  if (PANELLED.has(shape)) {
    panel = new Mesh(geometryOf(panelOf(info, thick_m)), material);
    panel.castShadow = true;
    mount.add(panel);
  }
  mount.position.set(info.at_m[1], middleOf(info), -info.at_m[0]);
  mount.rotation.y = -info.facing_rad;
  on.add(mount);
  return { info, mount, rubber: rubberMesh, panel, shape, thick_m };
}

/** Where the elements of a fender stand along its face [m]; positive to the left of somebody behind the fender. */
const places = ({ cones_m }: FenderInfo): number[] =>
  // To the right of somebody who faces the panel is to port of the way outwards.
  cones_m.length > 0 ? cones_m.map((at) => -at) : [0];

/** Rubber in the fender's axes: forward is outward from the mounting. With a panel its length is 1, else its own. */
const RUBBERS: Record<Shape, (to: Solids, info: FenderInfo) => void> = {
  cone: (to, info) => {
    const round = Math.min(0.46 * info.width_m, 0.62 * info.projection_m, 0.46 * info.height_m);
    for (const s of places(info)) {
      to.post([0, s, 0], [1, s, 0], round, RUBBER, { sides: 18, upper_m: 0.6 * round });
      to.post([0, s, 0], [0.06, s, 0], 1.12 * round, RUBBER, { sides: 18 });
    }
  },
  cell: (to, info) => {
    const round = Math.min(0.44 * info.width_m, 0.5 * info.projection_m, 0.44 * info.height_m);
    for (const s of places(info)) {
      to.post([0, s, 0], [1, s, 0], round, RUBBER, { sides: 20 });
      for (const at of [0, 0.92])
        to.post([at, s, 0], [at + 0.08, s, 0], 1.2 * round, RUBBER, { sides: 20 });
    }
  },
  // Two legs that lean towards each other, as high as most of the panel.
  leg: (to, info) => {
    const half = 0.42 * info.height_m;
    const wide = 0.24 * info.width_m;
    for (const s of places(info))
      for (const side of [-1, 1])
        slab(to, [s + side * 1.5 * wide, s + side * 1.1 * wide], 0.32 * wide, half);
  },
  element: (to, info) => {
    const half = 0.42 * info.height_m;
    for (const s of places(info))
      for (const side of [-1, 1])
        slab(to, [s + side * 0.24 * info.width_m, s + side * 0.24 * info.width_m], 0.09, half);
  },
  arch: (to, info) => {
    const [half, high] = [info.width_m / 2, info.height_m / 2];
    // An M without its middle: two flanks and a crown.
    const ring: [number, number][] = [
      [0, -high],
      [0.12, -high],
      [1, -0.45 * high],
      [1, 0.45 * high],
      [0.12, high],
      [0, high],
    ];
    for (let i = 0; i < ring.length; i++) {
      const [a, b] = [ring[i], ring[(i + 1) % ring.length]];
      if (!a || !b) continue;
      const corners: Spot[] = [
        [a[0], -half, a[1]],
        [b[0], -half, b[1]],
        [b[0], half, b[1]],
        [a[0], half, a[1]],
      ];
      to.face(corners, [a[0] + b[0] - 0.7, 0, a[1] + b[1]], RUBBER);
    }
    for (const side of [-1, 1])
      to.face(
        ring.map(([f, u]): Spot => [f, side * half, u]),
        [0, side, 0],
        RUBBER,
      );
  },
  cylinder: (to, info) => {
    const radius = info.projection_m / 2;
    const half = info.width_m / 2;
    to.post([radius, -half, 0], [radius, half, 0], radius, RUBBER, { sides: 22 });
    for (const side of [-1, 1])
      to.post(
        [radius, side * (half + 0.02), 0],
        [radius, side * (half + 0.03), 0],
        0.45 * radius,
        0x0c0d0e,
        { sides: 16 },
      );
  },
  pneumatic: (to, info) => floating(to, info, 0x26282a, true),
  foam: (to, info) => floating(to, info, 0x8c5a1e, false),
  block: (to, info) =>
    to.box(
      [0, -0.36 * info.width_m, -0.36 * info.height_m],
      [1, 0.36 * info.width_m, 0.36 * info.height_m],
      RUBBER,
    ),
};

/** An upright slab of rubber from the mounting to the panel: where its middle stands at both ends. */
function slab(to: Solids, [foot, head]: [number, number], half: number, high: number): void {
  const ring = (s: number): [number, number][] => [
    [s - half, -high],
    [s + half, -high],
    [s + half, high],
    [s - half, high],
  ];
  const [below, above] = [ring(foot), ring(head)];
  below.forEach((a, i) => {
    const k = (i + 1) % 4;
    const [b, c, d] = [below[k], above[k], above[i]];
    if (!b || !c || !d) return;
    to.face(
      [
        [0, ...a],
        [0, ...b],
        [1, ...c],
        [1, ...d],
      ],
      [0, a[0] + b[0] - 2 * foot, a[1] + b[1]],
      RUBBER,
    );
  });
}

/** A panel of steel with pads of polyethylene; its face is at 0. */
function panelOf({ width_m, height_m }: FenderInfo, thick_m: number): Solids {
  const [half, high] = [width_m / 2, height_m / 2];
  const steel = new Solids();
  const pad = 0.2 * thick_m;
  steel.box([-thick_m, -half, -high], [-pad, half, high], STEEL);
  const columns = Math.max(1, Math.round(width_m / 1.2));
  const rows = Math.max(1, Math.round(height_m));
  for (let c = 0; c < columns; c++)
    for (let r = 0; r < rows; r++)
      steel.box(
        [-pad, -half + (c * width_m) / columns + 0.03, -high + (height_m * r) / rows + 0.03],
        [
          0,
          -half + ((c + 1) * width_m) / columns - 0.03,
          -high + (height_m * (r + 1)) / rows - 0.03,
        ],
        FACING,
      );
  return steel;
}

/** A floating fender with rounded ends, its length along the face; `net`: in a net of tyres. */
function floating(
  to: Solids,
  { projection_m: deep, width_m: wide }: FenderInfo,
  colour: Colour,
  net: boolean,
): void {
  const radius = deep / 2;
  const straight = Math.max(0, wide / 2 - radius);
  const profile: [along: number, round: number][] = [];
  for (let i = 0; i <= 6; i++) {
    const angle = (Math.PI / 2) * (i / 6);
    profile.push([-straight - radius * Math.cos(angle), radius * Math.sin(angle)]);
  }
  const ends = [...profile, ...profile.toReversed().map(([a, r]): [number, number] => [-a, r])];
  to.plate(
    ends.map(([along, round]) =>
      Array.from({ length: 21 }, (_, i): [number, number, number] => {
        const angle = (2 * Math.PI * i) / 20;
        return [radius + round * Math.cos(angle), along, round * Math.sin(angle)];
      }),
    ),
    () => colour,
    ([f, s, u]) => [f - radius, Math.abs(s) > straight ? s : 0, u],
  );
  if (!net) {
    for (const side of [-1, 1])
      to.post(
        [radius, side * (straight + 0.9 * radius), 0],
        [radius, side * (straight + 1.1 * radius), 0],
        0.2 * radius,
        STEEL,
      );
    return;
  }
  for (let k = -2; k <= 2; k++)
    for (let i = 0; i < 10; i++) {
      const angle = (2 * Math.PI * (i + (k % 2 === 0 ? 0 : 0.5))) / 10;
      const at = (r: number): [number, number, number] => [
        radius + r * Math.cos(angle),
        (k * straight) / 2,
        r * Math.sin(angle),
      ];
      to.post(at(radius * 0.97), at(radius * 1.06), 0.16 * radius, 0x141516, { sides: 8 });
    }
}
