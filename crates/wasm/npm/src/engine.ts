/** The contact engine alone, for simulators that move their bodies themselves. */
import { FixedView, buffer, floats } from "./module.js";
import { calling } from "./problem.js";
import { RawEngine } from "./raw/raw.js";
import type { Source } from "./run.js";

/** The numbers of a body in {@link Engine.wrenches}, {@link Engine.peakWrenches} and {@link Engine.loads}. */
export const WRENCH_FIELDS = ["north_n", "east_n", "moment_nm"] as const;

/** The numbers of a contact in {@link Engine.contacts}. `fender` is -1 where hull meets hull; `slips` is 0 or 1. */
export const CONTACT_FIELDS = [
  "body_1",
  "body_2",
  "fender",
  "north_m",
  "east_m",
  "normal_north",
  "normal_east",
  "depth_m",
  "area_m2",
  "normal_force_n",
  "tangential_force_n",
  "slips",
] as const;

/** A place: north and east, or forward and to starboard [m]. */
export type Pair = [number, number];

export interface MaterialDefinition {
  name: string;
  /** k of the spring on the area of the overlap [N/m²]. */
  stiffness_npm2: number;
  damping_nspm2?: number;
  shear_stiffness_npm?: number;
  friction_static?: number;
  friction_dynamic?: number;
  /** From 0 to 1. */
  restitution?: number;
}

export interface MassDefinition {
  mass_kg: number;
  yaw_inertia_kgm2: number;
  added_surge_kg?: number;
  added_sway_kg?: number;
  added_yaw_kgm2?: number;
}

export interface BodyDefinition {
  name: string;
  /** Forward and to starboard of the centre of gravity [m], in either sense. */
  outline_m: Pair[];
  /** Absent: the body is fixed. */
  mass?: MassDefinition;
  position_m?: Pair;
  heading_rad?: number;
}

export interface FenderDefinition {
  name: string;
  /** The body that carries it. */
  body: string;
  /** Middle of the line where it is mounted, in the body's axes [m]. */
  position_m: Pair;
  /** Direction of its outward normal in the body's axes: 0 forward, positive to starboard [rad]. */
  facing_rad: number;
  width_m: number;
  /** From the mounting to the face, uncompressed [m]. */
  projection_m: number;
  /** Points of deflection [m] and reaction [N], from `[0, 0]` on. Absent: the spring of the material on the overlap. */
  curve?: Pair[];
  material: string;
  rated_deflection_m?: number;
  /** Where it goes solid. */
  stop?: { from_m: number; stiffness_npm: number };
}

/** A model: what is constant. */
export interface Model {
  materials: MaterialDefinition[];
  bodies: BodyDefinition[];
  fenders?: FenderDefinition[];
  pairs?: { bodies: [string, string]; material: string }[];
  /** The material of all pairs of bodies that `pairs` does not name; absent: these do not touch. */
  all_other_pairs?: string;
}

export interface Settings {
  /** Default: the scenario's, or `coupled`. */
  method?: "coupled" | "paper";
  /**
   * `direct` (the default) gives states and loads of the step's start. `co_simulation` moves its bodies itself and may give
   * old states.
   */
  host?:
    | { kind: "direct"; coriolis?: "by_engine" | "in_loads" }
    | {
        kind: "co_simulation";
        delay_steps?: number;
        integration?: "forward_euler" | "semi_implicit";
      };
}

/** Collects the parts of a model by calls. */
export class ModelBuilder {
  private readonly parts: Required<Omit<Model, "all_other_pairs">> = {
    materials: [],
    bodies: [],
    fenders: [],
    pairs: [],
  };
  private others: string | null = null;

  material(material: MaterialDefinition): this {
    this.parts.materials.push(material);
    return this;
  }

  body(body: BodyDefinition): this {
    this.parts.bodies.push(body);
    return this;
  }

  fender(fender: FenderDefinition): this {
    this.parts.fenders.push(fender);
    return this;
  }

  /** Enables contact between two bodies. */
  pair(one: string, two: string, material: string): this {
    this.parts.pairs.push({ bodies: [one, two], material });
    return this;
  }

  /** Enables contact between all other bodies. */
  allOtherPairs(material: string): this {
    this.others = material;
    return this;
  }

  model(): Model {
    return { ...this.parts, ...(this.others !== null && { all_other_pairs: this.others }) };
  }

  /** @throws FenderlineError that names body, fender or material, and the field. */
  build(settings: Settings = {}): Engine {
    return Engine.fromModel(this.model(), settings);
  }
}

