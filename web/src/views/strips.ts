/** Strip charts of the last minutes, or of a whole run. uPlot is loaded when they are first shown. */
import type uPlot from "uplot";
import type { History, Sample } from "../history";
import { palette } from "../palette";
import type { ColourName } from "../palette";
import { choices, h, setAttribute, setClass } from "../ui/dom";
import type { View } from "./view";

interface Strip {
  title: string;
  series: {
    label: string;
    key: Exclude<keyof Sample, "t_s">;
    colour: ColourName;
    dash?: number[];
  }[];
  least: [number, number];
  /** A limit, drawn over the times at which the first series has values. */
  limit?: { label: string; of: (history: History) => number | null };
  /** It is shown only where it has values. */
  optional?: boolean;
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
    title: "Cross-track distance, m, positive to starboard",
    least: [-10, 10],
    optional: true,
    series: [{ label: "off the track", key: "cross_track_m", colour: "plan" }],
  },
  {
    title: "Least clearance under the keel, m, squat included",
    least: [0, 1],
    optional: true,
    series: [{ label: "clearance", key: "under_keel_m", colour: "path" }],
    limit: { label: "limit", of: (history) => history.under_keel_limit_m },
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
  {
    title: "Contact forces, all together, MN",
    least: [0, 0.1],
    series: [{ label: "contacts", key: "contact_mn", colour: "force" }],
  },
];

/** A run whose charts show all of it, from its start. */
export interface WholeRun {
  duration_s(): number;
  /** The time that is shown, marked in the charts. */
  at_s(): number;
}

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
  /** Kept over a reload. */
  private minutes = Number(sessionStorage.getItem("chart minutes") ?? 5);
  /** The palette that the charts were built for; they keep their colours. */
  private built = "";
  private drawn_ms = 0;
  readonly root: HTMLElement;

  constructor(
    private readonly history: History,
    private readonly whole: WholeRun | null = null,
  ) {
    this.span = choices("Time shown", SPANS, (minutes) => {
      this.minutes = minutes;
      sessionStorage.setItem("chart minutes", String(minutes));
      this.span.show(minutes);
      this.drawn_ms = 0;
    });
    this.span.show(this.minutes);
    this.root = h("div", { class: "strips" }, whole === null && this.span.root, this.box);
    new ResizeObserver(() => this.resize()).observe(this.box);
  }

  tick(): void {}

  draw(now_ms: number): void {
    const wanted = document.documentElement.dataset.palette ?? "";
    if (this.built !== wanted) {
      this.built = wanted;
      void this.build();
    }
    if (now_ms - this.drawn_ms < (this.whole ? 120 : 500) || this.charts.length === 0) return;
    this.drawn_ms = now_ms;
    const { samples } = this.history;
    const till = samples.at(-1)?.t_s ?? 0;
    const shown = this.whole ? samples : samples.filter((s) => s.t_s >= till - this.minutes * 60);
    // For tests, which cannot read a canvas.
    setAttribute(this.root, "data-since", String(shown[0]?.t_s ?? ""));
    // The time axis counts minutes before now, or seconds from the start.
    const times = shown.map((s) => (this.whole ? s.t_s : (s.t_s - till) / 60));
    const range = this.whole
      ? { min: 0, max: Math.max(1e-3, this.whole.duration_s()) }
      : { min: -this.minutes, max: 0 };
    STRIPS.forEach((strip, i) => {
      const chart = this.charts[i];
      const columns = strip.series.map(({ key }) => shown.map((s) => s[key]));
      const limit = strip.limit?.of(this.history) ?? null;
      if (strip.limit) columns.push((columns[0] ?? []).map((v) => (v === null ? null : limit)));
      chart?.setData([times, ...columns], false);
      chart?.batch(() => {
        chart.setScale("x", range);
        const values = columns.flat().filter((v) => v !== null);
        // A strip without a value in the whole run says nothing.
        if (this.whole || strip.optional)
          setClass(chart.root, "hidden", values.length === 0 && shown.length > 0);
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
            hooks: { draw: [(chart) => this.mark(chart)] },
            cursor: { y: false },
            scales: { x: { time: false, auto: false }, y: { auto: false } },
            axes: [
              {
                ...axis,
                values: (_, ticks) =>
                  ticks.map((t) => (this.whole ? `${t} s` : t === 0 ? "now" : `${t} min`)),
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
              ...(strip.limit
                ? [
                    {
                      label: strip.limit.label,
                      stroke: () => palette().alarm,
                      width: 1.5,
                      points: { show: false },
                      dash: [2, 3],
                    },
                  ]
                : []),
            ],
          },
          [[], ...strip.series.map(() => []), ...(strip.limit ? [[]] : [])],
          this.box,
        ),
    );
  }

  /** A line at the time that is shown. */
  private mark(chart: uPlot): void {
    if (!this.whole) return;
    const { ctx, bbox } = chart;
    const x = chart.valToPos(this.whole.at_s(), "x", true);
    ctx.save();
    ctx.strokeStyle = palette().text;
    ctx.lineWidth = devicePixelRatio;
    ctx.setLineDash([4 * devicePixelRatio, 3 * devicePixelRatio]);
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  }

  private size(): { width: number; height: number } {
    const across = this.box.clientWidth > 760 ? 2 : 1;
    return { width: Math.max(200, Math.floor(this.box.clientWidth / across) - 8), height: 128 };
  }

  private resize(): void {
    for (const chart of this.charts) chart.setSize(this.size());
  }
}
