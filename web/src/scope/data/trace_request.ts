import { Refusal } from "../../source/refusal";

/** What is typed into a field of the form of a trace. */
export type Typed = Record<string, string>;

/** A field that a kind of trigger takes. */
export interface TriggerField {
  key: string;
  label: string;
  /** How what was typed is sent. */
  form: "signal" | "number" | "whole" | "word" | "hexadecimal" | "choice";
  choices?: readonly string[];
  isNeeded: boolean;
  hint?: string;
}

/** A kind of trigger (docs/reference/trace.md). */
export interface TriggerKind {
  on: string;
  text: string;
  fields: readonly TriggerField[];
}

const kSignal: TriggerField = { key: "signal", label: "Signal", form: "signal", isNeeded: true };
const kAxis: TriggerField = { key: "axis", label: "Axis", form: "word", isNeeded: false, hint: "any" };
const kNumber: TriggerField = { key: "number", label: "Number", form: "whole", isNeeded: false, hint: "any" };

function number(key: string, label: string): TriggerField {
  return { key, label, form: "number", isNeeded: true };
}

function hexadecimal(key: string, label: string, hint: string, isNeeded = false): TriggerField {
  return { key, label, form: "hexadecimal", isNeeded, hint };
}

const kStates = [
  "Not ready to switch on",
  "Switch on disabled",
  "Ready to switch on",
  "Switched on",
  "Operation enabled",
  "OFF1 braking",
  "Quick stop active",
  "Fault reaction active",
  "STOP2",
  "Fault",
] as const;

/** One row a kind. */
export const kTriggers: readonly TriggerKind[] = [
  { on: "none", text: "at once", fields: [] },
  { on: "stop", text: "until it is stopped", fields: [] },
  { on: "rising", text: "a signal rises to", fields: [kSignal, number("level", "Level")] },
  { on: "falling", text: "a signal falls to", fields: [kSignal, number("level", "Level")] },
  { on: "above", text: "a signal is above", fields: [kSignal, number("level", "Level")] },
  { on: "below", text: "a signal is below", fields: [kSignal, number("level", "Level")] },
  { on: "inside", text: "a signal is inside", fields: [kSignal, number("low", "From"), number("high", "To")] },
  { on: "outside", text: "a signal is outside", fields: [kSignal, number("low", "From"), number("high", "To")] },
  {
    on: "bits",
    text: "bits of a word are",
    fields: [kSignal, hexadecimal("value", "Value", "hexadecimal", true), hexadecimal("mask", "Mask", "all bits")],
  },
  { on: "fault", text: "a fault comes", fields: [kNumber, kAxis] },
  { on: "alarm", text: "an alarm comes", fields: [kNumber, kAxis] },
  { on: "state", text: "a drive state is reached", fields: [{ key: "state", label: "State", form: "choice", choices: kStates, isNeeded: true }, kAxis] },
  {
    on: "frame",
    text: "a frame comes or goes",
    fields: [
      hexadecimal("id", "Identifier", "any"),
      hexadecimal("id_mask", "Mask of it", "all bits"),
      hexadecimal("data", "Data begin with", "any"),
      hexadecimal("data_mask", "Mask of them", "all bits"),
      { key: "direction", label: "Direction", form: "choice", choices: ["", "received", "sent"], isNeeded: false },
    ],
  },
];

/** What trace.start is asked. */
export interface TraceRequest {
  signals: readonly string[];
  every: number | "cycle";
  trigger: Record<string, string | number>;
  before_s: number;
  length_s: number;
  repeat?: boolean;
  keep?: number;
}

/** What stands in the form, besides the fields of the trigger. */
export interface TraceForm {
  every: string;
  on: string;
  before: string;
  length: string;
  isRepeated: boolean;
  typed: Typed;
}

/** How the form is at first. */
export const kFirstForm: TraceForm = { every: "0.000125", on: "fault", before: "0.5", length: "1", isRepeated: false, typed: {} };

function wrong(field: string, expected: string): Refusal {
  return new Refusal("bad-request", `${field}: expected ${expected}`, 0, { field });
}

function numberOf(label: string, text: string, low: number, high: number): number {
  const value = text.trim() === "" ? NaN : Number(text);
  if (!(value >= low && value <= high)) throw wrong(label, `a number from ${low} to ${high}`);
  return value;
}

function valueOf(field: TriggerField, text: string): string | number {
  if (field.form === "number") return numberOf(field.label, text, -1e12, 1e12);
  if (field.form === "whole") {
    const value = Number(text.replace(/^[FA]/i, ""));
    if (!Number.isInteger(value) || value < 1 || value > 65535) throw wrong(field.label, "a number like 7900 or F07900");
    return value;
  }
  if (field.form === "hexadecimal" && !/^(0x)?[0-9a-f]{1,16}$/i.test(text)) throw wrong(field.label, "hexadecimal digits");
  if (field.key === "axis") return /^\d$/.test(text) ? Number(text) : text;
  return text;
}

function triggerOf(form: TraceForm): Record<string, string | number> {
  const kind = kTriggers.find(({ on }) => on === form.on);
  const trigger: Record<string, string | number> = { on: form.on };
  for (const field of kind?.fields ?? []) {
    const text = (form.typed[field.key] ?? "").trim();
    if (text === "" && field.isNeeded) throw wrong(field.label, "something");
    if (text !== "") trigger[field.key] = valueOf(field, text);
  }
  return trigger;
}

/** The period in @param text: a multiple of 125 µs, or each process-data cycle. */
function everyOf(text: string): number | "cycle" {
  if (text.trim() === "cycle") return "cycle";
  const steps = numberOf("Every", text, 0.000125, 3600) / 0.000125;
  if (Math.abs(steps - Math.round(steps)) > 1e-6) throw wrong("Every", "a multiple of 0.000125 s, or cycle");
  return Math.round(steps) * 0.000125;
}

/** What the form asks for with @param signals; a Refusal names the field that is wrong. */
export function traceRequest(form: TraceForm, signals: readonly string[]): TraceRequest {
  if (signals.length === 0) throw wrong("Signals", "at least one: add it to the picture");
  const length = numberOf("Length", form.length, 0.000125, 86400);
  const request: TraceRequest = {
    signals,
    every: everyOf(form.every),
    trigger: triggerOf(form),
    before_s: numberOf("Before", form.before, 0, length),
    length_s: length,
  };
  return form.isRepeated ? { ...request, repeat: true, keep: 8 } : request;
}
