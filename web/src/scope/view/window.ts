/** What of the time is shown. */
export interface TimeWindow {
  /** Whether its right edge goes with the newest data. */
  follows: boolean;
  /** Its length (s). */
  span: number;
  /** Its right edge (s since the start of the unit), if it does not follow. */
  to: number;
}

export interface Range {
  from: number;
  to: number;
}

/** Lengths that are offered (s). */
export const kSpans = [1, 2, 5, 10, 30, 60] as const;
/** Shortest and longest length (s). */
export const kShortest = 20e-6;
export const kLongest = 3600;

const limited = (span: number): number => Math.min(kLongest, Math.max(kShortest, span));

/** The times that are shown; @param end is the newest. */
export function rangeOf(window: TimeWindow, end: number): Range {
  const to = window.follows ? end : window.to;
  return { from: to - window.span, to };
}

/** Goes by @param by s; who looks elsewhere no longer follows. */
export function panned(window: TimeWindow, by: number, end: number): TimeWindow {
  return { ...window, follows: false, to: rangeOf(window, end).to + by };
}

/** Shows @param factor times as much; the instant @param about stays at its place, unless the window follows. */
export function zoomed(window: TimeWindow, factor: number, about: number, end: number): TimeWindow {
  const span = limited(window.span * factor);
  if (window.follows) return { ...window, span };
  const share = (rangeOf(window, end).to - about) / window.span;
  return { ...window, span, to: about + share * span };
}

/** Shows just @param range. */
export function showing(range: Range): TimeWindow {
  const span = limited(range.to - range.from);
  return { follows: false, span, to: (range.from + range.to) / 2 + span / 2 };
}

/** Shows @param t in the middle. */
export function around(window: TimeWindow, t: number, span = window.span): TimeWindow {
  return { follows: false, span: limited(span), to: t + limited(span) / 2 };
}

/** Stands still where it is, or follows again. */
export function paused(window: TimeWindow, isPaused: boolean, end: number): TimeWindow {
  return { ...window, follows: !isPaused, to: rangeOf(window, end).to };
}

/** @param t within @param range. */
export function within(t: number, range: Range): number {
  return Math.min(range.to, Math.max(range.from, t));
}
