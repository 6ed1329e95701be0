/** Draws what ships that pass do to vessels at rest: the clear distance, and the force of the flow. */
import { add, clamp, length, minus, onEarth, times, toScreen } from "../geometry";
import { fixed, force } from "../units";
import { Rank } from "./labels";
import { arrow, stroke } from "./marks";
import { PX_PER_MN, type Scene } from "./scene";

/** Half the length of the ticks at the ends of a distance [px]. */
const TICK_PX = 5;
/** A smaller force has no arrow [N]. */
const SMALL_N = 5e3;

export function drawPassages({ to, camera, colours, hello, frame, bodies, labels }: Scene): void {
  for (const { vessel, gap_m, between_m, force_n } of frame.passages) {
    const info = hello.vessels[vessel];
    const ship = info && bodies[info.body];
    if (!info || !ship) continue;
    const [from, till] = [toScreen(camera, between_m[0]), toScreen(camera, between_m[1])];
    const along = minus(till, from);
    const long = length(along);
    if (long > 1) {
      stroke(to, from, till, colours.text, 1.5);
      const tick = times([-along[1], along[0]], TICK_PX / long);
      for (const end of [from, till])
        stroke(to, add(end, tick), minus(end, tick), colours.text, 1.5);
    }
    labels.push({
      key: `gap ${info.name}`,
      text: `${fixed(gap_m, 0)} m clear`,
      rank: Rank.Distance,
      at: [(from[0] + till[0]) / 2, (from[1] + till[1]) / 2],
      colour: colours.text,
      size: 14,
      bold: true,
    });
    const size_n = length(force_n);
    if (size_n < SMALL_N) continue;
    const middle = toScreen(camera, [ship[0], ship[1]]);
    const px = clamp((size_n / 1e6) * PX_PER_MN, 14, 140);
    const tip = onEarth(ship, times(force_n, px / size_n / camera.pixels_per_m));
    arrow(to, middle, toScreen(camera, tip), colours.current, 4);
    labels.push({
      key: `flow ${info.name}`,
      text: `flow ${force(Math.abs(force_n[0]))} ${force_n[0] < 0 ? "astern" : "ahead"}, ${force(Math.abs(force_n[1]))} to ${force_n[1] < 0 ? "port" : "starboard"}`,
      rank: Rank.Tug,
      at: toScreen(camera, tip),
      colour: colours.current,
      size: 13,
    });
  }
}
