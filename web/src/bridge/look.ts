/** Places from which the view is seen, and how it is turned. The picture itself is loaded when a view is opened. */

export const EYES = [
  "bridge",
  "port-wing",
  "starboard-wing",
  "bow",
  "stern",
  "tug",
  "bollard",
  "free",
] as const;
export type Eye = (typeof EYES)[number];

/** Names on buttons, and in words for screen readers. */
export const EYE_NAMES: Record<Eye, [label: string, spoken: string]> = {
  bridge: ["Bridge", "bridge"],
  "port-wing": ["Port", "port bridge wing"],
  "starboard-wing": ["Stb", "starboard bridge wing"],
  bow: ["Bow", "bow"],
  stern: ["Stern", "stern"],
  tug: ["Tug", "tug's wheelhouse"],
  bollard: ["Bollard", "bollard on the quay"],
  free: ["Free", "free camera about the ship"],
};

const DEG = Math.PI / 180;

/** The least and the largest vertical angle of view: binoculars of about 7×, and a wide view [rad]. */
export const VIEW_LIMITS: [number, number] = [6 * DEG, 75 * DEG];

/** What a page may ask of the picture. */
export interface Look {
  eye: Eye;
  /**
   * Index in `Hello.vessels` of the vessel whose bridge it is, or of the tug. For the eye in a tug, the numbers after the vessels
   * are the vector tugs, `Hello.tugs`.
   */
  vessel: number;
  /** Index in `Hello.bollards`. */
  bollard: number;
  /** Turned from where the eye looks at first, positive to starboard and up [rad]. */
  turn_rad: number;
  raise_rad: number;
  /** Vertical angle of view [rad]; `null`: that of the eye. */
  view_rad: number | null;
  /** Distance of the free eye from the ship [m]. */
  off_m: number;
  /** How much higher than usual the eye is [m]. */
  lifted_m: number;
  /** Index in `Hello.fenders` of the fender that the free eye looks at; `null`: the ship. */
  fender: number | null;
  /** Distances, path, forces and loads are drawn in the picture. */
  marks: boolean;
  /** For a panorama of several windows: level, with this horizontal angle of view [rad]. */
  panorama_rad: number | null;
}

/** The least and the greatest height of an eye above its deck, and what is usual [m]. */
export const EYE_LIMITS_M: [number, number] = [1, 3];
export const USUAL_EYE_M = 1.75;

/**
 * A look that an address asks for, such as `?view=bridge&bearing=-60&fov=60&eye=1.6&marks`; `null` if it asks for none. `eye`:
 * height of the eye above the deck [m].
 */
export function lookOf(
  search: string,
): Pick<Look, "eye" | "turn_rad" | "panorama_rad" | "lifted_m" | "marks"> | null {
  const asked = new URLSearchParams(search);
  const eye = EYES.find((each) => each === asked.get("view"));
  if (!eye) return null;
  const number = (name: string, least: number, most: number): number | null => {
    const text = asked.get(name);
    const value = text === null || text.trim() === "" ? Number.NaN : Number(text);
    return Number.isFinite(value) ? Math.min(most, Math.max(least, value)) : null;
  };
  const fov = number("fov", 10, 120);
  return {
    eye,
    turn_rad: (number("bearing", -180, 180) ?? 0) * DEG,
    panorama_rad: fov === null ? null : fov * DEG,
    lifted_m: (number("eye", ...EYE_LIMITS_M) ?? USUAL_EYE_M) - USUAL_EYE_M,
    marks: asked.has("marks"),
  };
}
