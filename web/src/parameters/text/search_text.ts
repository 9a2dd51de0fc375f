import { parsedName } from "./names";

/** What is searched in: as the unit does it (parameter.search). */
export interface Searched {
  parameter: string;
  number: number;
  name: string;
  effect: string;
}

/** A number of a parameter or its beginning, with or without p and r. */
const kNumber = /^[pr]?\d+$/;

/** The text without index and bit: a parameter is found by its number. */
export function searchedText(text: string): string {
  return parsedName(text)?.base ?? text.trim();
}

/** Whether @param text finds @param entry: the beginning of its number, or words that all occur in name or effect. */
export function finds(text: string, entry: Searched): boolean {
  const words = searchedText(text).toLowerCase().split(/\s+/).filter((word) => word !== "");
  const [first = ""] = words;
  if (words.length === 1 && kNumber.test(first)) return hasNumber(first, entry);
  const told = `${entry.name} ${entry.effect}`.toLowerCase();
  return words.every((word) => told.includes(word));
}

function hasNumber(wanted: string, entry: Searched): boolean {
  if (/^[pr]/.test(wanted)) return entry.parameter.startsWith(wanted);
  return entry.parameter.slice(1).startsWith(wanted) || String(entry.number).startsWith(wanted);
}
