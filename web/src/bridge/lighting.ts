/** The light in the picture: that of the run's time or of the page's palette, dimmed by fog and rain. */
import { Color, DirectionalLight, HemisphereLight } from "three";
import type { Triple } from "./axes";
import { type Light, PALETTE_SUNS, density, lightOf } from "./light";
import type { Shared } from "./paintwork";
import { RAINS } from "./rain";
import { shine } from "./sky";
import { sunOf } from "./sun";
import type { PaletteName } from "../palette";
import type { Hello } from "../protocol";

/** Visibility below which fog dims the sun [m]. */
const DIMS_M = 6000;
/** How much of the sun heavy rain takes, and of the brightness of the sky. */
const RAIN_TAKES = { sun: 0.85, sky: 0.35 };

export class Lighting {
  /** Sun or moon. */
  readonly direct = new DirectionalLight();
  readonly ambient = new HemisphereLight();
  light: Light = lightOf(PALETTE_SUNS.day);
  private chosen: PaletteName = "day";
  /** What the light was made for. */
  private made = "";

  constructor(private readonly shared: Shared) {}

  /** The palette of the page stands for the time of day, where the scenario gives no date. */
  palette(name: PaletteName): void {
    this.chosen = name;
  }

  /** Makes the light of a time anew if it has changed, and tells whether it has. */
  tick({ daylight, rain }: Hello, t_s: number, visibility_m: number | null): boolean {
    const sun = sunOf(daylight, t_s) ?? PALETTE_SUNS[this.chosen];
    const tenths = (rad: number) => Math.round((rad * 1800) / Math.PI);
    const made = `${tenths(sun.elevation_rad)} ${tenths(sun.azimuth_rad)} ${visibility_m} ${rain}`;
    if (made === this.made) return false;
    this.made = made;
    this.light = lightOf(sun);
    this.dim(visibility_m, rain ? RAINS[rain].grey : 0);
    return true;
  }

  private dim(visibility_m: number | null, wet: number): void {
    const { light, direct, ambient } = this;
    // In fog the sun is a bright place at most.
    const fog = visibility_m === null ? 1 : Math.min(1, visibility_m / DIMS_M);
    const dim = fog * (1 - RAIN_TAKES.sun * wet);
    const sun: Triple = [light.direct[0] * dim, light.direct[1] * dim, light.direct[2] * dim];
    const [r, g, b] = light.horizon;
    const grey = ((r + g + b) / 3) * (1 - RAIN_TAKES.sky * wet);
    const dull = (c: Triple): Triple => [
      c[0] * dim + grey * 1.05 * (1 - dim),
      c[1] * dim + grey * 1.08 * (1 - dim),
      c[2] * dim + grey * 1.12 * (1 - dim),
    ];
    shine(
      this.shared,
      {
        ...light,
        direct: sun,
        horizon: dull(light.horizon),
        zenith: dull(light.zenith),
        glow: [light.glow[0] * dim, light.glow[1] * dim, light.glow[2] * dim],
        stars: light.stars * dim,
      },
      density(visibility_m),
    );
    this.shared.uLamps.value = light.lamps;
    direct.color = new Color(...sun);
    direct.intensity = 1;
    direct.shadow.intensity = light.shadows;
    ambient.color = new Color(...dull(light.sky));
    ambient.groundColor = new Color(...light.ground);
    ambient.intensity = 1.5 + 0.6 * (1 - dim);
  }
}
