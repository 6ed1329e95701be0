/** Drawing primitives of the plan and the conning display. */
import type { Pair } from "../protocol";

export const FONT = "system-ui, 'DejaVu Sans', sans-serif";

export function polygon(to: CanvasRenderingContext2D, points: Pair[]): void {
  to.beginPath();
  points.forEach(([x, y], i) => (i === 0 ? to.moveTo(x, y) : to.lineTo(x, y)));
  to.closePath();
}

export function stroke(
  to: CanvasRenderingContext2D,
  from: Pair,
  end: Pair,
  colour: string,
  width: number,
  dash: number[] = [],
): void {
  to.strokeStyle = colour;
  to.lineWidth = width;
  to.setLineDash(dash);
  to.beginPath();
  to.moveTo(...from);
  to.lineTo(...end);
  to.stroke();
  to.setLineDash([]);
}

/** An arrow with a filled head; nothing if it is shorter than a pixel. */
export function arrow(
  to: CanvasRenderingContext2D,
  from: Pair,
  end: Pair,
  colour: string,
  width = 3,
): void {
  const [dx, dy] = [end[0] - from[0], end[1] - from[1]];
  const long = Math.hypot(dx, dy);
  if (long < 1) return;
  const head = Math.min(long, 4 + width * 2.6);
  const [ux, uy] = [dx / long, dy / long];
  const neck: Pair = [end[0] - ux * head, end[1] - uy * head];
  const half = head * 0.55;
  stroke(to, from, [neck[0] + ux, neck[1] + uy], colour, width);
  to.fillStyle = colour;
  polygon(to, [
    end,
    [neck[0] - uy * half, neck[1] + ux * half],
    [neck[0] + uy * half, neck[1] - ux * half],
  ]);
  to.fill();
}

/** A label that is off the canvas by no more than this is moved onto it. */
const EDGE_PX = 60;

export interface LabelStyle {
  colour: string;
  ground: string;
  size?: number;
  bold?: boolean;
  align?: "left" | "center" | "right";
}

/** A text with its own background. `within`: it is kept on the canvas while its point is on it or close to it. */
export function label(
  to: CanvasRenderingContext2D,
  text: string,
  at: Pair,
  style: LabelStyle,
  within?: { width: number; height: number },
): void {
  if (
    within &&
    (at[0] < -EDGE_PX ||
      at[1] < -EDGE_PX ||
      at[0] > within.width + EDGE_PX ||
      at[1] > within.height + EDGE_PX)
  )
    return;
  const size = style.size ?? 14;
  to.font = `${style.bold ? 600 : 400} ${size}px ${FONT}`;
  const width = to.measureText(text).width + 8;
  const high = size + 6;
  const align = style.align ?? "center";
  let left = align === "left" ? at[0] : align === "right" ? at[0] - width : at[0] - width / 2;
  let top = at[1] - high / 2;
  if (within) {
    left = Math.min(within.width - width - 2, Math.max(2, left));
    top = Math.min(within.height - high - 2, Math.max(2, top));
  }
  to.fillStyle = style.ground;
  to.fillRect(left, top, width, high);
  to.fillStyle = style.colour;
  to.textAlign = "left";
  to.textBaseline = "middle";
  to.fillText(text, left + 4, top + high / 2 + 0.5);
}
