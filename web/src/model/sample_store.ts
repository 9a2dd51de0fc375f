import type { SampleBatch } from "../source/types";

/** Name and unit of a signal. */
export interface SignalHead {
  signal: string;
  unit?: string | undefined;
  text?: string | undefined;
}

/** A time, then a row of values a signal, as uPlot takes them; null: a gap. */
export type AlignedData = [number[], ...(number | null)[][]];

/** Values of up to 16 signals on one time, in a ring. */
export class SampleStore {
  /** @param capacity most samples that are kept (600 000: 10 minutes each ms); @param gapS longer times between two samples are gaps. */
  constructor(
    readonly signals: readonly SignalHead[],
    readonly capacity = 600_000,
    readonly gapS = Infinity,
  ) {}

  get size(): number {
    return 0;
  }
  /** Time of the oldest and of the newest sample (s); NaN without any. */
  get from(): number {
    return NaN;
  }
  get to(): number {
    return NaN;
  }

  append(t: number, values: readonly (number | null)[]): void {
    void t;
    void values;
  }
  /** Appends what samples.subscribe has sent. */
  appendBatch(batch: SampleBatch): void {
    void batch;
  }
  clear(): void {}

  /**
   * The samples in [from, to] and one on each side, at most 2 a pixel and signal: of a pixel with more the lowest and the highest.
   * @param pixels width of the picture.
   */
  window(from: number, to: number, pixels: number): AlignedData {
    void from;
    void to;
    void pixels;
    return [[]];
  }
  /** Each signal at @param t: its newest value not after it; null: none. */
  valuesAt(t: number): (number | null)[] {
    void t;
    return [];
  }
  /** All samples in [from, to], one after the other. */
  rows(from: number, to: number): Iterable<{ t: number; values: (number | null)[] }> {
    void from;
    void to;
    return [];
  }
}
