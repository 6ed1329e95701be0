/** Mooring lines, towlines, chains and marks as ribbons that face the eye, never thinner than a pixel. */
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  type IUniform,
  Mesh,
  ShaderMaterial,
  Vector2,
} from "three";
import type { Triple } from "./axes";
import { PIECES } from "./catenary";
import { SKY_GLSL, type SkyUniforms } from "./sky";

export class Ropes {
  readonly mesh: Mesh;
  private places = new BufferAttribute(new Float32Array(0), 3);
  private ways = this.places;
  private looks = this.places;
  private readonly geometry = new BufferGeometry();
  private readonly size = new Vector2(1, 1);
  private readonly shine = { value: 0 };
  private most = 0;
  private count = 0;

  constructor(sky: SkyUniforms & { uLamps: IUniform<number> }) {
    this.room(16);
    const material = new ShaderMaterial({
      uniforms: {
        ...(sky as unknown as Record<string, IUniform>),
        uSize: { value: this.size },
        uShine: this.shine,
      },
      side: DoubleSide,
      vertexShader: /* glsl */ `
        attribute vec4 way; attribute vec4 look;
        uniform vec2 uSize;
        varying vec3 vLook; varying float vSide; varying vec3 vAt;
        void main() {
          vec4 at = viewMatrix * vec4(position, 1.0);
          vec4 next = viewMatrix * vec4(position + way.xyz, 1.0);
          vec3 across = normalize(cross(next.xyz - at.xyz, at.xyz));
          // Width on the screen: that of the rope, but at least a pixel.
          float pixel = max(0.05, -at.z) * 2.0 / (projectionMatrix[1][1] * uSize.y);
          at.xyz += across * way.w * max(look.w, 0.62 * pixel);
          vLook = look.rgb; vSide = way.w; vAt = position;
          gl_Position = projectionMatrix * at;
        }`,
      fragmentShader: /* glsl */ `
        varying vec3 vLook; varying float vSide; varying vec3 vAt;
        uniform float uLamps; uniform float uShine;
        ${SKY_GLSL}
        void main() {
          vec3 light = uHorizon * 0.75 + uZenith * 0.5 + uDirect * 0.22 + uLamps * vec3(0.06, 0.05, 0.03);
          if (uShine > 0.0) light = vec3(uShine);
          vec3 c = vLook * light * (0.55 + 0.45 * sqrt(max(0.0, 1.0 - vSide * vSide)));
          vec3 way = vAt - cameraPosition;
          float away = length(way);
          if (uShine <= 0.0) c = mix(hazeColour(way / max(away, 0.01)), c, throughHaze(away));
          gl_FragColor = vec4(c, 1.0);
          #include <tonemapping_fragment>
          #include <colorspace_fragment>
        }`,
    });
    this.mesh = new Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
  }

  /** Marks shine by themselves: as bright on the screen at every exposure. */
  bright(exposure: number): void {
    this.shine.value = 0.85 / exposure;
  }

  /** Makes room for so many lines. */
  room(most: number): void {
    if (most <= this.most) return;
    this.most = most;
    const corners = most * (PIECES + 1) * 2;
    this.places = new BufferAttribute(new Float32Array(corners * 3), 3);
    this.ways = new BufferAttribute(new Float32Array(corners * 4), 4);
    this.looks = new BufferAttribute(new Float32Array(corners * 4), 4);
    this.geometry.dispose();
    this.geometry.setAttribute("position", this.places);
    this.geometry.setAttribute("way", this.ways);
    this.geometry.setAttribute("look", this.looks);
    const indices: number[] = [];
    for (let line = 0; line < most; line++)
      for (let i = 0; i < PIECES; i++) {
        const a = (line * (PIECES + 1) + i) * 2;
        indices.push(a, a + 1, a + 2, a + 1, a + 3, a + 2);
      }
    this.geometry.setIndex(indices);
  }

  pixels(width: number, height: number): void {
    this.size.set(width, height);
  }

  begin(): void {
    this.count = 0;
  }

  /** Adds a line through `PIECES` + 1 places. */
  add(points: Triple[], [r, g, b]: Triple, radius_m: number): void {
    if (this.count >= this.most) throw new Error("no room for another line in the picture");
    const first = this.count * (PIECES + 1) * 2;
    points.forEach((at, i) => {
      const [from, to] = [points[Math.max(0, i - 1)] ?? at, points[Math.min(PIECES, i + 1)] ?? at];
      for (const side of [0, 1]) {
        const k = first + 2 * i + side;
        this.places.setXYZ(k, ...at);
        this.ways.setXYZW(k, to[0] - from[0], to[1] - from[1], to[2] - from[2], side * 2 - 1);
        this.looks.setXYZW(k, r, g, b, radius_m);
      }
    });
    this.count += 1;
  }

  end(): void {
    this.places.needsUpdate = true;
    this.ways.needsUpdate = true;
    this.looks.needsUpdate = true;
    this.geometry.setDrawRange(0, this.count * PIECES * 6);
  }
}
