/** The page: the scenario's text beside the plan and the results. A change of the text is run at once. */
import type { ScenarioInfo } from "fenderline";
import { type Drawn, drawMoment } from "../src/bridge/moment";
import { Pane, type Share } from "../src/bridge/pane";
import { History } from "../src/history";
import { Live, structure } from "../src/live";
import { THEMES, type ThemeName, applyPalette } from "../src/palette";
import type { Frame, Hello } from "../src/protocol";
import { button, h, setAttribute, setClass, setText } from "../src/ui/dom";
import { TabRow } from "../src/ui/tab_row";
import { Conning } from "../src/views/conning";
import { Fenders } from "../src/views/fenders";
import { Plan } from "../src/views/plan";
import { Strips } from "../src/views/strips";
import { Verdict, setGravity } from "../src/views/verdict";
import type { View } from "../src/views/view";
import { Worst } from "../src/worst";
import { Editor } from "./editor";
import { EXAMPLES, titleOf } from "./examples";
import type { Heard, Job } from "./messages";
import { Maker } from "./maker";
import { bytesOf, isModel, textOf } from "./model_text";
import { Outcome } from "./outcome";
import { Runner } from "./runner";
import { Timeline } from "./timeline";

/** Wait after the last change before it is run [ms]. */
const SETTLED_MS = 350;
/** The largest file that is taken (bytes). Scenarios have some kilobytes; the editor stays quick up to here. */
const LARGEST_FILE = 4 << 20;
/** The program takes texts of 16 MB, and base64 has a third more characters than a model has bytes. */
const LARGEST_MODEL = 8 << 20;
/** From this width on the editor has a column of its own. */
const WIDE = "(min-width: 1400px)";

interface Tab {
  name: string;
  view: View;
  button: HTMLButtonElement;
}

export class Workbench {
  private readonly live = new Live();
  private readonly runner = new Runner({
    ready: (version) => this.ready(version),
    heard: (message) => this.heard(message),
    lost: (why) => this.lost(why),
  });
  private readonly editor = new Editor(() => this.changed());
  private readonly outcome = new Outcome();
  private readonly maker = new Maker(this.runner, (file, text, files) => {
    this.offer(file);
    this.openText(file, text, files);
  });
  private readonly timeline = new Timeline(
    (index) => this.go(index),
    () => this.peak(),
  );
  private readonly history = new History(0);
  private frames: Frame[] = [];
  private info: ScenarioInfo | null = null;
  private file = "";
  private files: Record<string, string> = {};
  /** The files of the run that is shown: others may have been opened since. */
  private ran: Record<string, string> = {};
  private sent: Record<string, string> = {};
  /** The bytes of a model among the files of the run. */
  private readonly model = async (_: number, file: string): Promise<ArrayBuffer> =>
    bytesOf(this.ran[file] ?? "");
  private plan: Plan | null = null;
  private tabs: Tab[] = [];
  private tabRow: TabRow | null = null;
  private shownTab = "Fenders";
  private built = "";
  private timer = 0;
  private began_ms = 0;

  private readonly choose = h("select", {
    "aria-label": "Scenario",
    onchange: () => this.openExample(),
  });
  private readonly picked = h("input", {
    type: "file",
    accept: ".toml,.geojson,.json,.csv,.asc,.xyz,.txt,.glb",
    multiple: true,
    class: "hidden",
    "aria-label": "Scenario file",
    onchange: () => void this.take(this.picked.files),
  });
  private readonly runButton = button("Run", () => this.runOrStop(), { class: "take run" });
  private readonly state = h("span", { class: "run-state", role: "status", "aria-label": "Run" });
  private readonly progress = h("progress", { max: 1, value: 0, "aria-label": "Progress" });
  private readonly verdictButton = button("–", () => this.show("Verdict"), {
    class: "verdict-button",
    name: "Verdict",
  });
  private readonly paletteButton = button("Day", () => this.nextPalette(), { name: "Palette" });
  private readonly banner = h("div", { class: "banner hidden", role: "alert" });
  private readonly stage = h("main", { class: "stage" });
  private readonly panel = h("section", { class: "panel", "aria-label": "Panel" });
  private readonly aside = h("div", { class: "aside" });
  private readonly planBox = h("div", { class: "plan-box" });
  /** The view out of the window. */
  private readonly pane = new Pane(this.live, {
    share: (how) => this.share(how),
    say: (text) => this.say(text),
    model: this.model,
  });

