/** Lights of the chart: a flare by day, at dusk and at night a lamp that flashes by its character; sectors as arcs between legs. */
import { isLit } from "../character";
import type { Palette } from "../palette";
import type { ChartInfo, Pair } from "../protocol";

const ARC_PX = 30;
const LEG_PX = 46;

export const lightColour = (feature: ChartInfo, colours: Palette): string =>
  ({
    red: colours.port,
    green: colours.starboard,
    yellow: colours.mark_yellow,
    black: colours.text,
    white: colours.lamp,
  })[feature.colour ?? "white"];

/** `t_s`: time of the run. `isDark`: lights flash. */
export function drawLight(
  to: CanvasRenderingContext2D,
  [x, y]: Pair,
  feature: ChartInfo,
  up_rad: number,
  colours: Palette,
  { t_s, isDark }: { t_s: number; isDark: boolean },
): void {
  to.save();
  to.translate(x, y);
  to.strokeStyle = to.fillStyle = lightColour(feature, colours);
  if (feature.sector_rad) {
    // A direction from north is an angle from east on the screen; both run clockwise.
    const [from, given] = feature.sector_rad.map((of) => of - up_rad - Math.PI / 2) as Pair;
    const until = given <= from ? given + 2 * Math.PI : given;
    to.lineWidth = 3.5;
    to.beginPath();
    to.arc(0, 0, ARC_PX, from, until);
    to.stroke();
    to.strokeStyle = colours.dim;
    to.lineWidth = 0.8;
    to.setLineDash([4, 4]);
    to.beginPath();
    for (const leg of [from, until]) {
      to.moveTo(0, 0);
      to.lineTo(Math.cos(leg) * LEG_PX, Math.sin(leg) * LEG_PX);
    }
    to.stroke();
    to.setLineDash([]);
  }
  if (isDark) lamp(to, isLit(feature.character ?? "", feature.period_s, t_s));
  else flare(to, colours);
  to.restore();
}

function lamp(to: CanvasRenderingContext2D, isOn: boolean): void {
  if (isOn) {
    to.globalAlpha = 0.3;
    to.beginPath();
    to.arc(0, 0, 9, 0, 2 * Math.PI);
    to.fill();
    to.globalAlpha = 1;
  }
  to.beginPath();
  to.arc(0, 0, isOn ? 4 : 1.5, 0, 2 * Math.PI);
  to.fill();
}

/** The flare of charts: a drop whose point is at the light. */
function flare(to: CanvasRenderingContext2D, colours: Palette): void {
  to.rotate(Math.PI / 4);
  to.beginPath();
  to.moveTo(0, 0);
  to.quadraticCurveTo(7, -10, 3.2, -17);
  to.arc(0, -17, 3.2, 0, Math.PI, true);
  to.quadraticCurveTo(-7, -10, 0, 0);
  to.fill();
  to.strokeStyle = colours.mark_edge;
  to.lineWidth = 0.8;
  to.stroke();
}
