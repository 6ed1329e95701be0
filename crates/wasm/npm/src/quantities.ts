/**
 * The quantities of `summary.json`, generated from the catalogue in `crates/results`:
 * `FENDERLINE_BLESS=1 cargo test -p fenderline-wasm --test all quantities::`.
 */

/** Of one anchor. */
export interface AnchorQuantities {
  /** the verdict on the anchor */
  verdict?: string;
  /** break load of the chain [N] */
  break_load_n: number;
  /** largest tension of the chain at the hawse pipe [N] */
  peak_tension_n: number;
  /** start of the step of the largest tension [s] */
  peak_tension_at_s: number;
  /** most chain out [m] */
  most_chain_out_m: number;
  /** time on the bottom [s] */
  on_bottom_s: number;
  /** distance by which the anchor dragged [m] */
  dragged_m: number;
  /** time in which the anchor dragged [s] */
  dragging_s: number;
  /** energy that the bottom absorbed from the anchor [J] */
  dragged_j: number;
  /** chain that the brake rendered [m] */
  rendered_m: number;
  /** where the anchor is at the end of the run */
  state_at_end?: string;
  /** chain out at the end of the run [m] */
  last_chain_out_m: number;
  /** tension at the end of the run [N] */
  last_tension_n: number;
}

/** Of one chain. */
export interface ChainQuantities {
  /** the motion or load that the chain holds */
  kind?: string;
  /** break load [N] */
  break_load_n?: number;
  /** largest tension [N] */
  peak_tension_n: number;
  /** start of the step of the largest tension [s] */
  peak_tension_at_s: number;
  /** largest tension as a share of the break load [1] */
  share_of_break_load: number;
  /** place of a tension chain to the right of the panel's middle [m] */
  at_m?: number;
  /** start of the step in which the chain parted [s] */
  parted_at_s?: number;
}

/** Of one dolphin. */
export interface DolphinQuantities {
  /** largest deflection of the head [m] */
  peak_deflection_m: number;
  /** start of the step of the largest deflection [s] */
  peak_deflection_at_s: number;
  /** largest load on the pile [N] */
  peak_load_n: number;
  /** start of the step of the largest load [s] */
  peak_load_at_s: number;
  /** largest energy in the pile's bending [J] */
  peak_energy_j: number;
  /** energy lost to damping of the pile [J] */
  damping_j: number;
  /** energy lost to yielding [J] */
  yield_j: number;
  /** permanent deflection [m] */
  offset_m: number;
  /** stiffness of the pile at its head [N/m] */
  stiffness_npm?: number;
  /** mass that moves with the head [kg] */
  mass_kg?: number;
  /** natural period without ship and fender [s] */
  period_s?: number;
  /** load at which the pile yields [N] */
  yield_load_n?: number;
  /** largest load as a share of the yield load [1] */
  share_of_yield_load?: number;
  /** start of the step in which the pile first yielded [s] */
  yielded_at_s?: number;
}

/** Of one fender. */
export interface FenderQuantities {
  /** the verdict on the fender */
  verdict?: string;
  /** whether the fender was deflected beyond its travel */
  failed: boolean;
  /** start of the first step in which the fender was touched [s] */
  first_touch_s: number;
  /** speed normal to the fender's face at the first touch [m/s] */
  approach_speed_mps: number;
  /** angle between hull and face at the first touch [rad] */
  approach_angle_rad: number;
  /** factor on the reaction: temperature, tolerance, speed and angle [1] */
  factor: number;
  /** largest deflection [m] */
  peak_deflection_m: number;
  /** start of the step of the largest deflection [s] */
  peak_deflection_at_s: number;
  /** largest reaction along the fender's axis [N] */
  peak_reaction_n: number;
  /** start of the step of the largest reaction [s] */
  peak_reaction_at_s: number;
  /** largest energy absorbed [J] */
  peak_energy_j: number;
  /** start of the step of the largest energy [s] */
  peak_energy_at_s: number;
  /** deflection in the last step [m] */
  last_deflection_m: number;
  /** reaction in the last step [N] */
  last_reaction_n: number;
  /** largest pressure on the hull [N/m²] */
  peak_hull_pressure_npm2?: number;
  /** rated energy times the run's factors [J] */
  capacity_j?: number;
  /** largest energy as a share of the rated energy with the run's factors [1] */
  share_of_rated_energy?: number;
  /** largest reaction as a share of the rated reaction with the run's factors [1] */
  share_of_rated_reaction?: number;
  /** largest deflection as a share of the rated deflection [1] */
  share_of_rated_deflection?: number;
  /** largest energy as a share of the rated energy without the run's factors [1] */
  share_of_catalogue_energy?: number;
  /** largest reaction as a share of the rated reaction without the run's factors [1] */
  share_of_catalogue_reaction?: number;
  /** the quantity that is nearest to its rated value */
  governing?: string;
  /** largest share of a rated value, that of the quantity `governing` [1] */
  governing_share?: number;
  /** largest pressure on the hull as a share of the permissible pressure [1] */
  share_of_hull_pressure?: number;
  /** rated deflection [m] */
  rated_deflection_m?: number;
  /** rated reaction [N] */
  rated_reaction_n?: number;
  /** rated energy [J] */
  rated_energy_j?: number;
  /** permissible pressure on the hull [N/m²] */
  hull_pressure_limit_npm2?: number;
  /** height of the first touch on the hull [m] */
  height_on_hull_m?: number;
  /** angle by which the hull's side leans out over the fender at the first touch [rad] */
  vertical_angle_rad?: number;
  /** vertical force on the hull with the largest magnitude, positive up [N] */
  peak_vertical_force_n?: number;
}

