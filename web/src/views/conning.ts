/** The conning display: heading and turn, speeds at the ends, rudder, shaft, thrusters, wind, depth; ordered and actual. */
import { FONT, arrow, polygon, stroke } from "../draw/marks";
import type { Live } from "../live";
import { type Palette, palette } from "../palette";
import type { BodyNow, Frame, Hello, Pair, VesselInfo, VesselNow } from "../protocol";
import { canvas, h, setAttribute } from "../ui/dom";
import { fixed, heading, rateOfTurn, sided, toDegrees, toKnots, toRadians, wrapped } from "../units";
import type { View } from "./view";

/** The display is laid out on a sheet of this size and scaled to what there is. */
const SHEET = { width: 420, height: 500 };

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
    const scale = Math.min(width / SHEET.width, height / SHEET.height);
    to.translate((width - SHEET.width * scale) / 2, (height - SHEET.height * scale) / 2);
    to.scale(scale, scale);
    const sheet = new Sheet(to, colours);
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
  constructor(readonly to: CanvasRenderingContext2D, readonly colours: Palette) {}

  text(text: string, x: number, y: number, size: number, colour = this.colours.text, align: CanvasTextAlign = "center", bold = false): void {
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
    this.to.fillRect(Math.min(x, x + width), Math.min(y, y + height), Math.abs(width), Math.abs(height));
  }

  /** A pointer at an order: a hollow triangle whose tip is at a place. */
  pointer(tip: Pair, from: "above" | "left"): void {
    const [x, y] = tip;
    polygon(this.to, from === "above" ? [[x, y], [x - 7, y - 12], [x + 7, y - 12]] : [[x, y], [x - 12, y - 7], [x - 12, y + 7]]);
    this.to.fillStyle = this.colours.panel;
    this.to.fill();
    this.to.strokeStyle = this.colours.text;
    this.to.lineWidth = 2;
    this.to.stroke();
  }
}

function drawHeading(sheet: Sheet, body: BodyNow, now: VesselNow): void {
  const { colours, to } = sheet;
  const [left, right, top] = [10, SHEET.width - 10, 44];
  sheet.text("HDG", 150, 20, 13, colours.dim, "right");
  sheet.text(heading(body[2]), 210, 20, 32, colours.text, "center", true);
  const speed = Math.hypot(body[3], body[4]);
  sheet.text(`COG ${speed < 0.02 ? "–" : heading(Math.atan2(body[4], body[3]))}`, right, 13, 13, colours.dim, "right");
  sheet.text(`SOG ${fixed(toKnots(speed), 2)} kn`, right, 30, 13, colours.dim, "right");
  sheet.text(`by ${now.pilot}`, left, 20, 13, colours.dim, "left");
  sheet.box(left, top, right - left, 34);
  to.save();
  to.beginPath();
  to.rect(left, top, right - left, 34);
  to.clip();
  const per = (right - left) / 60;
  const middle = toDegrees(body[2]);
  for (let degree = Math.ceil(middle - 30); degree <= middle + 30; degree++) {
    const x = 210 + (degree - middle) * per;
    const long = degree % 10 === 0 ? 12 : degree % 5 === 0 ? 8 : 4;
    stroke(to, [x, top], [x, top + long], colours.text, 1);
    if (degree % 10 === 0) sheet.text(heading(toRadians(degree), 0).slice(0, 3), x, top + 23, 13);
  }
  if (now.course_rad !== null) {
    const x = 210 + toDegrees(wrapped(now.course_rad - body[2])) * per;
    stroke(to, [x, top], [x, top + 34], colours.chosen, 3);
  }
  to.restore();
  stroke(to, [210, top - 4], [210, top + 34], colours.alarm, 2);
}

function drawTurn(sheet: Sheet, body: BodyNow): void {
  const { colours, to } = sheet;
  const rot = rateOfTurn(body[5]);
  const [middle, half, top] = [210, 150, 88];
  // Fine near nought, where berthing goes on: the scale goes by the root.
  const place = (value: number) => middle + Math.sign(value) * Math.sqrt(Math.min(1, Math.abs(value) / 60)) * half;
  sheet.box(middle - half, top, half * 2, 16);
  sheet.bar(middle, top + 2, place(rot) - middle, 12, rot < 0 ? colours.port : colours.starboard);
  for (const mark of [-60, -20, -5, 0, 5, 20, 60]) {
    stroke(to, [place(mark), top], [place(mark), top + 16], colours.text, 1);
    sheet.text(String(Math.abs(mark)), place(mark), top + 25, 11, colours.dim);
  }
  sheet.text("ROT", middle - half - 8, top + 8, 13, colours.dim, "right");
  sheet.text(`${fixed(Math.abs(rot), 1)}`, middle + half + 8, top + 8, 15, colours.text, "left", true);
  sheet.text("°/min", middle + half + 8, top + 25, 11, colours.dim, "left");
}