  constructor(root: HTMLElement) {
    for (const [index, example] of EXAMPLES.entries())
      this.choose.append(h("option", { value: index }, titleOf(example)));
    root.replaceChildren(
      h(
        "header",
        { class: "top" },
        h("h1", {}, "fenderline"),
        this.choose,
        button("Open…", () => this.picked.click(), { name: "Open a scenario file" }),
        this.picked,
        this.runButton,
        this.progress,
        this.state,
        h("span", { class: "space" }),
        this.verdictButton,
        this.paletteButton,
      ),
      this.banner,
      this.stage,
      this.timeline.root,
    );
    this.stage.append(this.aside, this.planBox, this.panel);
    const kept = localStorage.getItem("palette") as ThemeName | null;
    this.setPalette(kept && THEMES.includes(kept) ? kept : "day");
    const wide = matchMedia(WIDE);
    wide.addEventListener("change", () => this.buildTabs());
    this.buildTabs();
  }

  start(): void {
    this.listen();
    this.openExample(false);
    setText(this.state, "loading");
    // All that a later click needs, so that nothing is asked of the server afterwards.
    const later = [
      import("uplot"),
      import("uplot/dist/uPlot.min.css"),
      import("../src/bridge/picture").then(({ loadModels }) => loadModels()),
      import("../src/instruments/components"),
    ];
    Promise.all([this.runner.load(), ...later]).catch((error: unknown) =>
      this.say(`The page could not be loaded: ${String(error)}`),
    );
    requestAnimationFrame((now) => this.draw(now));
  }

  private ready(version: string): void {
    document.documentElement.dataset.ready = version;
    this.run();
  }

  // ---------------------------------------------------------------------------------------------------- scenarios

  private openExample(run = true): void {
    const example = EXAMPLES[Number(this.choose.value)];
    if (example) this.openText(example.file, example.text, example.files ?? {}, run);
  }

  private openText(file: string, text: string, files: Record<string, string>, run = true): void {
    [this.file, this.files] = [file, files];
    this.editor.open(text);
    this.say("");
    // Another scenario: the plan looks at it anew.
    this.built = "";
    if (run) this.run();
  }

  /** Takes dropped or chosen files: one scenario, and those that it names. */
  private async take(list: FileList | null | undefined): Promise<void> {
    const all = [...(list ?? [])];
    this.picked.value = "";
    if (all.length === 0) return;
    const large = all.find(
      ({ name, size }) => size > (isModel(name) ? LARGEST_MODEL : LARGEST_FILE),
    );
    if (large) {
      const size = (large.size / 1e6).toFixed(0);
      const most = isModel(large.name) ? "models of up to 8 MB" : "scenarios of up to 4 MB";
      this.say(`${large.name} has ${size} MB: this page takes ${most}.`);
      return;
    }
    const texts: Record<string, string> = {};
    for (const file of all) {
      try {
        const bytes = await file.arrayBuffer();
        texts[file.name] = isModel(file.name)
          ? textOf(bytes)
          : new TextDecoder("utf-8", { fatal: true }).decode(bytes);
      } catch {
        this.say(`${file.name} is not UTF-8 text: a scenario is a file of text in TOML.`);
        return;
      }
    }
    // The scenario is the file that names bodies; the others are those that it names.
    const names = Object.keys(texts);
    if (names.every(isModel)) {
      // Models alone join the scenario that is open.
      this.files = { ...this.files, ...texts };
      this.run();
      return;
    }
    const scenario =
      names.find((name) => /^\[body\./m.test(texts[name] ?? "")) ??
      names.find((name) => !isModel(name)) ??
      "";
    const { [scenario]: text = "", ...others } = texts;
    this.offer(scenario);
    this.openText(scenario, text, others);
  }

  /** Shows the name of an opened file in the list. */
  private offer(name: string): void {
    this.choose.querySelector("option[value=own]")?.remove();
    this.choose.prepend(h("option", { value: "own", selected: true }, name));
    this.choose.value = "own";
  }

  private changed(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.run(), SETTLED_MS);
  }

  private run(): void {
    clearTimeout(this.timer);
    if (document.documentElement.dataset.ready === undefined) return;
    this.sent = this.files;
    const job: Job = { text: this.editor.text, file: this.file, files: this.files };
    this.setRunning(true);
    setText(this.state, "checking");
    this.runner.run(job);
  }

  private runOrStop(): void {
    if (this.runButton.dataset.running === "yes") this.runner.stop();
    else this.run();
  }

  private setRunning(on: boolean): void {
    this.runButton.dataset.running = on ? "yes" : "no";
    setText(this.runButton, on ? "Stop" : "Run");
    setClass(this.progress, "idle", !on);
  }

  // ------------------------------------------------------------------------------------------------------- the run

