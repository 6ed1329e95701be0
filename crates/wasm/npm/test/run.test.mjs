import assert from "node:assert/strict";
import { test } from "node:test";
import {
  FENDER_FIELDS,
  FenderlineError,
  Run,
  STATE_FIELDS,
  check,
  load,
  scenarioSchema,
  version,
} from "fenderline";
import { hashes, ran, scenario } from "./native.mjs";

await load();

// The paper's method, the coupled one, vessels with tugs, waves, lines in gusts, chains, hulls by height.
const COMPARED = [
  "paper/experiment_2_4kn",
  "berth/eight_cones_at_5_deg",
  "berth/asd_tugs_push_alongside",
  "berth/moored_three_hours_in_gusts",
  "berth/chains_hold_a_panel_that_turns",
  "berth/bow_flare_on_a_fender",
  "berth/two_ships_on_pneumatic_fenders",
  "environment/rolling_in_a_beam_sea",
  "environment/across_a_tidal_stream",
  "live/tug_escort",
];
const STEPS = 1500;

test("the state after 1500 steps has the bits of the native program", () => {
  const native = hashes(STEPS, COMPARED);
  COMPARED.forEach((name, i) => {
    const run = new Run(scenario(name));
    run.advance(STEPS);
    assert.deepEqual([run.stateHash(), String(run.step)], native[i], name);
    run.free();
  });
});

test("summary and report are those of `fenderline run`", () => {
  for (const name of ["paper/experiment_2_4kn", "berth/eight_cones_at_5_deg"]) {
    const run = new Run(scenario(name));
    run.advance(1e6);
    assert.ok(run.isDone);
    const { summary, report } = ran(name);
    const own = run.summary();
    assert.deepEqual({ ...own, files: [] }, { ...summary, files: [] }, name);
    assert.equal(run.report(), report, name);
    assert.equal(run.verdict().text, summary.verdict.text);
    run.free();
  }
});

test("a mistake has line, column, key and help", () => {
  const { text } = scenario("berth/eight_cones_at_5_deg");
  const lines = text.split("\n");
  const at = lines.findIndex((line) => line.startsWith("outline"));
  lines[at] = lines[at].replace("outline", "outlin");
  assert.throws(
    () => check({ text: lines.join("\n"), file: "my.toml" }),
    (error) => {
      assert.ok(error instanceof FenderlineError);
      const { kind, file, line, column, help, text } = error.problem;
      assert.deepEqual([kind, file, line, column], ["scenario", "my.toml", at + 1, 1]);
      assert.match(text, /--> my\.toml:\d+:1/);
      assert.match(`${error.message} ${help}`, /outline/);
      return true;
    },
  );
  assert.throws(() => new Run({ text: "x = [" }), { line: 1 });
  assert.throws(
    () => check({ text, set: ["time.step=2 kn"] }),
    ({ problem }) => problem.option?.includes("time.step") && problem.line === null,
  );
});

test("a file that the scenario names is given with it, or is an error", () => {
  const { text } = scenario("berth/eight_cones_at_5_deg");
  const more = `fender_files = ["mine.toml"]\n${text}`;
  assert.throws(() => check({ text: more }), /mine\.toml: the text of this file was not given/);
  assert.throws(
    () => check({ text: more, files: { "mine.toml": "nonsense = 1" } }),
    ({ problem }) => problem.file === "mine.toml" && problem.line === 1,
  );
});

test("a text beyond 16 MiB, a provider, and nonsense are refused, and the module goes on", () => {
  assert.throws(() => check({ text: "#".repeat((16 << 20) + 1) }), /larger than the 16 MiB/);
  assert.throws(
    () => new Run(scenario("provider/drag_in_python")),
    ({ problem }) => problem.kind === "setup" && /provider/.test(problem.message),
  );
  for (const text of ["", "\u0000", "[".repeat(100_000), "a.".repeat(50_000)])
    assert.throws(() => check({ text }), FenderlineError);
  assert.ok(check(scenario("paper/experiment_2_4kn")).steps > 0);
});

test("views show the present state without copies, and survive a growing memory", () => {
  const run = new Run(scenario("berth/eight_cones_at_5_deg"));
  const { bodies, fenders } = run.info;
  const view = run.states;
  assert.equal(view.length, bodies.length * STATE_FIELDS.length);
  assert.equal(run.fenders.length, fenders.length * FENDER_FIELDS.length);
  const before = view.slice();
  run.advance(10);
  assert.equal(run.states.byteOffset, view.byteOffset);
  const present = run.states;
  assert.notDeepEqual(present.slice(), before);
  // Many runs make the memory grow: the old view is detached, the property gives a new one of the same numbers.
  const kept = present.slice();
  const others = [];
  while (view.length > 0 && others.length < 5000)
    others.push(new Run(scenario("berth/eight_cones_at_5_deg")));
  assert.equal(view.length, 0, "the memory has grown");
  assert.deepEqual(run.states.slice(), kept);
  others.forEach((other) => other.free());
  run.advance(1e6);
  const reaction = run.summary().fenders[0];
  const row = fenders.indexOf(reaction.name) * FENDER_FIELDS.length;
  assert.equal(run.fenders[row + FENDER_FIELDS.indexOf("touched")], 1);
  run.free();
});

test("a run plays in slices with progress, can be stopped, and goes on", async () => {
  const run = new Run(scenario("berth/eight_cones_at_5_deg"), { tables: true });
  const abort = new AbortController();
  const heard = [];
  const progress = (now) => {
    heard.push(now);
    if (heard.length === 3) abort.abort();
  };
  assert.equal(await run.play({ progress, signal: abort.signal, slice_ms: 1 }), false);
  assert.ok(!run.isDone && run.summary().interrupted);
  assert.equal(await run.play({ progress }), true);
  const last = heard.at(-1);
  assert.deepEqual([last.step, last.time_s], [last.steps, run.time_s]);
  assert.equal(run.advance(5), 0);
  assert.equal(run.summary().interrupted, false);
  const bodies = run.tables().find((table) => table.name === "bodies");
  const body = bodies.columns.find((column) => column.name === "body");
  assert.equal(body.values.length, bodies.rows);
  assert.equal(body.words[body.values[0]], run.info.bodies[0]);
  assert.ok(bodies.columns.some(({ values }) => values instanceof Float64Array));
  run.free();
});

test("frames are those of the live pages", () => {
  const run = new Run(scenario("berth/eight_cones_at_5_deg"), { frames: true });
  const hello = JSON.parse(run.hello());
  assert.deepEqual([hello.type, hello.role.name, hello.fenders.length], ["hello", "observer", 8]);
  run.advance(1e6);
  const frame = JSON.parse(run.frame());
  assert.equal(frame.bodies.length, run.info.bodies.length);
  assert.deepEqual(frame.bodies[0], [...run.states.slice(0, 6)]);
  assert.ok(frame.events.some(({ text }) => /touches/.test(text)));
  const plain = new Run(scenario("berth/eight_cones_at_5_deg"));
  assert.throws(() => plain.frame(), /option `frames`/);
  assert.throws(() => plain.tables(), /option `tables`/);
  run.free();
  plain.free();
});

test("version and schema", () => {
  assert.match(version(), /^\d+\.\d+\.\d+/);
  assert.ok("properties" in scenarioSchema());
});
