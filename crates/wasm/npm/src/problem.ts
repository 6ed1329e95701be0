/** Errors of the user's input. */

/** What is wrong, and where. A field that does not apply is `null`. */
export interface Problem {
  /**
   * `scenario`: the text of a scenario; `setup`: it cannot be simulated; `step`: a step failed; `model`: the JSON of an
   * engine's model; `engine`: a call that the engine refuses; `exercise`: choices that make no
   * exercise; `call`: a call with wrong arguments.
   */
  kind: "scenario" | "setup" | "step" | "model" | "engine" | "exercise" | "call";
  /** In one line. */
  message: string;
  /** Over several lines, with the line of the file and what to write instead. */
  text: string;
  file: string | null;
  /** From 1. */
  line: number | null;
  /** In characters, from 1. */
  column: number | null;
  /** Dotted path of the key, such as `material.rubber.stiffness`. */
  key: string | null;
  /** What to write instead. */
  help: string | null;
  /** The replaced key that is wrong, as `--set KEY=VALUE`. */
  option: string | null;
}

/** An error in a scenario, a model, or a call. After it everything is as before the call. */
export class FenderlineError extends Error {
  override readonly name = "FenderlineError";

  constructor(readonly problem: Problem) {
    super(problem.message);
  }

  get line(): number | null {
    return this.problem.line;
  }

  get column(): number | null {
    return this.problem.column;
  }

  get key(): string | null {
    return this.problem.key;
  }
}

/** Calls the module, and throws its errors as {@link FenderlineError}. */
export function calling<T>(call: () => T): T {
  try {
    return call();
  } catch (thrown) {
    if (typeof thrown === "string") throw new FenderlineError(JSON.parse(thrown) as Problem);
    throw thrown;
  }
}
