// Compiled in the strictest way: what a user of the types writes.
import { readFile } from "node:fs/promises";
import {
  Engine,
  FENDER_FIELDS,
  FenderlineError,
  ModelBuilder,
  Run,
  load,
  type Model,
  type Progress,
} from "fenderline";

export async function peakReactions(path: string): Promise<Map<string, number>> {
  await load();
  const text = await readFile(path, "utf8");
  const run = new Run({ text, file: path, set: ["time.step=0.05 s"] }, { tables: true });
  const peaks = new Map(run.info.fenders.map((name) => [name, 0]));
  try {
    const progress = ({ step, steps }: Progress): void => console.log(step / steps);
    await run.play({ progress, signal: AbortSignal.timeout(60_000) });
    for (const { name, peak_reaction_n } of run.summary().fenders) peaks.set(name, peak_reaction_n);
    const now: number | undefined = run.fenders[FENDER_FIELDS.indexOf("reaction_n")];
    if (now !== undefined && now > 0) console.log("the first fender is still in contact");
  } catch (error) {
    if (!(error instanceof FenderlineError)) throw error;
    console.error(error.line, error.column, error.problem.text);
  } finally {
    run.free();
  }
  return peaks;
}

export function forceOnTug(model: Model): number {
  const engine: Engine = Engine.fromModel(model, { host: { kind: "co_simulation", delay_steps: 1 } });
  engine.states.set([0, 0, 0, 0.5, 0, 0]);
  const [north = 0] = engine.advance(0.1);
  engine.free();
  return north;
}

export const model: Model = new ModelBuilder()
  .material({ name: "rubber", stiffness_npm2: 500e3 })
  .body({ name: "quay", outline_m: [[0, 0], [1, 0], [0, 1]] })
  .model();
