/** Rain before the eye: drops as short strokes in a box that goes with the eye, slanted by the wind. */
import {
  BufferGeometry,
  Float32BufferAttribute,
  type IUniform,
  LineSegments,
  ShaderMaterial,
  Vector3,
} from "three";
import type { Pair, Rain, WindNow } from "../protocol";
import { SKY_GLSL, type SkyUniforms } from "./sky";

/** Side of the box [m]. */
const BOX_M = 36;
/** Speed at which drops of usual size fall [m/s] (from memory). */
const FALLS_MPS = 7;
/** Drops are carried with most of the wind. */
const CARRIED = 0.8;
/** A drop is seen as a stroke of so much time [s]. */
const SEEN_S = 0.03;
/** Drops in the box, and how much the rain greys the sky. */
export const RAINS: Record<Rain, { drops: number; grey: number }> = {
  light: { drops: 500, grey: 0.55 },
  moderate: { drops: 1400, grey: 0.8 },
  heavy: { drops: 3200, grey: 1 },
};
const MOST = RAINS.heavy.drops;
/** Multiples of these shares fill a cube evenly: powers of the root of x⁴ = x + 1 (Roberts' sequence, from memory). */
const SPREAD = [0.8191725134, 0.6710436067, 0.5497004779];

/** The velocity of drops in the axes of the picture, in a wind that comes from a direction [m/s]. */
export function fall({ speed_mps, from_rad }: Pick<WindNow, "speed_mps" | "from_rad">) {
  const [east, south]: Pair = [-Math.sin(from_rad), Math.cos(from_rad)];
  const carried = CARRIED * speed_mps;
  return [carried * east, -FALLS_MPS, carried * south] as const;
}

export class RainFall {
  readonly lines: LineSegments;
  private readonly eye = new Vector3();
  private readonly way = new Vector3();
  private readonly moved = new Vector3();
  private t_s: number | null = null;

  constructor(
    sky: SkyUniforms,
    /** Fewer drops, for a machine that draws on the processor. */
    private readonly cheap: boolean,
  ) {
    const seeds: number[] = [];
    for (let i = 0; i < MOST; i++)
      for (const end of [0, 1]) seeds.push(...SPREAD.map((step) => (i * step) % 1), end);
    const geometry = new BufferGeometry();
    geometry.setAttribute("seed", new Float32BufferAttribute(seeds, 4));
    geometry.setAttribute("position", new Float32BufferAttribute(new Float32Array(MOST * 6), 3));
    const material = new ShaderMaterial({
      uniforms: {
        ...(sky as unknown as Record<string, IUniform>),
        uRainEye: { value: this.eye },
        uWay: { value: this.way },
        uMoved: { value: this.moved },
      },
      transparent: true,
      depthWrite: false,
      vertexShader: /* glsl */ `
        attribute vec4 seed;
        uniform vec3 uRainEye; uniform vec3 uWay; uniform vec3 uMoved;
        varying float vThin;
        void main() {
          const float box = ${BOX_M.toFixed(1)};
          vec3 at = uRainEye + mod(seed.xyz * box + uMoved - uRainEye, box) - 0.5 * box + seed.w * uWay;
          float away = length(at - uRainEye);
          vThin = smoothstep(0.5 * box, 0.15 * box, away) * smoothstep(0.4, 1.5, away);
          gl_Position = projectionMatrix * viewMatrix * vec4(at, 1.0);
        }`,
      fragmentShader: /* glsl */ `
        varying float vThin;
        ${SKY_GLSL}
        void main() {
          gl_FragColor = vec4(uHorizon * 1.25 + 0.004, 0.42 * vThin);
          #include <tonemapping_fragment>
          #include <colorspace_fragment>
        }`,
    });
    this.lines = new LineSegments(geometry, material);
    this.lines.frustumCulled = false;
    this.lines.renderOrder = 5;
    this.lines.visible = false;
  }

  rain(rain: Rain | null): void {
    this.lines.visible = rain !== null;
    const drops = rain === null ? 0 : RAINS[rain].drops;
    this.lines.geometry.setDrawRange(0, 2 * Math.round(this.cheap ? drops / 2 : drops));
  }

  tick(eye: Vector3, t_s: number, wind: Pick<WindNow, "speed_mps" | "from_rad">): void {
    if (!this.lines.visible) return;
    this.eye.copy(eye);
    const way = fall(wind);
    this.way.set(way[0] * SEEN_S, way[1] * SEEN_S, way[2] * SEEN_S);
    // The way is summed up step by step. The wind of now times the time of the run would move all drops with each gust.
    const since_s = t_s - (this.t_s ?? t_s);
    this.t_s = t_s;
    const { x, y, z } = this.moved;
    const [a, b, c] = way;
    const move = (at: number, mps: number) => (at + mps * since_s) % BOX_M;
    this.moved.set(move(x, a), move(y, b), move(z, c));
  }
}
