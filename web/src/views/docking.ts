/** The docking board: distances and speeds at bow and stern, in digits to be read across a bridge wing. The server has
 * its limits and signals. */
import { dot, turned } from "../geometry";
import type { Page } from "../page";
import type { BerthEnd, Frame, Hello, Lamp } from "../protocol";
import { button, h, setAttribute, setClass, setText } from "../ui/dom";
import { fixed, heading, toDegrees } from "../units";
import { type Way, farFromBerth } from "../ways";
import type { View } from "./view";

const LIGHTS: readonly Lamp["light"][] = ["ok", "caution", "alarm"];
/** Two limits that differ by less are shown as one [m/s]. */
const SAME_LIMIT_MPS = 0.02;
/** Below this an end counts as still [m/s]. */
const STILL_MPS = 0.005;

class End {
  private readonly distance = h("output", { class: "digits distance" }, "–");
  private readonly unit = h("span", { class: "unit" }, "m");
  private readonly speed = h("output", { class: "digits speed" }, "–");
  private readonly way = h("span", { class: "way" });
  private readonly lamp = h("div", { class: "lamp" }, "–");
  readonly root: HTMLElement;

  constructor(private readonly name: "Bow" | "Stern") {
    this.root = h(
      "section",
      { class: "end", "aria-label": name },
      h("h3", {}, name),
      h("div", { class: "figure" }, this.distance, this.unit),
      h("div", { class: "figure" }, this.speed, h("span", { class: "unit" }, "m/s")),
      this.way,
      this.lamp,
    );
  }

  /** `limit_mps`: the limit of the closing speed at this distance; `null` far from the berth. */
  show(
    end: BerthEnd,
    lamp: Lamp,
    off_m: number,
    closing_mps: number,
    limit_mps: number | null,
  ): void {
    // Four digits have no room.
    const isFar = Math.abs(off_m) >= 999.5;
    setText(
      this.distance,
      isFar ? fixed(off_m / 1000, 2) : fixed(off_m, Math.abs(off_m) < 100 ? 1 : 0),
    );
    setText(this.unit, isFar ? "km" : "m");
    setText(this.speed, fixed(Math.abs(closing_mps), 2));
    const way =
      closing_mps > STILL_MPS ? "▲ closing" : closing_mps < -STILL_MPS ? "▼ opening" : "■ still";
    const bySpeed = lamp.by_speed && lamp.light !== "ok" && limit_mps !== null;
    setText(this.way, bySpeed ? `${way}, limit ${fixed(limit_mps, 2)}` : way);
    setText(this.lamp, lamp.text);
    for (const name of LIGHTS) setClass(this.root, name, lamp.light === name);
    setAttribute(this.distance, "aria-label", `${this.name} distance`);
    setAttribute(this.speed, "aria-label", `${this.name} speed`);
    // Read by tests and screen readers: closing is positive.
    this.root.dataset.closing = closing_mps.toFixed(3);
    this.root.dataset.off = off_m.toFixed(2);
    this.root.dataset.end = end;
  }
}

/** The lamp of an end that is far from the berth: no signal, but the way there. */
const onTheWay = ({ bearing_rad }: Way): Lamp => ({
  light: "ok",
  text: `BERTH BEARS ${heading(bearing_rad, 0)}`,
  by_speed: false,
});

export class Docking implements View {
  private readonly bow = new End("Bow");
  private readonly stern = new End("Stern");
  private readonly ends = h("div", { class: "ends" }, this.bow.root, this.stern.root);
  private readonly angle = h(
    "output",
    { class: "digits", "aria-label": "Angle to the berth" },
    "–",
  );
  private readonly angleWay = h("span", { class: "way" });
  private readonly along = h(
    "output",
    { class: "digits", "aria-label": "Speed along the berth" },
    "–",
  );
  private readonly alongWay = h("span", { class: "way" });
  private readonly toGo = h("output", { class: "digits", "aria-label": "To go to the mark" }, "–");
  private readonly toGoUnit = h("span", { class: "unit" }, "m");
  private readonly toGoWay = h("span", { class: "way" });
  private readonly toGoName = h("h3", {}, "To go");
  private readonly mark = h(
    "section",
    { class: "mark hidden" },
    this.toGoName,
    h("div", { class: "figure" }, this.toGo, this.toGoUnit),
    this.toGoWay,
  );
  private readonly under = h(
    "div",
    { class: "under" },
    h(
      "section",
      {},
      h("h3", {}, "Angle"),
      h("div", { class: "figure" }, this.angle, h("span", { class: "unit" }, "°")),
      this.angleWay,
    ),
    h(
      "section",
      {},
      h("h3", {}, "Along"),
      h("div", { class: "figure" }, this.along, h("span", { class: "unit" }, "m/s")),
      this.alongWay,
    ),
    this.mark,
  );
  private readonly limit = h("output", {
    class: "limit",
    "aria-label": "Speed limit at the fenders",
  });
  private readonly none = h("p", { class: "nothing" }, "No berth in this scenario.");
  readonly root: HTMLElement;
  private approach_mps = 0;
  private readonly changes: HTMLButtonElement[];