/** The contact engine. Write {@link Engine.states}, call {@link Engine.advance}, read {@link Engine.wrenches}. */
export class Engine {
  /** Names of the bodies, in the order of all arrays. */
  readonly bodies: readonly string[];
  /** Names of the fenders; {@link Engine.contacts} has their indices. */
  readonly fenders: readonly string[];
  /** What a scenario has that is left to the host, one line each. */
  readonly notices: readonly string[];
  private readonly views: Record<"states" | "loads" | "wrenches" | "peakWrenches", FixedView>;

  private constructor(private readonly raw: RawEngine) {
    const said = JSON.parse(raw.description()) as Pick<Engine, "bodies" | "fenders" | "notices">;
    [this.bodies, this.fenders, this.notices] = [said.bodies, said.fenders, said.notices];
    this.views = {
      states: new FixedView(() => raw.states()),
      loads: new FixedView(() => raw.loads()),
      wrenches: new FixedView(() => raw.wrenches()),
      peakWrenches: new FixedView(() => raw.peakWrenches()),
    };
  }

  /**
   * An engine for bodies, fenders and materials of a scenario.
   * @throws FenderlineError with line and column of the first mistake.
   */
  static fromScenario(source: Source, settings: Settings = {}): Engine {
    buffer();
    const { text, file = "scenario.toml", set = [], files = {} } = source;
    const [named, how] = [JSON.stringify(files), JSON.stringify(settings)];
    return new Engine(calling(() => RawEngine.fromScenario(text, file, set, named, how)));
  }

  /**
   * An engine of a model: an object, or its JSON.
   * @throws FenderlineError that names body, fender or material, and the field.
   */
  static fromModel(model: Model | string, settings: Settings = {}): Engine {
    buffer();
    const text = typeof model === "string" ? model : JSON.stringify(model);
    return new Engine(calling(() => RawEngine.fromModel(text, JSON.stringify(settings))));
  }

  /**
   * Input: the states at the start of the step, `STATE_FIELDS` of each body. At first those of the model. A view of the
   * module's memory: write into it. It is valid until the next call of this package that may grow the memory; read the
   * property again after such a call.
   */
  get states(): Float64Array {
    return this.views.states.get();
  }

  /** Input: all that acts on each body but contact, {@link WRENCH_FIELDS} of each. For {@link Engine.advanceWithLoads}. */
  get loads(): Float64Array {
    return this.views.loads.get();
  }

  /** Result: the wrench that the host adds to its forces for the step, {@link WRENCH_FIELDS} of each body. */
  get wrenches(): Float64Array {
    return this.views.wrenches.get();
  }

  /** Result: the largest wrench within the step. Size fenders by it, and move bodies by `wrenches`. */
  get peakWrenches(): Float64Array {
    return this.views.peakWrenches.get();
  }

  /**
   * Result: the engine's states at the end of the step, for a direct host that lets it move the bodies:
   * `engine.states.set(engine.statesAfter)`. Empty for other hosts.
   */
  get statesAfter(): Float64Array {
    return floats(this.raw.statesAfter());
  }

  /** Result: the contacts, {@link CONTACT_FIELDS} of each; the length changes from step to step. */
  get contacts(): Float64Array {
    return floats(this.raw.contacts());
  }

  /**
   * One step of `step_s` seconds, without loads: a direct host's are zero, a co-simulation host's are observed.
   * @returns the wrenches.
   * @throws FenderlineError for a state or a step that the engine refuses; nothing changes then.
   */
  advance(step_s: number): Float64Array {
    calling(() => this.raw.advance(step_s, false));
    return this.wrenches;
  }

  /** As {@link Engine.advance}, with the loads in {@link Engine.loads}. */
  advanceWithLoads(step_s: number): Float64Array {
    calling(() => this.raw.advance(step_s, true));
    return this.wrenches;
  }

  /** Marks a body as teleported: its next state is a new place, not the result of motion. */
  markTeleported(body: number): void {
    calling(() => this.raw.markTeleported(body));
  }

  /** Returns to the start. */
  reset(): void {
    this.raw.reset();
  }

  /** The engine's memory as bytes, a copy. */
  save(): Uint8Array {
    return this.raw.save();
  }

  /** @throws FenderlineError for bytes of another model or other settings; nothing changes then. */
  restore(bytes: Uint8Array): void {
    calling(() => this.raw.restore(bytes));
  }

  /** Gives the memory back. Nothing of the engine can be used afterwards. */
  free(): void {
    this.raw.free();
  }
}
