import { kLanes } from "../../canopen/services";
import type { SignalHead } from "../../model/sample_store";

/** Curves that share a vertical scale. */
export interface PlotLane {
  /** Unit of measure; of a bit, what it is called. */
  title: string;
  isBit: boolean;
  /** Numbers of the signals. */
  signals: number[];
}

/** Whether @param name is a bit of a word: 1/r0899.2. */
export function isBit(name: string): boolean {
  return /\/[pr]\d+(\[\d+\])?\.\d+$/.test(name);
}

/** A lane a unit of measure in the order in which they appear, and one for each bit below them. */
export function plotLanes(signals: readonly SignalHead[]): PlotLane[] {
  const lanes: PlotLane[] = [];
  signals.forEach((signal, number) => {
    if (isBit(signal.signal)) return;
    const title = signal.unit ?? "";
    const found = lanes.find((lane) => lane.title === title);
    if (found) found.signals.push(number);
    else lanes.push({ title, isBit: false, signals: [number] });
  });
  signals.forEach((signal, number) => {
    if (isBit(signal.signal)) lanes.push({ title: signal.signal, isBit: true, signals: [number] });
  });
  return lanes;
}

/** Heights of @param lanes that fill @param height together, if that leaves each one enough. */
export function laneHeights(lanes: readonly PlotLane[], height: number): number[] {
  const kBit = 40;
  const kLeast = 84;
  const bits = lanes.filter((lane) => lane.isBit).length;
  const share = Math.floor((height - bits * kBit) / Math.max(1, lanes.length - bits));
  return lanes.map((lane) => (lane.isBit ? kBit : Math.max(kLeast, share)));
}

/** A row below the curves. */
export interface Row {
  kind: "axis" | "nmt" | "marks" | "frames";
  name: string;
  top: number;
  height: number;
  /** Of a band: which axis. */
  place?: number | "infeed";
  /** Of frames: number of the lane. */
  lane?: number;
}

/** The rows: drive states, NMT state, events, frames by service. */
export function rowsOf(places: readonly (number | "infeed")[], lanes: readonly number[]): Row[] {
  const rows: Omit<Row, "top">[] = places.map((place) => ({
    kind: "axis",
    name: place === "infeed" ? "Infeed" : `Axis ${place}`,
    height: 20,
    place,
  }));
  rows.push({ kind: "nmt", name: "NMT state", height: 20 }, { kind: "marks", name: "Events", height: 26 });
  for (const lane of lanes) rows.push({ kind: "frames", name: kLanes[lane]?.name ?? "?", height: 18, lane });
  let top = 2;
  return rows.map((row) => {
    const placed = { ...row, top };
    top += row.height + 2;
    return placed;
  });
}

/** Height of all @param rows. */
export function heightOf(rows: readonly Row[]): number {
  const last = rows.at(-1);
  return last === undefined ? 0 : last.top + last.height + 2;
}

/** The row at @param y. */
export function rowAt(rows: readonly Row[], y: number): Row | undefined {
  return rows.find((row) => y >= row.top - 1 && y <= row.top + row.height);
}
