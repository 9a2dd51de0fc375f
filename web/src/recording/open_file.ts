import type { CanFrame } from "../canopen/frame";
import { ServiceMap } from "../canopen/services";
import { FrameStore } from "../model/frame_store";
import { SampleStore, type SampleRow, type SignalHead } from "../model/sample_store";
import { Refusal } from "../source/refusal";
import type { UnitEvent } from "../source/types";
import { axrecHead, isAxrec, readAxrec } from "./axrec";
import { isCandumpLog, readCandumpLog } from "./candump_log";
import type { Recording } from "./recording";
import { isTraceCsv, readTraceCsv, readTraceJson, type Trace } from "./trace_file";

/** What is told of a unit whose file does not say it. */
export interface OpenSettings {
  /** Number of the lane of an identifier (ServiceMap.laneOf); if not given, by the head of the file and the predefined set. */
  laneOf?: ((id: number, isExtended: boolean) => number) | undefined;
}

/** Samples this many times their usual distance apart have a gap between them. */
const kGap = 5.5;

function framesOf(frames: CanFrame[], laneOf: (id: number, isExtended: boolean) => number): FrameStore {
  const store = new FrameStore(laneOf, frames.length);
  for (const frame of frames) store.append(frame);
  return store;
}

/** Half of all distances are at most this (s). */
function usualDistance(samples: readonly SampleRow[]): number {
  const distances = samples.slice(1).map(({ t }, i) => t - (samples[i]?.t ?? t));
  distances.sort((a, b) => a - b);
  return distances[distances.length >> 1] ?? Infinity;
}

function samplesOf(signals: SignalHead[], samples: SampleRow[]): SampleStore {
  const store = new SampleStore(signals, samples.length, kGap * usualDistance(samples));
  for (const { t, values } of samples) store.append(t, values);
  return store;
}

function extent(...times: number[]): { from: number; to: number } {
  const known = times.filter((t) => !Number.isNaN(t));
  return known.length === 0 ? { from: 0, to: 0 } : { from: Math.min(...known), to: Math.max(...known) };
}

function openAxrec(name: string, bytes: Uint8Array, settings: OpenSettings): Recording {
  const nodeId = axrecHead(name, bytes).node_id;
  const frames: CanFrame[] = [];
  const events: UnitEvent[] = [];
  const samples: SampleRow[] = [];
  const summary = readAxrec(name, bytes, {
    frame: (frame) => frames.push(frame),
    event: (event) => events.push(event),
    samples: (t, values) => samples.push({ t, values }),
  });
  const { head, lost, remark } = summary;
  const startedAt = head.wall_clock_ns;
  return {
    name,
    format: "axrec",
    unit: head.unit,
    head,
    ...extent(summary.from, summary.to),
    frames: framesOf(frames, settings.laneOf ?? new ServiceMap({ nodeId }).laneOf),
    samples: samplesOf(head.signals.map((signal) => ({ signal: signal.name, unit: signal.unit })), samples),
    events,
    ...(startedAt === undefined ? {} : { startedAt: startedAt / 1e9 }),
    lost,
    remark,
  };
}

function openCandump(name: string, text: string, settings: OpenSettings): Recording {
  const { frames, startedAt, remark } = readCandumpLog(name, text);
  return {
    name,
    format: "candump",
    unit: "",
    ...extent(frames[0]?.t ?? NaN, frames.at(-1)?.t ?? NaN),
    frames: framesOf(frames, settings.laneOf ?? new ServiceMap().laneOf),
    samples: samplesOf([], []),
    events: [],
    startedAt,
    lost: 0,
    remark,
  };
}

function ofTrace(name: string, format: Recording["format"], trace: Trace, unit: string, settings: OpenSettings): Recording {
  const { frames, events, samples } = trace;
  const ends = [samples, frames, events].flatMap((list) => [list[0]?.t ?? NaN, list.at(-1)?.t ?? NaN]);
  return {
    name,
    format,
    unit,
    ...extent(...ends),
    frames: framesOf(frames, settings.laneOf ?? new ServiceMap().laneOf),
    samples: samplesOf(trace.signals, samples),
    events,
    ...(trace.triggerT === undefined ? {} : { triggerT: trace.triggerT }),
    lost: trace.lost,
    remark: trace.lost === 0 ? "" : `${trace.lost} frames had no room in the trace`,
  };
}

/** The recording in @param bytes, whatever it is: .axrec, candump log, CSV or JSON of a trace. A Refusal says what is wrong and where. */
export function openFile(name: string, bytes: Uint8Array, settings: OpenSettings = {}): Recording {
  if (bytes.length === 0) throw new Refusal("damaged", `${name}: the file is empty`);
  if (isAxrec(bytes)) return openAxrec(name, bytes, settings);
  const text = new TextDecoder().decode(bytes);
  if (isCandumpLog(text)) return openCandump(name, text, settings);
  if (isTraceCsv(text)) return ofTrace(name, "trace-csv", readTraceCsv(name, text), "", settings);
  if (/^\uFEFF?\s*[{[]/.test(text)) return ofTrace(name, "trace-json", readTraceJson(name, text), "", settings);
  const begin = text.slice(0, 24).replace(/[^\x20-\x7e]/g, ".");
  throw new Refusal(
    "unknown-format",
    `${name} begins with "${begin}": a recording (AXISREC), a log of candump -l ("(seconds) can0 605#40..."), or CSV or JSON of a trace was expected`,
  );
}
