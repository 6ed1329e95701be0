/** Draws where the exercise wants the anchor: a circle of the distance that is good enough. */
import { toScreen } from "../geometry";
import { Rank } from "./labels";
import { stroke } from "./marks";
import type { Scene } from "./scene";

/** Half of the cross in the middle [px]. */
const CROSS = 6;

export function drawPlace({ to, camera, colours, hello, labels }: Scene): void {
  const place = hello.exercise?.place;
  if (!place) return;
  const [x, y] = toScreen(camera, place.at_m);
  const radius = place.within_m * camera.pixels_per_m;
  to.beginPath();
  to.arc(x, y, radius, 0, 2 * Math.PI);
  to.strokeStyle = colours.text;
  to.lineWidth = 1.5;
  to.setLineDash([8, 5]);
  to.stroke();
  to.setLineDash([]);
  stroke(to, [x - CROSS, y], [x + CROSS, y], colours.text, 1.5);
  stroke(to, [x, y - CROSS], [x, y + CROSS], colours.text, 1.5);
  labels.push({
    key: "place of the anchor",
    text: `anchor here, within ${Math.round(place.within_m)} m`,
    rank: Rank.Anchor,
    at: [x, y - radius],
    colour: colours.text,
    size: 12,
  });
}
