import type { CanFrame } from "../canopen/frame";

/** Frames of a unit in the order of their time, as columns in a ring. A frame has a serial number, which stays. */
export class FrameStore {
  /** @param laneOf number of the lane of an identifier (ServiceMap.laneOf); @param capacity most frames that are kept. */
  constructor(
    readonly laneOf: (id: number, isExtended: boolean) => number,
    readonly capacity = 1_000_000,
  ) {}

  /** Serial number of the oldest frame that is kept. */
  get first(): number {
    return 0;
  }
  /** Serial number of the next frame that comes: one more than the newest. */
  get next(): number {
    return 0;
  }
  /** Frames that are kept. */
  get size(): number {
    return this.next - this.first;
  }
  /** Time of the oldest and of the newest frame (s); NaN without any. */
  get from(): number {
    return NaN;
  }
  get to(): number {
    return NaN;
  }

  /** Appends "12.345678 R 205#0F00" as frames.subscribe has them. Returns how many lines could not be read. */
  appendLines(lines: readonly string[]): number {
    return lines.length;
  }
  append(frame: CanFrame): void {
    void frame;
  }
  clear(): void {}
  /** Sorts all frames into lanes again, after the identifiers have become others. */
  relane(laneOf: (id: number, isExtended: boolean) => number): void {
    void laneOf;
  }

  /** The frame @param serial; undefined: it is no longer kept. */
  frame(serial: number): CanFrame | undefined {
    void serial;
    return undefined;
  }
  timeOf(serial: number): number {
    return serial;
  }
  idOf(serial: number): number {
    return serial;
  }
  laneAt(serial: number): number {
    return serial;
  }
  /** Serial number of the first frame not before @param t. */
  at(t: number): number {
    return t;
  }
  /** Serial numbers [begin, end) of the frames in [from, to). */
  range(from: number, to: number): [number, number] {
    return [from, to];
  }
  /**
   * How many frames there are in each of @param bins equal parts of [from, to), lane by lane:
   * counts[lane * bins + bin]. @param into is taken if it is long enough.
   */
  density(from: number, to: number, bins: number, into?: Uint32Array): Uint32Array {
    return into ?? new Uint32Array(from + to + bins);
  }
  /** Serial number of the frame of @param lane that is the nearest to @param t, at most @param within s away. */
  nearest(t: number, lane: number, within: number): number | undefined {
    return t + lane + within;
  }
}
