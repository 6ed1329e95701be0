/** The dials of the conning display: OpenBridge's instruments, with what they show of a vessel. */
import type { BodyNow, Frame, VesselInfo, VesselNow } from "../protocol";
import { h, setText } from "../ui/dom";
import { rateOfTurn, toDegrees } from "../units";
import { inSteps, instrument } from "./instrument";
import { beaufort, currentArrows } from "./scales";
import { FIGURES_KN, LEAST_SCALE, speedShown } from "./speed_scale";

/** What the page knows of a vessel at a tick. */
export interface Sight {
  info: VesselInfo;
  now: VesselNow;
  body: BodyNow;
  frame: Frame;
  /** The page commands the vessel. */
  mine: boolean;
}

export interface Dial {
  root: HTMLElement;
  show(sight: Sight): void;
}

/** Below this a ship has no course over ground [m/s]. */
const NO_COURSE_MPS = 0.02;
/** The last figure on the scale of the rate of turn, of ships and of tugs, and how far the scale goes beyond [°/min]. */
const TURN = { ship: 30, tug: 90, beyond: 1.2 };
/** The letters N, E, S and W have room on a compass of this size [px]. */
const LETTERS_FROM_PX = 140;

const priority = ({ mine }: Sight) => (mine ? "enhanced" : "regular");
const degrees = (rad: number) => inSteps(toDegrees(rad), 0.1);
const percent = (share: number) => inSteps(share * 100, 0.5);
const frameOf = (kind: string, root: HTMLElement) => h("div", { class: `dial ${kind}` }, root);

/** Heading up, with course over ground, ordered heading, wind and current. */
export function compass(): Dial {
  // Before the instrument's own observer: a small dial must not be drawn with letters.
  const sized = new ResizeObserver(([entry]) => {
    const { width = 0, height = 0 } = entry?.contentRect ?? {};
    show({ showLabels: Math.min(width, height) >= LETTERS_FROM_PX });
  });
  const { root, show } = instrument("obc-compass", {
    direction: "headingUp",
    // Outside of the ring they would lie under the symbols of wind and current.
    tickmarksInside: true,
    rotType: undefined,
  });
  const framed = frameOf("compass", root);
  sized.observe(framed);
  return {
    root: framed,
    show: (sight) => {
      const { now, body, frame } = sight;
      const heading = degrees(body[2]);
      const course = Math.hypot(body[3], body[4]) < NO_COURSE_MPS ? body[2] : body[4];
      show({
        heading,
        courseOverGround: course === body[2] ? heading : degrees(Math.atan2(body[4], body[3])),
        headingSetpoint: now.course_rad === null ? null : degrees(now.course_rad),
        windSpeed: frame.wind.speed_mps > 0.1 ? beaufort(frame.wind.speed_mps) : null,
        windFromDirection: degrees(frame.wind.from_rad),
        currentSpeed:
          frame.current.speed_mps > 0.01 ? currentArrows(frame.current.speed_mps) : null,
        currentFromDirection: degrees(frame.current.to_rad + Math.PI),
        priority: priority(sight),
      });
    },
  };
}

export function turn(info: VesselInfo): Dial {
  const last = info.is_tug ? TURN.tug : TURN.ship;
  const most = last * TURN.beyond;
  const { root, show } = instrument("obc-rot-sector", {
    maxValue: most,
    rotArcExtent: 40,
    portStarboard: true,
    showLabels: true,
    primaryTickmarkInterval: last / 3,
    secondaryTickmarkInterval: last / 6,
    tickmarkStyle: "enhanced",
    zoomToFitArc: true,
  });
  return {
    root: frameOf("arc", root),
    show: ({ body }) =>
      show({ value: inSteps(Math.max(-most, Math.min(most, rateOfTurn(body[5]))), 0.1) }),
  };
}

export function engine(): Dial {
  const { root, show } = instrument("obc-main-engine");
  return {
    root: frameOf("engine-dial", root),
    show: (sight) => {
      const { order, now } = sight.now.shaft;
      show({
        thrust: percent(now),
        thrustSetpoint: percent(order),
        speed: Math.abs(percent(now)),
        speedSetpoint: Math.abs(percent(order)),
        priority: priority(sight),
      });
    },
  };
}

export function speed(): Dial {
  let scale = LEAST_SCALE;
  const { root, show } = instrument("obc-speed-gauge", {
    tickmarkInterval: FIGURES_KN,
    showLabels: true,
    tickmarkStyle: "enhanced",
  });
  const name = h("span", { class: "dial-name", "aria-hidden": "true" });
  const framed = frameOf("speed", root);
  framed.append(name);
  return {
    root: framed,
    show: (sight) => {
      const shown = speedShown(sight.now, scale);
      ({ scale } = shown);
      setText(name, shown.name);
      show({
        minSpeed: scale.astern_kn,
        maxSpeed: scale.ahead_kn,
        speed: shown.now_kn,
        setpoint: shown.order_kn ?? undefined,
        priority: priority(sight),
      });
    },
  };
}

export function rudder(stop_rad: number): Dial {
  const { root, show } = instrument("obc-rudder", {
    maxAngle: Math.round(toDegrees(stop_rad)),
    showLabels: true,
    tickmarkStyle: "enhanced",
    zoomToFitArc: true,
  });
  return {
    root: frameOf("arc", root),
    show: (sight) =>
      show({
        angle: degrees(sight.now.rudder.now_rad),
        setpoint: degrees(sight.now.rudder.order_rad),
        priority: priority(sight),
      }),
  };
}

export function thruster(index: number): Dial {
  const { root, show } = instrument("obc-thruster", { tunnel: true });
  return {
    root: frameOf("tunnel", root),
    show: (sight) => {
      const state = sight.now.thrusters[index];
      if (!state) return;
      show({
        thrust: percent(state.now),
        setpoint: percent(state.order),
        priority: priority(sight),
      });
    },
  };
}

export function azimuth(index: number): Dial {
  const { root, show } = instrument("obc-azimuth-thruster", {
    singleDirection: true,
    starboardPortIndicator: true,
    secondaryTickmarkInterval: 45,
    tickmarkStyle: "enhanced",
  });
  return {
    root: frameOf("azimuth", root),
    show: (sight) => {
      const state = sight.now.azimuths[index];
      if (!state) return;
      show({
        angle: degrees(state.direction_rad),
        angleSetpoint: degrees(state.direction_order_rad),
        thrust: percent(state.power),
        thrustSetpoint: percent(state.power_order),
        priority: priority(sight),
      });
    },
  };
}

/** Pitch and roll. OpenBridge's pitch is positive with the bow down, ours with the bow up; roll is positive to starboard. */
export function attitude(): Dial {
  const { root, show } = instrument("obc-pitch-roll", {
    vesselImageFore: "cargo-fore",
    vesselImageSide: "cargo-side",
  });
  return {
    root: frameOf("attitude", root),
    show: (sight) =>
      show({
        pitch: -degrees(sight.now.trim_rad),
        roll: degrees(sight.now.heel_rad),
        priority: priority(sight),
      }),
  };
}
