/** Draws the measured ship beside the simulated ones: her track and her outline, dashed, with the time to her touch. */
import { add, toScreen, turned } from "../geometry";
import { ghostAt, ghostText } from "../ghost";
import { Rank } from "./labels";
import { polygon } from "./marks";
import type { Scene } from "./scene";

export function drawGhost({ to, camera, colours, hello, t_s, labels }: Scene): void {
  const { ghost } = hello;
  const now = ghost && ghostAt(ghost, t_s);
  if (!now) return;
  const at = toScreen(camera, [now[1], now[2]]);
  to.save();
  to.strokeStyle = colours.text;
  to.lineWidth = 1;
  to.globalAlpha = 0.5;
  to.setLineDash([2, 4]);
  to.beginPath();
  ghost.points.forEach(([, north, east], i) => {
    const point = toScreen(camera, [north, east]);
    if (i === 0) to.moveTo(...point);
    else to.lineTo(...point);
  });
  to.stroke();
  to.globalAlpha = 1;
  to.lineWidth = 2;
  to.setLineDash([7, 4]);
  polygon(
    to,
    ghost.outline.map((corner) => toScreen(camera, add([now[1], now[2]], turned(now[3], corner)))),
  );
  to.stroke();
  to.restore();
  labels.push({
    key: "ghost",
    text: ghostText(ghost, t_s),
    rank: Rank.Tug,
    at,
    colour: colours.text,
    size: 13,
  });
}
