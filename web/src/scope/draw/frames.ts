import { kLanes } from "../../canopen/services";
import type { Bins } from "../view/density";
import type { Row } from "../view/layout";
import { kSmallFont, type Palette } from "./palette";
import { xOf, type TimeField } from "./time_field";

/** Tone of a lane. */
const kTones: Record<string, string> = { nmt: "ready", sync: "off", emcy: "fault", rpdo: "on", tpdo: "run", sdo: "brake", heartbeat: "off", other: "off" };

/** Frames of a lane that are in the window. */
export function framesIn(bins: Bins, lane: number): number {
  let sum = 0;
  for (let i = lane * bins.count, end = i + bins.count; i < end; ++i) sum += bins.counts[i] ?? 0;
  return sum;
}

/** Draws the frames of a lane: a tick each, where there are several at a place the higher the more. */
export function drawFrames(context: CanvasRenderingContext2D, row: Row, field: TimeField, bins: Bins, palette: Palette): void {
  const lane = row.lane ?? 0;
  const begin = lane * bins.count;
  let most = 1;
  for (let i = 0; i < bins.count; ++i) most = Math.max(most, bins.counts[begin + i] ?? 0);
  context.fillStyle = palette.tones[kTones[kLanes[lane]?.lane ?? "other"] ?? "off"]?.text ?? palette.text;
  const bottom = row.top + row.height;
  const width = field.width / Math.round((field.to - field.from) / bins.length);
  const offset = xOf(field, bins.from);
  const placeOf = (bin: number): number => Math.min(field.left + field.width, Math.max(field.left, Math.round(offset + bin * width)));
  for (let i = 0; i < bins.count; ++i) {
    const count = bins.counts[begin + i] ?? 0;
    if (count === 0) continue;
    const height = heightOf(count, most, row.height);
    const left = placeOf(i);
    while (i + 1 < bins.count && heightOf(bins.counts[begin + i + 1] ?? 0, most, row.height) === height) ++i;
    context.fillRect(left, bottom - height, Math.max(1, placeOf(i + 1) - left), height);
  }
}

/** Height of a tick that stands for @param count frames, of which there are @param most at the busiest place. */
function heightOf(count: number, most: number, height: number): number {
  if (count === 0) return 0;
  return Math.round(height * (most > 1 ? 0.35 + (0.65 * Math.log2(1 + count)) / Math.log2(1 + most) : 0.8));
}

/** Names of the rows in the gutter, and how many frames there are. */
export function drawNames(context: CanvasRenderingContext2D, rows: readonly Row[], field: TimeField, bins: Bins | undefined, palette: Palette): void {
  context.textBaseline = "middle";
  context.strokeStyle = palette.line;
  for (const row of rows) {
    const y = row.top + row.height / 2;
    context.fillStyle = palette.text;
    context.font = kSmallFont;
    context.fillText(row.name, 2, y);
    context.beginPath();
    context.moveTo(0, row.top + row.height + 1);
    context.lineTo(field.left + field.width, row.top + row.height + 1);
    context.stroke();
    if (row.kind !== "frames" || bins === undefined || field.left < 84) continue;
    const count = framesIn(bins, row.lane ?? 0);
    context.fillStyle = palette.muted;
    context.textAlign = "right";
    if (count > 0) context.fillText(shortCount(count), field.left - 6, y);
    context.textAlign = "left";
  }
}

/** 950, 1.2k, 35k, 1.1M. */
export function shortCount(count: number): string {
  if (count < 1000) return String(count);
  const [value, unit] = count < 1e6 ? [count / 1e3, "k"] : [count / 1e6, "M"];
  return `${value < 9.95 ? value.toFixed(1) : Math.round(value)}${unit}`;
}
