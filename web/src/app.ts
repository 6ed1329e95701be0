/** The page: bar, plan, panel with tabs, control strip, and which of them each role sees; keys; the drawing loop. */
import { type Drawn, drawMoment } from "./bridge/moment";
import { Pane, type Share } from "./bridge/pane";
import { Connection, type LinkState } from "./connection";
import type { Group, KeyAction } from "./controls/group";
import { Helm } from "./controls/helm";
import { Run } from "./controls/run";
import { tugHelm } from "./controls/tugmaster";
import { Tugs } from "./controls/tugs";
import { fileNameOf } from "./file_name";
import { Help } from "./help";
import { Hints } from "./hints";
import { History } from "./history";
import { Live, structure } from "./live";
import { NameBadge } from "./name";
import { ON_PAGE, isOrder, unknownOrders } from "./orders";
import type { Page } from "./page";
import { PastRequests } from "./past";
import { Placing } from "./placing";
import { THEMES, type ThemeName, applyPalette } from "./palette";
import {
  type Action,
  type Alarm,
  type FromServer,
  type Hello,
  PROTOCOL,
  type PlannedNow,
  type Role,
  type VerdictNow,
} from "./protocol";
import { illustrate } from "./report_picture";
import { Trial } from "./trial";
import { button, h, setAttribute, setClass, setText } from "./ui/dom";
import { TabRow } from "./ui/tab_row";
import { Seat } from "./seat";
import { Sound } from "./sound";
import { clock, fixed, spoken, spokenFinding, tugCalled } from "./units";
import { Alarms } from "./views/alarms";
import { Anchors } from "./views/anchors";
import { Conditions } from "./views/conditions";
import { Conning } from "./views/conning";
import { Docking } from "./views/docking";
import { Exercise } from "./views/exercise";
import { Fenders } from "./views/fenders";
import { Lines } from "./views/lines";
import { FileTools } from "./views/file_tools";
import { GalleryKeeper } from "./views/gallery_keeper";
import { NewExerciseView } from "./views/new_exercise";
import { Place } from "./views/place";
import { Plan } from "./views/plan";
import { SaveExercise } from "./views/save_exercise";
import { Session } from "./views/session";
import { Strips } from "./views/strips";
import { TrialView } from "./views/trial";
import { Verdict, setGravity } from "./views/verdict";
import type { View } from "./views/view";
import { Worst, mostLoaded } from "./worst";

const SAID_MS = 6000;
/** Period over which drawn frames per second are counted. */
const FPS_MS = 1000;

interface Tab {
  name: string;
  /** Its key; the instructor's own tabs have none. */
  key: string | null;
  view: View;
  button: HTMLButtonElement;
}

/** The user's model of a vessel, from the server. */
async function fetchModel(vessel: number): Promise<ArrayBuffer> {
  const token = new URLSearchParams(location.search).get("token") ?? "";
  const answer = await fetch(`model?token=${encodeURIComponent(token)}&vessel=${vessel}`);
  if (!answer.ok) throw new Error((await answer.text()).slice(0, 200));
  return answer.arrayBuffer();
}

export class App implements Page {
  readonly live = new Live();
  readonly trial = new Trial();
  private readonly connection: Connection;
  private readonly history = new History();
  private readonly worst = new Worst();
  private readonly past = new PastRequests(() => this.connection.send(this.charted()));
  private readonly sound = new Sound();
  private readonly hints = new Hints();
  private readonly help = new Help(
    () => this.live.hello && this.hints.again(this.live.hello.role.name),
  );
  private built = "";
  /** The program is of another version than this page. */
  private outdated = false;
  private newExercise: NewExerciseView | null = null;
  private readonly saveExercise = new SaveExercise(this);
  private readonly fileTools = new FileTools(this);
  private place: Place | null = null;
  private readonly placing = new Placing(
    (action) => this.order(action),
    () => this.place?.changed(),
  );
  private plan: Plan | null = null;
  /** The view out of the window. */
  private readonly pane = new Pane(
    this.live,
    {
      share: (how) => this.share(how),
      say: (text) => this.say(text),
      model: fetchModel,
    },
    location.search,
  );
  private shared: Share = this.pane.asked === null ? "plan" : "view";
  private trialView: TrialView | null = null;
  private alarms: Alarms | null = null;
  private conditions: Conditions | null = null;
  private plannedEvents: PlannedNow[] = [];
  private tabs: Tab[] = [];
  private tabRow: TabRow | null = null;
  private groups: Group[] = [];
  /** The group of controls that is shown where there is room for one; kept when they are built anew. */
  private shownGroup = "";
  /** Kept over a reload. */
  private shownTab = sessionStorage.getItem("tab") ?? "";
  /** The reason that the server gave when it closed the connection. */
  private why = "";
  private fps = { since: 0, count: 0, shown: 0, jank: 0, last: 0 };