  constructor(
    private readonly page: Page,
    hello: Hello,
  ) {
    const [least, most] = hello.limits.approach_limit_mps;
    const change = (by: number) => () => {
      const wanted_mps = Math.round((this.approach_mps + by) * 100) / 100;
      const speed_mps = Math.min(most, Math.max(least, wanted_mps));
      void this.page.order({ do: "approach_limit", speed_mps });
    };
    const [lower, higher] = [
      button("−", change(-0.01), { name: "Lower speed limit" }),
      button("+", change(0.01), { name: "Higher speed limit" }),
    ];
    this.changes = [lower, higher];
    this.root = h(
      "div",
      { class: "docking" },
      this.none,
      h(
        "div",
        { class: "board" },
        this.ends,
        this.under,
        h("div", { class: "limits" }, lower, this.limit, higher),
      ),
    );
  }

  private showLimit(at_fenders_mps: number, here_mps: number): void {
    this.approach_mps = at_fenders_mps;
    const now =
      here_mps - at_fenders_mps > SAME_LIMIT_MPS ? `; at this distance ${fixed(here_mps, 2)}` : "";
    setText(this.limit, `At most ${fixed(at_fenders_mps, 2)} m/s at the fenders${now}`);
  }

  /** The way to go along the berth to the mark of the exercise, for the ship of the exercise. */
  private showMark(frame: Frame, hello: Hello, ship: number): void {
    const isOwn = hello.exercise?.ship === hello.vessels[ship]?.name;
    const to_go_m = isOwn ? (frame.exercise?.to_go_m ?? null) : null;
    setClass(this.mark, "hidden", to_go_m === null);
    setClass(this.under, "with-mark", to_go_m !== null);
    if (to_go_m === null) return;
    setText(this.toGoName, hello.exercise?.mark ?? "To go");
    const long_m = Math.abs(to_go_m);
    const isFar = long_m >= 999.5;
    setText(this.toGo, isFar ? fixed(long_m / 1000, 2) : fixed(long_m, long_m < 100 ? 1 : 0));
    setText(this.toGoUnit, isFar ? "km" : "m");
    setText(this.toGoWay, long_m < 0.05 ? "abeam" : to_go_m > 0 ? "ahead" : "astern");
    this.mark.dataset.toGo = to_go_m.toFixed(2);
  }

  /** Pilot and instructor set the limit. */
  claims({ role }: Hello): void {
    const may = role.name === "pilot" || role.name === "instructor";
    for (const each of this.changes) each.disabled = !may;
  }

  tick(frame: Frame, hello: Hello): void {
    const index = this.page.live.ship();
    const now = frame.vessels[index];
    const body = frame.bodies[hello.vessels[index]?.body ?? -1];
    const quay = frame.bodies[hello.berth?.body ?? -1];
    const berth = now?.berth;
    setClass(this.root, "none", !berth);
    if (!berth || !hello.berth || !body || !quay) return;
    const ways = farFromBerth(frame, hello, index);
    setClass(this.ends, "far", ways !== null);
    if (ways) {
      const [bow, stern] = ways;
      this.bow.show("past_end", onTheWay(bow), bow.off_m, bow.closing_mps, null);
      this.stern.show("past_end", onTheWay(stern), stern.off_m, stern.closing_mps, null);
    } else {
      const { bow_limit_mps, stern_limit_mps } = berth;
      this.bow.show(berth.bow, berth.bow_lamp, berth.bow_m, berth.bow_mps, bow_limit_mps);
      this.stern.show(
        berth.stern,
        berth.stern_lamp,
        berth.stern_m,
        berth.stern_mps,
        stern_limit_mps,
      );
    }
    this.showLimit(frame.approach_mps, Math.min(berth.bow_limit_mps, berth.stern_limit_mps));
    this.showMark(frame, hello, index);
    // As seen from the ship facing the quay: starboard side to, the bow is on the left.
    const starboardTo = dot(turned(body[2] - quay[2], [0, 1]), hello.berth.facing) < 0;
    setClass(this.ends, "starboard-to", starboardTo);
    const degrees = Math.abs(toDegrees(berth.angle_rad));
    setText(this.angle, fixed(degrees, 1));
    const open = berth.bow_m - berth.stern_m;
    setText(this.angleWay, degrees < 0.05 ? "parallel" : open > 0 ? "bow out" : "bow in");
    setText(this.along, fixed(Math.abs(berth.along_mps), 2));
    setText(
      this.alongWay,
      berth.along_mps > STILL_MPS ? "ahead" : berth.along_mps < -STILL_MPS ? "astern" : "still",
    );
  }
}
