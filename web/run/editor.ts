/** The editor of the scenario's text: line numbers, marks at mistakes and notices, and steps of the number at the cursor. */
import type { Notice, Problem } from "fenderline";
import { button, h, setText } from "../src/ui/dom";
import { numberAt, stepped } from "./numbers";

/** A held button steps again after this time, then at this interval [ms]. */
const HELD_MS: [number, number] = [400, 120];

interface Mark {
  line: number;
  column: number;
  kind: "alarm" | "caution";
}

export class Editor {
  readonly area = h("textarea", {
    "aria-label": "Scenario",
    spellcheck: "false",
    autocapitalize: "off",
    autocomplete: "off",
    wrap: "off",
  });
  private readonly gutter = h("pre", { class: "gutter", "aria-hidden": "true" });
  private readonly backdrop = h("pre", { class: "backdrop", "aria-hidden": "true" });
  private readonly number = h("output", { class: "number" });
  private readonly problem = h("div", { class: "problem hidden", role: "alert" });
  private readonly notices = h("ul", { class: "notices", "aria-label": "Notices" });
  private marks: Mark[] = [];
  /** Number of lines in the gutter. */
  private count = 0;
  readonly root: HTMLElement;

  /** `changed` gets every new text. */
  constructor(private readonly changed: (text: string) => void) {
    const [less, more] = [false, true].map((up) => this.stepButton(up));
    this.root = h(
      "section",
      { class: "editor", "aria-label": "Scenario" },
      h(
        "div",
        { class: "paper" },
        this.gutter,
        h("div", { class: "sheet" }, this.backdrop, this.area),
      ),
      this.problem,
      this.notices,
      h("div", { class: "nudge" }, less, this.number, more),
    );
    this.area.addEventListener("input", () => this.edited());
    this.area.addEventListener("scroll", () => this.scrolled());
    this.area.addEventListener("blur", () => {
      const mistake = this.marks.find(({ kind }) => kind === "alarm");
      if (mistake) this.reveal(mistake.line);
    });
    this.area.addEventListener("keydown", (event) => this.pressed(event));
    document.addEventListener("selectionchange", () => this.showNumber());
  }

  get text(): string {
    return this.area.value;
  }

  /** Shows another text. */
  open(text: string): void {
    this.area.value = text;
    this.area.setSelectionRange(0, 0);
    [this.area.scrollTop, this.area.scrollLeft] = [0, 0];
    this.clear();
    this.scrolled();
  }

  /** Removes all marks. */
  clear(): void {
    this.marks = [];
    this.problem.classList.add("hidden");
    this.notices.replaceChildren();
    this.draw();
  }

  /** Marks a mistake and says what it is. */
  refuse(problem: Problem): void {
    const { line, column, message, help, file } = problem;
    this.clear();
    if (line !== null) this.marks = [{ line, column: column ?? 1, kind: "alarm" }];
    const where = line === null ? "" : `Line ${line}, column ${column ?? 1}`;
    this.problem.replaceChildren(
      where === ""
        ? h("b", {}, file ?? "")
        : button(where, () => this.show(line ?? 1, column ?? 1), { name: `Go to ${where}` }),
      h("p", {}, `${message}.`),
      ...(help === null ? [] : [h("p", { class: "help-line" }, help)]),
    );
    this.problem.classList.remove("hidden");
    this.draw();
    if (line !== null) this.reveal(line);
  }

  /** Marks what looks unintended. */
  note(notices: Notice[], start: string[]): void {
    this.clear();
    this.marks = notices.flatMap(({ line, column }): Mark[] =>
      line === null ? [] : [{ line, column: column ?? 1, kind: "caution" }],
    );
    this.notices.replaceChildren(
      ...notices.map(({ line, column, key, message }) =>
        h(
          "li",
          {},
          line === null
            ? h("b", {}, key)
            : button(`Line ${line}`, () => this.show(line, column ?? 1)),
          h("span", {}, line === null ? message : `${key}: ${message}`),
        ),
      ),
      ...start.map((text) => h("li", {}, h("span", {}, `${text}.`))),
    );
    this.draw();
  }

  /** Puts the cursor at a place. */
  show(line: number, column: number): void {
    const lines = this.text.split("\n").slice(0, line);
    const last = lines.pop() ?? "";
    const before = lines.reduce((sum, each) => sum + each.length + 1, 0);
    const at = before + [...last].slice(0, column - 1).join("").length;
    this.area.focus();
    this.area.setSelectionRange(at, at);
    this.scrollTo(line);
  }

