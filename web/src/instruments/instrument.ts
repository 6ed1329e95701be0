/** OpenBridge's instruments as elements of this page. They are custom elements of `@oicl/openbridge-webcomponents`. */
/** The instruments, as the package's own types name them. */
type Instruments = Pick<
  HTMLElementTagNameMap,
  | "obc-alert-icon"
  | "obc-azimuth-thruster"
  | "obc-badge-command"
  | "obc-bar-horizontal"
  | "obc-compass"
  | "obc-main-engine"
  | "obc-pitch-roll"
  | "obc-rot-sector"
  | "obc-rudder"
  | "obc-speed-gauge"
  | "obc-thruster"
  | "obc-watch"
>;

/** The package's words for a choice are enumerations; the page writes the words. */
type Written<T> = T extends string ? `${T}` : T;
/** Properties of an instrument. */
export type Shown<Tag extends keyof Instruments> = {
  [Name in keyof Instruments[Tag]]?: Written<Instruments[Tag][Name]> | undefined;
};

let loading: Promise<unknown> | null = null;

export interface Instrument<Tag extends keyof Instruments> {
  root: Instruments[Tag];
  /** Changes properties. The instrument draws itself anew only if one of them differs. */
  show(values: Shown<Tag>): void;
}

/**
 * An instrument with the properties that stay. It is empty until the components are loaded, which begins with the first
 * instrument, so that the page draws first. Screen readers read the figures beside it, or the name of what it stands in.
 */
export function instrument<Tag extends keyof Instruments>(
  tag: Tag,
  fixed: Shown<Tag> = {},
): Instrument<Tag> {
  loading ??= import("./components");
  const root = document.createElement(tag);
  root.setAttribute("aria-hidden", "true");
  const show = (values: Shown<Tag>) => void Object.assign(root, values);
  show(fixed);
  return { root, show };
}

/** A value in whole steps: an instrument does not draw what nobody can see. */
export const inSteps = (value: number, step: number): number => Math.round(value / step) * step;
