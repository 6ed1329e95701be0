/** Lights as points that keep a size on the screen: navigation lights, lights of marks, lamps on quays. */
import { AdditiveBlending, BufferAttribute, BufferGeometry, Points, ShaderMaterial } from "three";
import type { Triple } from "./axes";
import type { LampColour } from "./lamps";
import type { SkyUniforms } from "./sky";

const COLOURS: Record<LampColour, Triple> = {
  red: [1, 0.06, 0.03],
  green: [0.05, 1, 0.3],
  white: [1, 0.93, 0.78],
  yellow: [1, 0.72, 0.1],
  amber: [1, 0.6, 0.22],
};

/** As many points as are ever lit at the same time. */
export class Glows {
  readonly points: Points;
  private readonly places: BufferAttribute;
  private readonly colours: BufferAttribute;
  private count = 0;

  constructor(sky: SkyUniforms, most: number) {
    const geometry = new BufferGeometry();
    this.places = new BufferAttribute(new Float32Array(most * 3), 3);
    this.colours = new BufferAttribute(new Float32Array(most * 4), 4);
    geometry.setAttribute("position", this.places);
    geometry.setAttribute("glow", this.colours);
    const material = new ShaderMaterial({
      uniforms: { uHaze: sky.uHaze, uPixels: { value: 700 } },
      transparent: true,
      depthWrite: false,
      blending: AdditiveBlending,
      vertexShader: /* glsl */ `
        #define LANTERN_M 0.7
        attribute vec4 glow;
        uniform float uHaze; uniform float uPixels;
        varying vec3 vGlow;
        void main() {
          vec4 at = viewMatrix * vec4(position, 1.0);
          float away = max(1.0, -at.z);
          // As bright as an eye takes it: a light is seen somewhat farther than the visibility.
          float through = exp(-0.6 * uHaze * away);
          float near = clamp(60.0 / away, 0.0, 1.0);
          vGlow = glow.rgb * glow.a * through * (0.55 + 0.45 * near);
          // Before the lantern itself, not before what hides the lantern.
          gl_Position = projectionMatrix * vec4(at.xyz * max(0.5, 1.0 - LANTERN_M / away), 1.0);
          // In a small picture too a light is larger than a pixel: it would fall between pixels.
          float wide = max(5.0, (uPixels / 700.0) * clamp(9.0 + 420.0 / away, 9.0, 34.0));
          gl_PointSize = through < 0.01 ? 0.0 : wide;
        }`,
      fragmentShader: /* glsl */ `
        varying vec3 vGlow;
        void main() {
          float r = 2.0 * length(gl_PointCoord - 0.5);
          if (r > 1.0) discard;
          float core = smoothstep(0.34, 0.12, r);
          float halo = pow(1.0 - r, 3.0);
          gl_FragColor = vec4(vGlow * (0.35 * halo) + mix(vGlow, vec3(dot(vGlow, vec3(0.5))), 0.25) * core, 1.0);
          #include <colorspace_fragment>
        }`,
    });
    this.points = new Points(geometry, material);
    this.points.frustumCulled = false;
    this.points.renderOrder = 10;
  }

  /** Height of the picture [px]. */
  scale(pixels: number): void {
    const uniform = (this.points.material as ShaderMaterial).uniforms.uPixels;
    if (uniform) uniform.value = pixels;
  }

  begin(): void {
    this.count = 0;
  }

  /** Adds a light for this drawing. */
  add(x: number, y: number, z: number, colour: LampColour, strength: number): void {
    if (this.count >= this.places.count) return;
    const [r, g, b] = COLOURS[colour];
    this.places.setXYZ(this.count, x, y, z);
    this.colours.setXYZW(this.count, r, g, b, strength);
    this.count += 1;
  }

  end(): void {
    this.places.needsUpdate = true;
    this.colours.needsUpdate = true;
    this.points.geometry.setDrawRange(0, this.count);
  }

  get lit(): number {
    return this.count;
  }
}
