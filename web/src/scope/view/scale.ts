/** Steps of a scale, within a power of ten. */
const kSteps = [1, 2, 5, 10] as const;

/** The smallest of 1, 2, 5, 10, 20... that is not below @param least. */
export function niceStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  const factor = kSteps.find((step) => step * power >= least * (1 - 1e-9)) ?? 10;
  return factor * power;
}

/** Round values in [from, to], at most about @param most. */
export function ticksOf(from: number, to: number, most: number): number[] {
  if (!(to > from) || most < 1) return [];
  const step = niceStep((to - from) / most);
  const ticks: number[] = [];
  for (let i = Math.ceil(from / step - 1e-9); i * step <= to + step * 1e-9; ++i) ticks.push(i * step);
  return ticks;
}

/** Decimals that tell values @param step apart from each other. */
export function decimalsOf(step: number): number {
  return Math.max(0, Math.min(9, -Math.floor(Math.log10(step) + 1e-9)));
}

/** An instant (s since the start of the unit) on a scale whose smallest difference is @param step: 12.345 s, 3:12.5. */
export function instantText(t: number, step: number): string {
  const decimals = decimalsOf(step);
  if (Math.abs(t) < 120) return `${t.toFixed(decimals)}\u2009s`;
  const sign = t < 0 ? "-" : "";
  const whole = Number(Math.abs(t).toFixed(decimals));
  const hours = Math.floor(whole / 3600);
  const minutes = Math.floor((whole % 3600) / 60);
  const seconds = (whole % 60).toFixed(decimals).padStart(decimals === 0 ? 2 : decimals + 3, "0");
  const head = hours > 0 ? `${hours}:${String(minutes).padStart(2, "0")}` : String(minutes);
  return `${sign}${head}:${seconds}`;
}

/** Prefixes of a difference of time. */
const kPrefixes = [
  { below: 1e-3, factor: 1e6, unit: "µs" },
  { below: 1, factor: 1e3, unit: "ms" },
  { below: Infinity, factor: 1, unit: "s" },
] as const;

/** A difference of two instants: 250 µs, 12.35 ms, 3.2 s. */
export function differenceText(seconds: number): string {
  const row = kPrefixes.find(({ below }) => Math.abs(seconds) < below) ?? kPrefixes[2];
  return `${Number((seconds * row.factor).toPrecision(5))}\u2009${row.unit}`;
}

/** Limits of a vertical scale that do not jump with every value: they widen at once, and narrow when less than half is used. */
export class StickyRange {
  private low = NaN;
  private high = NaN;

  /** The limits for values from @param min to @param max. */
  next(min: number, max: number): [number, number] {
    if (!Number.isFinite(min) || !Number.isFinite(max)) return [this.low, this.high].map((x, i) => (Number.isNaN(x) ? i : x)) as [number, number];
    const fits = min >= this.low && max <= this.high && max - min >= (this.high - this.low) * 0.45;
    const isFlat = min >= this.low && max <= this.high && max - min < 1e-9 * Math.max(1, Math.abs(max)) && this.high - this.low <= 4 * Math.max(1, Math.abs(max));
    if (!fits && !isFlat) [this.low, this.high] = roomy(min, max);
    return [this.low, this.high];
  }
}

/** Round limits with some room around [min, max]. */
export function roomy(min: number, max: number): [number, number] {
  const length = max - min;
  const room = length > 1e-9 * Math.max(1, Math.abs(max)) ? length * 0.08 : Math.max(0.5, Math.abs(max) * 0.1);
  const step = niceStep((length + 2 * room) / 10);
  return [Math.floor((min - room) / step) * step, Math.ceil((max + room) / step) * step];
}
