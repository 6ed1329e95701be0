/** Materials: painted steel, concrete, ground and panes, all with the haze of the sky. Patterns are computed in the shader. */
import { type IUniform, MeshLambertMaterial, DoubleSide, FrontSide } from "three";
import { NOISE_GLSL, SKY_GLSL, type SkyUniforms } from "./sky";

export type Surface = "plain" | "steel" | "concrete" | "ground" | "panes" | "leaves";

/** What a surface does to its colour; `vPlace` is in the axes of the part, `vWorld` in those of the picture. */
const PATTERNS: Record<Surface, string> = {
  plain: "",
  leaves: `
    diffuseColor.rgb *= 0.72 + 0.5 * hash2(floor(vWorld.xz * 0.5));`,
  // Plates, and streaks that run down the side.
  steel: `
    float upright = 1.0 - abs(vNormalPart.y);
    float streak = noise2(vec2(dot(vPlace.xz, vec2(0.9, 1.0)) * 1.7, vPlace.y * 0.13)) * noise2(vPlace.xz * 0.35 + 3.0);
    diffuseColor.rgb *= 1.0 - 0.16 * upright * smoothstep(0.3, 0.8, streak);
    float seam = smoothstep(0.06, 0.0, abs(fract(vPlace.y / 2.4) - 0.5) * 2.4) + smoothstep(0.06, 0.0, abs(fract(vPlace.z / 9.0) - 0.5) * 9.0);
    diffuseColor.rgb *= 1.0 - 0.1 * upright * min(1.0, seam) * uNear;
    diffuseColor.rgb *= 0.95 + 0.1 * noise2(vPlace.xz * 0.6 + vPlace.y);`,
  // Joints of slabs and blocks, rust and weed near the water.
  concrete: `
    float wall = 1.0 - abs(vNormalPart.y);
    vec2 flat_ = vPlace.xz;
    float run = dot(vPlace.xz, vec2(1.0, 1.0));
    float rough = 0.6 * noise2(flat_ * 1.9) + 0.4 * noise2(flat_ * 0.23 + 9.0);
    float face = 0.6 * noise2(vec2(run * 0.9, vPlace.y * 1.4)) + 0.4 * noise2(vec2(run * 2.2, vPlace.y * 0.25));
    diffuseColor.rgb *= mix(0.82 + 0.3 * rough, 0.78 + 0.36 * face, wall);
    float joint = smoothstep(0.05, 0.02, abs(fract(vPlace.x / 6.0) - 0.5) * 6.0) + smoothstep(0.05, 0.02, abs(fract(vPlace.z / 6.0) - 0.5) * 6.0);
    diffuseColor.rgb *= 1.0 - 0.22 * min(1.0, joint) * (1.0 - wall) * uNear;
    float seam = smoothstep(0.08, 0.03, abs(fract(run / 9.0) - 0.5) * 9.0);
    diffuseColor.rgb *= 1.0 - 0.3 * wall * seam * uNear;
    float wet = smoothstep(1.5, 0.7, vWorld.y + 0.5 * face);
    diffuseColor.rgb = mix(diffuseColor.rgb, diffuseColor.rgb * vec3(0.36, 0.4, 0.34), wall * wet);
    float weed = smoothstep(0.75, 0.3, vWorld.y + 0.3 * face);
    diffuseColor.rgb = mix(diffuseColor.rgb, vec3(0.018, 0.03, 0.012), wall * weed * 0.85);`,
  ground: `
    float big = noise2(vWorld.xz * 0.013) * 0.6 + noise2(vWorld.xz * 0.06) * 0.4;
    float fine_ = noise2(vWorld.xz * 0.5 + vWorld.y);
    float steep_ = 1.0 - abs(vNormalPart.y);
    diffuseColor.rgb *= 0.72 + 0.36 * big + 0.2 * fine_ * uNear;
    float block = noise2(vec2(dot(vWorld.xz, vec2(0.8, 0.9)), vWorld.y * 1.3 + dot(vWorld.xz, vec2(-0.5, 0.6))) * 0.9);
    diffuseColor.rgb *= mix(1.0, 0.55 + 0.7 * block, smoothstep(0.05, 0.3, steep_));
    diffuseColor.rgb *= mix(0.42, 1.0, smoothstep(0.1, 1.1, vWorld.y + 0.4 * block));`,
  panes: `
    vec3 gaze = normalize(vWorld - cameraPosition);
    vec3 back = reflect(gaze, normalize(vNormalWorld));
    diffuseColor.rgb *= 0.8;`,
};

