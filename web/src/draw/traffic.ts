/** Draws the ships that pass on tracks of their own: outline, name, and where each will be in a minute. */
import { add, onEarth, times, toScreen } from "../geometry";
import { knots, spoken } from "../units";
import { Rank } from "./labels";
import { polygon, stroke } from "./marks";
import type { Scene } from "./scene";

/** Time of the vector ahead [s]. */
const AHEAD_S = 60;
/** Below this speed a ship has no vector [m/s]. */
const STILL_MPS = 0.1;

export function drawTraffic({ to, camera, colours, hello, frame, labels }: Scene): void {
  hello.traffic.forEach(({ name, outline }, i) => {
    const now = frame.traffic[i];
    if (!now) return;
    polygon(
      to,
      outline.map((at) => toScreen(camera, onEarth(now, at))),
    );
    to.fillStyle = colours.land_edge;
    to.globalAlpha = 0.7;
    to.fill();
    to.globalAlpha = 1;
    to.strokeStyle = colours.text;
    to.lineWidth = 1.5;
    to.stroke();
    const [north, east, , vNorth, vEast] = now;
    const speed = Math.hypot(vNorth, vEast);
    const at = toScreen(camera, [north, east]);
    if (speed > STILL_MPS) {
      const then = toScreen(camera, add([north, east], times([vNorth, vEast], AHEAD_S)));
      stroke(to, at, then, colours.text, 2, [8, 4]);
    }
    labels.push({
      key: `traffic ${name}`,
      text: `${spoken(name)} ${knots(speed, 1)}`,
      rank: Rank.Tug,
      at,
      colour: colours.text,
      size: 13,
    });
  });
}
