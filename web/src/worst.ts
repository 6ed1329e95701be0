/** The moment of the largest fender load that this page has seen, for the picture in the report. */
import { isOfTug } from "./live";
import type { FenderInfo, FenderNow, Frame, Hello, RunState } from "./protocol";

/** A frame, and the fender with its largest load. */
export interface Moment {
  hello: Hello;
  frame: Frame;
  fender: number;
  /**
   * Energy over the rated energy, which grows while a fender that buckles keeps its reaction; without a rated energy the
   * reaction over the rated reaction; without a rating a number that grows with the reaction.
   */
  load: number;
}

/** Frames of a branch that are kept at most. */
const MOST_KEPT = 40;
/** Frames that are kept are at least so far apart [s]. */
const APART_S = 1;
/** A seen load counts as the peak of the run from this share on: a page gets ten frames a second, the run has more steps. */
const IS_PEAK = 0.95;

const loadOf = (now: FenderNow, info: FenderInfo): number =>
  info.rated_energy_j !== null
    ? now.of_energy
    : info.rated_reaction_n !== null
      ? now.of_reaction
      : 1e-12 * now.reaction_n;

const peakOf = (now: FenderNow, info: FenderInfo): number =>
  info.rated_energy_j !== null ? now.peak_of_energy : now.peak_of_reaction;

/** The fender of a frame with the largest load over its rating; `null`: none is loaded. Fenders of tugs do not count. */
export function mostLoaded(frame: Frame, hello: Hello): Moment | null {
  let most: Moment | null = null;
  frame.fenders.forEach((now, fender) => {
    const info = hello.fenders[fender];
    if (!info || isOfTug(info, hello)) return;
    const load = loadOf(now, info);
    if (load > (most?.load ?? 0)) most = { hello, frame, fender, load };
  });
  return most;
}

/** Whether a run had a larger load than that of a moment; `frame`: a later frame of the run. */
export function hadMore({ load }: Moment, frame: Frame, hello: Hello): boolean {
  const peaks = frame.fenders.map((now, i) => {
    const info = hello.fenders[i];
    return info && !isOfTug(info, hello) ? peakOf(now, info) : 0;
  });
  return load < IS_PEAK * Math.max(0, ...peaks);
}

export class Worst {
  /** By branch: moments with ever larger loads, so that a branch that leaves another has the largest before. */
  private readonly kept = new Map<number, Moment[]>();

  hear(frame: Frame, hello: Hello): void {
    const now = mostLoaded(frame, hello);
    if (!now) return;
    const { branch } = frame.run;
    const moments = this.kept.get(branch) ?? [];
    const at = moments.findIndex((each) => each.frame.tick >= frame.tick);
    const before = at < 0 ? moments : moments.slice(0, at);
    const last = before.at(-1);
    if (last && last.load >= now.load) return;
    const isNear = last && frame.t_s - last.frame.t_s < APART_S;
    const after = at < 0 ? [] : moments.slice(at).filter((each) => each.load > now.load);
    this.kept.set(
      branch,
      [...(isNear ? before.slice(0, -1) : before), now, ...after].slice(-MOST_KEPT),
    );
  }

  /** The moment of the shown branch and of what came before it; `null`: this page has seen none. */
  found({ branch, branches }: RunState): Moment | null {
    let most: Moment | null = null;
    let [id, till]: [number | null, number] = [branch, Number.POSITIVE_INFINITY];
    while (id !== null) {
      for (const each of this.kept.get(id) ?? [])
        if (each.frame.tick <= till && each.load > (most?.load ?? 0)) most = each;
      const of = branches.find((each) => each.id === id);
      till = Math.min(till, of?.from_tick ?? 0);
      id = of?.parent ?? null;
    }
    return most;
  }

  clear(): void {
    this.kept.clear();
  }
}
