// Time of a step, here over natively, for a ship and eight fenders. Prints both and their ratio.
import { Run, load } from "fenderline";
import { scenario, time } from "./native.mjs";

const NAME = "berth/eight_cones_at_5_deg";
const RUNS = 9;

await load();
const times = [];
for (let i = 0; i < RUNS; i += 1) {
  const run = new Run(scenario(NAME));
  const begun = performance.now();
  const steps = run.advance(2 ** 31);
  times.push(((performance.now() - begun) * 1e6) / steps);
  run.free();
}
const here = times.toSorted((a, b) => a - b)[Math.floor(RUNS / 2)];
const native = time(NAME);
console.log(`${NAME}: ${here.toFixed(0)} ns a step in Node ${process.versions.node}, ${native.toFixed(0)} ns natively`);
console.log(`ratio ${(here / native).toFixed(2)}`);