  private readonly title = h("h1", {}, "fenderline");
  private readonly name = new NameBadge((name) => this.order({ do: "name", name }));
  private readonly seat = new Seat((key) => this.connection.send({ do: "seat", key }));
  private readonly held = h("span", { class: "held" });
  private readonly time = h("span", {
    class: "time",
    role: "timer",
    "aria-label": "Simulated time",
  });
  private readonly run = h("span", { class: "run-state", "aria-label": "State of the run" });
  private readonly link = h(
    "span",
    { class: "link-state", role: "status", "aria-label": "Link" },
    "connecting",
  );
  private readonly alarmButton = button("Alarms 0", () => this.show("Alarms"), {
    class: "alarm-button",
    name: "Alarms",
  });
  private readonly verdictButton = button("–", () => this.show("Verdict"), {
    class: "verdict-button",
    name: "Verdict",
  });
  private readonly paletteButton = button("Day", () => this.nextPalette(), {
    title: "Palette (B)",
  });
  private readonly banner = h("div", { class: "banner hidden", role: "alert" });
  private readonly said = h("div", { class: "said", role: "status", "aria-live": "polite" });
  private readonly stage = h("main", { class: "stage" });
  private readonly strip = h("footer", { class: "controls" });

  constructor(root: HTMLElement, url: string) {
    const bar = h(
      "header",
      { class: "top" },
      this.title,
      this.name.root,
      this.time,
      this.run,
      this.held,
      h("span", { class: "space" }),
      this.link,
      this.verdictButton,
      this.alarmButton,
      this.sound.state,
      this.paletteButton,
      button("?", () => this.help.open(this.keys()), { name: "Help and keys (?)" }),
    );
    root.replaceChildren(bar, this.banner, this.stage, this.strip, this.help.root);
    // One of several windows that make a panorama shows the view alone.
    setClass(root, "view-alone", this.pane.asked === "alone");
    const kept = localStorage.getItem("palette") as ThemeName | null;
    this.setPalette(kept && THEMES.includes(kept) ? kept : "day");
    this.connection = new Connection(url, {
      message: (message) => this.heard(message),
      link: (state, why) => this.linked(state, why),
    });
  }

  start(): void {
    this.connection.open();
    document.addEventListener("keydown", (event) => this.pressed(event));
    requestAnimationFrame((now) => this.draw(now));
    // Missing data must be reported even in a tab that is not drawn.
    setInterval(() => this.watch(), 250);
  }

  // ---------------------------------------------------------------------------------------- for views

  async order(action: Action): Promise<boolean> {
    if (this.tries(action)) return true;
    const done = this.answered(await this.connection.send(action));
    if (done) this.hinted(action);
    // The plan of what is opened must not stay behind a panel over the whole page.
    if (done && action.do === "load") this.stage.classList.remove("panel-only");
    return done;
  }

  trialOf(action: Action): Promise<string | null> {
    return this.connection.send(action);
  }

  /** Puts an order into the trial, if one is on. */
  private tries(action: Action): boolean {
    if (!this.trial.take(action)) return false;
    this.trialView?.changed();
    return true;
  }

  async report(): Promise<void> {
    // Opened at once: after the answer a browser would take it for a pop-up.
    const tab = window.open("", "_blank");
    if (tab) tab.document.body.textContent = "Making the report of the session …";
    const drawing = this.largestDrawn();
    const done = await this.order({ do: "report" });
    if (!done) tab?.close();
    else if (tab) {
      const address = new URL(`/report${location.search}`, location.href).href;
      tab.location.href = address;
      const drawn = await drawing;
      const name = `${fileNameOf(this.live.hello?.title ?? "")}-report.html`;
      if (drawn) illustrate(tab, address, name, drawn);
    } else
      this.say("The browser has blocked the report's tab: allow it and press again.", "refusal");
  }

