import { kExtended, kRemote, kSent, type CanFrame } from "../canopen/frame";
import { Refusal, wordsOf } from "../source/refusal";
import type { UnitEvent } from "../source/types";
import { eventIn } from "./axrec_event";
import { crc32 } from "./crc32";
import type { RecordingHead } from "./recording";

/** Format of docs/reference/recording.md. */
const kMagic = "AXISREC\n";
const kVersion = 1;
const kHeadBytes = 16;
const kRecordHeadBytes = 12;
const kChecksumBytes = 4;
const kLongestHead = 1 << 20;

/** Types of records. */
const kFrame = 1;
const kEvent = 2;
const kSamples = 3;
const kLost = 4;
const kEnd = 5;

const kEndReasons = ["stopped, or the unit was switched off", "full", "the time after the fault is over"];

/** Who takes what stands in a file, record by record. */
export interface RecordTaker {
  frame(frame: CanFrame): void;
  event(event: UnitEvent): void;
  samples(t: number, values: number[]): void;
}

/** What is said of a file as a whole. */
export interface AxrecSummary {
  head: RecordingHead;
  /** Records that had no room. */
  lost: number;
  /** Time of the first and the last record; NaN without any. */
  from: number;
  to: number;
  /** Damaged or without an end: where. Empty: nothing. */
  remark: string;
}

/** Whether @param bytes begin as a recording. */
export function isAxrec(bytes: Uint8Array): boolean {
  return new TextDecoder().decode(bytes.subarray(0, kMagic.length)) === kMagic;
}

function refuse(name: string, what: string): Refusal {
  return new Refusal("damaged", `${name}: ${what}`);
}

function headOf(name: string, bytes: Uint8Array, view: DataView): { head: RecordingHead; first: number } {
  if (!isAxrec(bytes)) throw refuse(name, "no recording: it does not begin with AXISREC");
  const cut = refuse(name, `cut within its head, after ${bytes.length} bytes`);
  if (bytes.length < kHeadBytes) throw cut;
  const version = view.getUint16(8, true);
  if (version !== kVersion) throw refuse(name, `version ${version} of the format, this page reads ${kVersion}`);
  const length = view.getUint32(12, true);
  if (length > kLongestHead) throw refuse(name, `its head is damaged: byte 12 says that it has ${length} bytes`);
  const first = kHeadBytes + length + kChecksumBytes;
  if (bytes.length < first) throw cut;
  if (crc32(bytes, kHeadBytes, kHeadBytes + length) !== view.getUint32(kHeadBytes + length, true))
    throw refuse(name, `its head is damaged: the checksum at byte ${kHeadBytes + length} is wrong`);
  try {
    const text = new TextDecoder().decode(bytes.subarray(kHeadBytes, kHeadBytes + length));
    return { head: { signals: [], ...(JSON.parse(text) as Partial<RecordingHead>) } as RecordingHead, first };
  } catch (error) {
    throw refuse(name, `its head is no JSON: ${wordsOf(error)}`);
  }
}

function frameIn(content: Uint8Array, t: number): CanFrame | undefined {
  const [flags, length] = [content[0] ?? 0, content[1] ?? 255];
  const isRemote = (flags & kRemote) !== 0;
  if (length > 8 || content.length < 6 + (isRemote ? 0 : length)) return undefined;
  return {
    t,
    sent: (flags & kSent) !== 0,
    isRemote,
    isExtended: (flags & kExtended) !== 0,
    id: new DataView(content.buffer, content.byteOffset, content.length).getUint32(2, true),
    length,
    data: content.slice(6, 6 + (isRemote ? 0 : length)),
  };
}

function realsIn(content: Uint8Array): number[] {
  const view = new DataView(content.buffer, content.byteOffset, content.length);
  return Array.from({ length: Math.floor(content.length / 8) }, (_, i) => view.getFloat64(8 * i, true));
}

/** A whole record, or why there is none. */
interface RecordAt {
  type: number;
  t: number;
  content: Uint8Array;
  next: number;
}

function recordAt(bytes: Uint8Array, view: DataView, at: number): RecordAt | string {
  if (at + kRecordHeadBytes > bytes.length) return "cut";
  const begin = at + kRecordHeadBytes;
  const end = begin + view.getUint16(at + 2, true);
  if (end + kChecksumBytes > bytes.length) return "cut";
  if (crc32(bytes, at, end) !== view.getUint32(end, true)) return "damaged";
  const t = Number(view.getBigInt64(at + 4, true)) / 1e9;
  return { type: view.getUint16(at, true), t, content: bytes.subarray(begin, end), next: end + kChecksumBytes };
}

/** Reads records to the last whole one. */
class AxrecReader {
  private end = -1;
  lost = 0;
  from = NaN;
  to = NaN;

  constructor(
    private readonly taker: RecordTaker,
    private readonly unit: string,
  ) {}

  /** Takes all records from @param first on. Returns the remark. */
  read(bytes: Uint8Array, view: DataView, first: number): string {
    let at = first;
    while (at < bytes.length) {
      const record = recordAt(bytes, view, at);
      if (typeof record === "string") return this.damage(record, at, bytes.length);
      this.take(record);
      at = record.next;
    }
    return this.end < 0 ? `it has no end: the unit was still writing, or was ended${this.until()}` : "";
  }

  get endText(): string {
    return kEndReasons[this.end] ?? "";
  }

  private until(): string {
    return Number.isNaN(this.to) ? "" : `; the last record is at ${this.to.toFixed(6)} s`;
  }

  private damage(how: string, at: number, size: number): string {
    return `${how} at byte ${at} of ${size}: what is behind it was left out${this.until()}`;
  }

  private take({ type, t, content }: RecordAt): void {
    if (Number.isNaN(this.from)) this.from = t;
    this.to = t;
    const view = new DataView(content.buffer, content.byteOffset, content.length);
    if (type === kFrame) {
      const frame = frameIn(content, t);
      if (frame !== undefined) this.taker.frame(frame);
    } else if (type === kEvent) {
      const event = eventIn(content, t, this.unit);
      if (event !== undefined) this.taker.event(event);
    } else if (type === kSamples) {
      this.taker.samples(t, realsIn(content));
    } else if (type === kLost && content.length >= 8) {
      this.lost += Number(view.getBigUint64(0, true));
    } else if (type === kEnd && content.length >= 1) {
      this.end = view.getUint8(0);
    }
  }
}

/** Only the head, for who needs it before the records. */
export function axrecHead(name: string, bytes: Uint8Array): RecordingHead {
  return headOf(name, bytes, new DataView(bytes.buffer, bytes.byteOffset, bytes.length)).head;
}

/** Reads the .axrec file in @param bytes to its last whole record; a Refusal if there is not even a head. */
export function readAxrec(name: string, bytes: Uint8Array, taker: RecordTaker): AxrecSummary {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const { head, first } = headOf(name, bytes, view);
  const reader = new AxrecReader(taker, head.unit);
  const remark = reader.read(bytes, view, first);
  return { head, lost: reader.lost, from: reader.from, to: reader.to, remark };
}
