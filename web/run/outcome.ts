/** The results of a run: the report, and the files to keep. */
import type { Drawn } from "../src/bridge/moment";
import { withPicture } from "../src/report_picture";
import { button, h, setText } from "../src/ui/dom";
import type { View } from "../src/views/view";
import type { Results } from "./messages";

export class Outcome implements View {
  private results: Results | null = null;
  private stem = "";
  private address = "";
  /** The report, with the picture once that is drawn. */
  private report = "";
  /** Draws the picture of the largest fender load; `null`: none is wanted any more. */
  private draws: (() => Promise<Drawn | null>) | null = null;
  private readonly frame = h("iframe", { title: "Report", sandbox: "allow-scripts" });
  private readonly none = h("p", { class: "nothing" }, "The report is made at the end of the run.");
  private readonly state = h("span", { role: "status" });
  private readonly tools = h(
    "div",
    { class: "row tools hidden" },
    button("Open in a tab", () => window.open(this.address, "_blank", "noopener")),
    button("Save report", () => this.save("report.html", "text/html", this.report)),
    button("Save summary", () =>
      this.save("summary.json", "application/json", this.results?.summary),
    ),
    button("Print", () => this.print()),
    this.state,
  );
  readonly root = h("div", { class: "outcome" }, this.tools, this.none, this.frame);

  /** `null`: there are none yet. `draws`: draws the picture of the largest fender load, if a fender was loaded. */
  show(
    results: Results | null,
    file: string,
    draws: (() => Promise<Drawn | null>) | null = null,
  ): void {
    this.results = results;
    this.stem = file.replace(/\.toml$/, "");
    this.draws = results && draws;
    this.tools.classList.toggle("hidden", results === null);
    this.none.classList.toggle("hidden", results !== null);
    this.frame.classList.toggle("hidden", results === null);
    this.put(results?.report ?? "");
    if (this.root.classList.contains("shown")) void this.illustrate();
  }

  private put(report: string): void {
    this.report = report;
    if (this.address !== "") URL.revokeObjectURL(this.address);
    this.address = report === "" ? "" : URL.createObjectURL(page(report));
    this.frame.srcdoc = report;
  }

  /** Draws the picture when the report is first looked at: not after each change of the scenario. */
  async illustrate(): Promise<void> {
    const { draws, results } = this;
    if (!draws || !results) return;
    this.draws = null;
    this.drawing(true);
    const drawn = await draws();
    this.drawing(false);
    if (drawn && this.results === results) this.put(withPicture(results.report, drawn));
  }

  /** Nobody saves the report while its picture is drawn. */
  private drawing(on: boolean): void {
    for (const each of this.tools.querySelectorAll("button")) each.disabled = on;
    setText(this.state, on ? "Drawing the picture of the largest fender load …" : "");
  }

  tick(): void {}

  private print(): void {
    window.open(this.address, "_blank")?.addEventListener("load", function () {
      this.print();
    });
  }

  private save(name: string, type: string, text: string | undefined): void {
    if (text === undefined) return;
    const url = URL.createObjectURL(new Blob([text], { type }));
    h("a", { href: url, download: `${this.stem}-${name}` }).click();
    URL.revokeObjectURL(url);
  }
}

const page = (html: string): Blob => new Blob([html], { type: "text/html;charset=utf-8" });
