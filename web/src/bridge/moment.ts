/** Draws the moment of the largest fender load for a report, beside the view of the page, from a kept frame. */
import type { Look } from "./look";
import type { Options } from "./picture";
import { isSoftware } from "./software";
import { Live } from "../live";
import type { Pair } from "../protocol";
import { clock, energy, fixed, force, percent, spoken } from "../units";
import { type Moment, hadMore } from "../worst";

/** A picture as a `data:` address, with its words; or why there is none. */
export type Drawn = { image: string; words: string } | { none: string };

/** Size of the picture [px], and what it may have as text (characters). */
const SIZE: Pair = [1120, 630];
const LARGEST = 240_000;
/** Below this time tenths of a second are told [s]. */
const SHORT_S = 600;

const LOOK: Look = {
  eye: "free",
  vessel: 0,
  bollard: 0,
  turn_rad: 0,
  raise_rad: 0,
  view_rad: null,
  off_m: 320,
  lifted_m: 0,
  fender: null,
  marks: true,
  panorama_rad: null,
};

/** Time, fender, reaction, energy and deflection of a moment, in words. */
export function wordsOf({ hello, frame, fender }: Moment): string {
  const [info, now] = [hello.fenders[fender], frame.fenders[fender]];
  if (!info || !now) return "";
  const { t_s } = frame;
  const at = t_s < SHORT_S ? `${fixed(t_s, 1)} s` : clock(t_s);
  const name = spoken(info.name);
  const of = (share: number, rated: number | null) =>
    rated === null ? "" : `, ${percent(share)} of the rated`;
  const rated = info.rated_deflection_m;
  return [
    `${at}: ${/fender/i.test(name) ? name : `fender ${name}`}`,
    `reaction ${force(now.reaction_n)}${of(now.of_reaction, info.rated_reaction_n)}`,
    `energy ${energy(now.energy_j)}${of(now.of_energy, info.rated_energy_j)}`,
    `deflection ${fixed(now.deflection_m, 2)} m${rated ? ` of ${fixed(rated, 2)} m` : ""}.`,
  ].join("; ");
}

/** `latest`: the last frame of the run, whose peaks tell whether the page has seen the largest load. */
export async function drawMoment(
  moment: Moment,
  latest: Moment["frame"],
  model: Options["model"],
): Promise<Drawn> {
  const { hello, frame, fender } = moment;
  const late = hadMore(moment, latest, hello)
    ? " This page has not seen the peak: it is the largest load that the page has seen."
    : "";
  try {
    const { Picture } = await import("./picture");
    const live = new Live();
    live.welcome(hello);
    live.tick(frame, 0);
    const canvas = document.createElement("canvas");
    const picture = new Picture(canvas, live, { cheap: isSoftware(), model });
    try {
      picture.build(hello, live.seenBodies(0));
      await picture.dressed;
      const still = picture.still(...SIZE, { ...LOOK, fender }, 0);
      return { image: jpeg(still), words: wordsOf(moment) + late };
    } finally {
      picture.dispose();
    }
  } catch {
    return { none: "this browser has no WebGL, so it draws no view" };
  }
}

/** The best JPEG that is not too large. */
function jpeg(canvas: HTMLCanvasElement): string {
  const tries = [0.88, 0.8, 0.7, 0.6].map(
    (quality) => () => canvas.toDataURL("image/jpeg", quality),
  );
  let text = "";
  for (const each of tries) if ((text = each()).length <= LARGEST) break;
  return text;
}