  /** The picture of the largest fender load for the report; `null`: no fender was loaded. */
  private async largestDrawn(): Promise<Drawn | null> {
    const { hello, frame } = this.live;
    if (!hello || !frame?.fenders.some(({ touched }) => touched)) return null;
    const moment = this.worst.found(frame.run);
    if (moment) return drawMoment(moment, frame, fetchModel);
    return {
      none: "this page has not seen that moment. Picture of the largest fender load, in the tab Verdict, goes there, and the next report has the picture",
    };
  }

  drag(control: string, action: Action): void {
    if (this.tries(action)) return;
    this.connection.drag(control, action, (reason) => this.answered(reason));
    this.hinted(action);
  }

  /** Marks the hint for an order as done. */
  private hinted(action: Action): void {
    const hint = isOrder(action.do) ? ON_PAGE[action.do].hint : action.do;
    if (hint !== null) this.did(hint);
  }

  private answered(reason: string | null): boolean {
    if (reason !== null) this.say(`Refused: ${reason}`, "refusal");
    return reason === null;
  }

  say(text: string, level: "note" | "refusal" = "note"): void {
    const same = [...this.said.children].find((each) => each.textContent === text);
    same?.remove();
    const line = h("div", { class: level }, text);
    this.said.append(line);
    while (this.said.children.length > 4) this.said.firstChild?.remove();
    setTimeout(() => line.remove(), SAID_MS);
  }

  did(what: string): void {
    this.hints.did(what);
  }

  // ------------------------------------------------------------------------------------------------- the server

  private heard(message: FromServer): void {
    switch (message.type) {
      case "hello":
        this.welcome(message);
        break;
      case "frame":
        this.live.tick(message, performance.now());
        this.past.frame(message);
        if (this.live.hello) this.worst.hear(message, this.live.hello);
        if (this.live.hello)
          this.history.add(message, this.live.hello, this.live.ship(), this.live.body());
        this.tick();
        break;
      case "prediction":
        this.live.prediction = message;
        break;
      case "planned":
        this.plannedEvents = message.events;
        this.conditions?.planned.heard(message.events);
        break;
      case "trial":
        this.trial.heard(message);
        break;
      case "refused":
        this.say(`Refused: ${message.reason}`, "refusal");
        break;
      case "notice":
        this.say(message.text);
        break;
      case "history":
        // The instructor may have chosen another ship meanwhile.
        if ((message.vessel ?? 0) === this.live.ship()) this.history.restore(message);
        this.alarms?.restore(message.events);
        break;
      case "ack":
        break;
    }
  }

  /** Asks for the charts of the ship that the page is about. */
  private charted(): Action {
    const name =
      this.live.choice().length > 1 ? this.live.vessel(this.live.ship())?.name : undefined;
    return name === undefined ? { do: "history" } : { do: "history", vessel: name };
  }

  /** Makes the instructor's page one about the next ship: plan, helm, docking board and charts. */
  private nextShip(hello: Hello): void {
    const ships = this.live.choice();
    const now = ships.findIndex((ship) => ship === hello.vessels[this.live.ship()]);
    const next = ships[(now + 1) % ships.length];
    if (!next) return;
    this.live.choose(next.name);
    this.history.clear();
    this.past.forget();
    this.build(hello);
    for (const group of this.groups) group.claims(hello);
    for (const { view } of this.tabs) view.claims?.(hello);
    this.newExercise?.offer(hello.gallery);
    this.say(`This page is about ${spoken(next.name)} now.`);
  }

  private linked(state: LinkState, why: string): void {
    if (why !== "") this.why = why;
    if (state !== "open") {
      this.name.forgotten();
      this.seat.forgotten();
    }
    if (state === "open") this.past.forget();
    setText(
      this.link,
      state === "open" ? "linked" : state === "connecting" ? "connecting" : "no link",
    );
    this.watch();
  }

