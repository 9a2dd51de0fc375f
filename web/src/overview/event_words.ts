import type { UnitEvent } from "../source/types";
import { lookOf, type StateLook } from "../ui/state_words";

/** How an event looks in the list: a tone of the palette, and a glyph for who does not see colours. */
export interface EventLook {
  tone: StateLook["tone"];
  glyph: string;
  title: string;
}

type Words = (event: UnitEvent) => string;

/** Objects whose values are read in hexadecimal digits. */
const kWords = new Set(["6040:00", "6041:00"]);

function valueText(event: UnitEvent, value: number | string | undefined): string {
  if (typeof value !== "number" || !kWords.has(event.object ?? "")) return String(value ?? "?");
  return `${value.toString(16).toUpperCase().padStart(4, "0")}h`;
}

function writtenText(event: UnitEvent): string {
  const before = event.before === undefined ? "" : `, was ${valueText(event, event.before)}`;
  return `${event.parameter ?? event.object ?? ""} = ${valueText(event, event.value)}${before}`;
}

function statesText(event: UnitEvent): string {
  return `${event.before ?? "?"} → ${event.state ?? "?"}`;
}

function messageText(event: UnitEvent): string {
  const value = event.value === undefined || event.value === 0 ? "" : ` (value ${event.value})`;
  return `${event.name ?? ""} ${event.text ?? ""}${value}${event.active === false ? " has gone" : ""}`;
}

interface Row {
  look: EventLook;
  words: Words;
}

function row(tone: EventLook["tone"], glyph: string, title: string, words: Words): Row {
  return { look: { tone, glyph, title }, words };
}

/** One row a kind of event. */
const kRows: Record<string, Row> = {
  power: row("on", "⏻", "Power", (event) => (event.on === true ? "switched on" : "switched off")),
  "boot-up": row("on", "▲", "Boot-up", (event) => `boot-up message of node ${event.node_id ?? "?"}`),
  nmt: row("ready", "N", "NMT state", statesText),
  link: row("brake", "⌁", "Bus", (event) => (event.up === true ? "the bus can be used" : "the bus cannot be used")),
  bus: row("brake", "C", "CAN controller", statesText),
  "drive-state": row("run", "→", "Drive state", statesText),
  fault: row("fault", "F", "Fault", messageText),
  alarm: row("brake", "A", "Alarm", messageText),
  emcy: row("fault", "!", "EMCY", (event) => `error code ${event.code ?? "?"} sent, data ${event.data ?? ""}`),
  parameter: row("off", "p", "Parameter", writtenText),
  object: row("off", "=", "Object", writtenText),
  refusal: row("brake", "✗", "Refusal", (event) => `write of ${event.object ?? "?"} refused with ${event.abort_code ?? "?"}: ${event.text ?? ""}`),
  store: row("off", "↓", "Store", (event) => (event.done === true ? "the parameters were saved" : "the parameters could not be saved")),
  restore: row("off", "↺", "Restore", () => "the parameters are those of a new unit"),
  control: row("ready", "c", "Control socket", (event) => `${event.method ?? ""} ${event.text ?? ""}`.trim()),
};

/** The look of @param event, also of a kind that this page does not know. */
export function eventLook(event: UnitEvent): EventLook {
  const look = kRows[event.kind]?.look ?? { tone: "off", glyph: "·", title: event.kind };
  if (event.kind === "drive-state") return { ...look, tone: lookOf(event.state ?? "").tone };
  return event.active === false ? { ...look, tone: "off" } : look;
}

/** What has happened, without where and when. */
export function eventWords(event: UnitEvent): string {
  return kRows[event.kind]?.words(event) ?? event.text ?? event.kind;
}

/** Where it has happened within the unit: "axis 1", "control unit", empty: the unit as a whole. */
export function placeWords(event: UnitEvent): string {
  if (event.axis === undefined) return "";
  if (event.axis === 0) return "control unit";
  return event.axis === "infeed" ? "infeed" : `axis ${event.axis}`;
}

const kOrigins: Record<string, string> = { unit: "unit", sdo: "SDO", control: "control socket" };

/** By whom: "unit", "SDO", "control socket"; what nobody has done is the unit's doing. */
export function originWords(event: UnitEvent): string {
  const origin = event.by ?? "unit";
  const server = origin === "sdo" && event.server !== undefined && event.server > 0 ? ` ${event.server + 1}` : "";
  return `${kOrigins[origin] ?? origin}${server}`;
}

/** @param events without those of the control socket that only say again what was said last: renewals of an operator panel. */
export function withoutRepeats(events: readonly UnitEvent[]): UnitEvent[] {
  const last = new Map<string, string>();
  return events.filter((event) => {
    if (event.kind !== "control") return true;
    const words = `${event.method ?? ""} ${event.text ?? ""}`;
    const isRepeat = last.get(event.unit ?? "") === words;
    last.set(event.unit ?? "", words);
    return !isRepeat;
  });
}
