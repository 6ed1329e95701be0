/** The direction of a look in words: its bearing as the compass on board shows it, and the side of the ship. */
import type { Look } from "./look";
import type { BodyNow, Hello } from "../protocol";
import { wrapped } from "../units";

/** The body with which the eye of a look turns. */
function bodyOf({ eye, vessel, bollard, fender }: Look, hello: Hello): number | undefined {
  if (eye === "bollard") return hello.bollards[bollard]?.body;
  if (eye === "free" && fender !== null) return hello.fenders[fender]?.body;
  const served = hello.tugs[vessel - hello.vessels.length]?.vessel;
  return hello.vessels[served ?? vessel]?.body;
}

/**
 * Bearing of a look [rad], from its true bearing, and its angle from the bow of the vessel on which the eye is; `null` for an eye
 * that is on no vessel. A person on board reads the bearing of what is seen off the compass: with a frozen compass the bearing is
 * the frozen heading and the angle from the bow, so that the words over the view do not give the true heading away.
 *
 * `shown`, `seen`: the bodies as instruments show them, and as the eye sees them.
 */
export function bearingOf(
  look: Look,
  true_rad: number,
  hello: Hello,
  shown: (BodyNow | null)[],
  seen: (BodyNow | null)[],
): { bearing_rad: number; side_rad: number | null } {
  const body = bodyOf(look, hello) ?? -1;
  const [shown_rad, seen_rad] = [shown[body]?.[2] ?? 0, seen[body]?.[2] ?? 0];
  const side_rad = wrapped(true_rad - seen_rad);
  const isAboard =
    look.eye !== "bollard" && look.eye !== "free" && look.vessel < hello.vessels.length;
  return {
    bearing_rad: shown_rad + side_rad,
    side_rad: isAboard && seen[body] ? side_rad : null,
  };
}
