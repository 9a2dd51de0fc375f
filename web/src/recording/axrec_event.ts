import { hexOf } from "../canopen/frame";
import type { UnitEvent } from "../source/types";

/** Kinds of events by their numbers in recordings (docs/reference/recording.md). */
const kKinds = [
  "power",
  "boot-up",
  "nmt",
  "link",
  "bus",
  "drive-state",
  "fault",
  "alarm",
  "emcy",
  "parameter",
  "object",
  "refusal",
  "store",
  "restore",
  "control",
] as const;
type Kind = (typeof kKinds)[number];

const kOrigins = ["unit", "sdo", "control"] as const;
/** The drive object that is the control unit. */
const kControlUnit = 1;
/** Flags of an event. */
const kActive = 1;
const kHasValue = 2;
const kHasBefore = 4;
/** Bytes of an event without its texts. */
const kFixed = 38;

/** An event as it stands in a recording. */
interface RawEvent {
  kind: Kind;
  origin: (typeof kOrigins)[number];
  server: number;
  object: number;
  axis: number;
  isActive: boolean;
  number: number;
  index: number;
  code: number;
  value: number | undefined;
  before: number | undefined;
  data: Uint8Array;
  text: string;
  textBefore: string;
}

type Members = Partial<Omit<UnitEvent, "kind">>;

function hexDigits(value: number, digits: number): string {
  return value.toString(16).toUpperCase().padStart(digits, "0");
}

function place(raw: RawEvent): Members {
  if (raw.object === 0) return {};
  const isAxis = raw.axis !== 0 || raw.object === kControlUnit;
  return { drive_object: raw.object, axis: isAxis ? raw.axis : "infeed" };
}

function states(raw: RawEvent): Members {
  return { ...place(raw), state: raw.text, before: raw.textBefore };
}

function message(raw: RawEvent): Members {
  const name = `${raw.kind === "fault" ? "F" : "A"}${String(raw.number).padStart(5, "0")}`;
  return { ...place(raw), number: raw.number, name, text: raw.text, value: raw.code, active: raw.isActive };
}

function origin(raw: RawEvent): Members {
  return raw.origin === "sdo" ? { by: raw.origin, server: raw.server } : { by: raw.origin };
}

function values(raw: RawEvent): Members {
  const members: Members = origin(raw);
  if (raw.value !== undefined) members.value = raw.value;
  if (raw.before !== undefined) members.before = raw.before;
  return members;
}

function object(raw: RawEvent): Members {
  return { object: `${hexDigits(raw.number, 4)}:${hexDigits(raw.index, 2)}` };
}

/** What further members the events of each kind have, as record/event.cpp gives them. */
const kMembers: Record<Kind, (raw: RawEvent) => Members> = {
  power: (raw) => ({ on: raw.isActive }),
  "boot-up": (raw) => ({ node_id: raw.number }),
  nmt: states,
  link: (raw) => ({ up: raw.isActive }),
  bus: states,
  "drive-state": states,
  fault: message,
  alarm: message,
  emcy: (raw) => ({ code: `0x${hexDigits(raw.number, 4)}`, data: hexOf(raw.data) }),
  parameter: (raw) => ({
    ...place(raw),
    parameter: `p${String(raw.number).padStart(4, "0")}[${raw.index}]`,
    ...values(raw),
  }),
  object: (raw) => ({ ...object(raw), ...values(raw) }),
  refusal: (raw) => ({
    ...object(raw),
    abort_code: `0x${hexDigits(raw.code, 8)}`,
    text: raw.text,
    ...origin(raw),
  }),
  store: (raw) => ({ done: raw.isActive }),
  restore: () => ({}),
  control: (raw) => ({ ...place(raw), method: raw.text, text: raw.textBefore, by: raw.origin }),
};

/** The text with its length in front at @param at; undefined: it is cut. */
function textAt(bytes: Uint8Array, at: number): string | undefined {
  const length = bytes[at];
  if (length === undefined || at + 1 + length > bytes.length) return undefined;
  return new TextDecoder().decode(bytes.subarray(at + 1, at + 1 + length));
}

function rawEvent(bytes: Uint8Array): RawEvent | undefined {
  if (bytes.length < kFixed) return undefined;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const [kind, origin] = [kKinds[view.getUint8(0)], kOrigins[view.getUint8(1)]];
  const text = textAt(bytes, kFixed);
  const textBefore = text === undefined ? undefined : textAt(bytes, kFixed + 1 + (bytes[kFixed] ?? 0));
  if (kind === undefined || origin === undefined || text === undefined || textBefore === undefined) return undefined;
  const flags = view.getUint8(5);
  return {
    kind,
    origin,
    server: view.getUint8(2),
    object: view.getUint8(3),
    axis: view.getUint8(4),
    isActive: (flags & kActive) !== 0,
    number: view.getUint16(6, true),
    index: view.getUint16(8, true),
    code: view.getUint32(10, true),
    value: (flags & kHasValue) === 0 ? undefined : view.getFloat64(14, true),
    before: (flags & kHasBefore) === 0 ? undefined : view.getFloat64(22, true),
    data: bytes.slice(30, 38),
    text,
    textBefore,
  };
}

/** The event in the content of a record, as events of a living unit are; undefined: a kind that this page does not know. */
export function eventIn(bytes: Uint8Array, t: number, unit: string): UnitEvent | undefined {
  const raw = rawEvent(bytes);
  if (raw === undefined) return undefined;
  return { t, unit, kind: raw.kind, ...kMembers[raw.kind](raw) };
}
