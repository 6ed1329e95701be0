/**
 * The sea: a disc about the eye whose rings widen towards the horizon, moved by the waves, with ripples by the wind from a
 * pattern that is computed once. It mirrors the sky and the sun, and fades into the haze at the horizon.
 */
import {
  BufferGeometry,
  DataTexture,
  Float32BufferAttribute,
  FloatType,
  LinearFilter,
  LinearMipmapLinearFilter,
  Mesh,
  RGBAFormat,
  RepeatWrapping,
  ShaderMaterial,
  UnsignedByteType,
  Vector2,
  Vector3,
  Vector4,
} from "three";
import { type Triple, smooth } from "./axes";
import { chance } from "./fittings";
import type { Jet } from "./wash";
import { SKY_GLSL, type SkyUniforms } from "./sky";
import { FEW, drawnOf } from "./waves";
import type { Pair, Wave, WindNow } from "../protocol";

const FAR_M = 60_000;
/** The disc about the eye: sectors, and how much wider each ring is than the one within it. */
interface Grid {
  sectors: number;
  wider: number;
}
export const FINE: Grid = { sectors: 300, wider: 0.025 };
const COARSE: Grid = { sectors: 112, wider: 0.07 };
/** Places of ships whose wash and wake the sea draws. */
const MOST_WAKES = 6;
/** Jets of thrusters and azimuth units that the sea draws: the nearest. */
const MOST_JETS = 10;

/** Harmonics fade out where a ring is wider than so many radians of them. */
const FADES: Pair = [2, 3];
/** Width of a ring near the eye, for which harmonics fade [m]. */
const NEAR_M = 0.8;

/** Share of a harmonic that is drawn at a distance from the eye; the shader has the same. */
export const shareDrawn = (away_m: number, number_radpm: number, { wider }: Grid): number =>
  1 - smooth(...FADES, Math.max(NEAR_M, away_m * wider) * number_radpm);

