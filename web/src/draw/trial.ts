/** Draws the trial manoeuvre over the present path: the ghost's track and hulls, and the word TRIAL. */
import { add, toScreen, turned } from "../geometry";
import type { Pair, ShipPath } from "../protocol";
import type { Trial } from "../trial";
import { type Box, Rank } from "./labels";
import { FONT } from "./marks";
import type { Scene } from "./scene";

/** Hulls that are drawn along a path. */
const HULLS = 6;

/**
 * The ghosts of all ships of the trial; the one that the page is about is drawn whole, others as a track with a last hull.
 * Returns what labels must not cover.
 */
export function drawTrial(scene: Scene, trial: Trial | null): Box[] {
  if (!trial?.on) return [];
  trial.answer?.paths.forEach((path, i) => drawGhost(scene, path, i === 0));
  return [drawWord(scene)];
}

/** The word TRIAL, so that nobody takes the ghost for what happens. */
function drawWord({ to, camera, colours }: Scene): Box {
  const [wide, tall, top] = [92, 32, 10];
  const box: Box = [camera.width / 2 - wide / 2, top, wide, tall];
  to.fillStyle = colours.trial;
  to.fillRect(...box);
  to.fillStyle = colours.trial_text;
  to.font = `700 22px ${FONT}`;
  to.textAlign = "center";
  to.textBaseline = "middle";
  to.fillText("TRIAL", camera.width / 2, top + tall / 2 + 1);
  return box;
}

function drawGhost(
  { to, camera, colours, hello, frame, labels }: Scene,
  of: ShipPath,
  whole: boolean,
): void {
  const outline = hello.bodies[hello.vessels[of.vessel]?.body ?? -1]?.outline;
  const path = of.path.filter(([t_s]) => t_s >= frame.t_s);
  const [first, last] = [path[0], path.at(-1)];
  if (!outline || !first || !last) return;
  const long_s = last[0] - first[0];
  to.save();
  to.strokeStyle = colours.trial;
  to.lineWidth = whole ? 3 : 2;
  to.beginPath();
  path.forEach(([, north, east], i) => {
    const at = toScreen(camera, [north, east]);
    if (i === 0) to.moveTo(...at);
    else to.lineTo(...at);
  });
  to.stroke();
  to.fillStyle = colours.trial;
  to.lineWidth = 2;
  let next_s = whole ? first[0] + long_s / HULLS : last[0];
  for (const point of path) {
    if (point[0] < next_s - 1e-6) continue;
    next_s += long_s / HULLS;
    const corners = outline.map((at): Pair =>
      toScreen(camera, add([point[1], point[2]], turned(point[3], at))),
    );
    to.beginPath();
    corners.forEach((at, i) => (i === 0 ? to.moveTo(...at) : to.lineTo(...at)));
    to.closePath();
    to.globalAlpha = point === last ? 0.28 : 0.1;
    to.fill();
    to.globalAlpha = 1;
    to.stroke();
  }
  to.restore();
  if (!whole) return;
  labels.push({
    key: "trial",
    text: `${Math.round((last[0] - frame.t_s) / 6) / 10} min`,
    rank: Rank.Minute,
    at: toScreen(camera, [last[1], last[2]]),
    colour: colours.trial,
    size: 12,
    bold: true,
  });
}
