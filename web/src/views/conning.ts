/**
 * The conning display: heading and turn, speeds at the ends, rudder, shaft, thrusters, wind, depth; ordered and actual. The dials
 * are OpenBridge's; every value stands beside them in figures.
 */
import {
  type Dial,
  type Sight,
  attitude,
  azimuth,
  compass,
  engine,
  rudder,
  speed,
  thruster,
  turn,
} from "../instruments/dials";
import type { Live } from "../live";
import type { Frame, Hello, VesselInfo, VesselNow } from "../protocol";
import { h, setAttribute, setClass, setText } from "../ui/dom";
import { fixed, heading, percent, rateOfTurn, relative, sided, toKnots, wrapped } from "../units";
import type { View } from "./view";

/** Below this a figure has no side. */
const STILL = { turn: 0.05, mps: 0.005, rad: 0.0009 };
/** She has less under her keel than this: it is marked [m]. */
const LITTLE_WATER_M = 0.5;

/** A figure with its name; it is as large as it must be to be read from two metres. */
class Figure {
  private readonly value = h("span", { class: "value" }, "–");
  private readonly note = h("span", { class: "beside" });
  readonly root: HTMLElement;

  constructor(
    name: string,
    private readonly read: (
      sight: Sight,
      hello: Hello,
    ) => [value: string, note?: string, bad?: boolean],
    kind = "",
  ) {
    this.root = h(
      "div",
      { class: `figure ${kind}` },
      h("span", { class: "name" }, name),
      this.value,
      this.note,
    );
  }

  show(sight: Sight, hello: Hello): void {
    const [value, note = "", bad = false] = this.read(sight, hello);
    setText(this.value, value);
    setText(this.note, note);
    setClass(this.root, "bad", bad);
  }
}

/** A lateral speed, on the side to which she moves. */
const lateral = (mps: number): string => {
  const text = fixed(Math.abs(mps), 2);
  return Math.abs(mps) < STILL.mps ? text : mps < 0 ? `◀ P ${text}` : `S ${text} ▶`;
};

const along = (mps: number): string =>
  `${fixed(Math.abs(toKnots(mps)), 2)}${Math.abs(mps) < STILL.mps ? "" : mps < 0 ? " ▼" : " ▲"}`;

/** While a speed is ordered: the speed that the order is about, and the order [kn]. */
const throughWater = ({ water_mps, speed_order_mps }: VesselNow): string =>
  speed_order_mps === null
    ? ""
    : `through water ${fixed(toKnots(water_mps[0]), 1)}, order ${fixed(toKnots(speed_order_mps), 1)}`;

const share = (value: number): string =>
  value === 0 ? "0 %" : `${value < 0 ? "P" : "S"} ${percent(Math.abs(value))}`;

const named = (name: string): string => name.replace(/^./, (c) => c.toUpperCase());

/** Dials and figures of one vessel. */
class Display {
  private readonly dials: Dial[] = [];
  private readonly figures: Figure[] = [];
  readonly root: HTMLElement;

  constructor(readonly info: VesselInfo) {
    this.root = h(
      "div",
      { class: `display ${info.azimuths.length > 0 ? "units-beside" : ""}`, role: "img" },
      h(
        "div",
        { class: "heading-row" },
        this.figure("HDG", ({ body }) => [heading(body[2])], "first"),
        this.figure("COG", ({ body }) => [
          Math.hypot(body[3], body[4]) < 0.02 ? "–" : heading(Math.atan2(body[4], body[3])),
        ]),
        this.figure("SOG kn", ({ body }) => [fixed(toKnots(Math.hypot(body[3], body[4])), 2)]),
        this.figure("Steered by", ({ now }) => [now.pilot], "words"),
      ),
      h(
        "div",
        { class: "middle" },
        h("div", { class: "weather" }, ...this.weather()),
        this.dial(compass()),
        h("div", { class: "wide-only" }, this.dial(speed()), this.dial(attitude())),
        ...this.units(),
        ...this.engine(),
      ),
      h(
        "div",
        { class: "ends-row" },
        this.figure("Bow m/s", ({ now }) => [lateral(now.bow_mps)], "strong"),
        this.figure(
          "Ahead kn",
          ({ now }) => [along(now.ground_mps[0]), throughWater(now)],
          "strong",
        ),
        this.figure("Stern m/s", ({ now }) => [lateral(now.stern_mps)], "strong"),
      ),
      h("div", { class: "gear" }, ...this.gear(), this.turn()),
    );
  }

  private dial(dial: Dial): HTMLElement {
    this.dials.push(dial);
    return dial.root;
  }

