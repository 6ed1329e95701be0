/** Draws the passage plans of the ships: corridor, track, waypoints, wheel-over points, and course and length of each leg. */
import { add, length, minus, times, toScreen, turned } from "../geometry";
import type { Pair } from "../protocol";
import { distance, heading, knots } from "../units";
import { Rank } from "./labels";
import { stroke } from "./marks";
import type { Scene } from "./scene";

const WAYPOINT_PX = 6;
/** Half the length of the stroke across the track at a wheel-over point. */
const WHEEL_PX = 11;
/** A leg that is shorter on the screen has no words [px]. */
const WORDS_PX = 110;

export function drawPassagePlan(scene: Scene): void {
  const { to, camera, colours, hello, live, labels } = scene;
  const index = live.ship();
  const plan = hello.vessels[index]?.plan;
  if (!plan) return;
  const now = scene.frame.vessels[index]?.plan;
  const line = (points: Pair[]) => {
    to.beginPath();
    for (const point of points) to.lineTo(...toScreen(camera, point));
    to.stroke();
  };
  to.save();
  to.strokeStyle = colours.plan;
  to.lineJoin = "round";
  to.lineWidth = 1;
  to.setLineDash([3, 4]);
  for (const edges of plan.corridor) edges.forEach(line);
  to.setLineDash([]);
  to.lineWidth = 2;
  line(plan.track);
  for (const wheel of plan.wheel_overs) {
    const at = toScreen(camera, wheel.at_m);
    const across = turned(wheel.course_rad - camera.up_rad, [0, WHEEL_PX]);
    // Ahead is up on the screen, and starboard to the right.
    const end: Pair = [across[1], -across[0]];
    stroke(to, minus(at, end), add(at, end), colours.plan, 3);
    labels.push({
      key: `wheel over ${wheel.waypoint}`,
      text: "wheel over",
      rank: Rank.Minute,
      at,
      off: times(end, 2.6),
      colour: colours.plan,
      size: 11,
    });
  }
  plan.waypoints.forEach(({ name, at_m, speed_mps }, i) => {
    const at = toScreen(camera, at_m);
    to.beginPath();
    to.arc(...at, WAYPOINT_PX, 0, 2 * Math.PI);
    to.fillStyle = now && i === now.leg + 1 ? colours.plan : colours.panel;
    to.fill();
    to.lineWidth = 2;
    to.stroke();
    labels.push({
      key: `waypoint ${i}`,
      text: name || `WP ${i + 1}`,
      rank: Rank.Bollard,
      at,
      off: [0, -18],
      colour: colours.plan,
      size: 13,
      bold: true,
    });
    const from = plan.waypoints[i - 1];
    if (!from) return;
    const start = toScreen(camera, from.at_m);
    const leg = minus(at_m, from.at_m);
    if (length(minus(at, start)) < WORDS_PX) return;
    const speed = speed_mps === null ? "" : ` ${knots(speed_mps)}`;
    labels.push({
      key: `leg ${i}`,
      text: `${heading(Math.atan2(leg[1], leg[0]))} ${distance(length(leg))}${speed}`,
      rank: Rank.Minute,
      at: [(start[0] + at[0]) / 2, (start[1] + at[1]) / 2],
      off: [0, 16],
      colour: colours.plan,
      size: 12,
    });
  });
  to.restore();
}