/** Rings about the eye, 2 m at first. */
function disc({ sectors: SECTORS, wider }: Grid): BufferGeometry {
  const radii = [0];
  for (let r = 2; r < FAR_M; r = Math.max(r + 1.5, r * (1 + wider))) radii.push(r);
  radii.push(FAR_M);
  const places: number[] = [];
  const indices: number[] = [];
  radii.forEach((r, j) => {
    for (let i = 0; i < SECTORS; i++) {
      const angle = (2 * Math.PI * i) / SECTORS;
      places.push(r * Math.cos(angle), 0, r * Math.sin(angle));
      if (j + 1 === radii.length) continue;
      const k = (i + 1) % SECTORS;
      const [a, b, c, d] = [
        j * SECTORS + i,
        j * SECTORS + k,
        (j + 1) * SECTORS + i,
        (j + 1) * SECTORS + k,
      ];
      indices.push(a, b, c, b, d, c);
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(places, 3));
  geometry.setIndex(indices);
  return geometry;
}

/** Slopes of a patch of rippled water that repeats: a sum of waves of whole numbers of lengths over the patch. */
export function ripples(anisotropy: number, side = 256): DataTexture {
  const waves: [kx: number, ky: number, amplitude: number, phase: number][] = [];
  for (let i = 0; i < 56; i++) {
    const number = 5 + Math.floor(chance(i, 1) ** 1.4 * 32);
    const angle = (chance(i, 2) - 0.5) * 4;
    waves.push([
      Math.round(number * Math.cos(angle)),
      Math.round(number * Math.sin(angle)),
      // Ripples across the wind are lower.
      (0.35 + 0.65 * Math.cos(angle / 2) ** 2) / number ** 1.05,
      2 * Math.PI * chance(i, 3),
    ]);
  }
  const slopes = new Float32Array(side * side * 2);
  // Sines by table: x and y run through whole steps of a turn.
  const table = Float32Array.from({ length: side }, (_, i) => Math.sin((2 * Math.PI * i) / side));
  for (const [kx, ky, amplitude, phase] of waves) {
    const shift = Math.round((phase / (2 * Math.PI)) * side);
    for (let y = 0; y < side; y++)
      for (let x = 0; x < side; x++) {
        const turn = (((kx * x + ky * y + shift) % side) + side) % side;
        const slope = (table[turn] ?? 0) * amplitude;
        const at = 2 * (y * side + x);
        slopes[at] = (slopes[at] ?? 0) + slope * kx;
        slopes[at + 1] = (slopes[at + 1] ?? 0) + slope * ky;
      }
  }
  const most = slopes.reduce((most, s) => Math.max(most, Math.abs(s)), 0);
  const data = new Uint8Array(side * side * 4);
  for (let i = 0; i < side * side; i++) {
    const [sx, sy] = [(slopes[2 * i] ?? 0) / most, (slopes[2 * i + 1] ?? 0) / most];
    data[4 * i] = 127.5 + 127.5 * sx;
    data[4 * i + 1] = 127.5 + 127.5 * sy;
    // The size of the slope: its mean stays when far water is seen through a smaller copy of the pattern.
    data[4 * i + 2] = 255 * Math.min(1, sx * sx + sy * sy);
    data[4 * i + 3] = 255;
  }
  const texture = new DataTexture(data, side, side, RGBAFormat, UnsignedByteType);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = anisotropy;
  texture.needsUpdate = true;
  return texture;
}

/** A row of so many harmonics, which the shader reads number by number. */
function harmonics(count: number): DataTexture {
  const texture = new DataTexture(new Float32Array(4 * count), count, 1, RGBAFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}

/** A ship in the water: what she leaves behind. */
export interface Wake {
  at: Triple;
  heading_rad: number;
  length_m: number;
  beam_m: number;
  /** Speed ahead through the water [m/s]. */
  speed_mps: number;
  /** Propeller's wash as a share of full revolutions, negative astern. */
  wash: number;
}

/** A jet in the axes of the picture. */
export interface PlacedJet extends Jet {
  at: Triple;
}

export class Sea {
  readonly mesh: Mesh;
  private readonly material: ShaderMaterial;
  /** Each harmonic: amplitude, wave number along x and z, and its phase at the time of the drawing. */
  private waves = harmonics(1);
  private drawn: { omega: number; phase: number }[] = [];
  private readonly wakes = Array.from({ length: MOST_WAKES }, () => new Vector4());
  private readonly eye = new Vector3();
  private readonly wind = new Vector2();
  private readonly water = new Vector3();
  private readonly shapes = Array.from({ length: MOST_WAKES }, () => new Vector4());
  private readonly jetPlaces = Array.from({ length: MOST_JETS }, () => new Vector4());
  private readonly jetShapes = Array.from({ length: MOST_JETS }, () => new Vector2());

  /** `cheap`: for a machine that draws on the processor: a coarser disc, the strongest harmonics alone. */
  constructor(
    sky: SkyUniforms,
    private readonly cheap: boolean,
  ) {
    const grid = cheap ? COARSE : FINE;
    this.material = new ShaderMaterial({
      uniforms: {
        ...(sky as unknown as Record<string, { value: unknown }>),
        uEye: { value: this.eye },
        uTime: { value: 0 },
        uWind: { value: this.wind },
        uRipples: { value: ripples(cheap ? 1 : 8) },
        uWater: { value: this.water },
        uWaves: { value: this.waves },
        uWider: { value: grid.wider },
        uWaveCount: { value: 0 },
        uWakes: { value: this.wakes },
        uShapes: { value: this.shapes },
        uWakeCount: { value: 0 },
        uJets: { value: this.jetPlaces },
        uJetShapes: { value: this.jetShapes },
        uJetCount: { value: 0 },
      },
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
    });
    this.mesh = new Mesh(disc(grid), this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -5;
  }

  private set(name: string, value: unknown): void {
    const uniform = this.material.uniforms[name];
    if (uniform) uniform.value = value;
  }

  colour([r, g, b]: Triple): void {
    this.water.set(r, g, b);
  }

  /** The run's harmonics, and the origin of the picture's axes, about which places are computed. */
  sea(all: Wave[], [north_m, east_m]: Pair): void {
    const drawn = drawnOf(all, this.cheap ? FEW : all.length);
    this.waves.dispose();
    this.waves = harmonics(Math.max(1, drawn.length));
    const values = this.waves.image.data as Float32Array;
    drawn.forEach(([a, north, east], i) => values.set([a, -east, north, 0], 4 * i));
    this.drawn = drawn.map(([, north, east, omega, phase]) => ({
      omega,
      phase: phase - north * north_m - east * east_m,
    }));
    this.set("uWaves", this.waves);
    this.set("uWaveCount", drawn.length);
  }

  wake(all: Wake[]): void {
    all.slice(0, MOST_WAKES).forEach((ship, i) => {
      this.wakes[i]?.set(
        ship.at[0],
        ship.at[2],
        Math.sin(ship.heading_rad),
        -Math.cos(ship.heading_rad),
      );
      this.shapes[i]?.set(ship.length_m, ship.beam_m, ship.speed_mps, ship.wash);
    });
    this.set("uWakeCount", Math.min(MOST_WAKES, all.length));
  }

  jets(all: PlacedJet[]): void {
    const away = ({ at }: PlacedJet) => Math.hypot(at[0] - this.eye.x, at[2] - this.eye.z);
    const near = all.toSorted((a, b) => away(a) - away(b)).slice(0, MOST_JETS);
    near.forEach(({ at, to_rad, power, wide_m }, i) => {
      this.jetPlaces[i]?.set(at[0], at[2], Math.sin(to_rad), -Math.cos(to_rad));
      this.jetShapes[i]?.set(power, wide_m);
    });
    this.set("uJetCount", near.length);
  }

  tick(eye: Triple, t_s: number, wind: WindNow): void {
    this.mesh.position.set(eye[0], 0, eye[2]);
    this.eye.set(...eye);
    this.set("uTime", t_s);
    // In double precision: hours of a run leave single precision no place for a phase.
    const values = this.waves.image.data as Float32Array;
    this.drawn.forEach(({ omega, phase }, i) => {
      values[4 * i + 3] = (omega * t_s + phase) % (2 * Math.PI);
    });
    this.waves.needsUpdate = true;
    const to = wind.from_rad + Math.PI;
    this.wind.set(Math.sin(to) * wind.speed_mps, -Math.cos(to) * wind.speed_mps);
  }
}

const VERTEX = /* glsl */ `
uniform sampler2D uWaves; uniform int uWaveCount; uniform float uWider;
varying vec3 vAt; varying vec2 vSlope;
void main() {
  vec4 at = modelMatrix * vec4(position, 1.0);
  float away = length(position.xz);
  vSlope = vec2(0.0);
  for (int i = 0; i < uWaveCount; i++) {
    vec4 w = texelFetch(uWaves, ivec2(i, 0), 0);
    // A ring must be narrow beside the wave; farther off the pattern of ripples shows the sea. The longest waves come first.
    float seen = 1.0 - smoothstep(${FADES[0].toFixed(1)}, ${FADES[1].toFixed(1)}, max(${NEAR_M}, away * uWider) * length(w.yz));
    if (seen <= 0.0) break;
    float turn = w.y * at.x + w.z * at.z + w.w;
    at.y += seen * w.x * cos(turn);
    vSlope -= seen * w.x * sin(turn) * w.yz;
  }
  vAt = at.xyz;
  gl_Position = projectionMatrix * viewMatrix * at;
}`;

const FRAGMENT = /* glsl */ `
uniform vec3 uEye; uniform float uTime; uniform vec2 uWind; uniform sampler2D uRipples; uniform vec3 uWater;
uniform vec4 uWakes[${MOST_WAKES}]; uniform vec4 uShapes[${MOST_WAKES}]; uniform int uWakeCount;
uniform vec4 uJets[${MOST_JETS}]; uniform vec2 uJetShapes[${MOST_JETS}]; uniform int uJetCount;
varying vec3 vAt; varying vec2 vSlope;
${SKY_GLSL}
vec3 ripple(vec2 p) { vec3 t = texture2D(uRipples, p).xyz; return vec3(t.xy * 2.0 - 1.0, t.z); }
void main() {
  vec3 way = vAt - uEye;
  float away = length(way);
  vec3 view = way / max(away, 0.001);
  float speed = length(uWind);
  vec2 down = speed > 0.1 ? uWind / speed : vec2(1.0, 0.0);
  // The pattern's waves run along its first axis: turned with the wind.
  vec2 p = vec2(dot(vAt.xz, down), dot(vAt.xz, vec2(-down.y, down.x)));
  vec3 fine = ripple(p / 9.0 - vec2(uTime * 0.07, 0.0));
  vec3 middle = ripple(p / 31.0 + vec2(0.37, 0.11) - vec2(uTime * 0.032, uTime * 0.004));
  vec3 coarse = ripple(p / 117.0 + vec2(0.19, 0.53) - vec2(uTime * 0.016, -uTime * 0.003));
  float gusts = 0.65 + 0.7 * ripple(p / 900.0 - vec2(uTime * 0.002, 0.0)).z * 4.0;
  float steep = (0.05 + 0.028 * min(speed, 16.0)) * clamp(gusts, 0.5, 1.4);
  vec2 slope = steep * (0.55 * fine.xy + 0.75 * middle.xy + 0.8 * coarse.xy);
  slope = vec2(dot(slope, vec2(down.x, -down.y)), dot(slope, vec2(down.y, down.x)));
  slope += vSlope;

  // Wash, wake and bow wave of ships.
  float foam = 0.0;
  float smooth_ = 0.0;
  for (int i = 0; i < ${MOST_WAKES}; i++) {
    if (i >= uWakeCount) break;
    vec4 w = uWakes[i]; vec4 s = uShapes[i];
    vec2 d = vAt.xz - w.xy;
    float along = dot(d, w.zw);
    float across = abs(dot(d, vec2(-w.w, w.z)));
    float half_ = 0.5 * s.x;
    if (along > half_ + 12.0 || across > 3.0 * s.y + 0.4 * max(0.0, -along)) continue;
    float astern = -along - half_;
    float fast = clamp(abs(s.z) / 6.0, 0.0, 1.0);
    // Beside and behind her.
    float breadth = 0.34 * s.y + 0.055 * max(astern, 0.0);
    float trail = smoothstep(-8.0, 6.0, astern) * exp(-max(astern, 0.0) / (60.0 + 90.0 * fast)) * smoothstep(breadth * 1.5, breadth * 0.3, across);
    float wash = trail * clamp(abs(s.w) * 0.8 + fast * 0.35, 0.0, 0.85) * (0.35 + 0.65 * exp(-max(astern, 0.0) / 45.0));
    // Wash astern goes forward along the hull.
    if (s.w < -0.02) wash += abs(s.w) * smoothstep(0.5 * s.x, 0.0, along + half_) * step(-half_ - 10.0, along) * smoothstep(1.1 * s.y, 0.3 * s.y, across);
    float hug = smoothstep(0.5 * s.y + 2.6, 0.5 * s.y - 0.4, across) * step(-half_, along) * smoothstep(half_ + 3.0, half_ - 4.0, along);
    float bow = hug * fast * (0.25 + 0.75 * smoothstep(0.2, 0.95, along / half_));
    float arm = exp(-pow((across - 0.36 * s.y - 0.34 * (half_ - along)) / (1.2 + 0.03 * (half_ - along)), 2.0)) * fast * exp(-(half_ - along) / (0.8 * s.x)) * step(along, half_);
    foam += wash + 0.9 * bow + 0.5 * arm;
    smooth_ += smoothstep(breadth * 1.8, breadth * 0.8, across) * smoothstep(-4.0, 20.0, astern) * exp(-max(astern, 0.0) / 700.0) * fast;
  }
  for (int i = 0; i < ${MOST_JETS}; i++) {
    if (i >= uJetCount) break;
    vec4 j = uJets[i]; vec2 s = uJetShapes[i];
    vec2 d = vAt.xz - j.xy;
    float along = dot(d, j.zw);
    // A strong jet is seen farther: the water slows as it spreads.
    float reach = s.y * (2.0 + 7.0 * s.x);
    if (along < -s.y || along > 4.0 * reach) continue;
    float across = abs(dot(d, vec2(-j.w, j.z)));
    float breadth = 0.6 * s.y + 0.16 * max(along, 0.0);
    if (across > 1.5 * breadth) continue;
    float thrown = sqrt(s.x) * smoothstep(-s.y, 0.5 * s.y, along) * exp(-max(along, 0.0) / reach) * smoothstep(1.5 * breadth, 0.35 * breadth, across);
    foam += 0.95 * thrown;
    smooth_ += 0.8 * thrown;
  }
  slope *= 1.0 - 0.55 * clamp(smooth_, 0.0, 1.0);
  float lather = (ripple(p / 6.0 - vec2(uTime * 0.02)).x + ripple(p / 21.0 + 0.3).y) * 1.3 + 0.5 * ripple(p / 70.0 + 0.6).x;
  foam = clamp(foam, 0.0, 1.0) * smoothstep(0.1, 0.95, clamp(foam, 0.0, 1.0) * 0.75 + 0.33 * lather + 0.2);
  // White horses from a fresh breeze on.
  float crest = coarse.x * 0.6 + middle.x * 0.6 + fine.x * 0.25;
  foam += smoothstep(0.62 - 0.03 * max(0.0, speed - 8.0), 0.9, crest) * smoothstep(7.0, 14.0, speed) * 0.7 * smoothstep(4000.0, 300.0, away);

  vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
  // Seen flat, the faces that lean towards the eye hide the others.
  normal = normalize(normal - view * max(0.0, dot(normal, view) + 0.03));
  vec3 mirror = reflect(view, normal);
  mirror.y = abs(mirror.y);
  float rough = steep * steep * (fine.z + middle.z + 0.3);
  float facing = max(dot(-view, normal), 0.0);
  float fresnel = 0.02 + 0.98 * pow(1.0 - facing, 5.0) / (1.0 + 9.0 * sqrt(rough));
  vec3 above = skyColour(normalize(mirror + vec3(0.0, 0.06 + 0.35 * sqrt(rough), 0.0)));
  vec3 lit = uWater * (0.5 + 0.28 * dot(uDirect, vec3(0.33)) * max(uFrom.y, 0.0)) ;
  vec3 colour = mix(lit + uWater * 0.6 * max(0.0, slope.x + slope.y), above, clamp(fresnel, 0.0, 1.0));
  // The path of sun or moon: the wider, the rougher the water.
  float spread = 0.0012 + 0.35 * rough + 0.00002 * min(away, 600.0);
  vec3 half3 = normalize(uDisc - view);
  float tan2 = (1.0 - half3.y * half3.y) / max(half3.y * half3.y, 1e-4);
  vec3 bent = normalize(normal + vec3(0.0));
  float c = max(dot(bent, half3), 0.0);
  float t2 = (1.0 - c * c) / max(c * c, 1e-4);
  colour += uDirect * min(2.5, exp(-t2 / spread) / (spread * 900.0)) * smoothstep(-0.005, 0.02, uDisc.y) * (0.25 + fresnel * 3.0) * 0.6;
  vec3 white = uDirect * (0.1 + 0.16 * max(uFrom.y, 0.0)) + uHorizon * 0.35 + uZenith * 0.3;
  colour = mix(colour, white, clamp(foam, 0.0, 1.0) * 0.8);
  float clear = throughHaze(away);
  colour = mix(hazeColour(view), colour, clear);
  gl_FragColor = vec4(colour, 1.0);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
}`;
