/** The docking board: what a laser docking system shows in digits that are read across a bridge wing. */
import { dot, turned } from "../geometry";
import type { Page } from "../page";
import type { BerthEnd, Frame, Hello } from "../protocol";
import { button, h, setAttribute, setClass, setText } from "../ui/dom";
import { fixed, toDegrees } from "../units";
import { DEFAULT_LIMIT_MPS, type Light, light, limitAt } from "./limits";
import type { View } from "./view";

const WORDS: Record<Light, string> = { ok: "OK", caution: "CAUTION", alarm: "TOO FAST" };
/** What the server says an end is at: its light and its word. `off` has neither, there the speed counts alone. */
const AT: Record<Exclude<BerthEnd, "off">, [Light, string]> = {
  at_fenders: ["ok", "AT FENDERS"],
  no_fender: ["caution", "NO FENDER"],
  past_end: ["caution", "PAST END"],
  touched: ["caution", "TOUCHED"],
  over_rated: ["alarm", "FENDER LIMIT"],
  structure: ["alarm", "STRUCTURE"],
};
const LIGHTS: readonly Light[] = ["ok", "caution", "alarm"];
const STILL_MPS = 0.005;

class End {
  private readonly distance = h("output", { class: "digits distance" }, "–");
  private readonly speed = h("output", { class: "digits speed" }, "–");
  private readonly way = h("span", { class: "way" });
  private readonly lamp = h("div", { class: "lamp" }, "–");
  readonly root: HTMLElement;

  constructor(private readonly name: "Bow" | "Stern") {
    this.root = h(
      "section",
      { class: "end", "aria-label": name },
      h("h3", {}, name),
      h("div", { class: "figure" }, this.distance, h("span", { class: "unit" }, "m")),
      h("div", { class: "figure" }, this.speed, h("span", { class: "unit" }, "m/s")),
      this.way,
      this.lamp,
    );
  }

  show(end: BerthEnd, off_m: number, closing_mps: number, limit_mps: number): void {
    const speed = light(closing_mps, off_m, limit_mps);
    const [place, word] = end === "off" ? [speed, WORDS[speed]] : AT[end];
    // The worse of the two; of two as bad, what she is at.
    const shown = LIGHTS.indexOf(speed) > LIGHTS.indexOf(place) ? speed : place;
    setText(this.distance, fixed(off_m, Math.abs(off_m) < 100 ? 1 : 0));
    setText(this.speed, fixed(Math.abs(closing_mps), 2));
    setText(
      this.way,
      closing_mps > STILL_MPS ? "▲ closing" : closing_mps < -STILL_MPS ? "▼ opening" : "■ still",
    );
    setText(this.lamp, shown === place ? word : WORDS[shown]);
    for (const name of LIGHTS) setClass(this.root, name, shown === name);
    setAttribute(this.distance, "aria-label", `${this.name} distance`);
    setAttribute(this.speed, "aria-label", `${this.name} speed`);
    // Read by tests and screen readers: closing is positive.
    this.root.dataset.closing = closing_mps.toFixed(3);
    this.root.dataset.off = off_m.toFixed(2);
    this.root.dataset.end = end;
  }
}

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
  private readonly limit = h("output", {
    class: "limit",
    "aria-label": "Speed limit at the fenders",
  });
  private readonly none = h("p", { class: "nothing" }, "No berth in this scenario.");
  readonly root: HTMLElement;
  private limit_mps: number;

  constructor(private readonly page: Page) {
    const kept = Number(localStorage.getItem("docking limit"));
    this.limit_mps = kept > 0 ? kept : DEFAULT_LIMIT_MPS;
    const change = (by: number) => () => {
      this.limit_mps = Math.min(1, Math.max(0.05, Math.round((this.limit_mps + by) * 100) / 100));
      localStorage.setItem("docking limit", String(this.limit_mps));
      this.showLimit(0);
    };
    this.root = h(
      "div",
      { class: "docking" },
      this.none,
      h(
        "div",
        { class: "board" },
        this.ends,
        h(
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
        ),
        h(
          "div",
          { class: "limits" },
          button("−", change(-0.01), { name: "Lower speed limit" }),
          this.limit,
          button("+", change(0.01), { name: "Higher speed limit" }),
        ),
      ),
    );
    this.showLimit(0);
  }

  private showLimit(off_m: number): void {
    const here = off_m > 3 ? `; limit here ${fixed(limitAt(off_m, this.limit_mps), 2)}` : "";
    setText(this.limit, `Limit at the fenders ${fixed(this.limit_mps, 2)} m/s${here}`);
  }

  tick(frame: Frame, hello: Hello): void {
    const index = this.page.live.ship();
    const now = frame.vessels[index];
    const body = frame.bodies[hello.vessels[index]?.body ?? -1];
    const quay = frame.bodies[hello.berth?.body ?? -1];
    const berth = now?.berth;
    setClass(this.root, "none", !berth);
    if (!berth || !hello.berth || !body || !quay) return;
    this.bow.show(berth.bow, berth.bow_m, berth.bow_mps, this.limit_mps);
    this.stern.show(berth.stern, berth.stern_m, berth.stern_mps, this.limit_mps);
    this.showLimit(Math.min(berth.bow_m, berth.stern_m));
    // As she lies when one looks at the quay over her side: starboard side to, her bow is to the left.
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
