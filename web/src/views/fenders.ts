/** The fender panel: reaction and energy of each fender over its rating, their peaks, and whether it has failed. */
import { isOfTug } from "../live";
import { type Palette, loadColour, palette } from "../palette";
import type { FenderInfo, FenderNow, Frame, Hello } from "../protocol";
import { h, setAttribute, setClass, setStyle, setText } from "../ui/dom";
import { energy, fenderLoad, fixed, percent, spoken } from "../units";
import type { View } from "./view";

/** Share of the rating at the full width of a bar. */
const BAR_SHARE = 1.25;

class Bar {
  private readonly fill = h("div", { class: "fill" });
  private readonly peak = h("div", { class: "peak" });
  readonly root: HTMLElement;

  constructor(private readonly name: string) {
    this.root = h(
      "div",
      { class: "bar", role: "meter", "aria-label": name, "aria-valuemin": 0, "aria-valuemax": 1 },
      this.fill,
      this.peak,
      h("div", { class: "full", title: "rated" }),
    );
  }

  show(share: number, peak: number, colours: Palette): void {
    setStyle(this.fill, "width", `${Math.min(100, (share / BAR_SHARE) * 100).toFixed(1)}%`);
    setStyle(this.fill, "background", loadColour(share, colours));
    setStyle(this.peak, "left", `${Math.min(99, (peak / BAR_SHARE) * 100).toFixed(1)}%`);
    setStyle(this.peak, "background", loadColour(peak, colours));
    setAttribute(this.root, "aria-valuenow", share.toFixed(2));
    setAttribute(
      this.root,
      "aria-valuetext",
      `${this.name} ${percent(share)}, peak ${percent(peak)}`,
    );
  }
}

class Row {
  private readonly reaction = new Bar("Reaction");
  private readonly energy = new Bar("Energy");
  private readonly figures = h("span", { class: "figures" });
  private readonly state = h("span", { class: "state" });
  readonly root: HTMLElement;

  constructor(
    private readonly info: FenderInfo,
    private readonly ofTug: boolean,
  ) {
    this.root = h(
      "li",
      {},
      h("div", { class: "row-head" }, h("b", {}, spoken(info.name)), this.state, this.figures),
      info.rated_reaction_n === null && info.rated_energy_j === null
        ? h("p", { class: "note" }, "No rating given.")
        : h(
            "div",
            { class: "bars" },
            h("span", {}, "R"),
            this.reaction.root,
            h("span", {}, "E"),
            this.energy.root,
          ),
    );
  }

  show(now: FenderNow, colours: Palette): void {
    this.reaction.show(now.of_reaction, now.peak_of_reaction, colours);
    this.energy.show(now.of_energy, now.peak_of_energy, colours);
    const rated = this.info.rated_deflection_m;
    const deep = rated
      ? `${fixed((now.deflection_m / rated) * 100, 0)} % of ${fixed(rated, 2)} m`
      : `${fixed(now.deflection_m, 2)} m`;
    const hasRating = this.info.rated_reaction_n !== null || this.info.rated_energy_j !== null;
    setText(
      this.figures,
      now.reaction_n > 0 || !now.touched || !hasRating
        ? `${fenderLoad(now.reaction_n, this.ofTug)} · ${energy(now.energy_j)} · ${deep}`
        : `peak: R ${percent(now.peak_of_reaction)} · E ${percent(now.peak_of_energy)}`,
    );
    setText(
      this.state,
      now.failed
        ? "FAILED"
        : now.over_rated
          ? "WAS OVER RATED"
          : now.reaction_n > 0
            ? "in contact"
            : "",
    );
    setClass(this.root, "alarm", now.failed);
    setClass(this.root, "caution", now.over_rated && !now.failed);
  }
}

export class Fenders implements View {
  private readonly rows: Row[];
  private readonly worst = h("p", { class: "summary" });
  readonly root: HTMLElement;

  constructor(hello: Hello) {
    this.rows = hello.fenders.map((info) => new Row(info, isOfTug(info, hello)));
    this.root = h(
      "div",
      { class: "fenders" },
      this.worst,
      hello.fenders.length === 0
        ? h("p", { class: "nothing" }, "No fenders in this scenario.")
        : h("ul", { class: "rows" }, ...this.rows.map((row) => row.root)),
      h(
        "p",
        { class: "note" },
        "R reaction, E energy; the stroke marks the rating, the thin mark the peak so far.",
      ),
    );
  }

  tick(frame: Frame, hello: Hello): void {
    const colours = palette();
    let [most, name] = [0, ""];
    frame.fenders.forEach((now, i) => {
      this.rows[i]?.show(now, colours);
      const load = Math.max(now.peak_of_energy, now.peak_of_reaction);
      if (load > most) [most, name] = [load, spoken(hello.fenders[i]?.name ?? "")];
    });
    // Tugs have fenders too, which say nothing about the berthing; where no others are, they count.
    const isCounted = (i: number) => {
      const info = hello.fenders[i];
      return info !== undefined && !isOfTug(info, hello);
    };
    const others = frame.fenders.filter((_, i) => isCounted(i));
    const counted = others.length > 0 ? others : frame.fenders;
    const touched = counted.filter((f) => f.touched).length;
    const highest = most > 0 ? ` · highest so far ${percent(most)} of rated, ${name}` : "";
    setText(
      this.worst,
      touched > 0
        ? `${touched} of ${counted.length} touched so far${highest}`
        : `${counted.length} fenders, none touched yet`,
    );
  }
}