  /** Brings the line of a mistake into view. Who types keeps the line of the cursor in view too; where both do not fit, the view
   *  goes to the mistake when the typing ends. */
  private reveal(line: number): void {
    if (document.activeElement !== this.area) {
      this.scrollTo(line);
      return;
    }
    const cursor = this.text.slice(0, this.area.selectionEnd).split("\n").length;
    const height = this.lineHeight();
    const [first, last] = [Math.min(line, cursor) - 1, Math.max(line, cursor)];
    if ((last - first) * height > this.area.clientHeight) return;
    const { scrollTop, clientHeight } = this.area;
    const lowest = last * height - clientHeight;
    this.area.scrollTop = Math.min(Math.max(scrollTop, lowest), first * height);
  }

  private scrollTo(line: number): void {
    this.area.scrollTop = Math.max(0, (line - 4) * this.lineHeight());
  }

  private lineHeight(): number {
    return this.area.scrollHeight / Math.max(1, this.text.split("\n").length);
  }

  private edited(): void {
    this.draw();
    this.changed(this.text);
  }

  /** Line numbers, and the marks behind the text. */
  private draw(): void {
    const lines = this.text.split("\n");
    if (lines.length !== this.count) {
      this.count = lines.length;
      setText(this.gutter, lines.map((_, i) => i + 1).join("\n"));
    }
    const marks = this.marks.toSorted((a, b) => a.line - b.line);
    const parts: (Node | string)[] = [];
    let drawn = 0;
    for (const mark of marks) {
      // One mark a line: the first.
      if (mark.line <= drawn) continue;
      parts.push(
        lines
          .slice(drawn, mark.line - 1)
          .map(ended)
          .join(""),
      );
      parts.push(markedLine(lines[mark.line - 1] ?? "", mark));
      drawn = mark.line;
    }
    this.backdrop.replaceChildren(...parts);
    this.scrolled();
  }

  private scrolled(): void {
    const { scrollTop, scrollLeft } = this.area;
    this.gutter.style.transform = `translateY(${-scrollTop}px)`;
    this.backdrop.style.transform = `translate(${-scrollLeft}px, ${-scrollTop}px)`;
  }

  private pressed(event: KeyboardEvent): void {
    const up = event.key === "ArrowUp";
    if (!event.altKey || (!up && event.key !== "ArrowDown")) return;
    event.preventDefault();
    this.step(up);
  }

  private stepButton(up: boolean): HTMLButtonElement {
    const own = button(up ? "+" : "−", () => {}, {
      name: up ? "Greater number (Alt+↑)" : "Smaller number (Alt+↓)",
    });
    let timer = 0;
    const again = (after_ms: number) => {
      this.step(up);
      timer = window.setTimeout(() => again(HELD_MS[1]), after_ms);
    };
    own.addEventListener("pointerdown", (event) => {
      // Keeps the cursor where it is, and a phone's keyboard away.
      event.preventDefault();
      own.setPointerCapture(event.pointerId);
      again(HELD_MS[0]);
    });
    for (const end of ["pointerup", "pointercancel"] as const)
      own.addEventListener(end, () => clearTimeout(timer));
    own.addEventListener("keydown", (event) => {
      if (event.key === "Enter" || event.key === " ") this.step(up);
    });
    return own;
  }

  /** Steps the number at the cursor. */
  private step(up: boolean): void {
    const found = numberAt(this.text, this.area.selectionEnd);
    if (!found) return;
    this.area.setRangeText(stepped(found.text, up), found.from, found.to, "end");
    this.edited();
    this.showNumber();
  }

  private showNumber(): void {
    const found = numberAt(this.text, this.area.selectionEnd);
    const start = this.text.lastIndexOf("\n", (found?.from ?? 0) - 1) + 1;
    const key = found
      ? (/^ *([\w.-]+) *=/.exec(this.text.slice(start, found.from))?.[1] ?? "")
      : "";
    setText(this.number, found ? `${key} ${found.text}`.trim() : "Number at the cursor");
  }
}

const ended = (line: string): string => `${line}\n`;

/** A line with a mark at a word. */
function markedLine(line: string, { column, kind }: Mark): HTMLElement {
  const letters = [...line];
  const before = letters.slice(0, column - 1).join("");
  const rest = letters.slice(column - 1).join("");
  const word = /^(?:"[^"]*"|[\w.-]+|.)/u.exec(rest)?.[0] ?? " ";
  return h(
    "span",
    { class: `marked ${kind}` },
    before,
    h("mark", {}, word),
    ended(rest.slice(word.length)),
  );
}
