/**
 * fenderline in WebAssembly: scenarios, runs and reports, and the contact engine alone.
 *
 * Call {@link load} once, then use {@link Run} or {@link Engine}. Units are SI. Earth-fixed places and forces are north and
 * east; headings and moments are positive clockwise, seen from above.
 */
export { load, version } from "./module.js";
export { FenderlineError, type Problem } from "./problem.js";
export { berthOf, library, newExercise } from "./exercise.js";
export {
  Run,
  check,
  scenarioSchema,
  FENDER_FIELDS,
  STATE_FIELDS,
  type Column,
  type Notice,
  type Options,
  type PlayOptions,
  type Progress,
  type ScenarioInfo,
  type Source,
  type Table,
  type Verdict,
} from "./run.js";
export type { FenderSummary, Named, PairSummary, Summary } from "./summary.js";
export type {
  AnchorQuantities,
  ChainQuantities,
  DolphinQuantities,
  FenderQuantities,
  LineQuantities,
  PairQuantities,
  TugQuantities,
  VesselQuantities,
} from "./quantities.js";
export {
  CONTACT_FIELDS,
  Engine,
  ModelBuilder,
  WRENCH_FIELDS,
  type BodyDefinition,
  type FenderDefinition,
  type MassDefinition,
  type MaterialDefinition,
  type Model,
  type Settings,
} from "./engine.js";
