/**
 * The toy world of the mock server: a container ship off a quay with eight fenders, a tug that is a force, a tug that
 * is a vessel, six lines. Made so that the pages have something plausible to show; no number here is physics
 * that anybody should believe.
 */
import type { BodyInfo, FenderInfo, LineInfo, Pair, TugInfo, VesselInfo } from "../src/protocol";

export const STEP_S = 0.1;
export const DEPTH_M = 14;

export const SHIP = 0;
export const ASD = 1;
export const QUAY = 2;

const SHIP_OUTLINE: Pair[] = [
  [-115, -11], [-108, -15], [-88, -16.1], [62, -16.1], [86, -13], [104, -7], [115, 0],
  [104, 7], [86, 13], [62, 16.1], [-88, 16.1], [-108, 15], [-115, 11],
];
const TUG_OUTLINE: Pair[] = [
  [-15, -4.4], [-13, -5.5], [6, -5.5], [12, -4], [15, -1.2], [15, 1.2], [12, 4], [6, 5.5], [-13, 5.5], [-15, 4.4],
];

export const BODIES: BodyInfo[] = [
  { name: "ship", fixed: false, outline: SHIP_OUTLINE },
  { name: "bruiser", fixed: false, outline: TUG_OUTLINE },
  { name: "quay", fixed: true, outline: [[-190, 0], [190, 0], [190, 45], [-190, 45]] },
];

export const VESSELS: VesselInfo[] = [
  {
    name: "ship",
    body: SHIP,
    title: "Container ship, 230 m",
    length_m: 230,
    beam_m: 32.2,
    draught_m: 11,
    rudder_stop_rad: (35 * Math.PI) / 180,
    full_rps: 1.7,
    thrusters: [
      { name: "bow", along_m: 98, force_n: 200e3 },
      { name: "stern", along_m: -95, force_n: 120e3 },
    ],
    azimuths: [],
    is_tug: false,
  },
  {
    name: "bruiser",
    body: ASD,
    title: "ASD tug Bruiser",
    length_m: 30,
    beam_m: 11,
    draught_m: 4.5,
    rudder_stop_rad: null,
    full_rps: null,
    thrusters: [],
    azimuths: [
      { name: "port", at_m: [-11, -2.6], bollard_n: 300e3 },
      { name: "starboard", at_m: [-11, 2.6], bollard_n: 300e3 },
    ],
    is_tug: true,
  },
];

export const FENDERS: FenderInfo[] = Array.from({ length: 8 }, (_, i) => ({
  name: `cone_${i + 1}`,
  body: QUAY,
  at_m: [-98 + 28 * i, 0] as Pair,
  facing_rad: -Math.PI / 2,
  width_m: 2.4,
  projection_m: 1.9,
  rated_deflection_m: 1.1,
  rated_reaction_n: 1.5e6,
  rated_energy_j: 0.95e6,
}));

const line = (name: string, fairlead_m: Pair, place_m: Pair): LineInfo => ({
  name,
  ship: SHIP,
  fairlead_m,
  end: { place_m },
  breaking_n: 1.2e6,
  working_n: 0.6e6,
  has_winch: true,
});

export const LINES: LineInfo[] = [
  line("head", [108, 4], [165, 5]),
  line("fore_breast", [92, 11], [110, 5]),
  line("fore_spring", [70, 15], [5, 5]),
  line("after_spring", [-80, 16], [-20, 5]),
  line("after_breast", [-100, 15.5], [-112, 5]),
  line("stern", [-113, 9], [-168, 5]),
];

export const TUGS: TugInfo[] = [
  { name: "alpha", vessel: 0, length_m: 30, beam_m: 11, bollard_pull_n: 600e3, push_at_m: [70, -16], pull_at_m: [78, -14] },
];

export const BERTH = { from: [-190, 0] as Pair, to: [190, 0] as Pair, facing: [0, -1] as Pair };
