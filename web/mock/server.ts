/**
 * A server that speaks the protocol over a toy world, for developing and testing the pages without the real one.
 * Serves `dist` too when asked, so that one port has page and socket, as with the real server. Never shipped.
 */
import { createReadStream, existsSync } from "node:fs";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize } from "node:path";
import { type WebSocket, WebSocketServer } from "ws";
import type { Action, Command, Control, Frame, FromServer, Hello, Role } from "../src/protocol";
import { type ToyState, alarms, bodiesNow, initialState, obey, predict, step, vesselsNow } from "./sim";
import { BERTH, BODIES, DEPTH_M, FENDERS, LINES, STEP_S, TUGS, VESSELS } from "./world";

const ROLES: Record<string, Role> = {
  instructor: { name: "instructor" },
  pilot: { name: "pilot" },
  "tugmaster-alpha": { name: "tugmaster", tug: "alpha" },
  "tugmaster-bruiser": { name: "tugmaster", tug: "bruiser" },
  observer: { name: "observer" },
};

const GALLERY = [
  { file: "alongside.toml", title: "Alongside with two tugs", text: "A container ship thirty metres off; two tugs, six lines, wind off the quay." },
  { file: "unberthing.toml", title: "Unberthing in a breeze", text: "The same ship is made fast; get her off the berth and away." },
];

interface Client { socket: WebSocket; role: Role; name: string }
interface Branch { id: number; from_tick: number; parent: number | null; states: Map<number, ToyState>; ends_tick: number }

export interface Mock {
  url: string;
  tokens: Record<string, string>;
  close(): Promise<void>;
}

export async function startMock(options: { port: number; serveDist: boolean }): Promise<Mock> {
  const dist = new URL("../dist/", import.meta.url).pathname;
  const http = createServer((request, response) => {
    const path = normalize(new URL(request.url ?? "/", "http://here").pathname);
    const file = join(dist, path === "/" ? "index.html" : path);
    if (!options.serveDist || !file.startsWith(dist) || !existsSync(file)) {
      response.writeHead(404).end("not here");
      return;
    }
    const types: Record<string, string> = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml" };
    response.writeHead(200, { "content-type": types[extname(file)] ?? "application/octet-stream" });
    createReadStream(file).pipe(response);
  });
  const sockets = new WebSocketServer({ server: http, path: "/live" });
  const session = new Session();
  sockets.on("connection", (socket, request) => {
    const token = new URL(request.url ?? "/", "http://here").searchParams.get("token") ?? "";
    const role = ROLES[token];
    if (!role) {
      socket.close(4401, "no such token");
      return;
    }
    session.join(socket, role);
  });
  await new Promise<void>((done) => http.listen(options.port, "127.0.0.1", done));
  const port = (http.address() as AddressInfo).port;
  session.start();
  return {
    url: `http://127.0.0.1:${port}`,
    tokens: Object.fromEntries(Object.keys(ROLES).map((name) => [name, name])),
    close: async () => {
      session.stop();
      for (const socket of sockets.clients) socket.terminate();
      await new Promise((done) => http.close(done));
    },
  };
}

class Session {
  private state = initialState();
  private branches: Branch[] = [{ id: 0, from_tick: 0, parent: null, states: new Map(), ends_tick: 0 }];
  private branch = 0;
  private paused = false;
  private pace = 1;
  private owed = 0;
  private late = { ticks: 0, latest_ms: 0 };
  private events: { t_s: number; text: string }[] = [];
  private clients: Client[] = [];
  private held = new Map<string, Client>();
  private timers: NodeJS.Timeout[] = [];
  private file = "alongside.toml";
  private joined = 0;

  start() {
    let last = performance.now();
    this.timers.push(
      setInterval(() => {
        const now = performance.now();
        if (!this.paused) this.owed += ((now - last) / 1000) * this.pace;
        last = now;
        let went = false;
        for (let i = 0; this.owed >= STEP_S && i < 50; i++) {
          this.owed -= STEP_S;
          this.advance();
          went = true;
        }
        if (went) this.broadcast(this.frame());
      }, 20),
      setInterval(() => {
        if (this.paused) this.broadcast(this.frame());
        this.broadcast({ type: "prediction", tick: this.state.tick, vessel: 0, path: predict(this.state) });
      }, 1000),
    );
  }

  stop() {
    this.timers.forEach(clearInterval);
  }

