/**
 * The editor of a new exercise from berth, ship, tugs and weather. Who keeps it is another matter: the server's gallery, or the page without
 * a server.
 */
import type { LibraryInfo, NewExercise } from "../protocol";
import { NAME_RULE, followTitle, isFileName } from "../file_name";
import { button, h, setClass, setText } from "../ui/dom";
import { KNOT_MPS, fixed, spoken } from "../units";
import type { View } from "./view";

/** A number field with its unit. */
function number(name: string, unit: string, value: number, [min, max, step]: number[]) {
  const input = h("input", { type: "number", value, min, max, step, "aria-label": name });
  return { input, row: row(name, input, unit), value: () => Number(input.value) };
}

function row(name: string, field: HTMLElement, unit = ""): HTMLElement {
  return h("label", { class: "field" }, h("span", {}, name), field, h("span", {}, unit));
}

function choice(name: string, options: [value: string, text: string][], chosen?: string) {
  const select = h(
    "select",
    { "aria-label": name },
    ...options.map(([value, text]) => h("option", { value, selected: value === chosen }, text)),
  );
  return { select, row: row(name, select), value: () => select.value };
}

/** What became of an exercise, in words; `taken`: another has the name, and may be replaced. */
export interface Kept {
  outcome: "kept" | "taken" | "refused";
  text: string;
}

/** Who makes and keeps exercises. */
export interface Keeper {
  /** The words of the button that keeps one. */
  keep_text: string;
  /** What to do with one that was kept: hidden without. */
  after: HTMLElement;
  keep(name: string, exercise: NewExercise, replace: boolean): Promise<Kept>;
}

/** A scenario whose berth can be taken; `berth`: in words. */
export interface OfferedBerth {
  file: string;
  title: string;
  berth: string | null;
}

const degrees = (bearing: number): number => (bearing * Math.PI) / 180;

export class NewExerciseView implements View {
  private readonly title = h("input", { type: "text", maxlength: 100, "aria-label": "Title" });
  private readonly name = h("input", { type: "text", maxlength: 60, "aria-label": "File name" });
  private readonly berth = choice("Berth", [["", "A straight quay that faces west, as below"]]);
  private readonly quay = number("Length of the quay", "m", 300, [20, 2000, 10]);
  private readonly depth = number("Depth of the water", "m", 20, [2, 100, 0.5]);
  private readonly family;
  private readonly size = choice("Size", []);
  private readonly height = number("Height of a fender", "m", 1.6, [0.2, 5, 0.1]);
  private readonly reaction = number("Rated reaction of a fender", "kN", 1500, [10, 20_000, 10]);
  private readonly fenders = number("Number of fenders", "", 6, [1, 60, 1]);
  private readonly spacing = number("Distance between fenders", "m", 25, [1, 500, 1]);
  private readonly bollards = number("Distance between bollards", "m", 25, [5, 500, 5]);
  private readonly ship;
  private readonly side = choice("Berths with her", [
    ["starboard", "starboard side"],
    ["port", "port side"],
  ]);
  private readonly off = number("Off the quay", "m", 60, [5, 2000, 5]);
  private readonly astern = number("Astern of the berth", "m", 250, [0, 10_000, 10]);
  private readonly speed = number("Speed", "kn", 2, [0, 15, 0.5]);
  private readonly tug;
  private readonly tugs = choice(
    "Number of tugs",
    ["0", "1", "2", "3", "4"].map((n) => [n, n]),
    "2",
  );
  private readonly wind = number("Wind", "kn", 12, [0, 100, 1]);
  private readonly windFrom = number("Wind from", "°", 270, [0, 360, 5]);
  private readonly gusts = h("input", { type: "checkbox", checked: true, "aria-label": "Gusts" });
  private readonly current = number("Current", "kn", 0, [0, 10, 0.1]);
  private readonly currentTo = number("Current to", "°", 0, [0, 360, 5]);
  private readonly visibility = choice("Visibility", [
    ["", "clear"],
    ["5000", "5 km"],
    ["2000", "2 km"],
    ["1000", "1 km"],
    ["500", "500 m"],
    ["200", "200 m"],
  ]);
  private readonly note = h("p", { class: "note", role: "status", "aria-label": "Saved" });
  private readonly replace = button("Replace it", () => void this.save(true), { class: "hidden" });
  readonly root: HTMLElement;