/** What a surface adds of light. */
const GLOWS: Record<Surface, string> = {
  plain: "",
  leaves: "",
  ground: "",
  // Paint shines: upright plates mirror a little of sky and sea, much at a low angle, so that a black side is not a hole.
  steel: `
    vec3 gaze = normalize(vWorld - cameraPosition);
    vec3 plate = normalize(vNormalWorld);
    vec3 back = reflect(gaze, plate);
    float sheen = 0.03 + 0.3 * pow(1.0 - max(0.0, dot(-gaze, plate)), 5.0);
    vec3 mirrored = skyColour(vec3(back.x, abs(back.y) + 0.05, back.z)) * mix(0.55, 1.0, smoothstep(-0.12, 0.12, back.y));
    totalEmissiveRadiance += upright * upright * sheen * mirrored;
    totalEmissiveRadiance += diffuseColor.rgb * uLamps * vec3(0.09, 0.075, 0.05) * step(0.6, vPlace.y);`,
  concrete: `totalEmissiveRadiance += diffuseColor.rgb * uLamps * vec3(0.3, 0.2, 0.09) * mix(0.3, 1.0, abs(vNormalPart.y)) * (0.45 + 0.55 * noise2(vPlace.xz * 0.045));`,
  panes: `
    float lit = step(0.5, hash2(floor(vPlace.xz * 0.36 + vPlace.y * 0.9))) * step(0.019, vColor.b) * uLamps;
    totalEmissiveRadiance += lit * vec3(0.95, 0.72, 0.4) * 0.75;
    totalEmissiveRadiance += 0.35 * skyColour(vec3(back.x, abs(back.y) + 0.05, back.z)) * (1.0 - lit);`,
};

export type Shared = SkyUniforms & { uLamps: IUniform<number> };

export function paintwork(shared: Shared, surface: Surface, twoSided = false): MeshLambertMaterial {
  const material = new MeshLambertMaterial({
    vertexColors: true,
    side: twoSided ? DoubleSide : FrontSide,
    fog: false,
  });
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, shared);
    shader.vertexShader = shader.vertexShader
      .replace(
        "#include <common>",
        `#include <common>
        varying vec3 vPlace; varying vec3 vWorld; varying vec3 vNormalPart; varying vec3 vNormalWorld;`,
      )
      .replace(
        "#include <begin_vertex>",
        `#include <begin_vertex>
        vPlace = position;
        vNormalPart = normal;
        vec4 hazed = vec4(position, 1.0);
        #ifdef USE_INSTANCING
          hazed = instanceMatrix * hazed;
        #endif
        vWorld = (modelMatrix * hazed).xyz;
        vNormalWorld = mat3(modelMatrix) * normal;`,
      );
    shader.fragmentShader = shader.fragmentShader
      .replace(
        "#include <common>",
        `#include <common>
        varying vec3 vPlace; varying vec3 vWorld; varying vec3 vNormalPart; varying vec3 vNormalWorld;
        uniform float uLamps;
        ${SKY_GLSL}
        ${NOISE_GLSL}`,
      )
      .replace(
        "#include <color_fragment>",
        `#include <color_fragment>
        float far_ = length(vWorld - cameraPosition);
        // Fine patterns fade before they flicker.
        float uNear = smoothstep(260.0, 60.0, far_);
        ${PATTERNS[surface]}`,
      )
      .replace(
        "#include <emissivemap_fragment>",
        `#include <emissivemap_fragment>
        ${GLOWS[surface]}`,
      )
      .replace(
        "#include <opaque_fragment>",
        `float clear_ = throughHaze(far_);
        outgoingLight = mix(hazeColour((vWorld - cameraPosition) / max(far_, 0.01)), outgoingLight, clear_);
        #include <opaque_fragment>`,
      );
  };
  material.customProgramCacheKey = () => surface;
  return material;
}