/** Her outline seen from above with speeds along it and at its ends, and her thrusters. */
function drawShip(sheet: Sheet, info: VesselInfo, now: VesselNow): void {
  const { colours, to } = sheet;
  const [x, bow, stern, half] = [210, 136, 384, 30];
  polygon(to, [[x, bow], [x + 16, bow + 22], [x + half, bow + 60], [x + half, stern - 14], [x + half - 8, stern], [x - half + 8, stern], [x - half, stern - 14], [x - half, bow + 60], [x - 16, bow + 22]]);
  to.fillStyle = colours.bg;
  to.fill();
  to.strokeStyle = colours.own_edge;
  to.lineWidth = 2;
  to.stroke();
  for (const [y, speed, name] of [[bow + 26, now.bow_mps, "bow"], [stern - 18, now.stern_mps, "stern"]] as const) {
    const side = Math.sign(speed) || 1;
    const from = x + side * (half + 4);
    const long = Math.min(52, Math.abs(speed) * 130);
    if (Math.abs(speed) >= 0.005) arrow(to, [from, y], [from + side * (long + 6), y], colours.path, 5);
    sheet.text(`${fixed(Math.abs(speed), 2)}`, x + side * 92, y - 12, 19, colours.path, "center", true);
    sheet.text(`m/s ${name}`, x + side * 92, y + 12, 11, colours.dim);
  }
  const ahead = now.ground_mps[0];
  const y = (bow + stern) / 2 + 4;
  const long = Math.min(44, Math.sqrt(Math.abs(ahead)) * 22);
  if (Math.abs(ahead) > 0.005) arrow(to, [x, y - Math.sign(ahead) * 20], [x, y - Math.sign(ahead) * (24 + long)], colours.path, 5);
  sheet.text(fixed(Math.abs(toKnots(ahead)), 2), x, y - 4, 19, colours.text, "center", true);
  sheet.text(ahead < -0.005 ? "kn astern" : "kn", x, y + 12, 11, colours.dim);
  sheet.text(`water ${fixed(toKnots(now.water_mps[0]), 1)}`, x, stern - 26, 11, colours.dim);
  info.thrusters.forEach((thruster, i) => {
    const state = now.thrusters[i];
    if (!state) return;
    const place = bow + ((info.length_m / 2 - thruster.along_m) / info.length_m) * (stern - bow);
    const level = Math.min(stern - 60, Math.max(bow + 66, place));
    sheet.box(x - 90, level - 6, 180, 12);
    sheet.bar(x, level - 4, state.now * 90, 8, state.now < 0 ? colours.port : colours.starboard);
    sheet.pointer([x + state.order * 90, level - 6], "above");
    sheet.text(`${thruster.name} thr ${fixed(Math.abs(state.now) * 100, 0)} %`, x + 94, level + 16, 11, colours.dim, "right");
  });
}

function drawWind(sheet: Sheet, frame: Frame, body: BodyNow): void {
  const { colours, to } = sheet;
  const [x, y, r] = [54, 196, 38];
  to.beginPath();
  to.arc(x, y, r, 0, 2 * Math.PI);
  to.strokeStyle = colours.edge;
  to.lineWidth = 1.5;
  to.stroke();
  polygon(to, [[x, y - 16], [x + 6, y - 4], [x + 6, y + 14], [x - 6, y + 14], [x - 6, y - 4]]);
  to.strokeStyle = colours.dim;
  to.stroke();
  const on = (angle: number, far: number): Pair => [x + Math.sin(angle) * far, y - Math.cos(angle) * far];
  const from = wrapped(frame.wind.from_rad - body[2]);
  if (frame.wind.speed_mps > 0.1) arrow(to, on(from, r + 6), on(from, r - 24), colours.wind, 4);
  const set = wrapped(frame.current.to_rad - body[2]);
  if (frame.current.speed_mps > 0.01) arrow(to, on(set, r - 26), on(set, r - 4), colours.current, 4);
  sheet.text(`${fixed(toKnots(frame.wind.speed_mps), 0)} kn`, x, y + r + 18, 19, colours.wind, "center", true);
  sheet.text(`wind ${sided(from)}`, x, y + r + 36, 12, colours.dim);
  sheet.text(`current ${fixed(toKnots(frame.current.speed_mps), 1)} kn`, x, y + r + 53, 12, colours.current);
}

