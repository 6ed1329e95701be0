/**
 * Fenders at their places and sizes, pressed by their deflection. The messages do not name the family: a fender whose name says
 * so is drawn as a pneumatic or a cylinder, each other one as a cone with a panel.
 */
import {
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  Mesh,
  type Material,
  type Object3D,
} from "three";
import { Solids } from "./solids";
import type { FenderInfo, FenderNow } from "../protocol";

export type Family = "cone" | "cylinder" | "pneumatic";

export function familyOf({ name }: Pick<FenderInfo, "name">): Family {
  if (/pneu|foam|yokohama|float/i.test(name)) return "pneumatic";
  return /cyl|tyre|tire|log/i.test(name) ? "cylinder" : "cone";
}

/** Height of a panel over its width, and height of the middle of a fixed fender above the water [m]. */
const PANEL = 1.35;
const MIDDLE_M = 1.9;
const PANEL_THICK_M = 0.3;

const RUBBER = 0x1a1b1d;
const FACING = 0x2b4a63;

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

/** A fender: a part of rubber that is shortened, and a panel that moves with the face. */
interface Built {
  info: FenderInfo;
  rubber: Object3D;
  panel: Object3D | null;
  family: Family;
}

export class Fenders {
  private readonly built: (Built | null)[];

  /** `carrier`: the picture of a body by its index, in whose axes the fender lies; `skips`: fenders that a ship has built in. */
  constructor(
    fenders: FenderInfo[],
    carrier: (body: number) => Group | null,
    skips: (fender: FenderInfo) => boolean,
    material: Material,
  ) {
    this.built = fenders.map((info) => {
      const on = carrier(info.body);
      if (!on || skips(info)) return null;
      const family = familyOf(info);
      const rubber = new Solids();
      const deep = info.projection_m;
      const wide = info.width_m;
      // In the fender's axes: forward is outward from the mounting, its length is 1.
      if (family === "cone") {
        const round = Math.min(0.46 * wide, 0.62 * deep);
        rubber.post([0, 0, 0], [1, 0, 0], round, RUBBER, { sides: 18, upper_m: 0.6 * round });
        rubber.post([0, 0, 0], [0.06, 0, 0], 1.12 * round, RUBBER, { sides: 18 });
      } else if (family === "cylinder") {
        rubber.post([0.5, -wide / 2, 0], [0.5, wide / 2, 0], 0.5, RUBBER, { sides: 20 });
      } else pneumatic(rubber, deep, wide);
      const mount = new Group();
      const rubberMesh = new Mesh(geometryOf(rubber), material);
      mount.add(rubberMesh);
      let panel: Mesh | null = null;
      if (family === "cone") {
        const half = (PANEL * wide) / 2;
        const steel = new Solids();
        steel.box([-PANEL_THICK_M, -wide / 2, -half], [-0.06, wide / 2, half], 0x30363a);
        // Pads of polyethylene, with joints.
        const [columns, rows] = [2, Math.max(2, Math.round((2 * half) / 1))];
        for (let c = 0; c < columns; c++)
          for (let r = 0; r < rows; r++)
            steel.box(
              [
                -0.06,
                -wide / 2 + (c * wide) / columns + 0.03,
                -half + (2 * half * r) / rows + 0.03,
              ],
              [
                0,
                -wide / 2 + ((c + 1) * wide) / columns - 0.03,
                -half + (2 * half * (r + 1)) / rows - 0.03,
              ],
              FACING,
            );
        panel = new Mesh(geometryOf(steel), material);
        panel.castShadow = true;
        mount.add(panel);
      }
      rubberMesh.castShadow = true;
      mount.position.set(
        info.at_m[1],
        family === "pneumatic" ? 0.25 * deep : MIDDLE_M,
        -info.at_m[0],
      );
      mount.rotation.y = -info.facing_rad;
      on.add(mount);
      return { info, rubber: rubberMesh, panel, family };
    });
  }

  tick(now: FenderNow[]): void {
    this.built.forEach((each, i) => {
      if (!each) return;
      const { info, rubber, panel, family } = each;
      const off = faceOff(info, now[i]);
      // The picture's z runs astern: outward is −z.
      if (family === "cone") {
        rubber.scale.set(1 + 0.5 * (1 - off / info.projection_m), 1, off - PANEL_THICK_M);
        rubber.scale.y = rubber.scale.x;
        if (panel) panel.position.z = -off;
      } else {
        const bulge = Math.sqrt(info.projection_m / off);
        if (family === "cylinder") rubber.scale.set(1, info.projection_m * bulge, off);
        else rubber.scale.set(1, bulge, off / info.projection_m);
      }
    });
  }
}

/** A floating fender with rounded ends in a net of tyres; its length lies along the ship. */
function pneumatic(to: Solids, deep: number, wide: number): void {
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
    () => 0x26282a,
    ([f, s, u]) => [f - radius, Math.abs(s) > straight ? s : 0, u],
  );
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