/** Of one line. */
export interface LineQuantities {
  /** the verdict on the line */
  verdict?: string;
  /** largest tension [N] */
  peak_tension_n: number;
  /** start of the step of the largest tension [s] */
  peak_tension_at_s: number;
  /** time with a tension above the working load [s] */
  over_working_load_s: number;
  /** length that the brake of the winch rendered [m] */
  rendered_m: number;
  /** whether the line parted */
  parted: boolean;
  /** whether the line is fast at the end of the run */
  fast_at_end: boolean;
  /** tension at the end of the run [N] */
  last_tension_n: number;
  /** start of the first step in which the line was fast [s] */
  made_fast_s?: number;
  /** break load of the line: that of the weaker of rope and tail [N] */
  break_load_n?: number;
  /** working load [N] */
  working_load_n?: number;
  /** largest tension as a share of the break load [1] */
  share_of_break_load?: number;
  /** start of the step in which the line parted [s] */
  parted_at_s?: number;
}

/** Of one pair. */
export interface PairQuantities {
  /** start of the first step in which the two bodies touched [s] */
  first_touch_s: number;
  /** start of the last step in which the two bodies touched [s] */
  last_touch_s: number;
  /** largest normal force of all patches [N] */
  peak_normal_force_n: number;
  /** time of that force [s] */
  peak_normal_force_at_s: number;
  /** largest depth of a patch [m] */
  peak_depth_m: number;
  /** time of that depth [s] */
  peak_depth_at_s: number;
  /** impulse of the normal force [N·s] */
  impulse_ns: number;
  /** closing speed along the normal at first touch [m/s] */
  approach_speed_mps: number;
  /** separation speed along the normal after the last touch [m/s] */
  final_speed_mps: number;
  /** work of normal forces on the two bodies [J] */
  normal_work_j: number;
  /** work of friction on the two bodies [J] */
  tangential_work_j: number;
  /** whether the two bodies touch in the last step */
  touching_at_end: boolean;
}

/** Of one tug. */
export interface TugQuantities {
  /** bollard pull [N] */
  bollard_pull_n?: number;
  /** largest force [N] */
  peak_force_n: number;
  /** start of the step of the largest force [s] */
  peak_force_at_s: number;
  /** time at work [s] */
  at_work_s: number;
  /** time in which speed and angle allowed less than the ordered force [s] */
  limited_s: number;
}

/** Of one vessel. */
export interface VesselQuantities {
  /** largest speed over the ground [m/s] */
  peak_speed_over_ground_mps: number;
  /** time of this speed [s] */
  peak_speed_over_ground_at_s: number;
  /** largest speed through the water [m/s] */
  peak_speed_through_water_mps: number;
  /** time of this speed [s] */
  peak_speed_through_water_at_s: number;
  /** largest rate of turn, positive to starboard [rad/s] */
  peak_rate_of_turn_radps: number;
  /** time of the largest rate of turn [s] */
  peak_rate_of_turn_at_s: number;
  /** largest rudder angle, positive turns to starboard [rad] */
  peak_rudder_rad: number;
  /** largest roll with wave motion, positive to starboard [rad] */
  peak_roll_rad: number;
  /** time of this roll [s] */
  peak_roll_at_s: number;
  /** largest roll without the motion in waves, positive to starboard [rad] */
  peak_heel_rad: number;
  /** time of this heel [s] */
  peak_heel_at_s: number;
  /** largest pitch with wave motion, positive bow up [rad] */
  peak_pitch_rad: number;
  /** time of this pitch [s] */
  peak_pitch_at_s: number;
  /** largest squat [m] */
  peak_squat_m: number;
  /** time of this squat [s] */
  peak_squat_at_s: number;
  /** time aground [s] */
  aground_s: number;
  /** least clearance under the keel, squat included [m] */
  min_under_keel_clearance_m?: number;
  /** time of this clearance [s] */
  min_under_keel_clearance_at_s?: number;
  /** largest cross-track distance from the passage plan, between its first and last waypoint, positive to starboard [m] */
  peak_cross_track_m?: number;
  /** time of this cross-track distance [s] */
  peak_cross_track_at_s?: number;
  /** least clearance under a bridge or cable, squat included; negative: the vessel is too high [m] */
  min_air_clearance_m?: number;
  /** time of this clearance [s] */
  min_air_clearance_at_s?: number;
}
