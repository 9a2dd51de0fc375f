import type { Decoder } from "../../canopen/decode";
import { identifierText, unsignedOf, type CanFrame } from "../../canopen/frame";
import { axisOfIndex, indexOfFirstAxis } from "../../canopen/object_words";
import { bytesAt, mappingOf } from "../../canopen/pdo";
import { laneNumber } from "../../canopen/services";
import type { UnitEvent } from "../../source/types";
import { eventAt } from "../event_store";
import type { FrameStore } from "../frame_store";

/** The controlword of an axis at a time, as something has brought it. */
export interface ControlwordWrite {
  t: number;
  value: number;
  /** "RPDO 1", "an SDO download", "a write over the control socket". */
  by: string;
  /** Serial number of the frame. */
  frame?: number;
  event?: UnitEvent;
  /** It acts with the next SYNC only. */
  isSynchronous: boolean;
}

const kControlword = 0x6040;
/** Frames that are looked through, from the event back. */
const kMostLooked = 300_000;
/** PDO transmission types up to this one are synchronous (CiA 301, 7.5.2.35). */
const kLastSynchronous = 240;
/** Command byte of an expedited download of 2 bytes, without the bits for its size (CiA 301, 7.2.4.3.3). */
const kDownload = 1;

function ofAxis(index: number, axis: number): boolean {
  return indexOfFirstAxis(index) === kControlword && axisOfIndex(index) === axis;
}

/** The controlword of @param axis in an RPDO. */
function inPdo(frame: CanFrame, decoder: Decoder, axis: number): Omit<ControlwordWrite, "t"> | undefined {
  const pdo = decoder.pdoOf(frame.id, frame.isExtended);
  if (pdo?.direction !== "receive") return undefined;
  const place = mappingOf(pdo).find((value) => ofAxis(value.index, axis));
  if (place === undefined || frame.isRemote || place.from + place.bits > 8 * frame.data.length) return undefined;
  return {
    value: unsignedOf(bytesAt(frame.data, place.from, place.bits)),
    by: `${pdo.pdo} (${identifierText(frame.id, frame.isExtended)})`,
    isSynchronous: pdo.transmission_type <= kLastSynchronous,
  };
}

/** The controlword of @param axis in an SDO request; 6040h fits into an expedited download. */
function inSdo(frame: CanFrame, axis: number): Omit<ControlwordWrite, "t"> | undefined {
  const { data } = frame;
  if (data.length !== 8 || (data[0] ?? 0) >> 5 !== kDownload || ((data[0] ?? 0) & 2) === 0) return undefined;
  if (!ofAxis(unsignedOf(data, 1, 2), axis)) return undefined;
  return { value: unsignedOf(data, 4, 2), by: `an SDO download (${identifierText(frame.id)})`, isSynchronous: false };
}

/** The same of a frame of any kind; undefined: it brings none. */
export function controlwordIn(frame: CanFrame, decoder: Decoder, axis: number): Omit<ControlwordWrite, "t"> | undefined {
  const { kind } = decoder.settings.services.of(frame.id, frame.isExtended);
  if (kind === "rpdo") return inPdo(frame, decoder, axis);
  return kind === "sdo-request" ? inSdo(frame, axis) : undefined;
}

function inEvent(event: UnitEvent, axis: number): ControlwordWrite | undefined {
  if (event.kind !== "object" || event.by !== "control" || typeof event.value !== "number") return undefined;
  const index = parseInt(event.object ?? "", 16);
  if (!ofAxis(index, axis)) return undefined;
  return { t: event.t, value: event.value, by: "a write over the control socket", event, isSynchronous: false };
}

/** The controlwords of @param axis from @param until back to @param since, the newest first. */
export function* controlwordsBefore(
  past: { events: readonly UnitEvent[]; frames: FrameStore; decoder: Decoder },
  axis: number,
  until: number,
  since: number,
): Generator<ControlwordWrite> {
  const { events, frames, decoder } = past;
  let place = eventAt(events, until + Number.EPSILON * until) - 1;
  while (place + 1 < events.length && (events[place + 1]?.t ?? Infinity) <= until) ++place;
  let serial = frames.at(until);
  while (serial < frames.next && frames.timeOf(serial) <= until) ++serial;
  const lowest = Math.max(frames.first, serial - kMostLooked);
  const lanes = [laneNumber("rpdo"), laneNumber("sdo")];
  for (--serial; serial >= lowest && frames.timeOf(serial) >= since; --serial) {
    const frame = lanes.includes(frames.laneAt(serial)) ? frames.frame(serial) : undefined;
    const found = frame === undefined ? undefined : controlwordIn(frame, decoder, axis);
    if (frame === undefined || found === undefined) continue;
    for (; place >= 0 && (events[place]?.t ?? -Infinity) > frame.t; --place) {
      const written = inEvent(events[place] as UnitEvent, axis);
      if (written !== undefined) yield written;
    }
    yield { t: frame.t, frame: serial, ...found };
  }
  for (; place >= 0 && (events[place]?.t ?? -Infinity) >= since; --place) {
    const written = inEvent(events[place] as UnitEvent, axis);
    if (written !== undefined) yield written;
  }
}

/** A controlword that is other than the one before it, which is undefined if nobody knows it. */
export interface ControlwordChange {
  now: ControlwordWrite;
  before: ControlwordWrite | undefined;
}

/** The newest change of the controlword of @param axis from @param until back to @param since. */
export function lastChange(
  past: { events: readonly UnitEvent[]; frames: FrameStore; decoder: Decoder },
  axis: number,
  until: number,
  since: number,
): ControlwordChange | undefined {
  let now: ControlwordWrite | undefined;
  for (const written of controlwordsBefore(past, axis, until, -Infinity)) {
    if (now !== undefined && written.value !== now.value) return { now, before: written };
    if (written.t < since) return undefined;
    now = written;
  }
  return now === undefined ? undefined : { now, before: undefined };
}

