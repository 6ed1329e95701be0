/** The results of a run: the report, and the files to keep. */
import type { View } from "../src/views/view";
import { button, h } from "../src/ui/dom";
import type { Results } from "./messages";

export class Outcome implements View {
  private results: Results | null = null;
  private stem = "";
  private address = "";
  private readonly frame = h("iframe", { title: "Report", sandbox: "allow-scripts" });
  private readonly none = h("p", { class: "nothing" }, "The report is made at the end of the run.");
  private readonly tools = h(
    "div",
    { class: "row tools hidden" },
    button("Open in a tab", () => window.open(this.address, "_blank", "noopener")),
    button("Save report", () => this.save("report.html", "text/html", this.results?.report)),
    button("Save summary", () =>
      this.save("summary.json", "application/json", this.results?.summary),
    ),
    button("Print", () => this.print()),
  );
  readonly root = h("div", { class: "outcome" }, this.tools, this.none, this.frame);

  /** `null`: there are none yet. */
  show(results: Results | null, file: string): void {
    this.results = results;
    this.stem = file.replace(/\.toml$/, "");
    if (this.address !== "") URL.revokeObjectURL(this.address);
    this.address = results ? URL.createObjectURL(page(results.report)) : "";
    this.tools.classList.toggle("hidden", results === null);
    this.none.classList.toggle("hidden", results !== null);
    this.frame.classList.toggle("hidden", results === null);
    this.frame.srcdoc = results?.report ?? "";
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
