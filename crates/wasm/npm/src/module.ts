/** The WebAssembly module: loaded once, with one memory. */
import init, { type InitInput, version as rawVersion } from "./raw/raw.js";

let memory: WebAssembly.Memory | null = null;
let loading: Promise<void> | null = null;

/**
 * Loads the WebAssembly module; later calls wait for the first. Without an argument it is the file of this package, read from
 * the disk in Node and fetched elsewhere. Pass bytes, a URL, a response or a compiled module to load it from another place.
 */
export function load(from?: InitInput | Promise<InitInput>): Promise<void> {
  loading ??= begin(from).catch((error: unknown) => {
    loading = null;
    throw error;
  });
  return loading;
}

async function begin(from?: InitInput | Promise<InitInput>): Promise<void> {
  const loaded = await init({ module_or_path: from ?? (await own()) });
  memory = loaded.memory;
}

/** The file of this package. */
async function own(): Promise<InitInput> {
  const url = new URL("./raw/raw_bg.wasm", import.meta.url);
  if (url.protocol !== "file:") return url;
  const fs = await import(/* @vite-ignore */ /* webpackIgnore: true */ "node:fs/promises");
  return fs.readFile(url);
}

/** The version of fenderline. */
export function version(): string {
  buffer();
  return rawVersion();
}

/** The module's memory. It is replaced when the memory grows; views of the old one have length 0 then. */
export function buffer(): ArrayBuffer {
  if (memory === null) throw new Error("fenderline is not loaded: await load() first");
  return memory.buffer as ArrayBuffer;
}

/** Address and length of an array in the memory. */
interface Span {
  address: number;
  length: number;
  free(): void;
}

/** A view of numbers in the memory: no copy. */
export function floats(span: Span): Float64Array {
  const view = new Float64Array(buffer(), span.address, span.length);
  span.free();
  return view;
}

/** A view that is made again only when the memory has grown. For arrays that never move. */
export class FixedView {
  private view: Float64Array | null = null;

  constructor(private readonly find: () => Span) {}

  get(): Float64Array {
    if (this.view === null || this.view.buffer !== buffer()) this.view = floats(this.find());
    return this.view;
  }
}
