import { kExtended, kRemote, kSent, type CanFrame } from "../canopen/frame";
import { kLaneCount } from "../canopen/services";
import { parseLine, type LineFields } from "./frame_line";

/** Frames whose lanes are counted together, for the density of long times. */
const kBlock = 64;

/** The part of the columns that is reserved first; they double until the capacity is reached. */
const kFirstRoom = 4096;

/** A time that is so much before the newest one (s) begins anew: the unit was switched off and on. */
export const kAnew = 1;

const kNothing = { t: 0, flags: 0, id: 0, length: 0 };

/**
 * Frames of a unit in the order of their time, as columns in a ring. A frame has a serial number, which stays.
 * A time that begins anew forgets what was before.
 */
export class FrameStore {
  private room = 0;
  private begin = 0;
  private end = 0;
  private t = new Float64Array(0);
  private id = new Uint32Array(0);
  private flags = new Uint8Array(0);
  private length = new Uint8Array(0);
  private lane = new Uint8Array(0);
  private data = new Uint8Array(0);
  /** Of each whole block how many frames of each lane it has. */
  private counts = new Uint8Array(0);
  private readonly fields: LineFields = { ...kNothing, data: new Uint8Array(8) };
  readonly capacity: number;

  /** @param laneOf number of the lane of an identifier (ServiceMap.laneOf); @param capacity most frames that are kept. */
  constructor(
    private laneOf: (id: number, isExtended: boolean) => number,
    capacity = 1_000_000,
  ) {
    this.capacity = Math.ceil(Math.max(capacity, 1) / kBlock) * kBlock;
  }

  /** Serial number of the oldest frame that is kept. */
  get first(): number {
    return this.begin;
  }
  /** Serial number of the next frame that comes: one more than the newest. */
  get next(): number {
    return this.end;
  }
  /** Frames that are kept. */
  get size(): number {
    return this.end - this.begin;
  }
  /** Time of the oldest frame (s); NaN without any. */
  get from(): number {
    return this.timeOf(this.begin);
  }
  /** Time of the newest frame (s); NaN without any. */
  get to(): number {
    return this.timeOf(this.end - 1);
  }

  /** Appends "12.345678 R 205#0F00" as frames.subscribe has them. Returns how many lines could not be read. */
  appendLines(lines: readonly string[]): number {
    let bad = 0;
    for (const line of lines) {
      if (parseLine(line, this.fields)) this.put(this.fields);
      else ++bad;
    }
    return bad;
  }

  append(frame: CanFrame): void {
    const { fields } = this;
    fields.t = frame.t;
    fields.flags = (frame.sent ? kSent : 0) | (frame.isRemote ? kRemote : 0) | (frame.isExtended ? kExtended : 0);
    fields.id = frame.id;
    fields.length = frame.length;
    fields.data.fill(0);
    fields.data.set(frame.data.subarray(0, 8));
    this.put(fields);
  }

  /** Forgets all frames; serial numbers go on. */
  clear(): void {
    this.begin = this.end = Math.ceil(this.end / kBlock) * kBlock;
  }

  /** Sorts all frames into lanes again, after the identifiers have become others. */
  relane(laneOf: (id: number, isExtended: boolean) => number): void {
    this.laneOf = laneOf;
    for (let serial = this.begin; serial < this.end; ++serial) {
      const at = serial % this.room;
      this.lane[at] = laneOf(this.id[at] ?? 0, ((this.flags[at] ?? 0) & kExtended) !== 0);
      if (serial % kBlock === kBlock - 1) this.count(serial);
    }
  }

  /** The frame @param serial; undefined: it is not kept. */
  frame(serial: number): CanFrame | undefined {
    if (!this.has(serial)) return undefined;
    const at = serial % this.room;
    const flags = this.flags[at] ?? 0;
    const length = this.length[at] ?? 0;
    const isRemote = (flags & kRemote) !== 0;
    return {
      t: this.t[at] ?? NaN,
      sent: (flags & kSent) !== 0,
      isRemote,
      isExtended: (flags & kExtended) !== 0,
      id: this.id[at] ?? 0,
      length,
      data: this.data.slice(8 * at, 8 * at + (isRemote ? 0 : Math.min(length, 8))),
    };
  }
  /** Time of the frame @param serial (s); NaN: it is not kept. */
  timeOf(serial: number): number {
    return this.has(serial) ? (this.t[serial % this.room] ?? NaN) : NaN;
  }
  /** Identifier of the frame @param serial; -1: it is not kept. */
  idOf(serial: number): number {
    return this.has(serial) ? (this.id[serial % this.room] ?? -1) : -1;
  }
  /** Number of its lane; -1: it is not kept. */
  laneAt(serial: number): number {
    return this.has(serial) ? (this.lane[serial % this.room] ?? -1) : -1;
  }