  private welcome(hello: Hello): void {
    this.outdated = hello.protocol !== PROTOCOL || unknownOrders(hello).length > 0;
    this.why = "";
    void this.seat.take();
    this.name.greet();
    const fresh = this.live.hello?.file !== hello.file;
    this.live.welcome(hello);
    if (fresh) {
      this.history.clear();
      this.worst.clear();
      this.past.forget();
      this.sound.welcome(hello.role);
    }
    const key = structure(hello);
    if (key !== this.built) {
      this.built = key;
      this.build(hello);
    }
    for (const group of this.groups) group.claims(hello);
    for (const { view } of this.tabs) view.claims?.(hello);
    this.newExercise?.offer(hello.gallery);
    const briefing = hello.gallery.find((entry) => entry.file === hello.file)?.text ?? "";
    this.help.brief(briefing);
    this.hints.start(hello.role.name, briefing, fresh);
  }

  // --------------------------------------------------------------------------------------------------- building

  private build(hello: Hello): void {
    const { role } = hello;
    setText(this.title, hello.title);
    this.title.title = hello.title;
    this.name.show(roleName(role));
    document.title = `${roleName(role)} · ${hello.title}`;
    document.documentElement.dataset.role = role.name;
    this.buildStage(hello);
    this.buildStrip(hello);
  }

  private buildStage(hello: Hello): void {
    // A view that is built anew, such as after a file was saved, stays where it was scrolled to.
    const scrolled = this.stage.querySelector(".view.shown")?.scrollTop ?? 0;
    const isInstructor = hello.role.name === "instructor";
    const plan = new Plan(this.live, this.trial, isInstructor ? this.placing : null);
    this.plan = plan;
    this.alarms = new Alarms(this, (open, worst) => this.alarmed(open, worst), this.sound.toggles);
    const anchors: [string, string | null, View][] =
      hello.anchors.length > 0 ? [["Anchors", "q", new Anchors(this, hello)]] : [];
    const views: [string, string | null, View][] = [
      ["Docking", "d", new Docking(this, hello)],
      ["Conning", "c", new Conning(this.live)],
      ["Fenders", "e", new Fenders(hello)],
      ["Lines", "w", new Lines(this, hello)],
      ...anchors,
      ["Charts", "g", new Strips(this.history)],
      ["Alarms", "a", this.alarms],
      ["Verdict", "r", new Verdict(isInstructor ? () => void this.largestLoad() : null)],
    ];
    if (hello.exercise) views.push(["Exercise", "y", new Exercise(this, hello, hello.exercise)]);
    this.conditions = null;
    this.place = null;
    if (isInstructor) {
      this.conditions = new Conditions(this, hello);
      this.conditions.planned.heard(this.plannedEvents);
      const own: typeof views = [
        ["Session", null, new Session(this, hello, this.saveExercise, this.fileTools)],
        ["Weather, faults", null, this.conditions],
      ];
      if (hello.vessels.length > 0) {
        this.place = new Place(this, this.placing, hello, () => plan.standStill());
        own.push(["Place ships", null, this.place]);
      }
      if (hello.library) {
        // Kept when the gallery changes, so that nobody loses what is filled in.
        this.newExercise ??= new NewExerciseView(new GalleryKeeper(this), hello.library);
        own.push(["New exercise", null, this.newExercise]);
      }
      views.unshift(...own);
    }
    this.trialView = null;
    this.trial.end();
    this.markTrial(false);
    if (hello.role.name !== "observer" && hello.vessels.length > 0) {
      this.trialView = new TrialView(this, hello, (on) => this.markTrial(on));
      views.push(["Trial", "j", this.trialView]);
      plan.addTool(
        button("Trial", () => this.show("Trial"), { name: "Trial manoeuvre: try orders (J)" }),
      );
    }
    if (this.live.choice().length > 1) {
      const shown = spoken(hello.vessels[this.live.ship()]?.name ?? "");
      plan.addTool(
        button(`${shown} ▸`, () => this.nextShip(hello), {
          name: `Ship: ${shown}; go to the next ship`,
        }),
      );
    }
    this.tabs = views.map(([name, key, view]) => ({
      name,
      key,
      view,
      button: button(
        name,
        () => {
          this.show(name);
          this.did("tab");
        },
        { role: "tab", name, "aria-selected": "false" },
      ),
    }));
    // The trial is opened from the plan.
    const inRow = this.tabs.flatMap((tab) => (tab.name === "Trial" ? [] : [tab.button]));
    this.tabRow = new TabRow(inRow);
    const size = button("⤢", () => this.widen(), {
      name: "Panel over the whole page (X)",
      class: "widen",
    });
    const panel = h(
      "section",
      { class: "panel", "aria-label": "Panel" },
      h("h2", { class: "unseen" }, "Views"),
      h("div", { class: "tabs" }, this.tabRow.root, size),
    );
    for (const { name, view } of this.tabs) {
      view.root.classList.add("view");
      view.root.setAttribute("role", "tabpanel");
      // A view that scrolls is scrolled by keys too.
      view.root.tabIndex = 0;
      view.root.setAttribute("aria-label", name);
      panel.append(view.root);
    }
    plan.addTool(button("View", () => this.share("view"), { name: "View out of the window (,)" }));
    this.stage.replaceChildren(plan.root, this.pane.root, panel, this.said);
    this.share(this.shared);
    const isThere = this.tabs.some((tab) => tab.name === this.shownTab);
    this.show(isThere ? this.shownTab : (this.tabs[0]?.name ?? ""));
    const shown = this.stage.querySelector(".view.shown");
    if (isThere && shown) shown.scrollTop = scrolled;
  }

