/** Strip charts of the last minutes. uPlot is loaded when they are first shown. */
import type uPlot from "uplot";
import type { History, Sample } from "../history";
import { palette } from "../palette";
import type { Palette } from "../palette";
import { choices, h } from "../ui/dom";
import type { View } from "./view";

interface Strip {
  title: string;
  series: {
    label: string;
    key: Exclude<keyof Sample, "t_s">;
    colour: keyof Palette;
    dash?: number[];
  }[];
  least: [number, number];
}

const STRIPS: Strip[] = [
  {
    title: "Closing speed at bow and stern, m/s",
    least: [-0.05, 0.2],
    series: [
      { label: "bow", key: "bow_mps", colour: "path" },
      { label: "stern", key: "stern_mps", colour: "wind", dash: [6, 3] },
    ],
  },
  {
    title: "Distance to the berth, m",
    least: [0, 5],
    series: [
      { label: "bow", key: "bow_m", colour: "path" },
      { label: "stern", key: "stern_m", colour: "wind", dash: [6, 3] },
    ],
  },
  {
    title: "Speed ahead, kn",
    least: [-0.5, 0.5],
    series: [{ label: "ahead", key: "ahead_kn", colour: "text" }],
  },
  {
    title: "Fenders and lines, % of rated and working load",
    least: [0, 100],
    series: [
      { label: "energy", key: "of_energy", colour: "alarm" },
      { label: "reaction", key: "of_reaction", colour: "caution", dash: [6, 3] },
      { label: "line", key: "tension", colour: "force", dash: [2, 3] },
    ],
  },
];

const SPANS = [
  { value: 2, label: "2 min" },
  { value: 5, label: "5 min" },
  { value: 15, label: "15 min" },
  { value: 30, label: "30 min" },
];

export class Strips implements View {
  private charts: uPlot[] = [];
  private readonly box = h("div", { class: "charts" });
  private readonly span;
  private minutes = 5;
  /** The palette that the charts were built for; they keep their colours. */
  private built = "";
  private drawn_ms = 0;
  readonly root: HTMLElement;

  constructor(private readonly history: History) {
    this.span = choices("Time shown", SPANS, (minutes) => {
      this.minutes = minutes;
      this.span.show(minutes);
      this.drawn_ms = 0;
    });
    this.span.show(this.minutes);
    this.root = h("div", { class: "strips" }, this.span.root, this.box);
    new ResizeObserver(() => this.resize()).observe(this.box);
  }

  tick(): void {}

  draw(now_ms: number): void {
    const wanted = document.documentElement.dataset.palette ?? "";
    if (this.built !== wanted) {
      this.built = wanted;
      void this.build();
    }
    if (now_ms - this.drawn_ms < 500 || this.charts.length === 0) return;
    this.drawn_ms = now_ms;
    const { samples } = this.history;
    const till = samples.at(-1)?.t_s ?? 0;
    const shown = samples.filter((s) => s.t_s >= till - this.minutes * 60);
    // The time axis counts minutes before now.
    const times = shown.map((s) => (s.t_s - till) / 60);
    STRIPS.forEach((strip, i) => {
      const chart = this.charts[i];
      chart?.setData([times, ...strip.series.map(({ key }) => shown.map((s) => s[key]))], false);
      chart?.batch(() => {
        chart.setScale("x", { min: -this.minutes, max: 0 });
        const values = shown
          .flatMap((s) => strip.series.map(({ key }) => s[key]))
          .filter((v) => v !== null);
        chart.setScale("y", {
          min: Math.min(strip.least[0], ...values),
          max: Math.max(strip.least[1], ...values) * 1.05,
        });
      });
    });
  }

  private async build(): Promise<void> {
    const [{ default: Chart }] = await Promise.all([
      import("uplot"),
      import("uplot/dist/uPlot.min.css"),
    ]);
    for (const chart of this.charts) chart.destroy();
    this.drawn_ms = 0;
    const font = "12px system-ui, 'DejaVu Sans', sans-serif";
    const axis = {
      stroke: () => palette().dim,
      grid: { stroke: () => palette().edge, width: 0.5 },
      ticks: { show: false },
      font,
    };
    this.charts = STRIPS.map(
      (strip) =>
        new Chart(
          {
            title: strip.title,
            ...this.size(),
            legend: { live: false },
            cursor: { y: false },
            scales: { x: { time: false, auto: false }, y: { auto: false } },
            axes: [
              {
                ...axis,
                values: (_, ticks) => ticks.map((t) => (t === 0 ? "now" : `${t} min`)),
                size: 24,
                space: 70,
              },
              { ...axis, size: 46, space: 24 },
            ],
            series: [
              {},
              ...strip.series.map(({ label, colour, dash }) => ({
                label,
                stroke: () => palette()[colour],
                width: 2,
                points: { show: false },
                ...(dash && { dash }),
              })),
            ],
          },
          [[], ...strip.series.map(() => [])],
          this.box,
        ),
    );
  }

  private size(): { width: number; height: number } {
    const across = this.box.clientWidth > 760 ? 2 : 1;
    return { width: Math.max(200, Math.floor(this.box.clientWidth / across) - 8), height: 128 };
  }

  private resize(): void {
    for (const chart of this.charts) chart.setSize(this.size());
  }
}
