/** The sky: a gradient, the glow of the sun, thin clouds, stars. The sea mirrors the same sky. */
import { BackSide, Mesh, ShaderMaterial, SphereGeometry, Vector3 } from "three";
import type { Light } from "./light";

/** Values that sky and sea share. */
export interface SkyUniforms {
  uSun: { value: Vector3 };
  uFrom: { value: Vector3 };
  uDisc: { value: Vector3 };
  uDirect: { value: Vector3 };
  uZenith: { value: Vector3 };
  uHorizon: { value: Vector3 };
  uGlow: { value: Vector3 };
  uStars: { value: number };
  /** Density of the haze [1/m]. */
  uHaze: { value: number };
}

export const skyUniforms = (): SkyUniforms => ({
  uSun: { value: new Vector3(0, 1, 0) },
  uFrom: { value: new Vector3(0, 1, 0) },
  uDisc: { value: new Vector3(0, 1, 0) },
  uDirect: { value: new Vector3(1, 1, 1) },
  uZenith: { value: new Vector3() },
  uHorizon: { value: new Vector3() },
  uGlow: { value: new Vector3() },
  uStars: { value: 0 },
  uHaze: { value: 0 },
});

export function shine(uniforms: SkyUniforms, light: Light, haze: number): void {
  uniforms.uSun.value.set(...light.sun);
  uniforms.uFrom.value.set(...light.from);
  uniforms.uDisc.value.set(...light.disc);
  uniforms.uDirect.value.set(...light.direct);
  uniforms.uZenith.value.set(...light.zenith);
  uniforms.uHorizon.value.set(...light.horizon);
  uniforms.uGlow.value.set(...light.glow);
  uniforms.uStars.value = light.stars;
  uniforms.uHaze.value = haze;
}

/** Colour of the sky in a direction, and of haze towards a direction along the horizon. */
export const SKY_GLSL = /* glsl */ `
uniform vec3 uSun; uniform vec3 uFrom; uniform vec3 uDisc; uniform vec3 uDirect;
uniform vec3 uZenith; uniform vec3 uHorizon; uniform vec3 uGlow;
uniform float uHaze;
vec3 skyColour(vec3 d) {
  float up = max(d.y, 0.0);
  vec3 c = mix(uZenith, uHorizon, pow(1.0 - up, 5.0));
  float near = max(dot(normalize(vec3(d.x, d.y * 1.6, d.z)), normalize(vec3(uSun.x, max(uSun.y, -0.02), uSun.z))), 0.0);
  c += uGlow * (0.16 * pow(near, 4.0) + 0.45 * pow(near, 24.0)) * (1.0 - 0.7 * up);
  return c;
}
// The share of a colour that comes through so much haze.
float throughHaze(float away) { return exp(-uHaze * away); }
vec3 hazeColour(vec3 d) { return skyColour(normalize(vec3(d.x, 0.012, d.z))); }
`;

export const NOISE_GLSL = /* glsl */ `
float hash2(vec2 p) { vec3 q = fract(vec3(p.xyx) * 0.1031); q += dot(q, q.yzx + 33.33); return fract((q.x + q.y) * q.z); }
float noise2(vec2 p) {
  vec2 i = floor(p), f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(hash2(i), hash2(i + vec2(1, 0)), f.x), mix(hash2(i + vec2(0, 1)), hash2(i + vec2(1, 1)), f.x), f.y);
}
`;

/** A dome that goes with the eye. */
export function sky(uniforms: SkyUniforms): Mesh {
  const material = new ShaderMaterial({
    uniforms: uniforms as unknown as Record<string, { value: unknown }>,
    side: BackSide,
    depthWrite: false,
    depthTest: false,
    fog: false,
    vertexShader: /* glsl */ `
      varying vec3 vWay;
      void main() {
        vWay = position;
        vec4 at = projectionMatrix * vec4(mat3(viewMatrix) * position, 1.0);
        gl_Position = at.xyww;
      }`,
    fragmentShader: /* glsl */ `
      varying vec3 vWay;
      uniform float uStars;
      ${SKY_GLSL}
      ${NOISE_GLSL}
      void main() {
        vec3 d = normalize(vWay);
        vec3 c = skyColour(d);
        if (d.y > 0.015) {
          // Thin clouds on a plane high above.
          vec2 p = d.xz / (d.y + 0.09);
          float n = 0.55 * noise2(p * 1.3 + 7.0) + 0.28 * noise2(p * 3.1 + 2.0) + 0.17 * noise2(p * 7.3);
          float cloud = smoothstep(0.5, 0.82, n) * smoothstep(0.015, 0.16, d.y);
          vec3 lit = uHorizon * 1.25 + uDirect * 0.06 + uGlow * 0.2 * pow(max(dot(d, uSun), 0.0), 6.0);
          c = mix(c, lit, 0.62 * cloud);
          if (uStars > 0.0) {
            vec2 cell = floor(vec2(atan(d.x, d.z) * 160.0, asin(d.y) * 160.0));
            float h = hash2(cell);
            vec2 f = fract(vec2(atan(d.x, d.z) * 160.0, asin(d.y) * 160.0)) - 0.5;
            c += uStars * (1.0 - cloud) * step(0.992, h) * smoothstep(0.28, 0.0, length(f)) * 0.35 * fract(h * 977.0) * smoothstep(0.02, 0.2, d.y);
          }
        }
        float disc = dot(d, uDisc);
        c += uDirect * (smoothstep(0.99996, 0.99999, disc) * 6.0 * step(0.0, d.y));
        // Haze as thick as the way through it: a layer of a kilometre.
        float through = uHaze * 1000.0 / max(0.02, d.y + 0.02);
        c = mix(hazeColour(d), c, clamp(exp(-through * 0.4), 0.0, 1.0));
        gl_FragColor = vec4(c, 1.0);
        #include <tonemapping_fragment>
        #include <colorspace_fragment>
      }`,
  });
  const mesh = new Mesh(new SphereGeometry(1, 32, 16), material);
  mesh.frustumCulled = false;
  mesh.renderOrder = -10;
  return mesh;
}
