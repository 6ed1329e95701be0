/** Draws anchors on the bottom, with their chains. */
import { add, minus, onEarth, times, toScreen, length } from "../geometry";
import type { Pair } from "../protocol";
import { shackles, spoken, tonnes } from "../units";
import { Rank } from "./labels";
import { stroke } from "./marks";
import type { Scene } from "./scene";

/** Height of the sign of an anchor [px]. */
const SIGN = 16;

/** The sign of an anchor, upright: ring, shank, stock and arms. */
function sign(to: CanvasRenderingContext2D, [x, y]: Pair, colour: string): void {
  const top = y - SIGN / 2;
  to.beginPath();
  to.arc(x, top + 2, 2, 0, 2 * Math.PI);
  to.moveTo(x, top + 4);
  to.lineTo(x, top + SIGN);
  to.moveTo(x - 4, top + 6);
  to.lineTo(x + 4, top + 6);
  to.moveTo(x - 6, top + SIGN - 5);
  to.quadraticCurveTo(x - 5, top + SIGN, x, top + SIGN);
  to.quadraticCurveTo(x + 5, top + SIGN, x + 6, top + SIGN - 5);
  to.strokeStyle = colour;
  to.lineWidth = 2;
  to.stroke();
}

/** The part in the water is drawn thick, that on the bottom thin. */
export function drawAnchors({ to, camera, colours, hello, frame, bodies, labels }: Scene): void {
  hello.anchors.forEach((info, i) => {
    const [now, ship] = [frame.anchors[i], bodies[info.ship]];
    if (!now?.place_m || !ship) return;
    const hawse = onEarth(ship, info.hawse_m);
    const along = minus(now.place_m, hawse);
    const far = length(along);
    const lifted = far > 0 ? Math.max(0, 1 - now.on_bottom_m / far) : 1;
    const down = add(hawse, times(along, lifted));
    const [from, touch, till] = [hawse, down, now.place_m].map((at) => toScreen(camera, at)) as [
      Pair,
      Pair,
      Pair,
    ];
    const colour = now.dragging ? colours.alarm : colours.line;
    stroke(to, touch, till, colour, 1.5, [2, 4]);
    stroke(to, from, touch, colour, 2.5, [6, 3]);
    sign(to, till, now.dragging ? colours.alarm : colours.text);
    labels.push({
      key: `anchor ${info.name}`,
      text: now.dragging
        ? `${spoken(info.name)} DRAGS`
        : `${spoken(info.name)} · ${shackles(now.chain_m)} · ${tonnes(now.tension_n)}`,
      rank: now.dragging ? Rank.Parted : Rank.Anchor,
      at: till,
      colour: now.dragging ? colours.alarm : colours.text,
      size: 12,
      bold: now.dragging,
    });
  });
}
