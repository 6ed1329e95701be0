/** The conning display: heading and turn, speeds at the ends, rudder, shaft, thrusters, wind, depth; ordered and actual. */
import { FONT, arrow, polygon, stroke } from "../draw/marks";
import type { Live } from "../live";
import { type Palette, palette } from "../palette";
import type { BodyNow, Frame, Hello, Pair, VesselInfo, VesselNow } from "../protocol";
import { canvas, h, setAttribute } from "../ui/dom";
import {
  fixed,
  heading,
  rateOfTurn,
  sided,
  toDegrees,
  toKnots,
  toRadians,
  wrapped,
} from "../units";
import type { View } from "./view";

/** Least size of the sheet on which the display is laid out. The sheet has the shape of the canvas and is scaled to it. */
const LEAST = { width: 400, height: 400 };

export class Conning implements View {
  private readonly surface = canvas("Conning display");
  readonly root = h("div", { class: "conning" }, this.surface.root);

  constructor(private readonly live: Live) {}

  tick(frame: Frame, hello: Hello): void {
    const index = this.live.conned();
    const [info, now] = [hello.vessels[index], frame.vessels[index]];
    const body = frame.bodies[info?.body ?? -1];
    if (!info || !now || !body) return;
    setAttribute(
      this.surface.root,
      "aria-label",
      `Conning display: heading ${heading(body[2])}, rudder ${sided(now.rudder.now_rad)}, shaft ${fixed(now.shaft.now * 100, 0)} per cent, ahead ${fixed(toKnots(now.ground_mps[0]), 1)} knots`,
    );
  }

  draw(now_ms: number): void {
    const begun = this.surface.begin();
    const { hello, frame } = this.live;
    if (!begun || !hello || !frame) return;
    const { to, width, height } = begun;
    const index = this.live.conned();
    const [info, now] = [hello.vessels[index], frame.vessels[index]];
    const body = this.live.bodies(now_ms)[info?.body ?? -1];
    const colours = palette();
    to.fillStyle = colours.panel;
    to.fillRect(0, 0, width, height);
    if (!info || !now || !body) return;
    const scale = Math.min(width / LEAST.width, height / LEAST.height);
    to.scale(scale, scale);
    const sheet = new Sheet(to, colours, width / scale, height / scale);
    drawHeading(sheet, body, now);
    drawTurn(sheet, body);
    drawShip(sheet, info, now);
    drawWind(sheet, frame, body);
    drawDepth(sheet, hello, info, now);
    drawShaft(sheet, info, now);
    if (info.azimuths.length > 0) drawAzimuths(sheet, info, now);
    else drawRudder(sheet, info, now);
  }
}

class Sheet {
  /** The ship's picture, from bow to stern. */
  readonly bow = 142;
  readonly stern: number;

  constructor(
    readonly to: CanvasRenderingContext2D,
    readonly colours: Palette,
    readonly width: number,
    readonly height: number,
  ) {
    this.stern = height - 92;
  }

  get middle(): number {
    return this.width / 2;
  }

  /** Position of the side columns: near the ship on a broad sheet. */
  column(side: -1 | 1): number {
    return this.middle + side * Math.min(this.width / 2 - 52, 260);
  }

  text(
    text: string,
    x: number,
    y: number,
    size: number,
    colour = this.colours.text,
    align: CanvasTextAlign = "center",
    bold = false,
  ): void {
    this.to.font = `${bold ? 700 : 400} ${size}px ${FONT}`;
    this.to.fillStyle = colour;
    this.to.textAlign = align;
    this.to.textBaseline = "middle";
    this.to.fillText(text, x, y);
  }

  box(x: number, y: number, width: number, height: number, colour = this.colours.edge): void {
    this.to.strokeStyle = colour;
    this.to.lineWidth = 1.5;
    this.to.strokeRect(x, y, width, height);
  }

  bar(x: number, y: number, width: number, height: number, colour: string): void {
    this.to.fillStyle = colour;
    this.to.fillRect(
      Math.min(x, x + width),
      Math.min(y, y + height),
      Math.abs(width),
      Math.abs(height),
    );
  }

