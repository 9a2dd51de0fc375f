import { kMessages, type MessageRow } from "./messages";

/** The number in "7860", "F7860" or "A07850"; undefined: there is none. */
export function numberOf(text: string): number | undefined {
  const digits = /^[fa]?0*(\d{1,5})$/i.exec(text.trim())?.[1];
  return digits === undefined ? undefined : Number(digits);
}

/** Whether every word of @param text is in the code, the name or the cause of @param row. */
function fits(row: MessageRow, words: readonly string[]): boolean {
  const all = `${row[0]} ${Number(row[0].slice(1))} ${row[2]} ${row[3]}`.toLowerCase();
  return words.every((word) => all.includes(word));
}

/** Faults and alarms of an axis, or of the control unit (@param place 0), that have all words of @param text. */
export function findMessages(text: string, place: number, most: number): MessageRow[] {
  const words = text.toLowerCase().split(/\s+/).filter((word) => word !== "");
  const other = place === 0 ? "axis" : "unit";
  return kMessages.filter((row) => row[1] !== other && fits(row, words)).slice(0, most);
}
