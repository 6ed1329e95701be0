/** A new exercise from choices, as the pages of `fenderline serve` make it: JSON of the interfaces in `web/src/protocol.ts`. */
import { calling } from "./problem.js";
import {
  berth as rawBerth,
  library as rawLibrary,
  newExercise as rawNew,
  newExerciseAt as rawNewAt,
} from "./raw/raw.js";
import type { Source } from "./run.js";

/** The ships, tugs and fenders that can be chosen: JSON of `LibraryInfo`. */
export function library(): string {
  return rawLibrary();
}

/**
 * The berth that a new exercise can take of a scenario, in words; `null` without one.
 * @throws FenderlineError for a mistake in the scenario.
 */
export function berthOf(source: Source): string | null {
  return calling(() => rawBerth(...args(source))) ?? null;
}

/**
 * The text of a scenario from choices, the JSON of `NewExercise`; at the berth of another scenario, if one is given.
 * @throws FenderlineError for choices that make no exercise.
 */
export function newExercise(choices: string, berth: Source | null = null): string {
  return calling(() => (berth ? rawNewAt(choices, ...args(berth)) : rawNew(choices)));
}

const args = ({ text, file, files }: Source): [string, string, string] => [
  text,
  file ?? "scenario.toml",
  JSON.stringify(files ?? {}),
];
