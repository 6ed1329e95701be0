/**
 * Light of the sun, the sky and the moon, by the page's palette. Directions are in the axes of the picture, towards the light.
 */
import { type Triple, smooth, unit } from "./axes";
import type { PaletteName } from "../palette";

const DEG = Math.PI / 180;

/** Where the sun stands: its azimuth from north and its elevation [rad]. */
export interface Sun {
  azimuth_rad: number;
  elevation_rad: number;
}

/** The sun that a palette stands for: an afternoon, a quarter of an hour after sunset, and deep night. */
export const PALETTE_SUNS: Record<PaletteName, Sun> = {
  day: { azimuth_rad: 222 * DEG, elevation_rad: 36 * DEG },
  dusk: { azimuth_rad: 292 * DEG, elevation_rad: -2.5 * DEG },
  night: { azimuth_rad: 345 * DEG, elevation_rad: -25 * DEG },
};

/** The moon of our nights. */
const MOON: Sun = { azimuth_rad: 150 * DEG, elevation_rad: 38 * DEG };

export const towards = ({ azimuth_rad, elevation_rad }: Sun): Triple => [
  Math.sin(azimuth_rad) * Math.cos(elevation_rad),
  Math.sin(elevation_rad),
  -Math.cos(azimuth_rad) * Math.cos(elevation_rad),
];

/** Colours are linear. */
export interface Light {
  /** Towards the sun, which may be below the horizon. */
  sun: Triple;
  /** Towards the light that casts shadows: sun or moon. */
  from: Triple;
  /** Towards the disc of the sun, or of the moon at night; below the horizon it is not seen. */
  disc: Triple;
  direct: Triple;
  /** 1 where the sun or the moon casts shadows, 0 in the dusk after sunset. */
  shadows: number;
  sky: Triple;
  ground: Triple;
  zenith: Triple;
  horizon: Triple;
  /** Colour of the sky round the sun. */
  glow: Triple;
  /** Colour of deep water. */
  water: Triple;
  /** Exposure of the picture: eyes grow used to the dark. */
  exposure: number;
  /** 0 by day, 1 when lights shine. */
  lamps: number;
  /** 0 by day, 1 when stars are seen. */
  stars: number;
}

type Colours = Omit<Light, "sun" | "from" | "disc" | "lamps" | "shadows">;

const NOON: Colours = {
  direct: [3.1, 2.85, 2.5],
  sky: [0.62, 0.78, 1],
  ground: [0.3, 0.33, 0.32],
  zenith: [0.055, 0.17, 0.43],
  horizon: [0.5, 0.63, 0.74],
  glow: [0.55, 0.5, 0.4],
  water: [0.014, 0.045, 0.048],
  exposure: 0.92,
  stars: 0,
};
const SUNSET: Colours = {
  direct: [0.8, 0.42, 0.22],
  sky: [0.3, 0.36, 0.5],
  ground: [0.14, 0.14, 0.15],
  zenith: [0.03, 0.066, 0.15],
  horizon: [0.21, 0.23, 0.29],
  glow: [1.15, 0.42, 0.12],
  water: [0.008, 0.022, 0.03],
  exposure: 1.35,
  stars: 0,
};
const NIGHT: Colours = {
  direct: [0.055, 0.07, 0.105],
  sky: [0.02, 0.028, 0.048],
  ground: [0.007, 0.009, 0.012],
  zenith: [0.0022, 0.004, 0.0095],
  horizon: [0.011, 0.0155, 0.024],
  glow: [0.012, 0.011, 0.014],
  water: [0.0022, 0.0042, 0.0056],
  exposure: 2.3,
  stars: 1,
};

const blend = (a: Colours, b: Colours, share: number): Colours => {
  const mix = (x: number, y: number) => x + (y - x) * share;
  const three = (x: Triple, y: Triple): Triple => [
    mix(x[0], y[0]),
    mix(x[1], y[1]),
    mix(x[2], y[2]),
  ];
  return {
    direct: three(a.direct, b.direct),
    sky: three(a.sky, b.sky),
    ground: three(a.ground, b.ground),
    zenith: three(a.zenith, b.zenith),
    horizon: three(a.horizon, b.horizon),
    glow: three(a.glow, b.glow),
    water: three(a.water, b.water),
    exposure: mix(a.exposure, b.exposure),
    stars: mix(a.stars, b.stars),
  };
};

/** The light under a sun. */
export function lightOf(sun: Sun): Light {
  const high = sun.elevation_rad / DEG;
  const colours =
    high > -2
      ? blend(SUNSET, NOON, smooth(-2, 20, high))
      : blend(NIGHT, SUNSET, smooth(-16, -2, high));
  const isNight = high < -8;
  const shown = isNight ? MOON : { ...sun, elevation_rad: Math.max(5 * DEG, sun.elevation_rad) };
  return {
    ...colours,
    lamps: high < 1 ? 1 : 0,
    shadows: isNight ? 1 : smooth(-0.5, 1.5, high),
    sun: towards(sun),
    from: unit(towards(shown)),
    disc: towards(isNight ? MOON : sun),
  };
}

/** Visibility in clear air [m]. */
const CLEAR_M = 45_000;

/**
 * Density of the haze [1/m]: a share exp(−density · distance) of a colour comes through, by the law of Beer and Lambert. At the
 * visibility five hundredths of the contrast are left, as the definition of visibility asks (Koschmieder's; from memory).
 */
export const density = (visibility_m: number | null): number =>
  Math.log(20) / Math.max(20, visibility_m ?? CLEAR_M);