  private buildStrip(hello: Hello): void {
    const ship = this.live.ship();
    const own = hello.vessels[ship];
    const groups: Group[] = [];
    if (hello.role.name === "tugmaster") {
      const helm = tugHelm(this, hello, hello.role.tug);
      if (helm) groups.push(helm);
    }
    if (hello.role.name === "instructor") groups.push(new Run(this, hello));
    if (hello.role.name === "pilot" || hello.role.name === "instructor") {
      if (own) groups.push(new Helm(this, own, ship, hello));
      const tugs = new Tugs(this, hello);
      if (tugs.count > 0) groups.push(tugs);
    }
    this.groups = groups;
    const buttons = groups.map((group) =>
      button(group.name, () => choose(group), {
        "data-group": group.name,
        "aria-pressed": "false",
      }),
    );
    const choose = (chosen: Group) => {
      this.shownGroup = chosen.name;
      groups.forEach((group, i) => {
        setClass(group.root, "shown", group === chosen);
        const own = buttons[i];
        if (own) setAttribute(own, "aria-pressed", String(group === chosen));
      });
    };
    const nothing =
      hello.role.name === "observer"
        ? "You watch: an observer gives no commands."
        : hello.role.name === "tugmaster"
          ? `This scenario has no tug named ${hello.role.tug}.`
          : "There is nothing to command here.";
    setClass(this.strip, "empty", groups.length === 0);
    this.strip.replaceChildren(
      h("h2", { class: "unseen" }, "Controls"),
      ...(groups.length > 1
        ? [h("nav", { class: "group-tabs", "aria-label": "Controls" }, ...buttons)]
        : []),
      ...(groups.length === 0
        ? [h("p", { class: "nothing" }, nothing)]
        : [h("div", { class: "groups" }, ...groups.map((group) => group.root))]),
    );
    this.held.replaceChildren(...groups.flatMap((group) => group.held ?? []));
    const first = groups.find(({ name }) => name === this.shownGroup) ?? groups[0];
    if (first) choose(first);
  }

  private show(name: string): void {
    this.shownTab = name;
    sessionStorage.setItem("tab", name);
    for (const tab of this.tabs) {
      setClass(tab.view.root, "shown", tab.name === name);
      setAttribute(tab.button, "aria-selected", String(tab.name === name));
    }
    // Does not wait for the next tick: there is none while the session is paused.
    if (this.live.frame && this.live.hello)
      this.tabs.find((tab) => tab.name === name)?.view.tick(this.live.frame, this.live.hello);
    this.place?.shown(name === "Place ships");
    const shown = this.tabs.find((tab) => tab.name === name);
    if (shown) this.tabRow?.reveal(shown.button);
  }

  /** Shares the place of the plan between the plan and the view out of the window. */
  private share(how: Share): void {
    this.shared = how;
    setClass(this.stage, "with-view", how === "view");
    setClass(this.stage, "with-both", how === "both");
    this.pane.shares(how);
  }