  /** The pointer of an order: a hollow triangle with its tip at a point. */
  pointer(tip: Pair, from: "above" | "left"): void {
    const [x, y] = tip;
    polygon(
      this.to,
      from === "above"
        ? [
            [x, y],
            [x - 7, y - 12],
            [x + 7, y - 12],
          ]
        : [
            [x, y],
            [x - 12, y - 7],
            [x - 12, y + 7],
          ],
    );
    this.to.fillStyle = this.colours.panel;
    this.to.fill();
    this.to.strokeStyle = this.colours.text;
    this.to.lineWidth = 2;
    this.to.stroke();
  }
}

function drawHeading(sheet: Sheet, body: BodyNow, now: VesselNow): void {
  const { colours, to, middle } = sheet;
  const [left, right, top] = [10, sheet.width - 10, 42];
  sheet.text(heading(body[2]), middle, 21, 34, colours.text, "center", true);
  const speed = Math.hypot(body[3], body[4]);
  sheet.text(
    `COG ${speed < 0.02 ? "–" : heading(Math.atan2(body[4], body[3]))}`,
    right,
    12,
    15,
    colours.text,
    "right",
  );
  sheet.text(`SOG ${fixed(toKnots(speed), 2)} kn`, right, 30, 15, colours.text, "right");
  sheet.text("steered by", left, 12, 13, colours.dim, "left");
  sheet.text(now.pilot, left, 30, 15, colours.text, "left");
  sheet.box(left, top, right - left, 32);
  to.save();
  to.beginPath();
  to.rect(left, top, right - left, 32);
  to.clip();
  const per = Math.max(5, (right - left) / 90);
  const reach = (right - left) / 2 / per;
  const here = toDegrees(body[2]);
  for (let degree = Math.ceil(here - reach); degree <= here + reach; degree++) {
    const x = middle + (degree - here) * per;
    const long = degree % 10 === 0 ? 11 : degree % 5 === 0 ? 8 : 4;
    stroke(to, [x, top], [x, top + long], colours.text, 1);
    if (degree % 10 === 0) sheet.text(heading(toRadians(degree), 0).slice(0, 3), x, top + 22, 15);
  }
  if (now.course_rad !== null) {
    const x = middle + toDegrees(wrapped(now.course_rad - body[2])) * per;
    stroke(to, [x, top], [x, top + 32], colours.path, 4);
  }
  to.restore();
  stroke(to, [middle, top - 2], [middle, top + 32], colours.alarm, 2);
}

function drawTurn(sheet: Sheet, body: BodyNow): void {
  const { colours, to, middle } = sheet;
  const rot = rateOfTurn(body[5]);
  const [half, top] = [Math.min(sheet.width / 2 - 74, 240), 84];
  // A square-root scale, fine near zero, where rates are while berthing.
  const place = (value: number) =>
    middle + Math.sign(value) * Math.sqrt(Math.min(1, Math.abs(value) / 60)) * half;
  sheet.box(middle - half, top, half * 2, 16);
  sheet.bar(middle, top + 2, place(rot) - middle, 12, rot < 0 ? colours.port : colours.starboard);
  for (const mark of [-60, -20, -5, 0, 5, 20, 60]) {
    stroke(to, [place(mark), top], [place(mark), top + 16], colours.text, 1);
    sheet.text(String(Math.abs(mark)), place(mark), top + 26, 13, colours.dim);
  }
  sheet.text("ROT", middle - half - 8, top + 8, 15, colours.dim, "right");
  const way = Math.abs(rot) < 0.05 ? "" : rot < 0 ? "P " : "S ";
  sheet.text(
    way + fixed(Math.abs(rot), 1),
    middle + half + 8,
    top + 8,
    18,
    colours.text,
    "left",
    true,
  );
  sheet.text("°/min", middle + half + 16, top + 26, 13, colours.dim, "left");
}

