/** A scenario from its text to summary and report. */
import { FixedView, buffer, floats } from "./module.js";
import { calling } from "./problem.js";
import { RawRun, check as rawCheck, scenarioSchema as rawSchema } from "./raw/raw.js";
import type { Summary } from "./summary.js";

/** The numbers of a body in {@link Run.states}. */
export const STATE_FIELDS = [
  "north_m",
  "east_m",
  "heading_rad",
  "north_mps",
  "east_mps",
  "yaw_rate_radps",
] as const;

/** The numbers of a fender in {@link Run.fenders}. Shares are 0 where no rating is given; `touched` and `failed` are 0 or 1. */
export const FENDER_FIELDS = [
  "deflection_m",
  "reaction_n",
  "energy_j",
  "share_of_rated_energy",
  "share_of_rated_reaction",
  "peak_share_of_rated_energy",
  "peak_share_of_rated_reaction",
  "touched",
  "failed",
] as const;

/** A scenario. */
export interface Source {
  /** The TOML text. */
  text: string;
  /** Its file's name, for messages and the default title. */
  file?: string;
  /** Keys that are replaced, as `time.step=0.5 s`. */
  set?: string[];
  /** Texts of the files that it names, by their names in it. */
  files?: Record<string, string>;
}

export interface Options {
  /** Makes {@link Run.frame} available; each step then costs more. */
  frames?: boolean;
  /** Keeps the result tables. */
  tables?: boolean;
}

/** A warning about a scenario that can be run. */
export interface Notice {
  key: string;
  message: string;
  line: number | null;
  column: number | null;
  /** With file and line. */
  text: string;
}

export interface ScenarioInfo {
  title: string;
  step_s: number;
  duration_s: number;
  /** Number of steps of the whole run. */
  steps: number;
  /** Names of the bodies, in the order of {@link Run.states}. */
  bodies: string[];
  /** Names of the fenders, in the order of {@link Run.fenders}. */
  fenders: string[];
  notices: Notice[];
  /** Bodies and fenders that overlap at the start, in words. */
  start: string[];
}

/** How grave a verdict or a finding is; `failed`: something broke or was struck, or the results are not valid. */
export type Gravity = "ok" | "note" | "attention" | "failed";

/** The worst that was found in the run up to now. */
export interface Verdict {
  key: string;
  text: string;
  gravity: Gravity;
  /** The worst first. */
  findings: { key: string; gravity: Gravity; text: string }[];
}

export interface Progress {
  step: number;
  /** Of the whole run. */
  steps: number;
  time_s: number;
  duration_s: number;
}

export interface PlayOptions {
  /** Called after each slice. */
  progress?: (now: Progress) => void;
  /** Stops the run between two slices. */
  signal?: AbortSignal;
  /** Time between two calls of `progress`, in which nothing else can run [ms]. */
  slice_ms?: number;
}

/** A result table. */
export interface Table {
  name: string;
  rows: number;
  columns: Column[];
}

export interface Column {
  name: string;
  /** `1` for a pure number, `-` for a text or a truth value. */
  unit: string;
  meaning: string;
  /** A view; of texts: indices into `words`; of truth values: 0 and 1. NaN where there is no value. */
  values: Float64Array | Uint32Array | Int32Array | Uint8Array;
  words: string[] | null;
}

const args = (source: Source): [string, string, string[], string] => [
  source.text,
  source.file ?? "scenario.toml",
  source.set ?? [],
  JSON.stringify(source.files ?? {}),
];

/**
 * Reads and checks a scenario without running it.
 * @throws FenderlineError with line and column of the first mistake.
 */
export function check(source: Source): ScenarioInfo {
  buffer();
  return JSON.parse(calling(() => rawCheck(...args(source)))) as ScenarioInfo;
}

/** The JSON Schema of scenario files, for editors. */
export function scenarioSchema(): object {
  buffer();
  return JSON.parse(rawSchema()) as object;
}

/** A run. Call {@link Run.free} when it is no longer needed: its memory is not the garbage collector's. */
export class Run {
  readonly info: ScenarioInfo;
  private readonly raw: RawRun;
  private readonly stateView: FixedView;
  private readonly fenderView: FixedView;