  private figure(...how: ConstructorParameters<typeof Figure>): HTMLElement {
    const figure = new Figure(...how);
    this.figures.push(figure);
    return figure.root;
  }

  private weather(): HTMLElement[] {
    return [
      this.figure("Wind kn", ({ frame, body }) => [
        fixed(toKnots(frame.wind.speed_mps), 0),
        frame.wind.speed_mps > 0.1
          ? `from ${relative(wrapped(frame.wind.from_rad - body[2]))}`
          : "",
      ]),
      this.figure("Current kn", ({ frame, body }) => [
        fixed(toKnots(frame.current.speed_mps), 1),
        frame.current.speed_mps > 0.01
          ? `sets ${relative(wrapped(frame.current.to_rad - body[2]))}`
          : "",
      ]),
      this.figure("Under keel m", ({ now, info }, { depth_m }) => {
        const under = now.under_keel_m;
        return [
          now.aground ? "AGROUND" : under === null ? "–" : fixed(under, 1),
          `draught ${fixed(info.draught_m, 1)}${depth_m === null ? "" : ` in ${fixed(depth_m, 1)}`}`,
          now.aground || (under !== null && under < LITTLE_WATER_M),
        ];
      }),
    ];
  }

  private engine(): HTMLElement[] {
    const { full_rps } = this.info;
    if (full_rps === null) return [];
    const rpm = (value: number) => fixed(value * full_rps * 60, 0);
    return [
      h(
        "div",
        { class: "shaft" },
        this.dial(engine()),
        this.figure("Shaft rpm", ({ now }) => [
          rpm(now.shaft.now),
          `order ${rpm(now.shaft.order)}`,
        ]),
      ),
    ];
  }

  private units(): HTMLElement[] {
    return this.info.azimuths.map((each, i) =>
      h(
        "div",
        { class: "unit" },
        this.dial(azimuth(i)),
        this.figure(named(each.name), ({ now }) => {
          const state = now.azimuths[i];
          return [percent(state?.power ?? 0), `at ${sided(state?.direction_rad ?? 0)}`];
        }),
      ),
    );
  }

  private turn(): HTMLElement {
    return h(
      "div",
      { class: "unit broad" },
      this.dial(turn(this.info)),
      this.figure("Rate of turn", ({ body }) => {
        const rot = rateOfTurn(body[5]);
        const side = Math.abs(rot) < STILL.turn ? "" : rot < 0 ? "P " : "S ";
        return [`${side}${fixed(Math.abs(rot), 1)}°/min`];
      }),
    );
  }

  /** What steers her, from bow to stern. */
  private gear(): HTMLElement[] {
    const { thrusters, azimuths, rudder_stop_rad } = this.info;
    const tunnels = thrusters.flatMap((each, i) => [
      this.dial(thruster(i)),
      this.figure(named(each.name), ({ now }) => [share(now.thrusters[i]?.now ?? 0)]),
    ]);
    const tunnelled = tunnels.length > 0 ? [h("div", { class: "unit tunnels" }, ...tunnels)] : [];
    if (azimuths.length > 0 || rudder_stop_rad === null) return tunnelled;
    const blade = h(
      "div",
      { class: "unit broad" },
      this.dial(rudder(rudder_stop_rad)),
      this.figure("Rudder", ({ now }) => [
        sided(now.rudder.now_rad),
        `order ${sided(now.rudder.order_rad)}`,
      ]),
    );
    return [...tunnelled, blade];
  }

  show(sight: Sight, hello: Hello): void {
    for (const dial of this.dials) dial.show(sight);
    for (const figure of this.figures) figure.show(sight, hello);
  }
}

export class Conning implements View {
  readonly root = h("div", { class: "conning" });
  private display: Display | null = null;

  constructor(private readonly live: Live) {}

  tick(frame: Frame, hello: Hello): void {
    const index = this.live.conned();
    const [info, now] = [hello.vessels[index], frame.vessels[index]];
    const body = frame.bodies[info?.body ?? -1];
    if (!info || !now || !body) return;
    if (this.display?.info.name !== info.name) {
      this.display = new Display(info);
      this.root.replaceChildren(this.display.root);
    }
    const mine = this.live.mine({ vessel: info.name });
    this.display.show({ info, now, body, frame, mine }, hello);
    const water = throughWater(now);
    setAttribute(
      this.display.root,
      "aria-label",
      `Conning display: heading ${heading(body[2])}, rudder ${sided(now.rudder.now_rad)}, shaft ${fixed(now.shaft.now * 100, 0)} per cent, ahead ${fixed(toKnots(now.ground_mps[0]), 1)} knots over ground${water && `, ${water} knots`}`,
    );
  }
}
