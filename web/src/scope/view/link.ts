import { kLongest, kShortest } from "./window";

/** Periods at which samples can be taken (ms). */
export const kPeriods = [1, 2, 4, 10, 100] as const;
/** Most signals of a picture. */
export const kMostSignals = 8;

/** What the address of the scope says; what it does not say is undefined. */
export interface ScopeLink {
  signals?: string[];
  periodMs?: number;
  /** Length of the window (s). */
  span?: number;
  /** Right edge of a window that stands still (s since the start of the unit). */
  to?: number;
  isPaused?: boolean;
  a?: number;
  b?: number;
  /** Number of a result of the unit's trace. */
  result?: number;
  /** Name of a recording of the session. */
  recording?: string;
  /** A fault or alarm whose cause is wanted: place (0 = control unit, 1.. = axis, infeed) and number. */
  fault?: { place: number | "infeed"; number: number };
}

const kNumber = /^-?\d{1,10}(\.\d{1,9})?$/;
const kSignal = /^[\w./[\]]{1,64}$/;
const kFault = /^(\d|infeed)\.(\d{1,5})$/;

function numberIn(text: string, low: number, high: number): number | undefined {
  const value = kNumber.test(text) ? Number(text) : NaN;
  return value >= low && value <= high ? value : undefined;
}

function signalsIn(text: string): string[] | undefined {
  const names = text === "" ? [] : text.split(",");
  const isGood = names.length <= kMostSignals && names.every((name) => kSignal.test(name)) && new Set(names).size === names.length;
  return isGood ? names : undefined;
}

function wholeIn(text: string, high: number): number | undefined {
  const value = numberIn(text, 1, high);
  return Number.isInteger(value) ? value : undefined;
}

function periodIn(text: string): number | undefined {
  return kPeriods.find((period) => String(period) === text);
}

function faultIn(text: string): ScopeLink["fault"] | undefined {
  const [, place, number] = kFault.exec(text) ?? [];
  if (place === undefined || number === undefined) return undefined;
  return { place: place === "infeed" ? place : Number(place), number: Number(number) };
}

const kLatest = 1e9;

/** A row a word of the address: how it is read, and how it is written. */
const kWords: { [Key in keyof Required<ScopeLink>]: Word<Required<ScopeLink>[Key]> } = {
  signals: { word: "signals", read: signalsIn, write: (names) => names.join(",") },
  periodMs: { word: "period", read: periodIn, write: String },
  span: { word: "span", read: (text) => numberIn(text, kShortest, kLongest), write: shortText },
  to: { word: "to", read: (text) => numberIn(text, -kLatest, kLatest), write: shortText },
  isPaused: { word: "paused", read: (text) => (text === "1" ? true : undefined), write: (value) => (value ? "1" : "") },
  a: { word: "a", read: (text) => numberIn(text, -kLatest, kLatest), write: shortText },
  b: { word: "b", read: (text) => numberIn(text, -kLatest, kLatest), write: shortText },
  result: { word: "result", read: (text) => wholeIn(text, 1e9), write: String },
  recording: { word: "recording", read: (text) => (/^[^/\\]{1,200}$/.test(text) ? text : undefined), write: String },
  fault: { word: "fault", read: faultIn, write: ({ place, number }) => `${place}.${number}` },
};

interface Word<Value> {
  word: string;
  read: (text: string) => Value | undefined;
  write: (value: Value) => string;
}

function shortText(value: number): string {
  return String(Number(value.toFixed(6)));
}

/** What @param query says, and the words in it that say nothing: they are left out, and the user is told. */
export function readLink(query: URLSearchParams): { link: ScopeLink; wrong: string[] } {
  const link: Record<string, unknown> = {};
  const wrong: string[] = [];
  for (const [word, text] of query) {
    const found = Object.entries(kWords).find(([, row]) => row.word === word);
    const value = found?.[1].read(text);
    if (found === undefined || value === undefined) wrong.push(`${word}=${text}`);
    else link[found[0]] = value;
  }
  return { link: link, wrong };
}

/** The words of an address that says @param link. */
export function writeLink(link: ScopeLink): URLSearchParams {
  const query = new URLSearchParams();
  for (const [key, row] of Object.entries(kWords) as [keyof ScopeLink, Word<unknown>][]) {
    const text = link[key] === undefined ? "" : row.write(link[key]);
    if (text !== "" || (key === "signals" && link.signals !== undefined)) query.set(row.word, text);
  }
  return query;
}
