/** The worker as the page sees it: it can always be stopped, and is replaced when it breaks or hangs. */
import wasm from "../../crates/wasm/npm/dist/raw/raw_bg.wasm?url";
import type { NewExercise } from "../src/protocol";
import type { Answer, FromWorker, Heard, Job, ToWorker } from "./messages";
// oxlint-disable-next-line import/default -- Vite makes it of the worker's code
import RunWorker from "./worker?worker&inline";

/** A worker that does not end a run within this time is replaced [ms]. */
const STOPS_WITHIN_MS = 1500;

export interface Listener {
  ready(version: string): void;
  heard(message: Heard): void;
  /** The worker was replaced: the run is lost, and why. */
  lost(why: string): void;
}

export class Runner {
  private module: WebAssembly.Module | null = null;
  private worker: Worker | null = null;
  private id = 0;
  private running = false;
  private timer = 0;
  private asked = 0;
  /** Questions that wait for their answers. */
  private readonly waiting = new Map<number, (answer: Answer) => void>();

  constructor(private readonly listener: Listener) {}

  /** Loads the module: the last request to a server. */
  async load(): Promise<void> {
    this.module = await WebAssembly.compileStreaming(fetch(wasm));
    this.begin();
  }

  run(job: Job): void {
    clearTimeout(this.timer);
    this.id += 1;
    this.running = true;
    this.say({ type: "run", id: this.id, job });
    // A step of a run before may take for ever.
    this.expect("A step of the run before took too long.");
  }

  /** Ends the run, with the results so far, or without if a step takes too long. */
  stop(): void {
    if (!this.running) return;
    this.say({ type: "stop", id: this.id });
    this.expect("A step took too long: the run was ended without results.");
  }

  /** What a new exercise can be made of, with the berths of scenarios. */
  choices(scenarios: Job[]): Promise<Answer> {
    return this.ask((ask) => ({ type: "choices", ask, scenarios }));
  }

  /** The text of a new exercise; at the berth of a scenario, if one is given. */
  make(exercise: NewExercise, berth: Job | null): Promise<Answer> {
    return this.ask((ask) => ({ type: "make", ask, exercise, berth }));
  }

  private ask(question: (ask: number) => ToWorker): Promise<Answer> {
    this.asked += 1;
    const ask = this.asked;
    return new Promise((answered) => {
      this.waiting.set(ask, answered);
      this.say(question(ask));
    });
  }

  private expect(why: string): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.replace(why), STOPS_WITHIN_MS);
  }

  private begin(): void {
    if (!this.module) throw new Error("the module is loaded first");
    this.worker = new RunWorker();
    this.worker.addEventListener("message", ({ data }: MessageEvent<FromWorker>) =>
      this.heard(data),
    );
    this.worker.addEventListener("error", (event) => this.replace(event.message));
    this.say({ type: "module", module: this.module });
  }

  private say(message: ToWorker): void {
    this.worker?.postMessage(message);
  }

  private heard(message: FromWorker): void {
    if (message.type === "ready") {
      this.listener.ready(message.version);
      return;
    }
    if ("ask" in message) {
      this.waiting.get(message.ask)?.(message);
      this.waiting.delete(message.ask);
      return;
    }
    if (message.id !== this.id) return;
    if (message.type === "broken") {
      this.replace(message.why);
      return;
    }
    if (message.type === "begun") clearTimeout(this.timer);
    if (message.type !== "begun" && message.type !== "frame") {
      clearTimeout(this.timer);
      this.running = false;
    }
    this.listener.heard(message);
  }

  private replace(why: string): void {
    clearTimeout(this.timer);
    this.worker?.terminate();
    this.running = false;
    this.id += 1;
    // Whoever waits hears why.
    for (const [ask, answered] of this.waiting) answered({ type: "unmade", ask, why });
    this.waiting.clear();
    this.begin();
    this.listener.lost(why);
  }
}
