import type { CanFrame } from "../canopen/frame";
import type { SampleRow, SignalHead } from "../model/sample_store";
import { Refusal, wordsOf } from "../source/refusal";
import type { UnitEvent } from "../source/types";
import { csvRows } from "./csv";

/** A result of a trace, as `axisctl trace read -o FILE.json` writes it, and as the pages of trace.read make it. */
export interface TraceResult {
  signals: { signal: string; unit: string; text?: string }[];
  /** The time, then a value a signal. */
  samples: (number | null)[][];
  frames?: {
    t: number;
    id: number;
    direction: string;
    data?: string;
    extended?: boolean;
    remote?: boolean;
    length?: number;
  }[];
  events?: {
    t: number;
    kind: string;
    axis: string | number;
    active?: boolean;
    text?: string;
    number?: number;
    index?: number;
    value?: number;
  }[];
  lost_frames?: number;
  trigger_t?: number;
}

/** A trace in the shape of a recording. */
export interface Trace {
  signals: SignalHead[];
  samples: SampleRow[];
  frames: CanFrame[];
  events: UnitEvent[];
  lost: number;
  triggerT?: number;
}

const kTime = "t (s)";
const kTimeFromTrigger = "t from trigger (s)";

/** Whether @param text begins as the CSV of a trace. */
export function isTraceCsv(text: string): boolean {
  return text.replace(/^\uFEFF/, "").startsWith(kTime);
}

/** "1/speed (rpm)" as a signal with its unit. */
function headOf(text: string): SignalHead {
  const match = /^(.*) \(([^()]*)\)$/.exec(text);
  return match === null ? { signal: text } : { signal: match[1] ?? "", unit: match[2] ?? "" };
}

/** Reads the CSV of a trace; a Refusal names the line that is wrong. */
export function readTraceCsv(name: string, text: string): Trace {
  const [heads = [], ...lines] = csvRows(text.replace(/^\uFEFF/, ""));
  if (heads[0] !== kTime) throw new Refusal("damaged", `${name}, line 1: "${kTime}" was expected in front`);
  const skipped = heads[1] === kTimeFromTrigger ? 2 : 1;
  const trace: Trace = { signals: heads.slice(skipped).map(headOf), samples: [], frames: [], events: [], lost: 0 };
  lines.forEach((fields, index) => {
    const numbers = fields.map((field) => (field === "" ? null : Number(field)));
    const t = numbers[0];
    if (fields.length !== heads.length || t === null || t === undefined || numbers.some(Number.isNaN))
      throw new Refusal("damaged", `${name}, line ${index + 2}: ${heads.length} numbers were expected, not "${fields.join(",")}"`);
    trace.samples.push({ t, values: numbers.slice(skipped) });
    const since = numbers[1];
    if (skipped === 2 && trace.triggerT === undefined && typeof since === "number")
      trace.triggerT = Math.round((t - since) * 1e9) / 1e9;
  });
  return trace;
}

function frameOf(frame: NonNullable<TraceResult["frames"]>[number]): CanFrame {
  const digits = frame.data ?? "";
  const data = Uint8Array.from({ length: digits.length / 2 }, (_, i) => parseInt(digits.slice(2 * i, 2 * i + 2), 16));
  return {
    t: frame.t,
    sent: frame.direction === "sent",
    isRemote: frame.remote ?? false,
    isExtended: frame.extended ?? false,
    id: frame.id,
    length: frame.length ?? data.length,
    data,
  };
}

/** The members that an event of a unit has for each kind that a trace knows. */
function eventOf(event: NonNullable<TraceResult["events"]>[number], unit: string): UnitEvent {
  const { t, kind, text = "", number = 0, index = 0 } = event;
  const axis = event.axis === "infeed" ? "infeed" : Number(event.axis);
  const base = { t, kind, unit };
  const value = event.value === undefined ? {} : { value: event.value };
  const members: Record<string, object> = {
    fault: { axis, number, name: `F${String(number).padStart(5, "0")}`, text, active: event.active ?? true, ...value },
    alarm: { axis, number, name: `A${String(number).padStart(5, "0")}`, text, active: event.active ?? true, ...value },
    "drive-state": { axis, state: text },
    nmt: { state: text },
    bus: { state: text },
    emcy: { code: `0x${number.toString(16).toUpperCase().padStart(4, "0")}` },
    parameter: { axis, parameter: `p${String(number).padStart(4, "0")}[${index}]`, ...value },
    object: { object: `${number.toString(16).toUpperCase().padStart(4, "0")}:${index.toString(16).toUpperCase().padStart(2, "0")}`, ...value },
  };
  return { ...base, ...(members[kind] ?? { text }) } as UnitEvent;
}

/** A result of trace.read as a recording has it. */
export function traceOf(result: TraceResult, unit = ""): Trace {
  const byTime = (a: { t: number }, b: { t: number }): number => a.t - b.t;
  const trace: Trace = {
    signals: result.signals.map(({ signal, unit: of, text }) => ({ signal, unit: of, text })),
    samples: result.samples.map(([t, ...values]) => ({ t: t ?? NaN, values })),
    frames: (result.frames ?? []).map(frameOf).sort(byTime),
    events: (result.events ?? []).map((event) => eventOf(event, unit)).sort(byTime),
    lost: result.lost_frames ?? 0,
  };
  if (result.trigger_t !== undefined) trace.triggerT = result.trigger_t;
  return trace;
}

/** Reads the JSON of a trace; a Refusal says what is missing. */
export function readTraceJson(name: string, text: string): Trace {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch (error) {
    throw new Refusal("damaged", `${name}: no JSON: ${wordsOf(error)}`);
  }
  const result = value as Partial<TraceResult> | null;
  if (!Array.isArray(result?.signals) || !Array.isArray(result.samples))
    throw new Refusal("unknown-format", `${name}: JSON, but no trace: "signals" and "samples" were expected`);
  return traceOf(result as TraceResult);
}