function drawDepth(sheet: Sheet, hello: Hello, info: VesselInfo, now: VesselNow): void {
  const { colours } = sheet;
  const under = now.under_keel_m;
  const bad = now.aground || (under !== null && under < 0.5);
  const [x, y] = [54, 316];
  sheet.text("under keel", x, y, 12, colours.dim);
  sheet.text(now.aground ? "AGROUND" : under === null ? "–" : `${fixed(under, 1)} m`, x, y + 20, now.aground ? 17 : 22, bad ? colours.alarm : colours.text, "center", true);
  sheet.text(`draught ${fixed(info.draught_m, 1)} m`, x, y + 40, 12, colours.dim);
  if (hello.depth_m !== null) sheet.text(`depth ${fixed(hello.depth_m, 1)} m`, x, y + 55, 12, colours.dim);
}

function drawShaft(sheet: Sheet, info: VesselInfo, now: VesselNow): void {
  if (info.full_rps === null) return;
  const { colours, to } = sheet;
  const [x, top, bottom] = [374, 142, 356];
  const [middle, half] = [(top + bottom) / 2, (bottom - top) / 2];
  sheet.box(x - 14, top, 28, bottom - top);
  sheet.bar(x - 12, middle, 24, -now.shaft.now * half, now.shaft.now < 0 ? colours.port : colours.starboard);
  for (const mark of [-1, -0.5, 0, 0.5, 1]) stroke(to, [x - 14, middle - mark * half], [x + 14, middle - mark * half], colours.text, mark === 0 ? 2 : 1);
  sheet.pointer([x - 14, middle - now.shaft.order * half], "left");
  sheet.text("ahead", x + 4, top - 9, 12, colours.dim);
  sheet.text(`${fixed(now.shaft.now * info.full_rps * 60, 0)} rpm`, x, bottom + 14, 16, colours.text, "center", true);
  sheet.text(`order ${fixed(now.shaft.order * info.full_rps * 60, 0)}`, x, bottom + 31, 12, colours.dim);
}

function drawRudder(sheet: Sheet, info: VesselInfo, now: VesselNow): void {
  if (info.rudder_stop_rad === null) return;
  const { colours, to } = sheet;
  const [x, half, y] = [210, 185, 430];
  const place = (rad: number) => x + (rad / (info.rudder_stop_rad ?? 1)) * half;
  sheet.box(x - half, y, half * 2, 20);
  sheet.bar(x, y + 2, place(now.rudder.now_rad) - x, 16, now.rudder.now_rad < 0 ? colours.port : colours.starboard);
  const stop = Math.round(toDegrees(info.rudder_stop_rad));
  for (let degree = -stop; degree <= stop; degree += 5) {
    const at = place(toRadians(degree));
    stroke(to, [at, y], [at, y + (degree % 10 === 0 ? 20 : 8)], colours.text, degree === 0 ? 2 : 1);
    if (degree % 10 === 0) sheet.text(String(Math.abs(degree)), at, y + 29, 12, degree < 0 ? colours.port : degree > 0 ? colours.starboard : colours.text);
  }
  sheet.pointer([place(now.rudder.order_rad), y], "above");
  sheet.text(`RUDDER ${sided(now.rudder.now_rad)}`, x - 6, y + 52, 19, colours.text, "right", true);
  sheet.text(`order ${sided(now.rudder.order_rad)}`, x + 10, y + 52, 14, colours.dim, "left");
}

function drawAzimuths(sheet: Sheet, info: VesselInfo, now: VesselNow): void {
  const { colours, to } = sheet;
  info.azimuths.forEach((unit, i) => {
    const state = now.azimuths[i];
    if (!state) return;
    const [x, y, r] = [210 + (i - (info.azimuths.length - 1) / 2) * 150, 438, 42];
    to.beginPath();
    to.arc(x, y, r, 0, 2 * Math.PI);
    to.strokeStyle = colours.edge;
    to.lineWidth = 1.5;
    to.stroke();
    const on = (angle: number, far: number): Pair => [x + Math.sin(angle) * far, y - Math.cos(angle) * far];
    stroke(to, on(state.direction_order_rad, r - 8), on(state.direction_order_rad, r + 4), colours.text, 3);
    if (state.power > 0.01) arrow(to, [x, y], on(state.direction_rad, 10 + (r - 10) * state.power), colours.starboard, 5);
    else stroke(to, [x, y], on(state.direction_rad, 12), colours.dim, 2);
    sheet.text(`${unit.name} ${fixed(state.power * 100, 0)} %`, x, y + r + 12, 13);
  });
}
