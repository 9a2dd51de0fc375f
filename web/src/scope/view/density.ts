import { kLaneCount } from "../../canopen/services";
import type { FrameStore } from "../../model/frame_store";

/** Counts of frames in equal parts of the time, which begin at multiples of their length: they go with the picture. */
export interface Bins {
  /** Beginning of the first one (s). */
  from: number;
  /** Length of each (s). */
  length: number;
  count: number;
  /** counts[lane * count + bin] */
  counts: Uint32Array;
}

/** Counts frames for a picture that moves: what was counted is not counted again. */
export class Density {
  private bins: Bins | undefined;
  private first = 0;
  /** Up to here all frames had come when they were counted (s). */
  private sure = -Infinity;
  private source: FrameStore | undefined;

  /** Counts for [from, to) at @param pixels parts. */
  of(frames: FrameStore, from: number, to: number, pixels: number): Bins {
    const length = (to - from) / pixels;
    const begin = Math.floor(from / length + 1e-6);
    const count = pixels + 2;
    const old = this.bins;
    const isSame = old !== undefined && this.source === frames && old.count === count && Math.abs(old.length / length - 1) < 1e-9;
    const bins = { from: begin * length, length, count, counts: new Uint32Array(kLaneCount * count) };
    const shift = begin - this.first;
    const kept = isSame && shift >= 0 ? Math.min(count, Math.floor((this.sure - bins.from) / length)) : 0;
    if (old !== undefined && kept > 0 && kept + shift <= count) this.take(old, bins, shift, kept);
    this.count(frames, bins, kept > 0 && kept + shift <= count ? kept : 0);
    this.bins = bins;
    this.first = begin;
    this.source = frames;
    this.sure = Number.isNaN(frames.to) ? -Infinity : Math.min(frames.to, bins.from + count * length);
    return bins;
  }

  /** All is counted anew: frames have come to other lanes. */
  forget(): void {
    this.bins = undefined;
  }

  private take(old: Bins, bins: Bins, shift: number, kept: number): void {
    for (let lane = 0; lane < kLaneCount; ++lane) {
      const begin = lane * old.count + shift;
      bins.counts.set(old.counts.subarray(begin, begin + kept), lane * bins.count);
    }
  }

  private count(frames: FrameStore, bins: Bins, begin: number): void {
    const rest = bins.count - begin;
    if (rest <= 0) return;
    const from = bins.from + begin * bins.length;
    const counts = frames.density(from, bins.from + bins.count * bins.length, rest);
    for (let lane = 0; lane < kLaneCount; ++lane)
      bins.counts.set(counts.subarray(lane * rest, lane * rest + rest), lane * bins.count + begin);
  }
}
