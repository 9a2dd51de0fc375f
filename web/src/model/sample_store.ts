import type { SampleBatch } from "../source/types";
import { kAnew } from "./frame_store";
import { SampleBlocks } from "./sample_blocks";

/** Name and unit of a signal. */
export interface SignalHead {
  signal: string;
  unit?: string | undefined;
  text?: string | undefined;
}

/** A time, then a row of values a signal, as uPlot takes them; null: a gap. */
export type AlignedData = [number[], ...(number | null)[][]];

/** A sample with its time. */
export interface SampleRow {
  t: number;
  values: (number | null)[];
}

/** AlignedData in the making. */
interface Rows {
  t: number[];
  values: (number | null)[][];
}

/** More samples a pixel than this are drawn as the lowest and the highest of them. */
const kMostPerPixel = 4;

function valueOf(value: number | undefined): number | null {
  return value === undefined || Number.isNaN(value) ? null : value;
}

/**
 * Values of up to 16 signals on one time, in a ring. A time that begins anew (the unit was switched off and on)
 * forgets what was before.
 */
export class SampleStore {
  private readonly ring: SampleBlocks;

  /** @param capacity most samples that are kept (600 000: 10 minutes each ms); @param gapS longer times between two samples are gaps. */
  constructor(
    readonly signals: readonly SignalHead[],
    readonly capacity = 600_000,
    readonly gapS = Infinity,
  ) {
    this.ring = new SampleBlocks(signals.length, capacity);
  }

  get size(): number {
    return this.ring.end - this.ring.begin;
  }
  /** Time of the oldest sample (s); NaN without any. */
  get from(): number {
    return this.size === 0 ? NaN : this.ring.timeOf(this.ring.begin);
  }
  /** Time of the newest sample (s); NaN without any. */
  get to(): number {
    return this.size === 0 ? NaN : this.ring.timeOf(this.ring.end - 1);
  }

  append(t: number, values: readonly (number | null)[]): void {
    if (t < this.to - kAnew) this.clear();
    if (t <= this.to) return;
    const at = this.ring.next(t);
    for (let i = 0; i < this.signals.length; ++i) this.ring.put(at, i, values[i] ?? NaN);
    this.ring.close();
  }

  /** Appends what samples.subscribe has sent. */
  appendBatch(batch: SampleBatch): void {
    batch.t.forEach((t, i) => {
      if (t < this.to - kAnew) this.clear();
      if (t <= this.to) return;
      const at = this.ring.next(t);
      for (let row = 0; row < this.signals.length; ++row) this.ring.put(at, row, batch.values[row]?.[i] ?? NaN);
      this.ring.close();
    });
  }

  clear(): void {
    this.ring.clear();
  }

  /**
   * The samples in [from, to] and one on each side; where there are too many for a pixel its lowest and highest.
   * @param pixels width of the picture.
   */
  window(from: number, to: number, pixels: number): AlignedData {
    const begin = Math.max(this.ring.at(from) - 1, this.ring.begin);
    const end = Math.min(this.ring.after(to) + 1, this.ring.end);
    const data: Rows = { t: [], values: this.signals.map(() => []) };
    if (end - begin <= kMostPerPixel * Math.max(pixels, 1)) this.addAll(data, begin, end);
    else this.addExtremes(data, begin, end, (to - from) / pixels);
    return [data.t, ...data.values];
  }

  /** Each signal at @param t: its newest value not after it; null: none. */
  valuesAt(t: number): (number | null)[] {
    const serial = this.ring.after(t) - 1;
    const isThere = serial >= this.ring.begin && t - this.ring.timeOf(serial) <= this.gapS;
    return this.signals.map((_, i) => (isThere ? valueOf(this.ring.valueOf(serial, i)) : null));
  }

  /** All samples in [from, to], one after the other. */
  *rows(from: number, to: number): Generator<SampleRow> {
    const end = this.ring.after(to);
    for (let serial = this.ring.at(from); serial < end; ++serial)
      yield {
        t: this.ring.timeOf(serial),
        values: this.signals.map((_, i) => valueOf(this.ring.valueOf(serial, i))),
      };
  }

  private addGap(data: Rows, from: number, to: number): void {
    if (!(to - from > this.gapS)) return;
    data.t.push((from + to) / 2);
    for (let i = 0; i < this.signals.length; ++i) data.values[i]?.push(null);
  }

  private addAll(data: Rows, begin: number, end: number): void {
    for (let serial = begin; serial < end; ++serial) {
      const t = this.ring.timeOf(serial);
      if (serial > begin) this.addGap(data, this.ring.timeOf(serial - 1), t);
      data.t.push(t);
      for (let i = 0; i < this.signals.length; ++i) data.values[i]?.push(valueOf(this.ring.valueOf(serial, i)));
    }
  }

  /** Two rows for each part of @param width s with samples; the parts begin at multiples of it, so that a picture that moves is steady. */
  private addExtremes(data: Rows, begin: number, end: number, width: number): void {
    const { ring } = this;
    for (let serial = begin; serial < end; ) {
      const first = ring.timeOf(serial);
      const limit = (Math.floor(first / width) + 1) * width;
      const next = Math.max(ring.at(limit, serial, end), serial + 1);
      if (serial > begin) this.addGap(data, ring.timeOf(serial - 1), first);
      data.t.push(first);
      if (next > serial + 1) data.t.push(ring.timeOf(next - 1));
      for (let i = 0; i < this.signals.length; ++i) {
        const pair = ring.extremes(i, serial, next);
        data.values[i]?.push(valueOf(pair[0]));
        if (next > serial + 1) data.values[i]?.push(valueOf(pair[1]));
      }
      serial = next;
    }
  }
}
