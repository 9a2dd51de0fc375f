import { Refusal, wordsOf } from "../../source/refusal";
import { rangeText, whenWords } from "./value_text";

interface Limits {
  minimum?: number;
  maximum?: number;
  unit?: string;
}

/** What is said beside a field of a write that was refused: the message, and what holds. */
export function refusalLines(error: unknown): string[] {
  if (!(error instanceof Refusal)) return [wordsOf(error)];
  const { limits, when, abort_code: code, abort_text: text } = error.details;
  const lines = [sentence(error.message)];
  if (limits !== undefined) lines.push(limitsLine(limits as Limits));
  if (typeof when === "string") lines.push(`It can be written ${whenWords(when)}.`);
  if (typeof code === "number") {
    const told = typeof text === "string" ? `: ${text}` : "";
    lines.push(`SDO abort code ${code.toString(16).toUpperCase().padStart(8, "0")}h${told}.`);
  }
  return lines;
}

function limitsLine({ minimum, maximum, unit }: Limits): string {
  const told = unit === undefined || unit === "" ? "" : `\u2009${unit}`;
  return `It takes ${rangeText(minimum, maximum)}${told}.`;
}

function sentence(text: string): string {
  return /[.!?]$/.test(text) ? text : `${text}.`;
}
