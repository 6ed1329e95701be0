/** What a vessel does, as far as her lights tell it. */
import type { BodyNow, Frame, Hello, LineInfo, LineNow } from "../protocol";

/** Under way with or without a tow, at anchor, aground, or made fast to a quay. */
export type Conduct = "under_way" | "tows" | "at_anchor" | "aground" | "made_fast";

/** A vessel that moves faster is under way, whatever holds her [m/s]. A ship that sheers about her anchor is slower. */
const SHEERS_MPS = 1;
const AT_REST_MPS = 0.5;

/** What a vessel does; `body`: index of her body, `vessel`: index of the vessel, `motion`: how she really moves. */
export function conductOf(
  body: number,
  vessel: number,
  hello: Hello,
  frame: Frame,
  motion: BodyNow,
): Conduct {
  const now = frame.vessels[vessel];
  const speed_mps = Math.hypot(motion[3], motion[4]);
  const lines = hello.lines.flatMap((info, i): [LineInfo, LineNow][] => {
    const line = frame.lines[i];
    return line?.state === "fast" ? [[info, line]] : [];
  });
  if (now?.aground && speed_mps < AT_REST_MPS) return "aground";
  if (speed_mps < AT_REST_MPS && lines.some(([info, line]) => holds(body, info, line, hello)))
    return "made_fast";
  const isAnchored = hello.anchors.some((anchor, i) => {
    const { state, dragging } = frame.anchors[i] ?? {};
    return anchor.ship === body && state === "on_bottom" && !dragging;
  });
  if (isAnchored && speed_mps < SHEERS_MPS) return "at_anchor";
  const isTug = hello.vessels[vessel]?.is_tug ?? false;
  return isTug && lines.some(([info]) => isOfTow(body, info)) ? "tows" : "under_way";
}

/** Whether a line leads from a body to something fixed. */
function holds(body: number, info: LineInfo, { bollard }: LineNow, { bodies, bollards }: Hello) {
  if (info.ship !== body || info.is_towline) return false;
  const end = bollard === null ? info.end : bollards[bollard];
  return end ? !("body" in end) || (bodies[end.body]?.fixed ?? false) : false;
}

const isOfTow = (body: number, { is_towline, ship, end }: LineInfo): boolean =>
  is_towline && (ship === body || (end !== null && "body" in end && end.body === body));