  private heard(message: Heard): void {
    switch (message.type) {
      case "refused":
        this.setRunning(false);
        this.editor.refuse(message.problem);
        setText(
          this.state,
          message.problem.line === null ? "mistake" : `mistake in line ${message.problem.line}`,
        );
        setClass(this.state, "caution", true);
        setClass(this.stage, "stale", true);
        // The verdict was on another text.
        setText(this.verdictButton, "–");
        setAttribute(this.verdictButton, "aria-label", "Verdict");
        setGravity(this.verdictButton, "note");
        break;
      case "begun":
        this.begin(message.info, JSON.parse(message.hello) as Hello);
        break;
      case "frame":
        this.frame(JSON.parse(message.frame) as Frame, message.kept, message.step);
        break;
      case "failed":
        this.ended(message.results);
        this.say(`The run could not go on: ${message.problem.message}. Results are those before.`);
        setText(this.state, "failed");
        break;
      case "done":
        this.ended(message.results);
        setText(
          this.state,
          `${message.complete ? "done in" : "stopped after"} ${(message.took_ms / 1e3).toFixed(1)} s`,
        );
        setClass(this.state, "caution", !message.complete);
    }
  }

  private begin(info: ScenarioInfo, hello: Hello): void {
    this.info = info;
    this.editor.note(info.notices, info.start);
    this.say("");
    setClass(this.stage, "stale", false);
    setClass(this.state, "caution", false);
    this.began_ms = performance.now();
    this.frames = [];
    this.history.clear();
    this.outcome.show(null, this.file);
    this.timeline.begin();
    document.title = `${info.title} · fenderline`;
    this.ran = this.sent;
    // There is no instructor here to whom marks could be left.
    if (hello.exercise) hello.exercise.view_marks = true;
    this.live.welcome(hello);
    const key = structure(hello);
    if (key !== this.built) {
      this.built = key;
      this.build(hello);
    }
  }

  private frame(frame: Frame, kept: boolean, step: number): void {
    const { info } = this;
    const { hello } = this.live;
    if (!info || !hello) return;
    const share = step / info.steps;
    this.progress.value = share;
    setText(this.state, this.remaining(share));
    if (!kept) {
      this.showFrame(frame);
      return;
    }
    this.frames.push(frame);
    this.live.tick(frame, performance.now());
    this.history.add(frame, hello, this.live.ship(), this.live.body());
    this.timeline.added(this.frames.length);
  }

  /** Share done, and the time that is left where that is worth telling. */
  private remaining(share: number): string {
    const spent_s = (performance.now() - this.began_ms) / 1e3;
    const percent = `${Math.floor(share * 100)} %`;
    if (share <= 0 || spent_s < 2) return percent;
    const left_s = (spent_s / share) * (1 - share);
    if (left_s < 90) return `${percent}, ${Math.ceil(left_s)} s left`;
    if (left_s < 5400) return `${percent}, ${Math.ceil(left_s / 60)} min left`;
    return `${percent}, more than ${Math.floor(left_s / 3600)} h left`;
  }

  private ended(results: Parameters<Outcome["show"]>[0]): void {
    this.setRunning(false);
    this.outcome.show(results, this.file, () => this.largestDrawn());
  }

  /** The picture of the largest fender load among the kept frames; `null`: no fender was loaded. */
  private async largestDrawn(): Promise<Drawn | null> {
    const { hello } = this.live;
    const last = this.frames.at(-1);
    if (!hello || !last) return null;
    const worst = new Worst();
    for (const frame of this.frames) worst.hear(frame, hello);
    const moment = worst.found(last.run);
    return moment && drawMoment(moment, last, this.model);
  }

  private lost(why: string): void {
    this.setRunning(false);
    setText(this.state, "ended");
    setClass(this.state, "caution", true);
    this.say(why);
  }

  /** Shows a kept frame. */
  private go(index: number): void {
    const frame = this.frames[index];
    if (frame) this.showFrame(frame);
  }

  /** The kept frame with the largest contact force. */
  private peak(): number {
    const sizes = this.frames.map(({ contacts }) =>
      Math.max(0, ...contacts.map(({ force_n }) => Math.hypot(...force_n))),
    );
    return sizes.indexOf(Math.max(...sizes));
  }

  private showFrame(frame: Frame): void {
    const { hello } = this.live;
    if (!hello) return;
    this.live.tick(frame, performance.now());
    this.timeline.show(frame.t_s, this.info?.duration_s ?? 0);
    const { text, gravity } = frame.verdict;
    setText(this.verdictButton, text);
    setAttribute(this.verdictButton, "aria-label", `Verdict: ${text}`);
    setGravity(this.verdictButton, gravity);
    this.plan?.tick(frame);
    this.tabs.find(({ name }) => name === this.shownTab)?.view.tick(frame, hello);
  }

  // ------------------------------------------------------------------------------------------------------ building

  private build(hello: Hello): void {
    this.plan = new Plan(this.live);
    this.plan.addTool(button("View", () => this.share("view"), { name: "View out of the window" }));
    this.planBox.replaceChildren(this.plan.root, this.pane.root);
    this.views = this.viewsOf(hello);
    this.buildTabs();
  }

