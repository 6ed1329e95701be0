import assert from "node:assert/strict";
import { test } from "node:test";
import { CONTACT_FIELDS, Engine, FenderlineError, ModelBuilder, load } from "fenderline";
import { scenario } from "./native.mjs";

await load();

const SQUARE = [
  [-5, -5],
  [5, -5],
  [5, 5],
  [-5, 5],
];
const RUBBER = { name: "rubber", stiffness_npm2: 500e3, restitution: 0.1 };

/** A tug that overlaps a quay by 0.1 m over 10 m. */
const builder = () =>
  new ModelBuilder()
    .material(RUBBER)
    .body({ name: "tug", outline_m: SQUARE, mass: { mass_kg: 1e6, yaw_inertia_kgm2: 2e7 } })
    .body({ name: "quay", outline_m: SQUARE, position_m: [9.9, 0] })
    .pair("tug", "quay", "rubber");

test("hull meets hull: equal and opposite forces, and the geometry of two squares", () => {
  const engine = builder().build();
  engine.states.set([-0.2, 0, 0, 0.5, 0, 0]);
  let touched = 0;
  for (let step = 0; step < 100; step += 1) {
    const [north, east, moment, ...onQuay] = engine.advance(0.02);
    assert.equal(onQuay[0], north === 0 ? onQuay[0] : -north);
    assert.ok(north <= 0 && Math.abs(east) < 1e-6 && Math.abs(moment) < 1e-3);
    const contacts = engine.contacts;
    if (contacts.length > 0) {
      assert.equal(contacts.length, CONTACT_FIELDS.length);
      const field = (name) => contacts[CONTACT_FIELDS.indexOf(name)];
      assert.equal(field("fender"), -1);
      // Square on: the area is the depth times the width of 10 m.
      assert.ok(Math.abs(field("area_m2") - 10 * field("depth_m")) < 1e-9);
      touched += 1;
    }
    engine.states.set(engine.statesAfter);
  }
  assert.ok(touched > 5 && engine.states[3] < 0, "she has bounced off");
  engine.free();
});

test("a host that lets the engine move the bodies bounces off a fender, with the momentum of the impulse", () => {
  const engine = builder()
    .fender({
      name: "cone",
      body: "quay",
      position_m: [-5, 0],
      facing_rad: Math.PI,
      width_m: 2,
      projection_m: 1,
      curve: [
        [0, 0],
        [0.5, 500e3],
        [0.8, 900e3],
      ],
      material: "rubber",
    })
    .build();
  const states = engine.states;
  states[0] = -3;
  states[3] = 0.5;
  let [impulse, fendered] = [0, false];
  for (let step = 0; step < 300; step += 1) {
    const [north] = engine.advance(0.05);
    impulse += north * 0.05;
    const contacts = engine.contacts;
    fendered ||= contacts.length > 0 && contacts[CONTACT_FIELDS.indexOf("fender")] === 0;
    engine.states.set(engine.statesAfter);
  }
  const change = 1e6 * (engine.states[3] - 0.5);
  assert.ok(fendered && engine.states[3] < 0, `${engine.states[3]}`);
  // The wrench of a step is the mean over the step, so the sum is the change of momentum; rounding only.
  assert.ok(Math.abs(impulse - change) < 1e-6 * Math.abs(change), `${impulse} ${change}`);
  engine.free();
});

test("a saved engine goes on with the same bits", () => {
  const engine = Engine.fromScenario(scenario("berth/eight_cones_at_5_deg"));
  const go = (steps) => {
    for (let step = 0; step < steps; step += 1) {
      engine.advance(0.1);
      engine.states.set(engine.statesAfter);
    }
    return engine.states.slice();
  };
  go(40);
  const saved = engine.save();
  const states = engine.states.slice();
  const first = go(40);
  engine.restore(saved);
  engine.states.set(states);
  assert.deepEqual(go(40), first);
  engine.reset();
  assert.ok(engine.wrenches.every((number) => number === 0));
  assert.throws(() => engine.restore(new Uint8Array(7)), FenderlineError);
  engine.free();
});

test("loads act on the bodies", () => {
  const engine = builder().build();
  engine.states[0] = -50;
  engine.loads[0] = 1e5;
  const speeds = [0, 1].map(() => {
    engine.advanceWithLoads(1);
    engine.states.set(engine.statesAfter);
    return engine.states[3];
  });
  // a = F / m
  assert.ok(Math.abs(speeds[1] - speeds[0] - 0.1) < 1e-12, `${speeds}`);
  engine.free();
});

test("mistakes name the part and the field, and change nothing", () => {
  const bad = [
    [(m) => (m.bodies[0].mass.mass_kg = -1), /tug/],
    [(m) => (m.bodies[0].outline_m = [[0, 0]]), /tug/],
    [(m) => (m.pairs[0].material = "rubbr"), /no material is named `rubbr`/],
    [(m) => (m.pairs[0].bodies[1] = "key"), /no body is named `key`/],
    [(m) => (m.materials[0].stifness = 1), /unknown field `stifness`/],
    [(m) => m.bodies.push(m.bodies[0]), /already used/],
  ];
  for (const [spoil, said] of bad) {
    const model = structuredClone(builder().model());
    spoil(model);
    assert.throws(() => Engine.fromModel(model), said);
  }
  assert.throws(
    () => Engine.fromModel("{"),
    ({ problem }) => problem.kind === "model" && problem.line === 1,
  );
  assert.throws(() => builder().build({ host: { kind: "master" } }), /unknown variant `master`/);
  const engine = builder().build();
  engine.states[1] = Number.NaN;
  assert.throws(() => engine.advance(0.1), /tug/);
  engine.states[1] = 0;
  assert.throws(() => engine.advance(-1), FenderlineError);
  assert.throws(() => engine.markTeleported(9), /no body with index 9/);
  engine.advance(0.1);
  engine.free();
});