/** The ship's outline from above, with her speeds ahead and at the ends, and her thrusters. */
function drawShip(sheet: Sheet, info: VesselInfo, now: VesselNow): void {
  const { colours, to, middle: x, bow, stern } = sheet;
  const half = 27;
  polygon(to, [
    [x, bow - 16],
    [x + 14, bow + 4],
    [x + half, bow + 36],
    [x + half, stern - 10],
    [x + half - 8, stern],
    [x - half + 8, stern],
    [x - half, stern - 10],
    [x - half, bow + 36],
    [x - 14, bow + 4],
  ]);
  to.fillStyle = colours.bg;
  to.fill();
  to.strokeStyle = colours.own_edge;
  to.lineWidth = 2;
  to.stroke();
  for (const [y, speed] of [
    [bow + 6, now.bow_mps],
    [stern - 12, now.stern_mps],
  ] as const) {
    const side = Math.sign(speed) || 1;
    const long = Math.min(34, Math.abs(speed) * 110);
    if (Math.abs(speed) >= 0.005)
      arrow(to, [x + side * (half + 2), y], [x + side * (half + 8 + long), y], colours.path, 5);
    // The value is on the side to which she moves, over the arrow.
    sheet.text(
      `${fixed(Math.abs(speed), 2)} m/s`,
      x + side * 69,
      y - 17,
      15,
      colours.path,
      "center",
      true,
    );
  }
  const ahead = now.ground_mps[0];
  const y = (bow + stern) / 2 + 8;
  const way = Math.sign(ahead);
  if (Math.abs(ahead) > 0.005)
    arrow(
      to,
      [x, y - way * 16],
      [x, y - way * (22 + Math.min(26, Math.sqrt(Math.abs(ahead)) * 14))],
      colours.path,
      5,
    );
  sheet.text(fixed(Math.abs(toKnots(ahead)), 2), x, y - 4, 20, colours.text, "center", true);
  sheet.text(ahead < -0.005 ? "kn astn" : "kn", x, y + 13, 13, colours.dim);
  info.thrusters.forEach((thruster, i) => {
    const state = now.thrusters[i];
    if (!state) return;
    const level = thruster.along_m > 0 ? bow + 42 : stern - 40;
    const reach = 66;
    sheet.box(x - reach, level - 6, reach * 2, 12);
    sheet.bar(x, level - 4, state.now * reach, 8, state.now < 0 ? colours.port : colours.starboard);
    sheet.pointer([x + state.order * reach, level - 5], "above");
    sheet.text(
      `${state.now < 0 ? "P " : state.now > 0 ? "S " : ""}${fixed(Math.abs(state.now) * 100, 0)} %`,
      x + reach + 6,
      level + 1,
      14,
      colours.text,
      "left",
    );
    sheet.text("thr", x - reach - 6, level + 1, 13, colours.dim, "right");
  });
}

function drawWind(sheet: Sheet, frame: Frame, body: BodyNow): void {
  const { colours, to } = sheet;
  const [x, y, r] = [sheet.column(-1), sheet.bow + 26, 34];
  to.beginPath();
  to.arc(x, y, r, 0, 2 * Math.PI);
  to.strokeStyle = colours.edge;
  to.lineWidth = 1.5;
  to.stroke();
  polygon(to, [
    [x, y - 15],
    [x + 6, y - 4],
    [x + 6, y + 13],
    [x - 6, y + 13],
    [x - 6, y - 4],
  ]);
  to.strokeStyle = colours.dim;
  to.stroke();
  const on = (angle: number, far: number): Pair => [
    x + Math.sin(angle) * far,
    y - Math.cos(angle) * far,
  ];
  const from = wrapped(frame.wind.from_rad - body[2]);
  if (frame.wind.speed_mps > 0.1) arrow(to, on(from, r + 8), on(from, r - 20), colours.wind, 4);
  const set = wrapped(frame.current.to_rad - body[2]);
  if (frame.current.speed_mps > 0.01)
    arrow(to, on(set, r - 24), on(set, r - 3), colours.current, 4);
  sheet.text(
    `${fixed(toKnots(frame.wind.speed_mps), 0)} kn ${sided(from)}`,
    x,
    y + r + 17,
    16,
    colours.wind,
    "center",
    true,
  );
  sheet.text(
    `set ${fixed(toKnots(frame.current.speed_mps), 1)} kn`,
    x,
    y + r + 36,
    14,
    colours.current,
  );
}

function drawDepth(sheet: Sheet, hello: Hello, info: VesselInfo, now: VesselNow): void {
  const { colours } = sheet;
  const under = now.under_keel_m;
  const bad = now.aground || (under !== null && under < 0.5);
  const [x, y] = [sheet.column(-1), sheet.stern - 50];
  sheet.text("under keel", x, y, 13, colours.dim);
  sheet.text(
    now.aground ? "AGROUND" : under === null ? "–" : `${fixed(under, 1)} m`,
    x,
    y + 21,
    now.aground ? 18 : 23,
    bad ? colours.alarm : colours.text,
    "center",
    true,
  );
  sheet.text(
    `${fixed(info.draught_m, 1)}${hello.depth_m === null ? " m draught" : ` in ${fixed(hello.depth_m, 1)} m`}`,
    x,
    y + 42,
    13,
    colours.dim,
  );
}

