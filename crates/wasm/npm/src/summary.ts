/** The content of `summary.json`: the keys that most programs read. `fenderline run` writes the same file. */
import type {
  AnchorQuantities,
  ChainQuantities,
  DolphinQuantities,
  FenderQuantities,
  LineQuantities,
  PairQuantities,
  TugQuantities,
  VesselQuantities,
} from "./quantities.js";

export interface Summary {
  title: string;
  fenderline_version: string;
  scenario_file: string;
  method: "coupled" | "paper";
  integrator: "euler" | "semi_implicit" | "rk4";
  step_s: number;
  steps: number;
  duration_s: number;
  /** The run was stopped before its end. */
  interrupted: boolean;
  verdict: { key: string; text: string; [key: string]: unknown };
  bodies: {
    name: string;
    final: {
      x_m: number;
      y_m: number;
      heading_rad: number;
      u_mps: number;
      v_mps: number;
      r_radps: number;
    };
  }[];
  pairs: PairSummary[];
  fenders: FenderSummary[];
  /** The following lists are there if the scenario has such parts. */
  dolphins?: (Named & DolphinQuantities)[];
  vessels?: (Named & VesselQuantities)[];
  tugs?: (Named & TugQuantities)[];
  lines?: (Named & LineQuantities)[];
  anchors?: (Named & AnchorQuantities)[];
  energy: Record<string, unknown>;
  events: Record<string, unknown>;
  notices: string[];
  [key: string]: unknown;
}

/** A part of the scenario. */
export interface Named {
  name: string;
  [key: string]: unknown;
}

export interface PairSummary extends PairQuantities {
  bodies: [string, string];
  [key: string]: unknown;
}

export interface FenderSummary extends FenderQuantities {
  name: string;
  /** Name of the body that carries the fender. */
  body: string;
  chains?: ChainQuantities[];
  [key: string]: unknown;
}