  join(socket: WebSocket, role: Role) {
    this.joined += 1;
    const client: Client = { socket, role, name: `${role.name === "tugmaster" ? `tugmaster ${role.tug}` : role.name} ${this.joined}` };
    this.clients.push(client);
    socket.on("message", (data) => this.heard(client, String(data)));
    socket.on("close", () => {
      this.clients = this.clients.filter((other) => other !== client);
      for (const [key, holder] of this.held) if (holder === client) this.held.delete(key);
      this.broadcast({ type: "notice", text: `${client.name} has gone; controls stay as they are` });
      this.greetAll();
    });
    this.greetAll();
    this.send(client, this.frame());
    this.broadcast({ type: "notice", text: `${client.name} joined` });
  }

  private advance() {
    const branch = this.current();
    if (this.state.tick < branch.ends_tick) {
      this.paused = true;
      return;
    }
    branch.states.set(this.state.tick, structuredClone(this.state));
    const events = step(this.state);
    this.events.push(...events.map((text) => ({ t_s: this.state.tick * STEP_S, text })));
    branch.ends_tick = this.state.tick;
    branch.states.set(this.state.tick, structuredClone(this.state));
  }

  private current(): Branch {
    const branch = this.branches.find((b) => b.id === this.branch);
    if (!branch) throw new Error("the branch that is shown exists");
    return branch;
  }

  private find(branch: Branch, tick: number): ToyState | null {
    const here = branch.states.get(tick);
    if (here) return here;
    const parent = this.branches.find((b) => b.id === branch.parent);
    return parent ? this.find(parent, tick) : null;
  }

  private heard(client: Client, text: string) {
    let command: Command;
    try {
      command = JSON.parse(text) as Command;
    } catch {
      this.send(client, { type: "refused", id: null, reason: "not JSON" });
      return;
    }
    const reason = this.carryOut(client, command.action);
    this.send(client, reason === null ? { type: "ack", id: command.id, tick: this.state.tick } : { type: "refused", id: command.id, reason });
  }

  private carryOut(client: Client, action: Action): string | null {
    const instructor = client.role.name === "instructor";
    switch (action.do) {
      case "claim": {
        const key = keyOf(action.control);
        if (!mayClaim(client.role, action.control)) return "your role has no such control";
        const holder = this.held.get(key);
        if (holder && holder !== client) return `${holder.name} has it`;
        this.held.set(key, client);
        this.greetAll();
        return null;
      }
      case "release":
        if (this.held.get(keyOf(action.control)) === client) this.held.delete(keyOf(action.control));
        this.greetAll();
        return null;
      case "pause": case "resume": case "single_step": case "pace": case "rewind": case "branch":
      case "show_branch": case "load": case "save": case "wind": case "current": case "fault":
        if (!instructor) return "only the instructor may do that";
        return this.instruct(action);
      default: {
        const control: Control | null = "vessel" in action ? { vessel: action.vessel } : "tug" in action ? { tug: action.tug } : null;
        if (this.rewound()) return "the run is rewound: nothing can be ordered in the past";
        if (control) {
          const holder = this.held.get(keyOf(control));
          if (!mayClaim(client.role, control) && !mayOrder(client.role, control)) return "your role has no such control";
          if (holder !== client && !(mayOrder(client.role, control) && !holder)) return holder ? `${holder.name} has it` : "take the control first";
        } else if (client.role.name === "observer") return "an observer commands nothing";
        return obey(this.state, action);
      }
    }
  }

  private rewound() {
    return this.state.tick < this.current().ends_tick;
  }

