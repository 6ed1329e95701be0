/**
 * Buoys and beacons by IALA's system: shape, colours and topmark say the same, so that neither colour nor shape is needed alone.
 * Lateral marks have the colours of the chart: red to port in region A, green to port in region B; a can is to port in both.
 */
import type { Palette } from "../palette";
import type { ChartInfo, Pair } from "../protocol";
import { polygon } from "./marks";

/** Half the size of a mark [px]. */
export const MARK_PX = 6;

type Form = NonNullable<ChartInfo["form"]>;

/** Points of an outline, in half sizes from the waterline at the middle, up negative. */
const FORMS: Record<Exclude<Form, "ball">, Pair[]> = {
  can: [
    [-0.8, 0],
    [-0.8, -1.7],
    [0.8, -1.7],
    [0.8, 0],
  ],
  cone: [
    [-1, 0],
    [0, -2],
    [1, 0],
  ],
  pillar: [
    [-1, 0],
    [-0.75, -0.6],
    [-0.3, -0.6],
    [-0.22, -2.4],
    [0.22, -2.4],
    [0.3, -0.6],
    [0.75, -0.6],
    [1, 0],
  ],
  spar: [
    [-0.2, 0.3],
    [-0.2, -2.4],
    [0.2, -2.4],
    [0.2, 0.3],
  ],
  barrel: [
    [-1.1, 0],
    [-1.1, -1],
    [1.1, -1],
    [1.1, 0],
  ],
  tower: [
    [-0.8, 0],
    [-0.45, -2.4],
    [0.45, -2.4],
    [0.8, 0],
  ],
};

/** The colours of marks. */
export type MarkColours = Pick<
  Palette,
  "port" | "starboard" | "mark_yellow" | "mark_white" | "mark_black"
>;

/** Colours of the bands from the top down; a mark of one colour has one. */
export function bands(feature: ChartInfo, colours: MarkColours): string[] {
  const [black, yellow, red] = [colours.mark_black, colours.mark_yellow, colours.port];
  switch (feature.meaning) {
    case "north":
      return [black, yellow];
    case "south":
      return [yellow, black];
    case "east":
      return [black, yellow, black];
    case "west":
      return [yellow, black, yellow];
    case "isolated_danger":
      return [black, red, black];
    default:
      return [
        {
          red: colours.port,
          green: colours.starboard,
          yellow: colours.mark_yellow,
          black,
          white: colours.mark_white,
        }[feature.colour ?? "white"],
      ];
  }
}

/** The shape of a mark: as the chart says, else by the side that it is on. */
export function formOf({ form, side, meaning, kind }: ChartInfo): Form {
  if (form) return form;
  if (side) return side === "port" ? "can" : "cone";
  if (meaning === "safe_water") return "ball";
  if (kind === "beacon") return "tower";
  return meaning === null || meaning === "other" || meaning === "special" ? "ball" : "pillar";
}

/** Draws a mark whose waterline is at a point of the screen. */
export function drawMark(
  to: CanvasRenderingContext2D,
  [x, y]: Pair,
  feature: ChartInfo,
  colours: Palette,
): void {
  const s = MARK_PX;
  const form = formOf(feature);
  to.save();
  to.translate(x, y);
  to.strokeStyle = colours.mark_edge;
  to.lineWidth = 1.1;
  if (feature.kind === "beacon") {
    to.beginPath();
    to.moveTo(-s, 3);
    to.lineTo(s, 3);
    to.moveTo(0, 0);
    to.lineTo(0, 3);
    to.stroke();
  } else {
    // The place of a buoy is the ring on its waterline.
    to.beginPath();
    to.arc(0, 0, 1.8, 0, 2 * Math.PI);
    to.stroke();
  }
  const top = form === "ball" ? -1.7 * s : Math.min(...FORMS[form].map((p) => p[1])) * s;
  outline(to, form);
  to.save();
  to.clip();
  const all = bands(feature, colours);
  all.forEach((colour, i) => {
    to.fillStyle = colour;
    const high = -top / all.length;
    to.fillRect(-1.5 * s, top + i * high - 0.5, 3 * s, high + 2.5);
  });
  if (feature.meaning === "safe_water") {
    to.fillStyle = colours.port;
    for (const left of [-0.75, 0.25]) to.fillRect(left * s, top, 0.5 * s, -top + 2);
  }
  to.restore();
  outline(to, form);
  to.stroke();
  topmark(to, top - 1.5, feature, colours);
  to.restore();
}

function outline(to: CanvasRenderingContext2D, form: Form): void {
  const s = MARK_PX;
  if (form === "ball") {
    to.beginPath();
    to.arc(0, -0.85 * s, 0.85 * s, 0, 2 * Math.PI);
  } else
    polygon(
      to,
      FORMS[form].map(([px, py]): Pair => [px * s, py * s]),
    );
}

/** The topmark, from `foot` upwards. Lateral marks whose body is a can or a cone need none. */
function topmark(
  to: CanvasRenderingContext2D,
  foot: number,
  feature: ChartInfo,
  colours: Palette,
): void {
  const s = 0.5 * MARK_PX;
  const cone = (low: number, pointsUp: boolean) => {
    const [base, tip] = pointsUp ? [low, low - 1.6 * s] : [low - 1.6 * s, low];
    polygon(to, [
      [-s, base],
      [0, tip],
      [s, base],
    ]);
    to.fill();
  };
  const ball = (middle: number) => {
    to.beginPath();
    to.arc(0, middle, 0.8 * s, 0, 2 * Math.PI);
    to.fill();
  };
  to.fillStyle = colours.mark_black;
  const upper = foot - 2 * s;
  switch (feature.meaning) {
    case "north":
      cone(foot, true);
      cone(upper, true);
      break;
    case "south":
      cone(foot, false);
      cone(upper, false);
      break;
    case "east":
      cone(foot, false);
      cone(upper, true);
      break;
    case "west":
      cone(foot, true);
      cone(upper, false);
      break;
    case "isolated_danger":
      ball(foot - 0.8 * s);
      ball(foot - 2.6 * s);
      break;
    case "safe_water":
      to.fillStyle = colours.port;
      if (feature.form !== "ball" && feature.form !== null) ball(foot - 0.8 * s);
      break;
    case "special":
      to.strokeStyle = colours.mark_yellow;
      to.lineWidth = 1.8;
      to.beginPath();
      to.moveTo(-s, foot - 2 * s);
      to.lineTo(s, foot);
      to.moveTo(s, foot - 2 * s);
      to.lineTo(-s, foot);
      to.stroke();
      break;
    case "lateral": {
      const form = formOf(feature);
      if (form === "can" || form === "cone" || !feature.side) break;
      to.fillStyle = bands(feature, colours)[0] ?? colours.mark_black;
      if (feature.side === "starboard") cone(foot, true);
      else to.fillRect(-0.8 * s, foot - 1.7 * s, 1.6 * s, 1.7 * s);
      break;
    }
    default:
      break;
  }
}
