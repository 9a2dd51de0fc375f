import type { ParameterEntry } from "../../source/types";
import { csvField } from "../../ui/download";

/** A value as it is read and typed: seven digits, as a F32 has. */
export function valueText(value: number | string | undefined): string {
  if (value === undefined) return "–";
  if (typeof value === "string" || Number.isInteger(value)) return String(value);
  return String(Number(value.toPrecision(7)));
}

/** `0 … 10`; empty: there are no limits. */
export function rangeText(minimum: number | undefined, maximum: number | undefined): string {
  if (minimum === undefined && maximum === undefined) return "";
  return `${valueText(minimum)} … ${valueText(maximum)}`;
}

/** A value with its unit behind a thin space. */
export function quantity(value: number | string | undefined, unit: string): string {
  return unit === "" || value === undefined ? valueText(value) : `${valueText(value)}\u2009${unit}`;
}

/** When a parameter can be written, in words: "U, T" is while running, and with the pulses off. */
export function whenWords(when: string | undefined): string {
  if (when === undefined || when === "") return "never: read-only";
  return when
    .split(/, (?![^(]*\))/)
    .map((word) => {
      if (word === "U") return "while the motor runs";
      if (word === "T") return "with the pulses off";
      const filter = /^C\((.*)\)$/.exec(word)?.[1];
      return filter === undefined ? word : `in commissioning (p0010 or p0009 = ${filter.replaceAll(",", ", ")})`;
    })
    .join(", ");
}

/** The bits of a whole number, bit 0 first; @param width 1..32. */
export function bitsOf(value: number, width: number): boolean[] {
  return Array.from({ length: width }, (_, bit) => Math.floor(value / 2 ** bit) % 2 === 1);
}

const kWidths: Partial<Record<ParameterEntry["type"], number>> = { U8: 8, U16: 16, U32: 32 };

/** How many bits of @param entry can be taken by binector inputs; 0: none. */
export function bitWidth(entry: ParameterEntry): number {
  return entry.uses === undefined ? 0 : (kWidths[entry.type] ?? 0);
}

const kColumns: [string, (entry: ParameterEntry) => string | number | undefined][] = [
  ["place", (entry) => entry.axis],
  ["parameter", (entry) => entry.parameter],
  ["number", (entry) => entry.number],
  ["index", (entry) => entry.index],
  ["name", (entry) => entry.name],
  ["value", (entry) => entry.value],
  ["unit", (entry) => entry.unit],
  ["minimum", (entry) => entry.minimum],
  ["maximum", (entry) => entry.maximum],
  ["factory", (entry) => entry.factory],
  ["stored", (entry) => entry.stored],
  ["type", (entry) => entry.type],
  ["access", (entry) => entry.access],
  ["when", (entry) => entry.when],
  ["effect", (entry) => entry.effect],
];

/** Parameters as CSV with a head. */
export function parametersCsv(entries: readonly ParameterEntry[]): string {
  const lines = entries.map((entry) => kColumns.map(([, field]) => csvField(field(entry))).join(","));
  return [kColumns.map(([title]) => title).join(","), ...lines, ""].join("\n");
}
