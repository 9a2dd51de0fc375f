import type { UnitEvent } from "../../source/types";

const kBy: Readonly<Record<string, string>> = {
  sdo: "over SDO",
  control: "over the control socket",
  unit: "by the unit",
};

/** Time as a person reads it: 12 ms, 1.2 s. */
export function timeText(seconds: number): string {
  return seconds < 1 ? `${Number((seconds * 1000).toPrecision(3))}\u2009ms` : `${Number(seconds.toPrecision(4))}\u2009s`;
}

/** Where an event is: "axis 1", "the control unit", "the infeed"; empty: it says nothing. */
export function whereOf(event: UnitEvent): string {
  if (event.axis === undefined) return "";
  if (event.axis === "infeed") return "the infeed";
  return event.axis === 0 || event.axis === "0" ? "the control unit" : `axis ${event.axis}`;
}

function at(event: UnitEvent): string {
  const where = whereOf(event);
  return where === "" ? "" : ` of ${where}`;
}

function written(what: string, event: UnitEvent): string {
  const before = event.before === undefined ? "" : ` (before: ${event.before})`;
  return `${what}${at(event)} = ${String(event.value ?? "?")}${before}, written ${kBy[event.by ?? ""] ?? ""}`.trim();
}

/** An event in one line, for each kind. */
const kWords: Readonly<Record<string, (event: UnitEvent) => string>> = {
  power: (event) => (event.on === false ? "the unit was switched off" : "the unit was switched on"),
  "boot-up": (event) => `boot-up message of node ${event.node_id ?? "?"}`,
  nmt: (event) => `NMT state ${event.before ?? "?"} → ${event.state ?? "?"}`,
  link: (event) => (event.up === false ? "the bus cannot be used any more" : "the bus can be used"),
  bus: (event) => `CAN controller ${event.before ?? "?"} → ${event.state ?? "?"}`,
  "drive-state": (event) => `drive state${at(event)}: ${event.before ?? "?"} → ${event.state ?? "?"}`,
  fault: (event) => `${event.name ?? "fault"} ${event.text ?? ""}${at(event)}${event.active === false ? " has gone" : ""}`,
  alarm: (event) => `${event.name ?? "alarm"} ${event.text ?? ""}${at(event)}${event.active === false ? " has gone" : ""}`,
  emcy: (event) => `emergency message ${event.code ?? ""} was sent`,
  parameter: (event) => written(event.parameter ?? "parameter", event),
  object: (event) => written(`object ${event.object ?? ""}`, event),
  refusal: (event) => `SDO write of ${event.object ?? "?"} refused: ${event.abort_code ?? ""} ${event.text ?? ""}`,
  store: (event) => (event.done === false ? "the parameters could not be saved" : "the parameters were saved"),
  restore: () => "the parameters are those of a new unit",
  control: (event) => `${event.method ?? "a method"} ${event.text ?? ""}${at(event)}`.trim() + " over the control socket",
};

/** An event in one line. */
export function eventWords(event: UnitEvent): string {
  return (kWords[event.kind] ?? ((other) => `${other.kind} ${other.text ?? ""}`))(event);
}