  constructor(
    private readonly keeper: Keeper,
    private readonly library: LibraryInfo,
  ) {
    const vessels = (is_tug: boolean): [string, string][] =>
      library.vessels
        .filter((vessel) => vessel.is_tug === is_tug)
        .map(({ name, title, length_m, draught_m }) => [
          name,
          `${title} (${fixed(length_m, 0)} m, draught ${fixed(draught_m, 1)} m)`,
        ]);
    this.ship = choice("Ship", vessels(false));
    this.tug = choice("Tugs", vessels(true));
    this.family = choice(
      "Fenders",
      library.fenders.map(({ name }) => [name, spoken(name)]),
      "cone SPC",
    );
    this.family.select.addEventListener("change", () => this.sizes());
    const form = h(
      "form",
      {
        class: "new-exercise",
        onsubmit: (event: Event) => {
          event.preventDefault();
          void this.save(false);
        },
      },
      h(
        "p",
        { class: "note" },
        "A berth, a ship on her way to it, tugs on their lines. The berth is a straight quay of your own, or that of another scenario with its chart.",
      ),
      group("", [{ row: row("Title", this.title) }], "wide"),
      group("Berth", [this.berth], "wide"),
      group("", [this.quay, this.depth, this.family, this.size, this.height, this.reaction]),
      group("", [this.fenders, this.spacing, this.bollards]),
      group("Ship", [this.ship], "wide"),
      group("", [this.side, this.off, this.astern, this.speed]),
      group("Tugs", [this.tug], "wide"),
      group("", [this.tugs]),
      group("Weather", [this.wind, this.windFrom, { row: row("Gusts", this.gusts) }]),
      group("", [this.current, this.currentTo, this.visibility]),
      h("h3", {}, "Save"),
      group("", [{ row: row("File name", this.name) }], "wide"),
      h(
        "div",
        { class: "row" },
        h("button", { type: "submit", class: "take" }, keeper.keep_text),
        this.replace,
        keeper.after,
      ),
      this.note,
    );
    // A tab's panel must not be a form itself.
    this.root = h("div", {}, form);
    followTitle(this.title, this.name);
    this.name.addEventListener("input", () => {
      for (const each of [this.replace, keeper.after]) setClass(each, "hidden", true);
    });
    this.berth.select.addEventListener("change", () => this.sizes());
    this.sizes();
  }

  tick(): void {}

  /** Fills in the berths that can be taken. */
  offer(berths: OfferedBerth[]): void {
    const chosen = this.berth.value();
    const offered = berths.flatMap(({ file, title, berth }): [string, string][] =>
      berth === null ? [] : [[file, `${title} (${berth})`]],
    );
    const first = this.berth.select.options[0];
    this.berth.select.replaceChildren(
      ...(first ? [first] : []),
      ...offered.map(([value, text]) => h("option", { value, selected: value === chosen }, text)),
    );
  }

  /** Shows the fields of the chosen kind of berth, with the sizes of the chosen family; one without sizes has height and reaction. */
  private sizes(): void {
    const family = this.library.fenders.find(({ name }) => name === this.family.value());
    const sizes = family?.sizes ?? [];
    this.size.select.replaceChildren(
      ...sizes.map(({ designation, rated_reaction_n }) =>
        h(
          "option",
          { value: designation },
          `${designation}: ${fixed(rated_reaction_n / 1e3, 0)} kN`,
        ),
      ),
    );
    const isOwn = this.berth.value() === "";
    setClass(this.size.row, "hidden", !isOwn || sizes.length === 0);
    for (const { row } of [this.height, this.reaction])
      setClass(row, "hidden", !isOwn || sizes.length > 0);
    for (const { row } of [
      this.quay,
      this.depth,
      this.family,
      this.fenders,
      this.spacing,
      this.bollards,
    ])
      setClass(row, "hidden", !isOwn);
  }

  private choices(): NewExercise {
    const size = this.size.value() || null;
    const visibility = this.visibility.value();
    return {
      title: this.title.value.trim(),
      berth: {
        length_m: this.quay.value(),
        depth_m: this.depth.value(),
        fender: this.family.value(),
        size,
        height_m: size === null ? this.height.value() : null,
        rated_reaction_n: size === null ? this.reaction.value() * 1e3 : null,
        fenders: Math.round(this.fenders.value()),
        fender_spacing_m: this.spacing.value(),
        bollard_spacing_m: this.bollards.value(),
      },
      berth_of: this.berth.value() || null,
      ship: {
        vessel: this.ship.value(),
        side: this.side.value() as "port" | "starboard",
        off_m: this.off.value(),
        astern_m: this.astern.value(),
        speed_mps: this.speed.value() * KNOT_MPS,
      },
      tugs: { vessel: this.tug.value(), number: Number(this.tugs.value()) },
      weather: {
        wind_mps: this.wind.value() * KNOT_MPS,
        wind_from_rad: degrees(this.windFrom.value()),
        gusts: this.gusts.checked,
        current_mps: this.current.value() * KNOT_MPS,
        current_to_rad: degrees(this.currentTo.value()),
        visibility_m: visibility === "" ? null : Number(visibility),
      },
    };
  }

  private async save(replace: boolean): Promise<void> {
    const name = this.name.value.trim();
    if (this.title.value.trim() === "" || name === "") {
      setText(this.note, "Give the exercise a title and a file name.");
      (name === "" && this.title.value.trim() !== "" ? this.name : this.title).focus();
      return;
    }
    if (!isFileName(name)) {
      setText(this.note, `Not saved. ${NAME_RULE}`);
      this.name.focus();
      return;
    }
    setText(this.note, "");
    const { outcome, text } = await this.keeper.keep(name, this.choices(), replace);
    setClass(this.replace, "hidden", outcome !== "taken");
    setClass(this.keeper.after, "hidden", outcome !== "kept");
    setText(this.note, text);
  }
}

function group(name: string, fields: { row: HTMLElement }[], kind = ""): HTMLElement {
  return h(
    "fieldset",
    { class: kind },
    name === "" ? "" : h("legend", {}, name),
    ...fields.map(({ row }) => row),
  );
}
