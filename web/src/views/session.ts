/** The instructor's view of the session: clients and their controls, links to hand out, scenarios, saving. */
import type { Page } from "../page";
import type { Control, Frame, Hello, Role } from "../protocol";
import { withoutSpaces } from "../file_name";
import { button, h, setClass, setText } from "../ui/dom";
import { askToEnd } from "../ui/question";
import { spoken } from "../units";
import type { FileTools } from "./file_tools";
import type { SaveExercise } from "./save_exercise";
import type { View } from "./view";

const nameOf = (control: Control): string =>
  "vessel" in control ? control.vessel : "tug" in control ? control.tug : "session";
const roleOf = (role: Role): string => {
  if (role.name === "tugmaster") return `Tugmaster of ${spoken(role.tug)}`;
  if (role.name === "pilot" && role.vessel !== undefined) return `Pilot of ${spoken(role.vessel)}`;
  return role.name.replace(/^./, (c) => c.toUpperCase());
};

export class Session implements View {
  private readonly claimRows = h("ul", { class: "rows claims", "aria-label": "Who holds what" });
  private readonly count = h("p", { class: "summary" });
  private readonly opening = h("span", { role: "status" });
  private readonly openingRow: HTMLElement;
  readonly root: HTMLElement;

  constructor(
    private readonly page: Page,
    hello: Hello,
    /** Kept when the gallery changes, with what is filled in. */
    private readonly exercise: SaveExercise,
    private readonly tools: FileTools,
  ) {
    const name = h("input", {
      type: "text",
      "aria-label": "Name to save under",
      placeholder: "name",
      maxlength: 60,
    });
    withoutSpaces(name);
    const save = button("Save session", () => {
      const text = name.value.trim();
      if (text === "") page.say("Give the session a name to save it under.", "refusal");
      else void page.order({ do: "save", name: text });
    });
    this.openingRow = h(
      "div",
      { class: "row opening hidden" },
      this.opening,
      button("Stop opening", () => void page.order({ do: "stop_opening" })),
    );
    const recordings = hello.gallery
      .filter(({ written_unix_s }) => written_unix_s !== null)
      .toSorted((a, b) => (b.written_unix_s ?? 0) - (a.written_unix_s ?? 0));
    const deleted = this.tools.deleted(hello);
    this.root = h(
      "div",
      { class: "session" },
      this.openingRow,
      this.count,
      h("h3", {}, "Who holds what"),
      this.claimRows,
      h("h3", {}, "Links to hand out"),
      this.links(hello),
      h("h3", {}, "Keep this session"),
      h("form", { class: "row", onsubmit: (event) => event.preventDefault() }, name, save),
      this.exercise.root,
      this.tools.root,
      // What was run and kept first: the scenarios are many and have long texts.
      recordings.length > 0 && h("h3", {}, "Recorded sessions"),
      recordings.length > 0 && this.entries(recordings, hello),
      h("h3", {}, "Scenarios"),
      this.entries(
        hello.gallery.filter(({ written_unix_s }) => written_unix_s === null),
        hello,
      ),
      deleted && h("h3", {}, "Deleted"),
      deleted &&
        h(
          "p",
          { class: "note" },
          "These files are in a folder named deleted beside the others, until they are removed there by hand.",
        ),
      deleted,
    );
  }

  private links(hello: Hello): HTMLElement {
    if (!hello.links || hello.links.length === 0)
      return h(
        "p",
        { class: "note" },
        "The server has printed the links of each role where it was started.",
      );
    return h(
      "ul",
      { class: "rows" },
      ...hello.links.map(({ role, path }) => {
        const url = new URL(path, location.href).href;
        return h(
          "li",
          { class: "link" },
          h("a", { href: url, target: "_blank", rel: "noopener" }, roleOf(role)),
          button("Copy", () => void this.copy(url), { name: `Copy the link of ${roleOf(role)}` }),
        );
      }),
    );
  }

  private async copy(url: string): Promise<void> {
    try {
      await navigator.clipboard.writeText(url);
      this.page.say("Copied.");
    } catch {
      // There is no clipboard without a secure context: the link is shown to be copied by hand.
      window.prompt("Copy this link:", url);
    }
  }

  private entries(entries: Hello["gallery"], hello: Hello): HTMLElement {
    return h(
      "ul",
      { class: "rows gallery" },
      ...entries.map((entry) => this.scenario(entry, hello)),
    );
  }

  private scenario(entry: Hello["gallery"][number], hello: Hello): HTMLElement {
    const open = entry.file === hello.file;
    const label = open ? "Start anew" : "Open";
    const when =
      entry.written_unix_s === null
        ? entry.changeable
          ? `File ${entry.file}. `
          : ""
        : `${new Date(entry.written_unix_s * 1000).toLocaleString(undefined, { dateStyle: "medium", timeStyle: "short" })}. `;
    const load = button(
      label,
      async () => {
        if (await askToEnd(entry.title)) void this.page.order({ do: "load", file: entry.file });
      },
      { name: open ? `Start anew: Open ${entry.title}` : `Open ${entry.title}` },
    );
    return h(
      "li",
      { class: open ? "chosen" : "" },
      h("div", {}, h("b", {}, entry.title), h("p", { class: "note" }, when + entry.text)),
      h("div", { class: "file-tools" }, load, ...this.tools.of(entry, hello)),
    );
  }

  tick(frame: Frame): void {
    setText(this.count, `${frame.run.clients} connected`);
    const { opening } = frame.run;
    setClass(this.openingRow, "hidden", opening === null);
    if (opening)
      setText(
        this.opening,
        `Opening ${opening.file}: ${opening.at === "reads" ? "read" : "played again"} ${Math.floor(100 * opening.share)} %`,
      );
  }

  claims(hello: Hello): void {
    this.claimRows.replaceChildren(
      ...hello.claims.map(({ control, holder, connected }) => {
        const row = h(
          "li",
          {},
          h("b", {}, spoken(nameOf(control))),
          h(
            "span",
            {},
            holder === null
              ? "nobody"
              : `${spoken(holder)}${connected ? "" : " — left; the orders stay as they are"}`,
          ),
        );
        setClass(row, "caution", holder !== null && !connected);
        return row;
      }),
    );
  }
}
