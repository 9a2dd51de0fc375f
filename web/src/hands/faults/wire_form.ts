import type { InjectKind } from "../../source/types";

/** A field of the form. */
export interface WireField {
  key: string;
  expected: string;
  summary: string;
  required: boolean;
  /** What holds while it is empty. */
  absent: string;
}

/** When it acts; the same for every kind. */
const kWhen: readonly WireField[] = [
  { key: "after", expected: "a whole number", summary: "so many events pass first", required: false, absent: "none" },
  { key: "times", expected: "a whole number", summary: "so many hits, then it is over", required: false, absent: "every one" },
  { key: "every", expected: "a whole number", summary: "every Nth opportunity", required: false, absent: "each" },
  { key: "probability", expected: "0 to 1", summary: "of a hit", required: false, absent: "1" },
  { key: "while", expected: "operational, operation-enabled, ...", summary: "only in this state of the node or the axis", required: false, absent: "in all" },
  { key: "until", expected: "10 heartbeat, ...", summary: "over after so many healthy events", required: false, absent: "never" },
  { key: "for_ms", expected: "ms", summary: "over after so long", required: false, absent: "for ever" },
];

/** The fields of @param kind: its own arguments first, then when it acts. */
export function fieldsOf(kind: InjectKind): { own: WireField[]; when: readonly WireField[] } {
  return { own: kind.arguments.map((argument) => ({ ...argument, absent: argument.absent ?? "" })), when: kWhen };
}

function valueOf(text: string): string | number {
  const number = Number(text);
  return /^0x/i.test(text) || Number.isNaN(number) ? text : number;
}

/** What is sent: numbers as numbers, hexadecimal ones and words as text; empty fields are left out. */
export function bodyOf(kind: string, texts: Readonly<Record<string, string>>): Record<string, string | number> {
  const body: Record<string, string | number> = { kind };
  for (const [key, text] of Object.entries(texts)) if (text.trim() !== "") body[key] = valueOf(text.trim());
  return body;
}

/** The required fields of @param kind that are empty. */
export function missingOf(kind: InjectKind, texts: Readonly<Record<string, string>>): string[] {
  return kind.arguments.filter((argument) => argument.required && (texts[argument.key] ?? "").trim() === "").map((argument) => argument.key);
}

/** A fault as it was given, in words: "sdo.late: delay_ms 500, object 0x6040". */
export function faultWords(fault: Readonly<Record<string, unknown>>): string {
  const words = Object.entries(fault).filter(([key]) => key !== "kind");
  return words.map(([key, value]) => `${key} ${String(value)}`).join(", ");
}
