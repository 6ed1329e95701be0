/** Placing ships before the start: which one is chosen, and where she is dragged to. The server decides whether she may be there. */
import { type Camera, add, minus, onEarth, toEarth, toScreen, turned } from "./geometry";
import type { BodyNow, Hello, OtherAction, Pair } from "./protocol";

/** A finger hits a hull or a knob within this distance [px]. */
const REACH_PX = 24;
/** From the bow to the knob that turns her [px]. */
export const KNOB_PX = 44;

/** A ship where she is dragged to. */
export interface Ghost {
  vessel: number;
  at: Pair;
  heading_rad: number;
}

/** What a pointer drags. */
interface Grip {
  pointer: number;
  turns: boolean;
  /** From the pointer to her centre of gravity when she was gripped [m]. */
  offset: Pair;
}

/** True if a point is inside an outline. */
export function inside(outline: Pair[], [x, y]: Pair): boolean {
  let odd = false;
  outline.forEach(([fromX, fromY], i) => {
    const [toX, toY] = outline[(i + 1) % outline.length] ?? [fromX, fromY];
    if (fromY > y !== toY > y && x < fromX + ((toX - fromX) * (y - fromY)) / (toY - fromY))
      odd = !odd;
  });
  return odd;
}

export class Placing {
  /** Ships can be dragged: the tab is shown, and the run has not begun. */
  on = false;
  chosen: number | null = null;
  ghost: Ghost | null = null;
  private grip: Grip | null = null;

  /** `place` sends the command and resolves to whether it was carried out. */
  constructor(
    private readonly place: (action: OtherAction) => Promise<boolean>,
    private readonly changed: () => void,
  ) {}

  /** Takes a pointer that is pressed on a ship, or on the knob of the chosen one. */
  takes(
    camera: Camera,
    hello: Hello,
    bodies: (BodyNow | null)[],
    pointer: number,
    at: Pair,
  ): boolean {
    if (!this.on || this.grip) return false;
    const here = toEarth(camera, at);
    const knob = this.knob(camera, hello, bodies);
    if (this.chosen !== null && knob && Math.hypot(...minus(knob, at)) <= REACH_PX) {
      const ghost = this.pose(hello, bodies, this.chosen);
      if (!ghost) return false;
      this.ghost = ghost;
      this.grip = { pointer, turns: true, offset: [0, 0] };
      return true;
    }
    const hit = hello.vessels.findIndex((_, vessel) => {
      const pose = this.pose(hello, bodies, vessel);
      const outline = this.outline(hello, vessel);
      if (!pose || !outline) return false;
      const near = Math.hypot(...minus(toScreen(camera, pose.at), at)) <= REACH_PX;
      const local = turned(-pose.heading_rad, minus(here, pose.at));
      return near || inside(outline, local);
    });
    const pose = hit >= 0 ? this.pose(hello, bodies, hit) : null;
    if (!pose) return false;
    this.chosen = hit;
    this.ghost = pose;
    this.grip = { pointer, turns: false, offset: minus(pose.at, here) };
    this.changed();
    return true;
  }

  /** Moves or turns the gripped ship. Returns whether this pointer drags one. */
  move(camera: Camera, pointer: number, at: Pair): boolean {
    if (this.grip?.pointer !== pointer || !this.ghost) return false;
    const here = toEarth(camera, at);
    if (this.grip.turns) {
      const [north, east] = minus(here, this.ghost.at);
      this.ghost = { ...this.ghost, heading_rad: Math.atan2(east, north) };
    } else this.ghost = { ...this.ghost, at: add(here, this.grip.offset) };
    this.changed();
    return true;
  }

  /** Ends a drag: the server places her, or refuses, and then she is where she was. */
  end(pointer: number, drop: boolean): boolean {
    if (this.grip?.pointer !== pointer) return false;
    this.grip = null;
    const { ghost } = this;
    if (ghost && drop) void this.send(ghost);
    else this.ghost = null;
    return true;
  }

  private async send({ vessel, at, heading_rad }: Ghost): Promise<void> {
    const name = this.names[vessel];
    if (name !== undefined) await this.place({ do: "place", vessel: name, at_m: at, heading_rad });
    // Not one that another finger has gripped meanwhile.
    if (!this.grip) this.ghost = null;
    this.changed();
  }

  private names: string[] = [];

  /** The names of the ships, for commands. */
  of(hello: Hello): void {
    this.names = hello.vessels.map(({ name }) => name);
  }

  /** Where a ship is, or is dragged to. */
  pose(hello: Hello, bodies: (BodyNow | null)[], vessel: number): Ghost | null {
    if (this.ghost?.vessel === vessel) return this.ghost;
    const body = bodies[hello.vessels[vessel]?.body ?? -1];
    return body ? { vessel, at: [body[0], body[1]], heading_rad: body[2] } : null;
  }

  outline(hello: Hello, vessel: number): Pair[] | undefined {
    return hello.bodies[hello.vessels[vessel]?.body ?? -1]?.outline;
  }

  /** The knob that turns the chosen ship, on the screen. */
  knob(camera: Camera, hello: Hello, bodies: (BodyNow | null)[]): Pair | null {
    if (!this.on || this.chosen === null) return null;
    const pose = this.pose(hello, bodies, this.chosen);
    const outline = this.outline(hello, this.chosen);
    if (!pose || !outline) return null;
    const bow = Math.max(...outline.map(([ahead]) => ahead));
    const ahead = bow + KNOB_PX / camera.pixels_per_m;
    return toScreen(camera, onEarth([...pose.at, pose.heading_rad, 0, 0, 0], [ahead, 0]));
  }
}
