/** The messages between the page and the worker that runs scenarios. */
import type { Problem, ScenarioInfo, Verdict } from "fenderline";
import type { NewExercise } from "../src/protocol";

/** A scenario to run. `files`: texts of the files that it names. */
export interface Job {
  text: string;
  file: string;
  files: Record<string, string>;
}

export type ToWorker =
  /** First: the compiled module, so that a new worker asks no server for it. */
  | { type: "module"; module: WebAssembly.Module }
  /** Runs a scenario; one that runs is given up. */
  | { type: "run"; id: number; job: Job }
  /** Ends the run, with the results so far. */
  | { type: "stop"; id: number }
  /** Wants what a new exercise can be made of. */
  | { type: "choices"; ask: number; scenarios: Job[] }
  /** Wants the text of a new exercise; at the berth of a scenario, if one is given. */
  | { type: "make"; ask: number; exercise: NewExercise; berth: Job | null };

/** An answer to a question that is no run. */
export type Answer =
  | { type: "choices"; ask: number; library: string; berths: (string | null)[] }
  | { type: "made"; ask: number; text: string }
  | { type: "unmade"; ask: number; why: string };

export type FromWorker =
  | Answer
  | { type: "ready"; version: string }
  /** The scenario has a mistake, or cannot be simulated. */
  | { type: "refused"; id: number; problem: Problem }
  | { type: "begun"; id: number; info: ScenarioInfo; hello: string }
  /** The present state. `kept`: one of the frames for the timeline; the others only show the progress. */
  | { type: "frame"; id: number; frame: string; kept: boolean; step: number }
  | { type: "done"; id: number; complete: boolean; took_ms: number; results: Results }
  /** A step failed; the results are those up to it. */
  | { type: "failed"; id: number; problem: Problem; results: Results }
  /** The module is broken: no memory is left, or a fault of ours. The worker must be replaced. */
  | { type: "broken"; id: number; why: string };

export interface Results {
  verdict: Verdict;
  /** The text of `summary.json`. */
  summary: string;
  /** The text of `report.html`. */
  report: string;
}

/** What a listener of a run hears; the others are the runner's own matter. */
export type Heard = Exclude<FromWorker, Answer | { type: "ready" } | { type: "broken" }>;
