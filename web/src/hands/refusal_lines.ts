import { Refusal, wordsOf } from "../source/refusal";

interface Limits {
  low?: number;
  high?: number;
  minimum?: number;
  maximum?: number;
}

function limitsLine(limits: Limits): string {
  const low = limits.low ?? limits.minimum;
  const high = limits.high ?? limits.maximum;
  if (low !== undefined && high !== undefined) return `It takes ${low} to ${high}.`;
  return low === undefined ? `It takes ${high ?? "?"} at most.` : `It takes ${low} at least.`;
}

function sentence(text: string): string {
  return /[.!?]$/.test(text) ? text : `${text}.`;
}

/** Why something was not done, beside what was to do it: the message, and what would be taken. */
export function refusalLines(error: unknown): string[] {
  const lines = [sentence(wordsOf(error))];
  if (error instanceof Refusal && error.details["limits"] !== undefined) lines.push(limitsLine(error.details["limits"] as Limits));
  return lines;
}
