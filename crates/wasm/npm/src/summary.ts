/** The content of `summary.json`: the keys that most programs read. `fenderline run` writes the same file. */

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
  energy: Record<string, unknown>;
  events: Record<string, unknown>;
  notices: string[];
  [key: string]: unknown;
}

export interface PairSummary {
  bodies: [string, string];
  first_touch_s: number;
  last_touch_s: number;
  peak_normal_force_n: number;
  peak_normal_force_at_s: number;
  peak_depth_m: number;
  impulse_ns: number;
  approach_speed_mps: number;
  final_speed_mps: number;
  touching_at_end: boolean;
  [key: string]: unknown;
}

export interface FenderSummary {
  name: string;
  peak_deflection_m: number;
  peak_reaction_n: number;
  [key: string]: unknown;
}