  /** @throws FenderlineError with line and column of the first mistake. */
  constructor(source: Source, options: Options = {}) {
    buffer();
    const { frames = false, tables = false } = options;
    this.raw = calling(() => new RawRun(...args(source), frames, tables));
    this.info = JSON.parse(this.raw.description()) as ScenarioInfo;
    this.stateView = new FixedView(() => this.raw.states());
    this.fenderView = new FixedView(() => this.raw.fenders());
  }

  /** Steps taken. */
  get step(): number {
    return this.raw.step;
  }

  /** Time reached [s]. */
  get time_s(): number {
    return this.raw.timeS;
  }

  get isDone(): boolean {
    return this.raw.isDone;
  }

  /**
   * The states of all bodies, {@link STATE_FIELDS} of each one after the other. A view of the module's memory: it shows the
   * present state after each step, and is valid until the next call of this package that may grow the memory. Read the
   * property again after such a call, and copy what is to be kept (`slice`).
   */
  get states(): Float64Array {
    return this.stateView.get();
  }

  /** The fenders, {@link FENDER_FIELDS} of each; a view as {@link Run.states}. */
  get fenders(): Float64Array {
    return this.fenderView.get();
  }

  /**
   * Takes up to `steps` steps, and fewer at the end of the run.
   * @returns how many.
   * @throws FenderlineError for a step that fails; the run stays at the step before.
   */
  advance(steps = 1): number {
    return calling(() => this.raw.advance(steps));
  }

  /**
   * Runs to the end in slices, so that the page or the server stays alive. In a page, call it in a worker.
   * @returns whether the run is at its end; `false`: `signal` stopped it, and it can go on.
   * @throws FenderlineError as {@link Run.advance}.
   */
  async play({ progress, signal, slice_ms = 30 }: PlayOptions = {}): Promise<boolean> {
    let steps = 1;
    while (!this.isDone) {
      if (signal?.aborted) return false;
      const begun = performance.now();
      this.advance(steps);
      const took_ms = performance.now() - begun;
      progress?.(this.progress());
      if (took_ms < slice_ms / 2) steps = Math.min(2 * steps, 1 << 20);
      else if (took_ms > slice_ms) steps = Math.max(1, steps >> 1);
      await new Promise((go) => setTimeout(go, 0));
    }
    return true;
  }

  private progress(): Progress {
    const { steps, duration_s } = this.info;
    return { step: this.step, steps, time_s: this.time_s, duration_s };
  }

  /** The summary of the run up to now: the content of `summary.json`. */
  summary(): Summary {
    return JSON.parse(this.summaryText()) as Summary;
  }

  /** The text of `summary.json`. */
  summaryText(): string {
    return calling(() => this.raw.summary());
  }

  /** The verdict on the run up to now. */
  verdict(): Verdict {
    return JSON.parse(this.raw.verdict()) as Verdict;
  }

  /** The report of the run up to now: one HTML page that needs no other file. */
  report(): string {
    return this.raw.report();
  }

  /** Fingerprint of the present state. Equal on every platform. */
  stateHash(): string {
    return this.raw.stateHash();
  }

  /**
   * The result tables, with views as {@link Run.states}; the option `tables` is needed. It ends them: later steps are not
   * in them.
   */
  tables(): Table[] {
    const tables = JSON.parse(calling(() => this.raw.tables())) as Table[];
    tables.forEach((table, t) => {
      table.columns.forEach((column, c) => (column.values = this.column(t, c)));
    });
    return tables;
  }

  private column(table: number, index: number): Column["values"] {
    const column = this.raw.column(table, index);
    const { kind, span } = column;
    column.free();
    if (kind === "f64") return floats(span);
    const { address, length } = span;
    span.free();
    if (kind === "u32") return new Uint32Array(buffer(), address, length);
    if (kind === "i32") return new Int32Array(buffer(), address, length);
    return new Uint8Array(buffer(), address, length);
  }

  /** The greeting of a live session: what a page of `fenderline serve` is built from. */
  hello(): string {
    return this.raw.hello();
  }

  /** The present state as such a page shows it; the option `frames` is needed. */
  frame(): string {
    return calling(() => this.raw.frame());
  }

  /** Gives the memory back. Nothing of the run can be used afterwards. */
  free(): void {
    this.raw.free();
  }
}