  /** Serial number of the first frame not before @param t. */
  at(t: number): number {
    let low = this.begin;
    let high = this.end;
    while (low < high) {
      const middle = Math.floor((low + high) / 2);
      if ((this.t[middle % this.room] ?? 0) < t) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** Serial numbers [begin, end) of the frames in [from, to). */
  range(from: number, to: number): [number, number] {
    const begin = this.at(from);
    return [begin, Math.max(begin, this.at(to))];
  }

  /**
   * How many frames there are in each of @param bins equal parts of [from, to), lane by lane:
   * counts[lane * bins + bin]. @param into is taken if it is long enough.
   */
  density(from: number, to: number, bins: number, into?: Uint32Array): Uint32Array {
    const size = kLaneCount * bins;
    const counts = into !== undefined && into.length >= size ? into : new Uint32Array(size);
    counts.fill(0);
    const width = (to - from) / bins;
    const [begin, end] = this.range(from, to);
    const { t, lane, room } = this;
    let bin = 0;
    let limit = from + width;
    for (let serial = begin, at = begin % room; serial < end; ) {
      while (bin < bins - 1 && (t[at] ?? 0) >= limit) limit = from + (++bin + 1) * width;
      const isWhole = at % kBlock === 0 && serial + kBlock <= end && ((t[at + kBlock - 1] ?? 0) < limit || bin === bins - 1);
      if (isWhole) {
        this.addBlock(at, counts, bin, bins);
      } else {
        const place = (lane[at] ?? 0) * bins + bin;
        counts[place] = (counts[place] ?? 0) + 1;
      }
      const step = isWhole ? kBlock : 1;
      serial += step;
      at = at + step === room ? 0 : at + step;
    }
    return counts;
  }

  /** Serial number of the frame of @param lane that is the nearest to @param t, at most @param within s away. */
  nearest(t: number, lane: number, within: number): number | undefined {
    let found: number | undefined;
    let distance = within;
    const look = (serial: number): boolean => {
      const away = Math.abs(this.timeOf(serial) - t);
      if (!(away <= distance)) return true;
      if (this.laneAt(serial) !== lane) return false;
      found = serial;
      distance = away;
      return true;
    };
    const middle = this.at(t);
    for (let serial = middle; serial < this.end; ++serial) if (look(serial)) break;
    for (let serial = middle - 1; serial >= this.begin; --serial) if (look(serial)) break;
    return found;
  }

  private has(serial: number): boolean {
    return serial >= this.begin && serial < this.end;
  }

  /** Adds what was counted of the block at place @param at. */
  private addBlock(at: number, counts: Uint32Array, bin: number, bins: number): void {
    const block = (at / kBlock) * kLaneCount;
    for (let lane = 0; lane < kLaneCount; ++lane) {
      const count = this.counts[block + lane] ?? 0;
      if (count > 0) counts[lane * bins + bin] = (counts[lane * bins + bin] ?? 0) + count;
    }
  }

  private put(fields: LineFields): void {
    if (fields.t < this.to - kAnew) this.clear();
    if (this.end - this.begin >= this.room) this.makeRoom();
    const at = this.end % this.room;
    const newest = this.end > this.begin ? (this.t[(this.end - 1) % this.room] ?? 0) : fields.t;
    this.t[at] = Math.max(fields.t, newest);
    this.id[at] = fields.id;
    this.flags[at] = fields.flags;
    this.length[at] = fields.length;
    this.lane[at] = this.laneOf(fields.id, (fields.flags & kExtended) !== 0);
    for (let i = 0; i < 8; ++i) this.data[8 * at + i] = fields.data[i] ?? 0;
    ++this.end;
    if (this.end % kBlock === 0) this.count(this.end - 1);
  }

  /** Counts the block that ends with @param last. */
  private count(last: number): void {
    const at = (last % this.room) - kBlock + 1;
    const block = (at / kBlock) * kLaneCount;
    this.counts.fill(0, block, block + kLaneCount);
    for (let i = at; i < at + kBlock; ++i) {
      const place = block + (this.lane[i] ?? 0);
      this.counts[place] = (this.counts[place] ?? 0) + 1;
    }
  }

  /** More columns, or a block of the oldest frames less. */
  private makeRoom(): void {
    if (this.room === this.capacity) {
      this.begin = Math.floor(this.begin / kBlock) * kBlock + kBlock;
      return;
    }
    const was = { ...this.columns(), room: this.room };
    this.room = Math.min(this.capacity, Math.max(kFirstRoom, 2 * this.room));
    this.t = new Float64Array(this.room);
    this.id = new Uint32Array(this.room);
    this.flags = new Uint8Array(this.room);
    this.length = new Uint8Array(this.room);
    this.lane = new Uint8Array(this.room);
    this.data = new Uint8Array(8 * this.room);
    this.counts = new Uint8Array((this.room / kBlock) * kLaneCount);
    const now = this.columns();
    for (let serial = this.begin; serial < this.end; ) {
      const from = serial % was.room;
      const to = serial % this.room;
      const count = Math.min(this.end - serial, was.room - from, this.room - to);
      now.t.set(was.t.subarray(from, from + count), to);
      now.id.set(was.id.subarray(from, from + count), to);
      now.flags.set(was.flags.subarray(from, from + count), to);
      now.length.set(was.length.subarray(from, from + count), to);
      now.lane.set(was.lane.subarray(from, from + count), to);
      now.data.set(was.data.subarray(8 * from, 8 * (from + count)), 8 * to);
      serial += count;
    }
    this.recount();
  }

  private recount(): void {
    const first = Math.ceil(this.begin / kBlock) * kBlock;
    for (let serial = first; serial + kBlock <= this.end; serial += kBlock) this.count(serial + kBlock - 1);
  }

  private columns() {
    return { t: this.t, id: this.id, flags: this.flags, length: this.length, lane: this.lane, data: this.data };
  }
}
