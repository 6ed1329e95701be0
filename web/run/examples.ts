/** The scenarios that the page brings along: files of the repository. */
import cones from "../../scenarios/berth/eight_cones_at_5_deg.toml?raw";
import panel from "../../scenarios/berth/chains_hold_a_panel_that_turns.toml?raw";
import twoShips from "../../scenarios/berth/two_ships_on_pneumatic_fenders.toml?raw";
import berthing from "../../scenarios/live/berthing.toml?raw";
import harbour from "../../scenarios/live/harbour.toml?raw";
import harbourChart from "../../scenarios/live/harbour.geojson?raw";
import escort from "../../scenarios/live/tug_escort.toml?raw";
import paper from "../../scenarios/paper/experiment_2_4kn.toml?raw";
import vizhinjam from "../../scenarios/worked/container_ship_vizhinjam.toml?raw";

export interface Example {
  file: string;
  text: string;
  /** The files that it names. */
  files?: Record<string, string>;
}

export const EXAMPLES: Example[] = [
  { file: "eight_cones_at_5_deg.toml", text: cones },
  { file: "container_ship_vizhinjam.toml", text: vizhinjam },
  { file: "chains_hold_a_panel_that_turns.toml", text: panel },
  { file: "two_ships_on_pneumatic_fenders.toml", text: twoShips },
  { file: "berthing.toml", text: berthing },
  { file: "harbour.toml", text: harbour, files: { "harbour.geojson": harbourChart } },
  { file: "tug_escort.toml", text: escort },
  { file: "experiment_2_4kn.toml", text: paper },
];

/** The title in a scenario's text, or its file's name. */
export const titleOf = ({ file, text }: Example): string =>
  /^title *= *"([^"]+)"/m.exec(text)?.[1] ?? file;
