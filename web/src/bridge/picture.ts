/**
 * The picture out of the window: one renderer, one scene, one camera. It draws what frames say, between the same two ticks as
 * the plan, and computes no physics.
 */
import {
  ACESFilmicToneMapping,
  Group,
  Matrix4,
  Mesh,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { Alphabet } from "./alphabet";
import { fairleadHeight } from "./arrangement";
import { type Attitude, LEVEL, aim, fixedIn, stand } from "./aim";
import { type Triple, aboard, toPicture } from "./axes";
import { BIGHT_M, bollard, fixedParts, isInside, quay, quaysOf } from "./berth";
import { cut } from "./blocks";
import { PIECES, catenary, draped, weightOf } from "./catenary";
import { conductOf } from "./conduct";
import { type Seat, seatAtBollard, seatOn } from "./eyes";
import { Drift, MOST_MARKS } from "./drift";
import { Fenders, geometryOf, middleOf } from "./fenders";
import { Headset } from "./headset";
import {
  type Fixed,
  type Heights,
  type Site,
  deckHeight,
  endsOn,
  heightsOf,
  knownQuays,
} from "./heights";
import { hides } from "./hidden";
import { Glows } from "./glows";
import { type Lamp, type LampColour, bearingFrom, isSeen } from "./lamps";
import type { Placed } from "./labels";
import { FIGURES, painted } from "./lettering";
import { MOST_TREES, land } from "./land";
import { Lighting } from "./lighting";
import type { Look } from "./look";
import { OVER_DOLPHIN_M, carriersOf, floats, lampHeight, mark, riseOf } from "./marks";
import { type Shared, paintwork } from "./paintwork";
import {
  type Label,
  type Stroke,
  MEASURED_STROKES,
  MOST_GHOSTS,
  arrow,
  colourOf,
  fenderLabel,
  lineLabel,
  measuredStrokes,
  pathStrokes,
  resampled,
  tugLabel,
} from "./in_picture";
import { RainFall } from "./rain";
import { Ropes } from "./ropes";
import { type PlacedJet, Sea, type Wake } from "./sea";
import {
  type Ship,
  type ShipPicture,
  dispose,
  dress,
  plainVessel,
  shipPicture,
} from "./ship_picture";
import { sky, skyUniforms } from "./sky";
import { Solids, type Spot, linearOf } from "./solids";
import { cablesOf, isOn } from "./structures";
import { jetOfTug, jetsOf } from "./wash";
import { surface } from "./waves";
import { isLit } from "../character";
import { clamp, onEarth, turned } from "../geometry";
import { ghostAt, ghostText } from "../ghost";
import { type Live, isOfTug } from "../live";
import type { PaletteName } from "../palette";
import type { BodyNow, ChartInfo, Frame, Hello, LineInfo, LineNow, Pair } from "../protocol";
import { tugOutline, tugPlace } from "../vector_tug";

export { loadModels } from "./ship_picture";

/** What the picture shows of a frame. */
export interface Shown {
  tick: number;
  north_m: number | null;
  east_m: number | null;
  heading_rad: number | null;
  /** The place of the eye in the axes of the picture [m]. */
  eye: Triple;
  /** How far each fender is pressed; `null`: it is not drawn. */
  pressed_m: (number | null)[];
  /** The words of the marks, hidden ones too. */
  labels: string[];
}

/** Slack below which a line counts as without tension [N]. */
const SLACK_N = 50;
/** A line is at least 1.2 pixels wide, a mark 2. */
const MARKS_NARROWER = 0.6;
/** Overhead cables. */
const CABLE = 0x2a2d30;
const CABLE_RADIUS_M = 0.03;
/** How high an arrow lies above what could hide the arrow [m]. */
const ARROW_OVER_M = 0.7;
/** How high the words of a measured ship stand above the water [m]. */
const MEASURED_WORDS_UP_M = 9;
/** Marks of the current: their height above the water, their colour and their thickness. */
const FLOATS_M = 0.3;
const FLOATING = { colour: 0xd7f3ff, radius_m: 0.14 };
/** Half the side of the square that casts shadows [m]. */
const SHADOW_M = 170;

export interface Options {
  /** The bytes of the user's model of a vessel. */
  model(vessel: number, file: string): Promise<ArrayBuffer>;
  /** A software renderer smooths no edges, casts no shadows and has fewer trees: it would draw too seldom. */
  cheap: boolean;
}

export class Picture {
  readonly renderer: WebGLRenderer;
  readonly camera = new PerspectiveCamera(45, 1, 0.35, 70_000);
  private readonly scene = new Scene();
  private readonly shared: Shared = { ...skyUniforms(), uLamps: { value: 0 } };
  private readonly lighting = new Lighting(this.shared);
  private readonly sea: Sea;
  private readonly rain: RainFall;
  private readonly drift = new Drift();
  private readonly dome = sky(this.shared);
  private readonly ropes = new Ropes(this.shared);
  private readonly strokes = new Ropes(this.shared);
  private labels: Label[] = [];
  private readonly glows = new Glows(this.shared, 1024);
  readonly headset: Headset;
  private fenders: Fenders | null = null;
  private ships: Ship[] = [];
  private tugs: ShipPicture[] = [];
  private bodies: (Group | null)[] = [];
  private hello: Hello | null = null;
  private origin: Pair = [0, 0];
  /** Triangles of the last drawing. */
  triangles = 0;
  private built = new Group();
  /** What stands on the ground and has heights above datum: land, beacons. */
  private ground = new Group();
  /** Level of the water above datum [m]. */
  private water_m = 0;
  /** The mark that carries each light. */
  private carriers = new Map<ChartInfo, ChartInfo>();
  /** Mooring points that are bodies of the scenario, with the height of the deck above datum [m]. */
  private onBodies = new Map<ChartInfo, number>();
  private heights: Heights = heightsOf(0, []);
  /** Overhead cables: places on the earth with heights above datum [m]. */
  private cables: Spot[][] = [];
  /** Heights of the decks of fixed bodies above datum [m]. */
  private decks: number[] = [];
  /** Outlines of the decks of fixed bodies, in the body's frame. */
  private decked: Pair[][][] = [];
  /** What is wrong with models of ships, in words. */
  troubles: string[] = [];
  /** Until the models of ships are in their places, or known not to be. */
  dressed: Promise<unknown> = Promise.resolve();

  constructor(
    canvas: HTMLCanvasElement,
    private readonly live: Live,
    private readonly options: Options,
  ) {
    this.sea = new Sea(this.shared, options.cheap);
    this.rain = new RainFall(this.shared, options.cheap);
    this.renderer = new WebGLRenderer({
      canvas,
      antialias: !options.cheap,
      powerPreference: "high-performance",
    });
    this.headset = new Headset(this.renderer);
    this.renderer.toneMapping = ACESFilmicToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.lighting.direct.castShadow = !options.cheap;
    this.lighting.direct.shadow.mapSize.set(2048, 2048);
    const { camera } = this.lighting.direct.shadow;
    camera.left = camera.bottom = -SHADOW_M;
    camera.right = camera.top = SHADOW_M;
    camera.near = 10;
    camera.far = 1200;
    this.lighting.direct.shadow.bias = -0.0004;
    this.lighting.direct.shadow.normalBias = 0.35;
    this.scene.add(
      this.dome,
      this.sea.mesh,
      this.lighting.ambient,
      this.lighting.direct,
      this.lighting.direct.target,
      this.ropes.mesh,
      this.strokes.mesh,
      this.rain.lines,
      this.glows.points,
      this.built,
      this.headset.rig,
    );
    this.camera.rotation.order = "YXZ";
  }

  /** Resizes to CSS pixels at a share of the screen's resolution. */
  resize(width: number, height: number, ratio: number): void {
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.ropes.pixels(width * ratio, height * ratio);
    // Marks keep their width on the screen, and in a picture that is drawn larger and made smaller.
    const per = Math.min(1, ratio) * MARKS_NARROWER;
    this.strokes.pixels(width * per, height * per);
    this.glows.scale(height * ratio);
  }

  private clear(): void {
    dispose(this.built);
    this.built.clear();
  }

  /**
   * A picture of what the eye sees, with all detail: drawn at twice its size, so that edges are smooth, and with shadows.
   */
  still(width: number, height: number, look: Look, now_ms: number): HTMLCanvasElement {
    const { renderer } = this;
    const { direct } = this.lighting;
    const [ratio, casts] = [renderer.getPixelRatio(), direct.castShadow];
    const { width: before, height: tall } = renderer.getSize(new Vector2());
    const most = renderer.capabilities.maxTextureSize;
    this.resize(width, height, Math.min(2, most / Math.max(width, height)));
    direct.castShadow = renderer.shadowMap.autoUpdate = renderer.shadowMap.enabled = true;
    this.draw(now_ms, look);
    const small = document.createElement("canvas");
    [small.width, small.height] = [width, height];
    const to = small.getContext("2d");
    if (to) to.imageSmoothingQuality = "high";
    // Browsers forget a picture after it was shown: it is copied in the same turn.
    to?.drawImage(renderer.domElement, 0, 0, width, height);
    direct.castShadow = casts;
    this.resize(before, tall, ratio);
    return small;
  }

  /** Gives the graphics back; nothing is drawn after. */
  dispose(): void {
    this.clear();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  // --------------------------------------------------------------------------------------------------- building

  /** Builds everything of a scenario: once, and again when it changes. */
  build(hello: Hello, bodies: (BodyNow | null)[]): void {
    this.clear();
    this.hello = hello;
    this.origin = originOf(hello, bodies);
    this.sea.sea(hello.sea, this.origin);
    this.rain.rain(hello.rain);
    this.heights = heightsOf(hello.highest_water_m, knownQuays(hello));
    this.decks = hello.bodies.map((_, i) => this.deckOf(hello, i));
    this.decked = hello.bodies.map(({ fixed, outline, levels }, i) => {
      const deck = levels.at(-1)?.outline ?? outline;
      return !fixed ? [] : deck.length > 0 ? [deck] : this.quays(hello, i);
    });
    this.ground = new Group();
    this.built.add(this.ground);
    const concrete = paintwork(this.shared, "concrete");
    const steel = paintwork(this.shared, "steel");
    const panes = paintwork(this.shared, "panes");
    const plain = paintwork(this.shared, "plain", true);
    const names = [...hello.bodies, ...hello.traffic, ...hello.tugs].map(({ name }) => name);
    const alphabet = new Alphabet(FIGURES + names.map(painted).join(""), this.shared);
    const paints = { steel, panes, alphabet };
    this.ships = [];
    this.bodies = hello.bodies.map(({ fixed, outline, levels }, i) => {
      const group = new Group();
      const vessel = hello.vessels.findIndex(({ body }) => body === i);
      if (fixed) {
        const parts = new Solids();
        const deck_m = this.decks[i] ?? this.heights.quay_m;
        if (outline.length > 0) fixedParts(outline, deck_m, cut, parts, levels);
        else for (const ring of this.decked[i] ?? []) quay(ring, deck_m, cut, parts);
        const mesh = new Mesh(geometryOf(parts), concrete);
        mesh.receiveShadow = mesh.castShadow = true;
        group.add(mesh);
      } else if (outline.length >= 3) {
        const info = hello.vessels[vessel];
        const name = hello.bodies[i]?.name ?? "";
        const known = { ...(info ?? plainVessel(outline, name, levels)), name, levels };
        const lines = hello.lines.filter(({ ship }) => ship === i);
        const look = vessel >= 0 ? vessel : i;
        const built = shipPicture(known, outline, look, paints, lines);
        group.add(built.group);
        this.ships.push({ ...built, body: i, index: vessel, group });
      }
      this.built.add(group);
      return group;
    });
    hello.traffic.forEach(({ name, outline }, i) => {
      if (outline.length < 3) return;
      const ship = { ...plainVessel(outline, name), name };
      const built = shipPicture(ship, outline, i + 1, paints);
      this.built.add(built.group);
      this.ships.push({ ...built, body: -1, index: i });
    });
    this.tugs = hello.tugs.map((info) => {
      const { name, length_m, beam_m } = info;
      const outline = tugOutline(info);
      const draught_m = 0.13 * length_m;
      const vessel = { name, title: name, length_m, beam_m, draught_m, is_tug: true };
      const built = shipPicture(vessel, outline, 0, paints);
      this.built.add(built.group);
      return built;
    });
    this.troubles = [];
    this.dressed = Promise.all(this.ships.map((ship) => this.dress(ship, hello)));
    this.furnish(hello, steel);
    this.fenders = new Fenders(
      hello.fenders,
      (body) => this.bodies[body] ?? null,
      (fender) => isOfTug(fender, hello),
      plain,
      (body) => hello.bodies[body]?.fixed ?? true,
    );
    const fixed = this.decked.flatMap((rings, i): Fixed[] => {
      const [on, deck_m] = [bodies[i], this.decks[i] ?? this.heights.quay_m];
      return on ? rings.map((ring) => ({ ring: ring.map((at) => onEarth(on, at)), deck_m })) : [];
    });
    const site: Site = {
      fixed,
      origin: this.origin,
      heights: this.heights,
      high_water_m: hello.clearance_datum_m ?? hello.highest_water_m,
    };
    this.cables = cablesOf(hello.chart, site);
    this.ropes.room(
      hello.lines.length + hello.anchors.length + hello.tugs.length + this.cables.length,
    );
    const { ashore: standing, afloat: floating } = land(
      hello,
      site,
      this.shared,
      this.options.cheap ? MOST_TREES / 4 : MOST_TREES,
    );
    for (const mesh of standing) this.ground.add(mesh);
    for (const mesh of floating) this.built.add(mesh);
    const rise_m = riseOf(this.heights);
    this.carriers = carriersOf(hello.chart);
    this.onBodies = new Map(
      [...this.carriers.values()].flatMap((on): [ChartInfo, number][] => {
        const at = on.lines[0]?.[0];
        const body = at && fixed.find(({ ring }) => isOn(ring, at));
        return body && on.kind === "mooring" ? [[on, body.deck_m]] : [];
      }),
    );
    const [afloat, ashore] = [new Solids(), new Solids()];
    for (const feature of hello.chart) {
      const at = feature.lines[0]?.[0];
      if (at && feature.shape === "point" && !this.carriers.has(feature))
        mark(
          feature,
          [at[0] - this.origin[0], at[1] - this.origin[1]],
          floats(feature) ? afloat : ashore,
          rise_m,
        );
    }
    for (const [marks, on] of [
      [afloat, this.built],
      [ashore, this.ground],
    ] as const) {
      const mesh = new Mesh(geometryOf(marks), plain);
      mesh.castShadow = true;
      on.add(mesh);
    }
  }

  /** Height of the deck of a fixed body above datum [m]. */
  private deckOf(hello: Hello, body: number): number {
    const { fixed, levels } = hello.bodies[body] ?? { fixed: false, levels: [] };
    // The deck of a fixed body by outlines is no lower than the highest.
    const top_m = (fixed ? levels.at(-1)?.height_m : undefined) ?? Number.NEGATIVE_INFINITY;
    const deck_m = deckHeight(
      endsOn(hello, body),
      hello.fenders
        .filter((fender) => fender.body === body && !fender.floating)
        .map((fender) => middleOf(fender) + fender.height_m / 2),
      Number.isFinite(top_m) ? top_m : this.heights.quay_m,
    );
    return Math.max(top_m, deck_m);
  }

  /** Puts the user's model of a ship in her place, when it is loaded. */
  private async dress(ship: Ship, hello: Hello): Promise<void> {
    const info = ship.body >= 0 ? hello.vessels[ship.index]?.model : null;
    if (!info) return;
    const bytes = () => this.options.model(ship.index, info.file);
    // Another scenario may be shown by then.
    const isWanted = () => this.hello === hello;
    const trouble = await dress(ship, info, bytes, this.shared, isWanted);
    if (trouble && isWanted()) this.troubles.push(trouble);
  }

  /** The quays of a shore, which has no outline in the messages. */
  private quays({ fenders, bollards }: Hello, shore: number): Pair[][] {
    return quaysOf(
      fenders.filter(({ body }) => body === shore),
      bollards.filter(({ body }) => body === shore).map(({ at_m }) => at_m),
    );
  }

  /** Bollards, and lamps along quays. */
  private furnish(hello: Hello, steel: Mesh["material"]): void {
    const perBody = new Map<number, Solids>();
    const on = (body: number) => {
      let parts = perBody.get(body);
      if (!parts) perBody.set(body, (parts = new Solids()));
      return parts;
    };
    for (const { body, at_m, above_water_m } of hello.bollards)
      bollard(at_m, this.foot(body, at_m, above_water_m), on(body));
    for (const { end } of hello.lines)
      if (end && "body" in end && hello.bodies[end.body]?.fixed)
        bollard(end.at_m, this.foot(end.body, end.at_m, end.above_water_m), on(end.body));
    for (const [body, parts] of perBody) {
      const mesh = new Mesh(geometryOf(parts), steel);
      mesh.castShadow = true;
      this.bodies[body]?.add(mesh);
    }
  }

  /** Height of the deck of a body at a place above its water, or above datum if the body is fixed [m]. */
  private deck(body: number, [forward]: Pair): number {
    const ship = this.ships.find((each) => each.body === body);
    return ship ? ship.arrangement.hull.deck_m(forward) : (this.decks[body] ?? this.heights.quay_m);
  }

  /** Height of the foot of a bollard; `height_m`: where lines hold on it, 0 if the scenario gives no height [m]. */
  private foot(body: number, at: Pair, height_m: number): number {
    return height_m === 0 ? this.deck(body, at) : height_m - BIGHT_M;
  }

  // ----------------------------------------------------------------------------------------------------- light

  /** The palette of the page stands for the time of day, where the scenario gives no date. */
  palette(name: PaletteName): void {
    this.lighting.palette(name);
  }

  // ----------------------------------------------------------------------------------------------------- drawing

  draw(now_ms: number, look: Look): void {
    const { frame } = this.live;
    const { hello } = this;
    if (!frame || !hello) return;
    const bodies = this.live.seenBodies(now_ms);
    const t_s = this.live.time(now_ms);
    const share = this.live.share(now_ms);
    if (this.lighting.tick(hello, t_s, frame.visibility_m)) {
      this.renderer.toneMappingExposure = this.lighting.light.exposure;
      this.sea.colour(this.lighting.light.water);
    }
    const before = this.live.previous?.water_level_m ?? frame.water_level_m;
    this.water_m = before + (frame.water_level_m - before) * share;
    this.ground.position.y = -this.water_m;
    const traffic = this.live.traffic(now_ms);
    this.place(bodies, traffic, frame, share);
    this.fenders?.tick(frame.fenders, this.water_m);
    if (this.headset.runs) {
      // Level with the deck: the head looks up and down.
      this.aim({ ...look, raise_rad: 0, panorama_rad: look.panorama_rad ?? 1 }, t_s);
      this.headset.stand(this.camera, look.eye === "free");
    } else this.aim(look, t_s);
    // Two strokes for an arrow.
    const arrows = 2 * (frame.contacts.length + hello.tugs.length);
    const marks = look.marks ? MOST_GHOSTS + MOST_MARKS : 0;
    this.strokes.room(hello.lines.length + arrows + MEASURED_STROKES + marks);
    this.strokes.begin();
    this.labels = [];
    this.lines(frame, hello, look.marks);
    this.measured(hello, t_s);
    if (look.marks) {
      this.mark(frame, hello, look);
      this.float(frame, t_s);
    }
    this.strokes.end();
    this.lights(frame, bodies, t_s);
    const { x, y, z } = this.camera.position;
    this.sea.tick([x, y, z], t_s, frame.wind);
    this.rain.tick(this.camera.position, t_s, frame.wind);
    this.sea.wake(this.wakes(frame, bodies, traffic));
    this.sea.jets(this.jets(frame, hello));
    this.dome.position.copy(this.camera.position);
    this.shadow(look);
    this.renderer.render(this.scene, this.headset.runs ? this.headset.camera : this.camera);
    this.triangles = this.renderer.info.render.triangles;
  }

  private attitude(index: number, frame: Frame, share: number): Attitude {
    const to = frame.vessels[index];
    if (!to) return LEVEL;
    const from = this.live.previous?.vessels[index] ?? to;
    const mix = (a: number, b: number) => a + (b - a) * share;
    return {
      heel_rad: mix(from.heel_rad, to.heel_rad),
      trim_rad: mix(from.trim_rad, to.trim_rad),
      sunk_m: mix(from.squat_m + from.heave_m, to.squat_m + to.heave_m),
    };
  }

  private place(
    bodies: (BodyNow | null)[],
    traffic: (BodyNow | null)[],
    frame: Frame,
    share: number,
  ): void {
    const { live, origin } = this;
    bodies.forEach((now, i) => {
      const group = this.bodies[i];
      if (!group) return;
      group.visible = now !== null;
      if (!now) return;
      const index = live.hello?.vessels.findIndex(({ body }) => body === i) ?? -1;
      const lies = live.hello?.bodies[i]?.fixed ? fixedIn(this.water_m) : LEVEL;
      stand(group, origin, now, index >= 0 ? this.attitude(index, frame, share) : lies);
    });
    for (const ship of this.ships) {
      if (ship.body >= 0) continue;
      const now = traffic[ship.index];
      ship.group.visible = Boolean(now);
      if (!now) continue;
      stand(ship.group, origin, now, LEVEL);
    }
    this.placeTugs(bodies, frame);
  }

  /** Vector tugs lie at the place of their force, as on the plan. */
  private placeTugs(bodies: (BodyNow | null)[], frame: Frame): void {
    this.hello?.tugs.forEach((info, i) => {
      const [now, built] = [frame.tugs[i], this.tugs[i]];
      const ship = bodies[this.hello?.vessels[info.vessel]?.body ?? -1];
      if (!built) return;
      built.group.visible = Boolean(now && ship);
      if (!now || !ship) return;
      const { place, heading_rad } = tugPlace(info, now, ship);
      built.group.position.set(...toPicture(this.origin, place, 0));
      built.group.rotation.set(0, -heading_rad, 0, "YXZ");
      built.group.updateMatrixWorld();
    });
  }

  private shipOf(vessel: number): Ship | undefined {
    return this.ships.find(({ body, index }) => body >= 0 && index === vessel);
  }

  /** Where the eye of a look is, and on which body; `null` for the free eye. */
  seat(look: Look): { seat: Seat; on: Group } | null {
    if (look.eye === "free") return null;
    if (look.eye === "bollard") {
      const info = this.hello?.bollards[look.bollard];
      const on = info && this.bodies[info.body];
      if (!info || !on) return null;
      const facing = this.hello?.berth?.body === info.body ? this.hello.berth.facing : null;
      const toward = facing ? Math.atan2(facing[1], facing[0]) : 0;
      // Some steps behind the bollard, and beside it.
      const back = turned(toward, [-4.5, -1.2]);
      const at: Pair = [info.at_m[0] + back[0], info.at_m[1] + back[1]];
      return { seat: seatAtBollard(at, this.deck(info.body, info.at_m), toward), on };
    }
    const vectors = look.vessel - (this.hello?.vessels.length ?? 0);
    const tug = look.eye === "tug" ? this.tugs[vectors] : undefined;
    const ship = tug ?? this.shipOf(look.vessel) ?? this.ships[0];
    return ship ? { seat: seatOn(ship.arrangement, look.eye), on: ship.group } : null;
  }

  private aim(look: Look, t_s: number): void {
    const { camera } = this;
    const at = this.seat(look);
    if (at) {
      const { seat, on } = at;
      const lifted = look.eye === "bollard" ? 0 : look.lifted_m;
      aim(camera, { ...seat, up_m: seat.up_m + lifted }, on.matrixWorld, look);
    } else if (!this.atFender(look)) {
      const ship = this.shipOf(look.vessel) ?? this.ships[0];
      const centre = ship ? ship.group.position.clone() : new Vector3();
      const heading = ship ? -ship.group.rotation.y : 0;
      const bearing = heading + look.turn_rad + 2.5;
      const high = clamp(0.3 - look.raise_rad, 0.02, 1.5);
      camera.position.set(
        centre.x + Math.sin(bearing) * Math.cos(high) * look.off_m,
        Math.max(1.5, 6 + Math.sin(high) * look.off_m),
        centre.z - Math.cos(bearing) * Math.cos(high) * look.off_m,
      );
      camera.lookAt(centre.x, 6, centre.z);
      camera.fov = deg(look.view_rad ?? 0.75);
    }
    // An eye ashore or on a free place is never in a wave.
    const sea = surface(
      this.hello?.sea ?? [],
      this.origin[0] - camera.position.z,
      this.origin[1] + camera.position.x,
      t_s,
    );
    camera.position.y = Math.max(camera.position.y, sea + 0.8);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  /** Puts the free eye on the edge of the quay beside a fender, so that panel, rubber and ship's side are seen. */
  private atFender(look: Look): boolean {
    const info = look.fender === null ? undefined : this.hello?.fenders[look.fender];
    const on = info && this.bodies[info.body];
    if (!info || !on) return false;
    const middle = middleOf(info);
    const far = 4 + 2.2 * info.width_m;
    const place = (out: number, along: number, up: number) => {
      const [f, s] = turned(info.facing_rad, [out, along]);
      return new Vector3(...aboard([info.at_m[0] + f, info.at_m[1] + s], up)).applyMatrix4(
        on.matrixWorld,
      );
    };
    const { camera } = this;
    camera.position.copy(place(0.2 * info.projection_m, -far, middle + 0.45 * far));
    // Beyond the fender, so that the horizon is in the picture.
    camera.lookAt(place(0.4 * info.projection_m, 0.7 * far, middle + 0.2));
    camera.fov = deg(look.view_rad ?? 0.8);
    return true;
  }

  /** What stands in the picture, read back from the picture: tests compare it with the frames. */
  shown(): Shown {
    const ship = this.bodies[this.live.body()];
    return {
      tick: this.live.frame?.tick ?? -1,
      north_m: ship ? this.origin[0] - ship.position.z : null,
      east_m: ship ? this.origin[1] + ship.position.x : null,
      heading_rad: ship ? -ship.rotation.y : null,
      eye: this.camera.position.toArray(),
      pressed_m: this.fenders?.pressed() ?? [],
      labels: this.labels.map(({ text }) => text),
    };
  }

  /** Direction in which the camera looks, from north [rad], its elevation, and its vertical angle of view. */
  gaze(): { bearing_rad: number; elevation_rad: number; view_rad: number } {
    const d = this.camera.getWorldDirection(new Vector3());
    return {
      bearing_rad: Math.atan2(d.x, -d.z),
      elevation_rad: Math.asin(clamp(d.y, -1, 1)),
      view_rad: (this.camera.fov * Math.PI) / 180,
    };
  }

  // -------------------------------------------------------------------------------------------- lines and chains

  private lines(frame: Frame, hello: Hello, marks: boolean): void {
    this.ropes.begin();
    hello.lines.forEach((info, i) => {
      const now = frame.lines[i];
      if (!now || (now.state !== "fast" && now.state !== "sent")) return;
      const ends = this.lineEnds(info, now, hello);
      if (!ends) return;
      const hanging = catenary(
        ...ends,
        {
          tension_n: now.state === "fast" && now.tension_n > SLACK_N ? now.tension_n : 0,
          length_m: now.length_m,
          weight_npm: weightOf(info.breaking_n),
        },
        PIECES,
      );
      // A rope of 1 MN is about 60 mm thick.
      const radius = 0.03 * Math.sqrt(info.breaking_n / 1e6);
      const points = this.onQuay(hanging, info, now, hello, radius);
      if (!marks || now.state !== "fast") {
        this.ropes.add(points, linearOf(now.over_working ? 0xe05a2a : 0xcfc6a8), radius);
        return;
      }
      // The mark stands in the line's place, so that what hides the line hides the mark.
      const share = now.tension_n / Math.max(1, info.working_n);
      this.stroke({ points, colour: colourOf(share), radius_m: 1.2 * radius });
      const middle = points[Math.floor(PIECES / 2)];
      if (middle && now.tension_n > 1000) this.labels.push(lineLabel(middle, now.tension_n, share));
    });
    hello.anchors.forEach((info, i) => {
      const now = frame.anchors[i];
      const on = this.bodies[info.ship];
      if (!now || !on || now.state === "housed" || now.state === "lost" || !on.visible) return;
      const up = info.hawse_above_water_m || this.deck(info.ship, info.hawse_m) - 3;
      const from = this.worldOf(on, aboard(info.hawse_m, up));
      // The chain goes into the water in its lead; what lies below is not seen.
      const lead = now.lead_rad ?? 0;
      const off = now.lead_rad === null ? 0.05 : up * (0.3 + Math.min(3, now.tension_n / 2e5));
      const heading = -on.rotation.y + lead;
      const to: Triple = [
        from[0] + Math.sin(heading) * off,
        -1.5,
        from[2] - Math.cos(heading) * off,
      ];
      const points = catenary(from, to, { tension_n: 1e9, length_m: null, weight_npm: 1 }, PIECES);
      this.ropes.add(points, linearOf(0x4a4642), 0.11);
    });
    hello.tugs.forEach((info, i) => {
      const [now, built] = [frame.tugs[i], this.tugs[i]];
      const on = this.bodies[hello.vessels[info.vessel]?.body ?? -1];
      if (!now || !built || !on || now.order !== "pull" || !built.group.visible) return;
      const { hull } = built.arrangement;
      const staple = hull.aft_m + 0.93 * built.arrangement.length_m;
      const points = catenary(
        this.worldOf(built.group, aboard([staple, 0], hull.deck_m(staple) + 1.5)),
        this.worldOf(
          on,
          aboard(
            info.pull_at_m,
            this.deck(hello.vessels[info.vessel]?.body ?? -1, info.pull_at_m) + 0.3,
          ),
        ),
        { tension_n: Math.max(2e4, now.force_n), length_m: null, weight_npm: weightOf(2e6) },
        PIECES,
      );
      this.ropes.add(points, linearOf(0xd8b23a), 0.045);
    });
    for (const cable of this.cables) {
      const points = cable.map(([n, e, up]) => toPicture(this.origin, [n, e], up - this.water_m));
      this.ropes.add(resampled(points), linearOf(CABLE), CABLE_RADIUS_M);
    }
    this.ropes.end();
  }

  private stroke({ points, colour, radius_m }: Stroke): void {
    this.strokes.add(points, linearOf(colour), radius_m);
  }

  /**
   * How high the arrow of a push lies above the water [m]: over the deck of a quay or ship that pushes, over the mast of a tug,
   * and over the fender, so that none of them hides the arrow.
   */
  private over(pusher: number, top_m: number): number {
    const ship = this.ships.find(({ body }) => body === pusher)?.arrangement;
    const deck_m = ship
      ? ship.kind === "tug"
        ? ship.mast_m
        : ship.deck_m
      : (this.decks[pusher] ?? this.heights.quay_m) - this.water_m;
    return Math.max(deck_m, top_m) + ARROW_OVER_M;
  }

  /** The ship of a log beside the simulated ones, on the clock of the session. */
  private measured({ ghost }: Hello, t_s: number): void {
    const now = ghost && ghostAt(ghost, t_s);
    if (!now) return;
    this.strokes.bright(this.lighting.light.exposure);
    const place = (at: Pair, up_m: number) => toPicture(this.origin, at, up_m);
    for (const each of measuredStrokes(ghost.outline, now, place)) this.stroke(each);
    const at = toPicture(this.origin, [now[1], now[2]], MEASURED_WORDS_UP_M);
    this.labels.push({ at, text: ghostText(ghost, t_s), level: "plain" });
  }

  /** Marks on request: the predicted path, and arrows of the forces of contacts and tugs. */
  private mark(frame: Frame, hello: Hello, look: Look): void {
    this.strokes.bright(this.lighting.light.exposure);
    const path = this.live.prediction?.paths.find(({ vessel }) => vessel === look.vessel);
    const outline = hello.bodies[hello.vessels[look.vessel]?.body ?? -1]?.outline ?? [];
    if (path)
      for (const each of pathStrokes(path, outline, (at) => toPicture(this.origin, at, 0.4)))
        this.stroke(each);
    const isTug = (body: number) =>
      hello.vessels.some((vessel) => vessel.is_tug && vessel.body === body);
    for (const { bodies, fender, at_m, force_n } of frame.contacts) {
      const size_n = Math.hypot(...force_n);
      if (size_n < 500) continue;
      // The force on the ship: not on the quay, not on the tug.
      const [first, second] = bodies;
      const onFirst = !(hello.bodies[first]?.fixed ?? true) && !isTug(first);
      const sign = onFirst ? 1 : -1;
      const info = fender === null ? undefined : hello.fenders[fender];
      const now = fender === null ? undefined : frame.fenders[fender];
      const fixed = info ? (hello.bodies[info.body]?.fixed ?? false) : false;
      const top = info
        ? middleOf(info) + info.height_m / 2 - (fixed && !info.floating ? this.water_m : 0)
        : 2;
      const at = toPicture(this.origin, at_m, this.over(onFirst ? second : first, top));
      const share = info && isTug(info.body) ? 0 : (now?.of_reaction ?? 0);
      for (const each of arrow(at, [sign * force_n[1], -sign * force_n[0]], colourOf(share)))
        this.stroke(each);
      const tug = hello.vessels.find(({ body, is_tug }) => is_tug && bodies.includes(body));
      const label: Triple = [at[0], at[1] + 1.2, at[2]];
      this.labels.push(tug ? tugLabel(label, tug.name, size_n) : fenderLabel(label, size_n, share));
    }
    hello.tugs.forEach((info, i) => {
      const now = frame.tugs[i];
      const on = this.bodies[hello.vessels[info.vessel]?.body ?? -1];
      if (!now || !on?.visible || now.force_n < 500) return;
      const pulls = now.order === "pull";
      const body = hello.vessels[info.vessel]?.body ?? -1;
      const mast_m = this.tugs[i]?.arrangement.mast_m ?? 0;
      // A pull begins at the bitts; a push ends at the side, over the tug's mast.
      const at = this.worldOf(
        on,
        pulls
          ? aboard(info.pull_at_m, this.deck(body, info.pull_at_m) + ARROW_OVER_M)
          : aboard(info.push_at_m, mast_m + ARROW_OVER_M),
      );
      const towards = now.direction_rad - on.rotation.y;
      const vector: Pair = [Math.sin(towards) * now.force_n, -Math.cos(towards) * now.force_n];
      for (const each of arrow(at, vector, colourOf(now.limited ? 1 : 0.5), pulls))
        this.stroke(each);
      this.labels.push(tugLabel([at[0], at[1] + 1.5, at[2]], info.name, now.force_n));
    });
  }

  /** The current, by marks on the water about the eye. */
  private float(frame: Frame, t_s: number): void {
    const { x, z } = this.camera.position;
    const near: Pair = [this.origin[0] - z, this.origin[1] + x];
    const place = (at: Pair) => toPicture(this.origin, at, FLOATS_M);
    for (const [tail, head] of this.drift.marks(near, t_s, frame.current))
      this.stroke({ points: resampled([place(tail), place(head)]), ...FLOATING });
  }

  /** The labels of the last drawing that no ship hides, on a picture of a size in CSS pixels. */
  labelled([width, height]: Pair): Placed[] {
    return this.labels.flatMap(({ at, text, level }) => {
      const { x, y, z } = this.spot.set(...at).project(this.camera);
      if (z > 1 || Math.abs(x) > 1 || Math.abs(y) > 1 || this.isHidden(at)) return [];
      return [{ x: ((x + 1) / 2) * width, y: ((1 - y) / 2) * height, text, level }];
    });
  }

  /** Whether a ship stands between the eye and a place. */
  private isHidden(at: Triple): boolean {
    return [...this.ships, ...this.tugs].some(({ group, blocks }) => {
      if (!group.visible) return false;
      const aboard = this.inverse.copy(group.matrixWorld).invert();
      const [eye, place] = [this.camera.position, this.spot.set(...at)].map((each): Triple => {
        const { x, y, z } = this.eye.copy(each).applyMatrix4(aboard);
        return [x, y, z];
      }) as [Triple, Triple];
      return blocks.some((block) => hides(block, eye, place));
    });
  }

  private worldOf(group: Group, [x, y, z]: Triple): Triple {
    const at = new Vector3(x, y, z).applyMatrix4(group.matrixWorld);
    return [at.x, at.y, at.z];
  }

  /** A line to a quay: where it would hang through the quay, it lies on the quay. */
  private onQuay(
    points: Triple[],
    info: LineInfo,
    now: LineNow,
    hello: Hello,
    radius_m: number,
  ): Triple[] {
    const end = now.bollard === null ? info.end : hello.bollards[now.bollard];
    if (!end || !("body" in end)) return points;
    const [on, rings] = [this.bodies[end.body], this.decked[end.body] ?? []];
    if (!on || rings.length === 0) return points;
    const toQuay = this.inverse.copy(on.matrixWorld).invert();
    const isOverQuay = (at: Triple) => {
      const { x, z } = this.spot.set(...at).applyMatrix4(toQuay);
      return rings.some((ring) => isInside(ring, [-z, x]));
    };
    const top_m = (this.decks[end.body] ?? this.heights.quay_m) - this.water_m + radius_m;
    return draped(points, isOverQuay, top_m);
  }

  /** Both ends of a line: its fairlead, and the bollard or place where it is fast. */
  private lineEnds(info: LineInfo, now: LineNow, hello: Hello): [Triple, Triple] | null {
    const ship = this.bodies[info.ship];
    if (!ship?.visible) return null;
    const from = this.worldOf(
      ship,
      aboard(
        info.fairlead_m,
        info.fairlead_above_water_m || this.fairlead(info.ship, info.fairlead_m),
      ),
    );
    const end = now.bollard === null ? info.end : hello.bollards[now.bollard];
    if (!end) return null;
    if ("place_m" in end)
      return [
        from,
        toPicture(
          this.origin,
          end.place_m,
          (end.above_datum_m || this.heights.quay_m + BIGHT_M) - this.water_m,
        ),
      ];
    const on = this.bodies[end.body];
    if (!on) return null;
    const isShip = this.ships.some(({ body }) => body === end.body);
    const usual = isShip
      ? this.fairlead(end.body, end.at_m)
      : this.deck(end.body, end.at_m) + BIGHT_M;
    return [from, this.worldOf(on, aboard(end.at_m, end.above_water_m || usual))];
  }

  /** Height of a fairlead above the water: on a tug her staple, else a hand above the deck [m]. */
  private fairlead(body: number, at: Pair): number {
    const ship = this.ships.find((each) => each.body === body);
    if (!ship) return this.deck(body, at) + BIGHT_M;
    return fairleadHeight(ship.arrangement, at[0]);
  }

  // -------------------------------------------------------------------------------------------------------- lights

  private lights(frame: Frame, bodies: (BodyNow | null)[], t_s: number): void {
    this.glows.begin();
    // Rule 20: lights from sunset on, and in restricted visibility.
    const fog = frame.visibility_m !== null && frame.visibility_m < 3700;
    if (this.lighting.light.lamps > 0 || fog) {
      for (const ship of this.ships) this.shipLights(ship, frame, bodies[ship.body]);
      this.tugs.forEach(({ group, lamps }, i) => {
        const tows = frame.tugs[i]?.order === "pull";
        if (group.visible) this.glow(group, tows ? lamps.tows : lamps.under_way, 1);
      });
    }
    if (this.lighting.light.lamps > 0) {
      for (const feature of this.hello?.chart ?? []) this.chartLight(feature, t_s);
    }
    this.glows.end();
  }

  private shipLights(ship: Ship, frame: Frame, now: BodyNow | null | undefined): void {
    const { group, body, index, lamps } = ship;
    if (!group.visible || !this.hello) return;
    const conduct = body < 0 || !now ? "under_way" : conductOf(body, index, this.hello, frame, now);
    this.glow(group, lamps[conduct], 1);
  }

  private readonly inverse = new Matrix4();
  private readonly eye = new Vector3();
  private readonly spot = new Vector3();

  private glow(group: Group, lamps: Lamp[], strength: number): void {
    const eye = this.eye
      .copy(this.camera.position)
      .applyMatrix4(this.inverse.copy(group.matrixWorld).invert());
    for (const { at, colour, arc } of lamps) {
      if (!isSeen(arc, bearingFrom(at, [eye.x, eye.y, eye.z]))) continue;
      // A lamp beside the eye would fill the picture.
      if (Math.hypot(eye.x - at[0], eye.y - at[1], eye.z - at[2]) < 4) continue;
      const { x, y, z } = this.spot.set(...at).applyMatrix4(group.matrixWorld);
      this.glows.add(x, y, z, colour, strength);
    }
  }

  private chartLight(feature: ChartInfo, t_s: number): void {
    const at = feature.lines[0]?.[0];
    const isMark = feature.kind === "buoy" || feature.kind === "beacon" || feature.kind === "light";
    if (!at || !isMark || feature.shape !== "point") return;
    // A mark of which the chart gives no character has no light.
    if (feature.kind !== "light" && !feature.character) return;
    if (!isLit(feature.character ?? "", feature.period_s, t_s)) return;
    const on = this.carriers.get(feature) ?? feature;
    const deck_m = this.onBodies.get(on);
    const above_m =
      deck_m === undefined ? lampHeight(on, riseOf(this.heights)) : deck_m + OVER_DOLPHIN_M;
    const up = above_m - (floats(on) ? 0 : this.water_m);
    const [x, y, z] = toPicture(this.origin, at, up);
    const { x: ex, z: ez } = this.camera.position;
    const bearing = Math.atan2(ex - x, -(ez - z));
    if (!isSeen(feature.sector_rad, bearing)) return;
    const away = Math.hypot(ex - x, ez - z);
    if (feature.range_m !== null && away > feature.range_m) return;
    this.glows.add(x, y, z, lampColour(feature.colour), 1.15);
  }

  // ------------------------------------------------------------------------------------------------ wakes, shadows

  private wakes(frame: Frame, bodies: (BodyNow | null)[], traffic: (BodyNow | null)[]): Wake[] {
    const { x, z } = this.camera.position;
    return this.ships
      .flatMap((ship): (Wake & { away: number })[] => {
        if (!ship.group.visible) return [];
        const now = ship.body >= 0 ? bodies[ship.body] : traffic[ship.index];
        if (!now) return [];
        const { arrangement, group } = ship;
        const info = ship.body >= 0 ? frame.vessels[ship.index] : undefined;
        const eyes = frame.eyes?.body === ship.body ? frame.eyes : undefined;
        const ahead = now[3] * Math.cos(now[2]) + now[4] * Math.sin(now[2]);
        return [
          {
            at: [group.position.x, 0, group.position.z],
            heading_rad: now[2],
            length_m: arrangement.length_m,
            beam_m: arrangement.beam_m,
            speed_mps: (eyes ?? info)?.water_mps[0] ?? ahead,
            // Thrusters and azimuth units have jets.
            wash: info?.shaft.now ?? 0,
            away: Math.hypot(group.position.x - x, group.position.z - z),
          },
        ];
      })
      .toSorted((a, b) => a.away - b.away);
  }

  /** The jets of thrusters and azimuth units. */
  private jets(frame: Frame, hello: Hello): PlacedJet[] {
    const ofShips = this.ships.flatMap(({ body, index, group, arrangement }) => {
      const [info, now] = [hello.vessels[index], frame.vessels[index]];
      if (body < 0 || !info || !now || !group.visible) return [];
      return jetsOf(arrangement, info, now).map((jet) => ({ jet, group }));
    });
    const ofTugs = hello.tugs.flatMap((info, i) => {
      const [now, built] = [frame.tugs[i], this.tugs[i]];
      if (!now || !built?.group.visible) return [];
      const force = { force_n: now.force_n, pulls: now.order === "pull" };
      const jets = jetOfTug(built.arrangement, force, info.bollard_pull_n);
      return jets.map((jet) => ({ jet, group: built.group }));
    });
    return [...ofShips, ...ofTugs].map(({ jet, group }) => ({
      ...jet,
      at: this.worldOf(group, aboard(jet.at_m, 0)),
      // A group turns against the compass.
      to_rad: jet.to_rad - group.rotation.y,
    }));
  }

  private drawn = 0;

  /** The square that casts shadows lies before the eye; shadows move slowly, so each fourth picture renews them. */
  private shadow(look: Look): void {
    const { camera } = this;
    const { direct } = this.lighting;
    if (!direct.castShadow) return;
    this.drawn += 1;
    if (!this.options.cheap)
      this.renderer.shadowMap.autoUpdate = this.drawn % 4 === 1 || look.eye === "free";
    const ahead = camera.getWorldDirection(new Vector3());
    const reach = look.eye === "free" ? Math.min(look.off_m, 250) : SHADOW_M * 0.7;
    // In whole steps, so that shadows do not creep.
    const step = 8;
    const round = (v: number) => Math.round(v / step) * step;
    direct.target.position.set(
      round(camera.position.x + ahead.x * reach),
      0,
      round(camera.position.z + ahead.z * reach),
    );
    direct.position
      .set(...this.lighting.light.from)
      .multiplyScalar(500)
      .add(direct.target.position);
    direct.target.updateMatrixWorld();
  }
}

const deg = (rad: number): number => (rad * 180) / Math.PI;
const lampColour = (colour: string | null): LampColour =>
  colour === "red" || colour === "green" || colour === "yellow" ? colour : "white";

/**
 * A round place near something that stays where it is, so that all windows of a session have the same axes whenever they are opened; near
 * the first body where nothing stays.
 */
function originOf(hello: Hello, bodies: (BodyNow | null)[]): Pair {
  const fixed = hello.bodies.findIndex((body) => body.fixed);
  const chart = hello.chart[0]?.lines[0]?.[0];
  const near = bodies[fixed] ?? chart ?? bodies.find((body) => body !== null) ?? [0, 0];
  return [Math.round(near[0] / 1000) * 1000, Math.round(near[1] / 1000) * 1000];
}
