/** Draws the ship that is being placed: her ghost, and the knob that turns her. */
import { onEarth, toScreen } from "../geometry";
import type { Placing } from "../placing";
import type { Pair } from "../protocol";
import { heading } from "../units";
import { Rank } from "./labels";
import { polygon, stroke } from "./marks";
import type { Scene } from "./scene";

const KNOB_RADIUS_PX = 11;

export function drawPlacing(
  { to, camera, colours, hello, bodies, labels }: Scene,
  placing: Placing | null,
): void {
  if (!placing?.on || placing.chosen === null) return;
  const pose = placing.pose(hello, bodies, placing.chosen);
  const outline = placing.outline(hello, placing.chosen);
  const knob = placing.knob(camera, hello, bodies);
  if (!pose || !outline || !knob) return;
  const corners = outline.map((at): Pair =>
    toScreen(camera, onEarth([...pose.at, pose.heading_rad, 0, 0, 0], at)),
  );
  to.save();
  to.fillStyle = colours.trial;
  to.strokeStyle = colours.trial;
  to.lineWidth = 2.5;
  polygon(to, corners);
  to.globalAlpha = 0.22;
  to.fill();
  to.globalAlpha = 1;
  to.stroke();
  stroke(to, toScreen(camera, pose.at), knob, colours.trial, 2);
  to.beginPath();
  to.arc(...knob, KNOB_RADIUS_PX, 0, 2 * Math.PI);
  to.fillStyle = colours.trial;
  to.fill();
  to.restore();
  labels.push({
    key: "placing",
    text: heading(pose.heading_rad, 0),
    rank: Rank.Measure,
    at: knob,
    colour: colours.trial,
    size: 13,
    bold: true,
  });
}
