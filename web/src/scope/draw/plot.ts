import uPlot from "uplot";

import type { AlignedData, SignalHead } from "../../model/sample_store";
import { laneHeights, plotLanes, type PlotLane } from "../view/layout";
import { StickyRange } from "../view/scale";
import type { Range } from "../view/window";
import { kDashes, kSmallFont, type Palette } from "./palette";

/** Room at the right of the curves (CSS pixels). */
export const kRight = 10;

/** Width of the unit of measure beside the scale (CSS pixels). */
const kLabel = 16;

interface Drawn {
  lane: PlotLane;
  plot: uPlot;
  limits: StickyRange;
}

/** Curves of all signals, a uPlot a unit of measure, under each other on one time. */
export class Plot {
  /** Instants of the vertical lines. */
  ticks: number[] = [];
  private drawn: Drawn[] = [];

  constructor(private readonly place: HTMLElement) {}

  /** Makes the lanes for @param signals, @param width wide and @param height high together, curves from @param left on. */
  build(signals: readonly SignalHead[], width: number, height: number, left: number, palette: Palette): void {
    this.end();
    const lanes = plotLanes(signals);
    const heights = laneHeights(lanes, height);
    this.drawn = lanes.map((lane, i) => {
      const options = this.options(lane, signals, { width, height: heights[i] ?? 80, left }, palette);
      const data = [[], ...lane.signals.map(() => [])] as unknown as uPlot.AlignedData;
      return { lane, plot: new uPlot(options, data, this.place), limits: new StickyRange() };
    });
  }

  /** Draws @param data of the signals in @param range. */
  draw(data: AlignedData, range: Range): void {
    for (const { lane, plot, limits } of this.drawn) {
      const rows = lane.signals.map((number) => data[number + 1] ?? []);
      const [min, max] = lane.isBit ? [-0.1, 1.1] : limits.next(...extremes(rows));
      plot.batch(() => {
        plot.setData([data[0], ...rows] as uPlot.AlignedData, false);
        plot.setScale("x", { min: range.from, max: range.to });
        plot.setScale("y", { min, max });
      });
    }
  }

  /** The pictures, for export. */
  canvases(): HTMLCanvasElement[] {
    return this.drawn.map(({ plot }) => plot.ctx.canvas);
  }

  end(): void {
    for (const { plot } of this.drawn) plot.destroy();
    this.drawn = [];
  }

  private options(
    lane: PlotLane,
    signals: readonly SignalHead[],
    size: { width: number; height: number; left: number },
    palette: Palette,
  ): uPlot.Options {
    const grid = { stroke: palette.line, width: 1 };
    return {
      width: size.width,
      height: size.height,
      legend: { show: false },
      cursor: { show: false },
      pxAlign: 0,
      padding: [5, kRight, 5, 0],
      scales: { x: { time: false, auto: false }, y: { auto: false } },
      axes: [
        { size: 0, ticks: { show: false }, values: () => [], splits: () => this.ticks, grid },
        lane.isBit ? bitAxis(lane, size.left, palette) : valueAxis(lane, size.left, palette),
      ],
      series: [{}, ...lane.signals.map((number, i) => seriesOf(number, i, signals[number], lane.isBit, palette))],
    };
  }
}

function extremes(rows: readonly (number | null)[][]): [number, number] {
  let min = Infinity;
  let max = -Infinity;
  for (const row of rows)
    for (const value of row) {
      if (value === null) continue;
      if (value < min) min = value;
      if (value > max) max = value;
    }
  return [min, max];
}

function valueAxis(lane: PlotLane, size: number, palette: Palette): uPlot.Axis {
  return {
    size: size - kLabel,
    stroke: palette.muted,
    font: kSmallFont,
    label: lane.title === "" ? "no unit" : lane.title,
    labelSize: kLabel,
    labelFont: kSmallFont,
    space: 26,
    grid: { stroke: palette.line, width: 1 },
    ticks: { stroke: palette.line, width: 1, size: 4 },
    values: (_, splits) => splits.map((value) => String(Number(value.toPrecision(6)))),
  };
}

function bitAxis(lane: PlotLane, size: number, palette: Palette): uPlot.Axis {
  return {
    size,
    stroke: palette.muted,
    font: kSmallFont,
    splits: () => [0.5],
    values: () => [lane.title],
    grid: { show: false },
    ticks: { show: false },
  };
}

function seriesOf(number: number, inLane: number, head: SignalHead | undefined, isBit: boolean, palette: Palette): uPlot.Series {
  const series: uPlot.Series = {
    label: head?.signal ?? "",
    stroke: palette.curves[number % palette.curves.length] ?? palette.text,
    width: 1.5,
    dash: [...(kDashes[inLane % kDashes.length] ?? [])],
    points: { show: false },
    spanGaps: false,
    pxAlign: 0,
  };
  const stepped = uPlot.paths.stepped?.({ align: 1 });
  if (isBit && stepped !== undefined) series.paths = stepped;
  return series;
}