  /** Rewinds to the moment of the largest fender load, looks at that fender and saves the picture. */
  private async largestLoad(): Promise<void> {
    const { hello } = this.live;
    const t_s = this.history.largest_s();
    if (!hello || t_s === null) {
      this.say("No fender has been loaded yet.");
      return;
    }
    const tick = Math.round(t_s / hello.step_s);
    if (!(await this.order({ do: "rewind", tick }))) return;
    for (let i = 0; i < 100 && this.live.frame?.tick !== tick; i++)
      await new Promise((done) => setTimeout(done, 50));
    const { frame } = this.live;
    const most = frame && mostLoaded(frame, hello);
    if (!most) {
      this.say("The frame of that moment has no loaded fender.");
      return;
    }
    if (this.shared === "plan") this.share("view");
    const made = await this.pane.fenderPicture(most.fender);
    const name = spoken(hello.fenders[most.fender]?.name ?? "");
    this.say(
      made
        ? `${clock(t_s)}: the largest load, at ${name}. The picture is saved; the timeline leads back.`
        : `${clock(t_s)}: the largest load, at ${name}. This browser made no picture of it.`,
    );
  }

  /** While a trial is on, the controls give no orders: they say so. */
  private markTrial(on: boolean): void {
    setClass(this.strip, "in-trial", on);
  }

  private widen(): void {
    this.stage.classList.toggle("panel-only");
  }

  private setPalette(name: ThemeName): void {
    applyPalette(name);
    // The view out of the window is as bright by day as it can be.
    this.pane.setPalette(name === "bright" ? "day" : name);
    localStorage.setItem("palette", name);
    const shown = name.replace(/^./, (c) => c.toUpperCase());
    setText(this.paletteButton, shown);
    setAttribute(this.paletteButton, "aria-label", `Palette: ${shown} (B)`);
  }

  private nextPalette(): void {
    const now = document.documentElement.dataset.palette as ThemeName;
    this.setPalette(THEMES[(THEMES.indexOf(now) + 1) % THEMES.length] ?? "day");
  }

  private alarmed(open: number, worst: Alarm["level"] | null): void {
    setText(this.alarmButton, `Alarms ${open}`);
    setAttribute(this.alarmButton, "aria-label", `Alarms, ${open} not acknowledged`);
    setClass(this.alarmButton, "alarm", worst === "alarm");
    setClass(this.alarmButton, "caution", worst === "caution");
  }

  private judged({ text, gravity, findings }: VerdictNow): void {
    setText(this.verdictButton, text);
    setAttribute(this.verdictButton, "aria-label", `Verdict: ${text}`);
    this.verdictButton.title = findings
      .map((finding) => `${spokenFinding(finding.text)}.`)
      .join("\n");
    setGravity(this.verdictButton, gravity);
  }

  // ------------------------------------------------------------------------------------------------ ticks and drawing

  private tick(): void {
    const { frame, hello } = this.live;
    if (!frame || !hello) return;
    setText(this.time, clock(frame.t_s));
    const rewound = frame.tick < frame.run.last_tick;
    setText(
      this.run,
      rewound
        ? frame.run.paused
          ? "REWOUND"
          : "REPLAY"
        : frame.run.paused
          ? "PAUSED"
          : `${fixed(frame.run.pace, frame.run.pace % 1 === 0 ? 0 : 2)}×`,
    );
    setClass(this.run, "caution", rewound || frame.run.paused);
    this.judged(frame.verdict);
    this.sound.tick(frame, this.live, performance.now());
    this.plan?.tick(frame);
    for (const group of this.groups) group.tick(frame, hello);
    for (const { name, view } of this.tabs) {
      // Alarms are counted even if their tab is not shown.
      if (name === this.shownTab || name === "Alarms") view.tick(frame, hello);
    }
    this.place?.shown(this.shownTab === "Place ships");
  }

  private draw(now_ms: number): void {
    requestAnimationFrame((next) => this.draw(next));
    this.plan?.draw(performance.now());
    this.pane.draw(performance.now());
    for (const { name, view } of this.tabs)
      if (name === this.shownTab) view.draw?.(performance.now());
    for (const group of this.groups) if (group.root.offsetParent !== null) group.draw?.(now_ms);
    this.live.drawn(Date.now());
    this.fps.count += 1;
    if (now_ms - this.fps.since >= FPS_MS) {
      this.fps.shown = Math.round((this.fps.count * 1000) / (now_ms - this.fps.since));
      this.fps = { ...this.fps, since: now_ms, count: 0 };
    }
  }

