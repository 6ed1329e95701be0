/** Drawing primitives of the plan and the conning display. */
import type { Pair } from "../protocol";
import { type Label, type Placed, nearest } from "./labels";

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

export const labelFont = ({ size, bold }: Pick<Label, "size" | "bold">): string =>
  `${bold ? 600 : 400} ${size}px ${FONT}`;

/** A label on its own ground, with a leader to its point if it is away from it. */
export function drawLabel(
  to: CanvasRenderingContext2D,
  { label, box, leads }: Placed,
  ground: string,
): void {
  const [left, top, width, high] = box;
  if (leads) stroke(to, label.at, nearest(box, label.at), label.colour, 1);
  to.fillStyle = ground;
  to.fillRect(left, top, width, high);
  to.font = labelFont(label);
  to.fillStyle = label.colour;
  to.textAlign = "left";
  to.textBaseline = "middle";
  to.fillText(label.text, left + 4, top + high / 2 + 0.5);
}