  private instruct(action: Action): string | null {
    switch (action.do) {
      case "pause":
        this.paused = true;
        break;
      case "resume":
        if (this.rewound()) return "the run is rewound: branch, or go to its end";
        this.paused = false;
        break;
      case "single_step":
        if (this.rewound()) return this.instruct({ do: "rewind", tick: this.state.tick + 1 });
        this.paused = true;
        this.advance();
        break;
      case "pace":
        if (!(action.pace >= 0.1 && action.pace <= 20)) return "a pace is from 0.1 to 20";
        this.pace = action.pace;
        break;
      case "rewind": {
        const found = this.find(this.current(), action.tick);
        if (!found) return `there is no tick ${action.tick}`;
        this.paused = true;
        this.state = structuredClone(found);
        break;
      }
      case "branch": {
        if (!this.rewound()) return "the run is at its end";
        const id = this.branches.length;
        this.branches.push({ id, from_tick: this.state.tick, parent: this.branch, states: new Map([[this.state.tick, structuredClone(this.state)]]), ends_tick: this.state.tick });
        this.branch = id;
        this.greetAll();
        break;
      }
      case "show_branch": {
        const branch = this.branches.find((b) => b.id === action.id);
        if (!branch) return `there is no branch ${action.id}`;
        this.branch = action.id;
        const found = this.find(branch, branch.ends_tick);
        if (found) this.state = structuredClone(found);
        this.paused = true;
        this.greetAll();
        break;
      }
      case "load":
        if (!GALLERY.some((g) => g.file === action.file)) return `there is no scenario ${action.file}`;
        this.file = action.file;
        this.state = initialState();
        if (action.file === "unberthing.toml") this.state.vessels[0]?.state.splice(0, 3, 0, -17.7, 0);
        this.branches = [{ id: 0, from_tick: 0, parent: null, states: new Map(), ends_tick: 0 }];
        this.branch = 0;
        this.held.clear();
        this.greetAll();
        break;
      case "save":
        if (!/^[\w-]+$/.test(action.name)) return "a name has letters, digits, - and _ only";
        this.broadcast({ type: "notice", text: `saved as ${action.name}` });
        break;
      default:
        return obey(this.state, action);
    }
    this.broadcast(this.frame());
    return null;
  }

  private frame(): Frame {
    const s = this.state;
    const events = this.events;
    this.events = [];
    return {
      type: "frame",
      tick: s.tick,
      t_s: s.tick * STEP_S,
      at_ms: Date.now(),
      run: {
        paused: this.paused,
        pace: this.pace,
        late_ticks: this.late.ticks,
        latest_ms: this.late.latest_ms,
        branch: this.branch,
        branches: this.branches.map(({ id, from_tick, ends_tick, parent }) => ({ id, from_tick, ends_tick, parent })),
        last_tick: this.current().ends_tick,
        clients: this.clients.length,
      },
      bodies: bodiesNow(s),
      vessels: vesselsNow(s),
      fenders: s.fenders,
      contacts: s.contacts,
      lines: s.lines.map(({ state, tension_n, winch }) => ({ state, tension_n, winch })),
      tugs: s.tugs,
      wind: s.wind,
      current: s.current,
      waves: null,
      alarms: alarms(s),
      events,
    };
  }

  private hello(client: Client): Hello {
    const controls: Control[] = [...VESSELS.map((v) => ({ vessel: v.name })), ...TUGS.map((t) => ({ tug: t.name })), { session: true as const }];
    return {
      type: "hello",
      protocol: 1,
      role: client.role,
      title: GALLERY.find((g) => g.file === this.file)?.title ?? this.file,
      file: this.file,
      step_s: STEP_S,
      bodies: BODIES,
      vessels: VESSELS,
      fenders: FENDERS,
      lines: LINES,
      tugs: TUGS,
      mine: controls.filter((c) => {
        const holder = this.held.get(keyOf(c));
        return holder === client || (mayOrder(client.role, c) && !holder) || ("session" in c && client.role.name === "instructor");
      }),
      claims: controls.filter((c) => !("session" in c)).map((control) => {
        const holder = this.held.get(keyOf(control));
        return { control, holder: holder?.name ?? null, connected: holder !== undefined };
      }),
      gallery: GALLERY,
      berth: BERTH,
      depth_m: DEPTH_M,
      ...(client.role.name === "instructor" && { links: Object.entries(ROLES).map(([token, role]) => ({ role, path: `/?token=${token}` })) }),
    };
  }

  private greetAll() {
    for (const client of this.clients) this.send(client, this.hello(client));
  }

  private broadcast(message: FromServer) {
    for (const client of this.clients) this.send(client, message);
  }

  private send(client: Client, message: FromServer) {
    // The latest frame only: who is slow misses some.
    if (message.type === "frame" && client.socket.bufferedAmount > 1 << 16) return;
    client.socket.send(JSON.stringify(message));
  }
}

const keyOf = (control: Control) => JSON.stringify(control);

function mayClaim(role: Role, control: Control): boolean {
  if (role.name === "instructor") return true;
  if (role.name === "pilot") return "vessel" in control && VESSELS.some((v) => v.name === control.vessel && !v.is_tug);
  if (role.name === "tugmaster") return "tug" in control ? control.tug === role.tug : "vessel" in control && control.vessel === role.tug;
  return false;
}

/** The pilot's orders go to tugs that nobody steers. */
function mayOrder(role: Role, control: Control): boolean {
  if (role.name !== "pilot") return false;
  return "tug" in control || ("vessel" in control && VESSELS.some((v) => v.name === control.vessel && v.is_tug));
}