  private watch(): void {
    const open = this.link.textContent !== "connecting" && this.link.textContent !== "no link";
    const silent = this.live.silence(performance.now());
    const late = this.live.latency.figures();
    if (open && late) {
      setText(
        this.link,
        `${late.clocks ? "+" : ""}${late.median.toFixed(0)} ms · ${this.fps.shown} fps`,
      );
      this.link.title = `From tick to drawing: median ${late.median.toFixed(0)} ms, 99 of 100 within ${late.p99.toFixed(0)} ms${late.clocks ? " over the quickest (the clocks of page and server differ)" : ""}; ${this.fps.shown} drawings a second`;
      Object.assign(this.link.dataset, {
        median: late.median.toFixed(1),
        p99: late.p99.toFixed(1),
        fps: String(this.fps.shown),
      });
    }
    setClass(this.link, "alarm", !open || silent !== null);
    const text =
      this.connection.failures > 0
        ? this.why !== ""
          ? `The server says: ${this.why}`
          : this.live.frame
            ? "NO LINK TO THE SERVER — what is shown is old. Trying again."
            : "The server does not answer. Trying again."
        : this.outdated
          ? "THIS PAGE HAS ANOTHER VERSION THAN THE PROGRAM: load the page again."
          : silent === null
            ? ""
            : `NO DATA FOR ${Math.round(silent / 1000)} s — what is shown is old.`;
    setText(this.banner, text);
    setClass(this.banner, "hidden", text === "");
    setClass(this.stage, "stale", text !== "");
  }

  // ------------------------------------------------------------------------------------------------------- keys

  private keys(): KeyAction[] {
    const { plan } = this;
    const common: KeyAction[] = [
      ...this.tabs.flatMap(({ name, key }) =>
        key ? [{ key, text: `Show ${name}`, run: () => this.show(name) }] : [],
      ),
      { key: "x", text: "Panel over the whole page, and back", run: () => this.widen() },
      { key: "+", text: "Zoom in", repeats: true, run: () => plan?.zoom(1.2) },
      { key: "-", text: "Zoom out", repeats: true, run: () => plan?.zoom(1 / 1.2) },
      { key: "0", text: "Ship, berth and passage plan", run: () => plan?.fit() },
      { key: "f", text: "Follow the ship or not", run: () => plan?.follow() },
      { key: "u", text: "North, head or berth up", run: () => plan?.turnUp() },
      { key: "i", text: "Measuring tools", run: () => plan?.measure() },
      { key: "h", text: "Safety contour of the chart", run: () => plan?.depths() },
      { key: "v", text: "Predicted path", run: () => plan?.togglePath() },
      {
        key: ",",
        text: "View out of the window, or the plan",
        run: () => this.share(this.shared === "plan" ? "view" : "plan"),
      },
      { key: "b", text: "Bright, day, dusk, night", run: () => this.nextPalette() },
      { key: "?", text: "This help", run: () => this.help.open(this.keys()) },
    ];
    const { trialView } = this;
    if (trialView)
      common.push({
        key: "z",
        text: "Start or end a trial manoeuvre",
        run: () => {
          this.show("Trial");
          trialView.toggle();
        },
      });
    return [...this.groups.flatMap((group) => group.keys), ...common];
  }

  private pressed(event: KeyboardEvent): void {
    if (event.ctrlKey || event.altKey || event.metaKey || document.querySelector("dialog[open]"))
      return;
    const target = event.target as HTMLElement;
    // Sliders and text fields keep their own keys.
    if (target.matches("input[type=text], input[type=number], select, textarea")) return;
    if (target.matches("input[type=range]") && event.key.startsWith("Arrow")) return;
    const key =
      event.key === "=" ? "+" : event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const action = this.keys().find((each) => each.key === key);
    if (!action || (event.repeat && !action.repeats)) return;
    event.preventDefault();
    action.run();
  }
}

const roleName = (role: Role): string => {
  if (role.name === "tugmaster") return tugCalled(role.tug).replace(/^./, (c) => c.toUpperCase());
  if (role.name === "pilot" && role.vessel !== undefined) return spoken(`Pilot of ${role.vessel}`);
  return role.name.replace(/^./, (c) => c.toUpperCase());
};