function drawShaft(sheet: Sheet, info: VesselInfo, now: VesselNow): void {
  if (info.full_rps === null) return;
  const { colours, to } = sheet;
  const [x, top, bottom] = [sheet.column(1) + 16, sheet.bow - 12, sheet.stern - 36];
  const [middle, half] = [(top + bottom) / 2, (bottom - top) / 2];
  sheet.box(x - 14, top, 28, bottom - top);
  sheet.bar(
    x - 12,
    middle,
    24,
    -now.shaft.now * half,
    now.shaft.now < 0 ? colours.port : colours.starboard,
  );
  for (const mark of [-1, -0.5, 0, 0.5, 1])
    stroke(
      to,
      [x - 14, middle - mark * half],
      [x + 14, middle - mark * half],
      colours.text,
      mark === 0 ? 2 : 1,
    );
  sheet.pointer([x - 14, middle - now.shaft.order * half], "left");
  sheet.text(
    `${fixed(now.shaft.now * info.full_rps * 60, 0)} rpm`,
    x,
    bottom + 15,
    18,
    colours.text,
    "center",
    true,
  );
  sheet.text(
    `order ${fixed(now.shaft.order * info.full_rps * 60, 0)}`,
    x,
    bottom + 34,
    14,
    colours.dim,
  );
}

function drawRudder(sheet: Sheet, info: VesselInfo, now: VesselNow): void {
  if (info.rudder_stop_rad === null) return;
  const { colours, to, middle: x } = sheet;
  const [half, y] = [Math.min(sheet.width / 2 - 20, 300), sheet.height - 74];
  const place = (rad: number) => x + (rad / (info.rudder_stop_rad ?? 1)) * half;
  sheet.box(x - half, y, half * 2, 20);
  sheet.bar(
    x,
    y + 2,
    place(now.rudder.now_rad) - x,
    16,
    now.rudder.now_rad < 0 ? colours.port : colours.starboard,
  );
  const stop = Math.round(toDegrees(info.rudder_stop_rad));
  for (let degree = -stop; degree <= stop; degree += 5) {
    const at = place(toRadians(degree));
    stroke(to, [at, y], [at, y + (degree % 10 === 0 ? 20 : 8)], colours.text, degree === 0 ? 2 : 1);
    if (degree % 10 === 0)
      sheet.text(
        `${degree < 0 ? "P " : degree > 0 ? "S " : ""}${Math.abs(degree)}`,
        at,
        y + 30,
        14,
        degree < 0 ? colours.port : degree > 0 ? colours.starboard : colours.text,
      );
  }
  sheet.pointer([place(now.rudder.order_rad), y], "above");
  sheet.text(`RUDDER ${sided(now.rudder.now_rad)}`, x - 6, y + 56, 22, colours.text, "right", true);
  sheet.text(`order ${sided(now.rudder.order_rad)}`, x + 12, y + 57, 16, colours.dim, "left");
}

function drawAzimuths(sheet: Sheet, info: VesselInfo, now: VesselNow): void {
  const { colours, to } = sheet;
  info.azimuths.forEach((unit, i) => {
    const state = now.azimuths[i];
    if (!state) return;
    const [x, y, r] = [
      sheet.middle + (i - (info.azimuths.length - 1) / 2) * 190,
      sheet.height - 48,
      36,
    ];
    to.beginPath();
    to.arc(x, y, r, 0, 2 * Math.PI);
    to.strokeStyle = colours.edge;
    to.lineWidth = 1.5;
    to.stroke();
    const on = (angle: number, far: number): Pair => [
      x + Math.sin(angle) * far,
      y - Math.cos(angle) * far,
    ];
    stroke(
      to,
      on(state.direction_order_rad, r - 8),
      on(state.direction_order_rad, r + 4),
      colours.text,
      3,
    );
    if (state.power > 0.01)
      arrow(to, [x, y], on(state.direction_rad, 10 + (r - 10) * state.power), colours.starboard, 5);
    else stroke(to, [x, y], on(state.direction_rad, 12), colours.dim, 2);
    sheet.text(unit.name, x + r + 8, y - 9, 13, colours.dim, "left");
    sheet.text(
      `${fixed(state.power * 100, 0)} %`,
      x + r + 8,
      y + 10,
      18,
      colours.text,
      "left",
      true,
    );
  });
}