  /** Shares the place of the plan between the plan and the view out of the window. */
  private share(how: Share): void {
    setClass(this.planBox, "with-view", how === "view");
    setClass(this.planBox, "with-both", how === "both");
    this.pane.shares(how);
  }

  private views: [string, View][] = [];

  private viewsOf(hello: Hello): [string, View][] {
    const whole = {
      duration_s: () => this.info?.duration_s ?? 1,
      at_s: () => this.live.frame?.t_s ?? 0,
    };
    const conning: [string, View][] =
      hello.vessels.length > 0 ? [["Conning", new Conning(this.live)]] : [];
    return [
      ["Fenders", new Fenders(hello)],
      ...conning,
      ["Charts", new Strips(this.history, whole)],
      ["Verdict", new Verdict()],
      ["Report", this.outcome],
      ["New exercise", this.maker],
    ];
  }

  /** The panel's tabs; on a narrow page the editor is one of them. */
  private buildTabs(): void {
    const isWide = matchMedia(WIDE).matches;
    const scroll = this.editor.area.scrollTop;
    const views: [string, View][] = isWide
      ? this.views
      : [["Scenario", { root: this.editor.root, tick: () => {} }], ...this.views];
    this.aside.replaceChildren(...(isWide ? [this.editor.root] : []));
    setClass(this.editor.root, "view", !isWide);
    this.tabs = views.map(([name, view]) => ({
      name,
      view,
      button: button(name, () => this.show(name), { role: "tab", name, "aria-selected": "false" }),
    }));
    const size = button("⤢", () => this.stage.classList.toggle("panel-only"), {
      name: "Panel over the whole page",
      class: "widen",
    });
    this.tabRow = new TabRow(this.tabs.map((tab) => tab.button));
    this.panel.replaceChildren(
      h("h2", { class: "unseen" }, "Views"),
      h("div", { class: "tabs" }, this.tabRow.root, size),
    );
    for (const { name, view } of this.tabs) {
      view.root.classList.add("view");
      view.root.setAttribute("role", "tabpanel");
      // A view that scrolls is scrolled by keys too.
      view.root.tabIndex = 0;
      view.root.setAttribute("aria-label", name);
      this.panel.append(view.root);
    }
    this.show(this.tabs.some(({ name }) => name === this.shownTab) ? this.shownTab : "Fenders");
    this.editor.area.scrollTop = scroll;
  }

  private show(name: string): void {
    this.shownTab = name;
    if (name === "New exercise") void this.maker.open();
    if (name === "Report") void this.outcome.illustrate();
    for (const tab of this.tabs) {
      setClass(tab.view.root, "shown", tab.name === name);
      setAttribute(tab.button, "aria-selected", String(tab.name === name));
      if (tab.name === name) this.tabRow?.reveal(tab.button);
    }
    const { frame, hello } = this.live;
    if (frame && hello) this.tabs.find((tab) => tab.name === name)?.view.tick(frame, hello);
  }

  private draw(now_ms: number): void {
    requestAnimationFrame((next) => this.draw(next));
    this.timeline.draw(performance.now());
    this.plan?.draw(performance.now());
    this.pane.draw(performance.now());
    this.tabs.find(({ name }) => name === this.shownTab)?.view.draw?.(now_ms);
  }

  // ---------------------------------------------------------------------------------------------------------- input

  private listen(): void {
    addEventListener("dragover", (event) => {
      event.preventDefault();
      document.body.classList.add("dropping");
    });
    addEventListener("dragleave", (event) => {
      if (event.relatedTarget === null) document.body.classList.remove("dropping");
    });
    addEventListener("drop", (event) => {
      event.preventDefault();
      document.body.classList.remove("dropping");
      void this.take(event.dataTransfer?.files);
    });
    addEventListener("keydown", (event) => {
      const target = event.target as HTMLElement;
      if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) this.run();
      else if (event.key === " " && !target.matches("textarea, button, select, input[type=file]")) {
        event.preventDefault();
        this.timeline.toggle();
      }
    });
  }

  private say(text: string): void {
    setText(this.banner, text);
    setClass(this.banner, "hidden", text === "");
  }

  private setPalette(name: ThemeName): void {
    applyPalette(name);
    // The view out of the window is as bright by day as it can be.
    this.pane.setPalette(name === "bright" ? "day" : name);
    localStorage.setItem("palette", name);
    const shown = name.replace(/^./, (c) => c.toUpperCase());
    setText(this.paletteButton, shown);
    setAttribute(this.paletteButton, "aria-label", `Palette: ${shown}`);
  }

  private nextPalette(): void {
    const now = document.documentElement.dataset.palette as ThemeName;
    this.setPalette(THEMES[(THEMES.indexOf(now) + 1) % THEMES.length] ?? "day");
  }
}
