/** Puts pictures of bodies where frames say, and the camera where an eye is. */
import { Euler, Matrix4, type Object3D, type PerspectiveCamera, Vector3 } from "three";
import { aboard, toPicture } from "./axes";
import { type Seat, vertical } from "./eyes";
import { type Look, VIEW_LIMITS } from "./look";
import { clamp } from "../geometry";
import type { BodyNow, Pair } from "../protocol";

/** How a body lies in the water: heel to starboard, trim with the bow up [rad]; heave, squat and the like, positive down [m]. */
export interface Attitude {
  heel_rad: number;
  trim_rad: number;
  sunk_m: number;
}

export const LEVEL: Attitude = { heel_rad: 0, trim_rad: 0, sunk_m: 0 };

/** A fixed body: its heights count from datum, over which the water stands. */
export const fixedIn = (water_level_m: number): Attitude => ({ ...LEVEL, sunk_m: water_level_m });

/** Puts the picture of a body at its place. */
export function stand(picture: Object3D, origin: Pair, now: BodyNow, attitude: Attitude): void {
  picture.position.set(...toPicture(origin, [now[0], now[1]], -attitude.sunk_m));
  picture.rotation.set(attitude.trim_rad, -now[2], -attitude.heel_rad, "YXZ");
  picture.updateMatrixWorld();
}

const HIGHEST_RAD = 1.3;
const LOWEST_RAD = -1.5;

/** Puts the camera at a seat on the picture of a body, turned as the look says. The camera heels and trims with the body. */
export function aim(camera: PerspectiveCamera, seat: Seat, on: Matrix4, look: Look): void {
  const raised =
    look.panorama_rad === null
      ? clamp(seat.elevation_rad + look.raise_rad, LOWEST_RAD, HIGHEST_RAD)
      : look.raise_rad;
  const local = new Matrix4().makeRotationFromEuler(
    new Euler(raised, -(seat.bearing_rad + look.turn_rad), 0, "YXZ"),
  );
  local.setPosition(...aboard(seat.at, seat.up_m));
  local.premultiply(on).decompose(camera.position, camera.quaternion, new Vector3());
  camera.fov = (viewOf(seat, look, camera.aspect) * 180) / Math.PI;
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
}

/** The vertical angle of view; on an upright screen the seat's angle is that of the width [rad]. */
export function viewOf(seat: Seat, look: Look, aspect: number): number {
  if (look.panorama_rad !== null) return vertical(look.panorama_rad, aspect);
  if (look.view_rad !== null) return look.view_rad;
  return aspect < 1 ? clamp(vertical(seat.view_rad, aspect), ...VIEW_LIMITS) : seat.view_rad;
}
