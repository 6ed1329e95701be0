/**
 * The place of the sun, by the low-precision formulas of Meeus, Astronomical Algorithms, chapters 12 and 25, as NOAA's solar
 * calculator has them: within a hundredth of a degree from 1950 to 2100, refraction included.
 */
import type { Sun } from "./light";
import type { DaylightInfo } from "../protocol";

const DEG = Math.PI / 180;

const turn = (degrees: number): number => ((degrees % 360) + 360) % 360;

/** Azimuth from north and apparent elevation of the sun's middle at a time of the Unix clock [s] and a place [rad]. */
export function sunAt(unix_s: number, latitude_rad: number, longitude_rad: number): Sun {
  const days = unix_s / 86_400 + 2_440_587.5 - 2_451_545;
  const c = days / 36_525;
  const mean = turn(280.46646 + c * (36_000.76983 + 0.0003032 * c));
  const anomaly = (357.52911 + c * (35_999.05029 - 0.0001537 * c)) * DEG;
  const centre =
    Math.sin(anomaly) * (1.914602 - c * (0.004817 + 0.000014 * c)) +
    Math.sin(2 * anomaly) * (0.019993 - 0.000101 * c) +
    Math.sin(3 * anomaly) * 0.000289;
  const node = (125.04 - 1934.136 * c) * DEG;
  const longitude = (mean + centre - 0.00569 - 0.00478 * Math.sin(node)) * DEG;
  const tilt = (23.4392911 - 0.0130042 * c + 0.00256 * Math.cos(node)) * DEG;
  const declination = Math.asin(Math.sin(tilt) * Math.sin(longitude));
  const ascension = Math.atan2(Math.cos(tilt) * Math.sin(longitude), Math.cos(longitude));
  const sidereal = turn(280.46061837 + 360.98564736629 * days + 0.000387933 * c * c) * DEG;
  const hour = sidereal + longitude_rad - ascension;
  const [sin, cos] = [Math.sin(latitude_rad), Math.cos(latitude_rad)];
  const up = Math.asin(sin * Math.sin(declination) + cos * Math.cos(declination) * Math.cos(hour));
  const azimuth = Math.atan2(
    -Math.cos(declination) * Math.sin(hour),
    Math.sin(declination) * cos - Math.cos(declination) * Math.cos(hour) * sin,
  );
  return {
    azimuth_rad: turn(azimuth / DEG) * DEG,
    elevation_rad: up + refraction(up),
  };
}

/** How much the air lifts the sun (Saemundsson, after Meeus, chapter 16); 0 deep below the horizon [rad]. */
function refraction(elevation_rad: number): number {
  const high = elevation_rad / DEG;
  if (high < -2) return 0;
  return (1.02 / Math.tan((high + 10.3 / (high + 5.11)) * DEG) / 60) * DEG;
}

/** The sun of a run at a time of it [s]; `null` if the scenario gives no date. */
export const sunOf = (daylight: DaylightInfo | null, t_s: number): Sun | null =>
  daylight && sunAt(daylight.start_unix_s + t_s, daylight.latitude_rad, daylight.longitude_rad);
