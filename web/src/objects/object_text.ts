import type { ObjectEntry } from "../source/types";
import { valueText } from "../parameters/text/value_text";
import { csvField } from "../ui/download";

/** An object of the dictionary: index and sub-index. */
export interface ObjectName {
  index: number;
  sub: number;
}

const kName = /^(?:0x)?([0-9a-f]{4})h?(?::([0-9a-f]{1,2}))?$/i;

/** The object that @param text names: 6040, 6040h, 0x6040, 1018:04 (both in hexadecimal); undefined: none. */
export function parsedObject(text: string): ObjectName | undefined {
  const [, index, sub] = kName.exec(text.trim()) ?? [];
  if (index === undefined) return undefined;
  return { index: parseInt(index, 16), sub: sub === undefined ? 0 : parseInt(sub, 16) };
}

function hexadecimal(value: number, digits: number): string {
  return value.toString(16).toUpperCase().padStart(digits, "0");
}

/** `6040:00` as an address has it. */
export function objectText({ index, sub }: ObjectName): string {
  return `${hexadecimal(index, 4)}:${hexadecimal(sub, 2)}`;
}

/** The path of an object in the HTTP API; the sub-index is a word of the query. */
export function objectPath({ index }: ObjectName): string {
  return `objects/${hexadecimal(index, 4)}`;
}

/** The name of the object of @param entry. */
export function nameOf(entry: ObjectEntry): ObjectName {
  return { index: entry.index, sub: entry.sub_index };
}

const kDigits: Record<string, number> = {
  UNSIGNED8: 2,
  UNSIGNED16: 4,
  UNSIGNED24: 6,
  UNSIGNED32: 8,
};

/** A value in hexadecimal with all digits of its type; empty: the type is not counted so. */
export function hexText(value: number | string | undefined, type: string): string {
  const digits = kDigits[type];
  return digits === undefined || typeof value !== "number" ? "" : `${hexadecimal(value, digits)}h`;
}

/** What of the dictionary is listed. */
export const kObjectFilters = [
  { filter: "all", title: "All", holds: () => true },
  { filter: "writable", title: "Writable", holds: (entry: ObjectEntry) => !["ro", "const"].includes(entry.access) },
  { filter: "mappable", title: "Mappable into PDOs", holds: (entry: ObjectEntry) => entry.mappable },
] as const;

export type ObjectFilter = (typeof kObjectFilters)[number]["filter"];

/** The filter that @param text names; all, if it names none. */
export function objectFilterOf(text: string | null): ObjectFilter {
  return kObjectFilters.find((each) => each.filter === text)?.filter ?? "all";
}

/** Whether @param entry is listed with @param filter. */
export function objectHolds(filter: ObjectFilter, entry: ObjectEntry): boolean {
  return kObjectFilters.find((each) => each.filter === filter)?.holds(entry) ?? true;
}

/** Whether @param text finds @param entry, as object.list does: the beginning of its index, or a part of its name. */
export function findsObject(text: string, entry: ObjectEntry): boolean {
  const wanted = searchedObject(text).toLowerCase();
  return entry.object.toLowerCase().startsWith(wanted) || entry.name.toLowerCase().includes(wanted);
}

/** The text without sub-index and signs of hexadecimal: what object.list searches for. */
export function searchedObject(text: string): string {
  const named = parsedObject(text);
  return named === undefined ? text.trim().replace(/^0x/i, "") : hexadecimal(named.index, 4);
}

/** Objects as CSV with a head; @param parentOf tells the name of what a sub-index belongs to. */
export function objectsCsv(entries: readonly ObjectEntry[], parentOf: (index: number) => string): string {
  const lines = entries.map((entry) =>
    [
      entry.object,
      parentOf(entry.index),
      entry.name,
      entry.value === undefined ? "" : valueText(entry.value),
      entry.type,
      entry.access,
      entry.mappable,
      entry.minimum,
      entry.maximum,
    ]
      .map(csvField)
      .join(","),
  );
  return ["object,parent,name,value,type,access,mappable,minimum,maximum", ...lines, ""].join("\n");
}
