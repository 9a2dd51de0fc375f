import type { FrameStore } from "../../model/frame_store";
import type { ServiceMap } from "../services";
import { SdoReader, type SdoStep, type SdoTransfer } from "./reader";

/** A frame in its transfer. */
export interface TransferPlace {
  /** Serial numbers of all its frames. */
  frames: number[];
  transfer: SdoTransfer | undefined;
  step: SdoStep;
  partner: number | undefined;
}

/** Frames of the transfer that are looked for before a frame, and frames of all kinds that are looked through. */
const kMostBefore = 4000;
const kMostAfter = 4000;
const kMostLooked = 200_000;
/** A client and a server that say nothing for so long (s) have given up. */
const kLongestPause = 30;

interface Side {
  serial: number;
  isRequest: boolean;
}

/** Whether the frame @param serial belongs to the SDO server @param number of the node; which side has sent it. */
function sideOf(store: FrameStore, services: ServiceMap, serial: number, number: number, node: number): Side | undefined {
  const service = services.of(store.idOf(serial));
  if (service.number !== number || (service.node ?? 0) !== node) return undefined;
  if (service.kind === "sdo-request") return { serial, isRequest: true };
  return service.kind === "sdo-response" ? { serial, isRequest: false } : undefined;
}

/** Frames of the same pair of identifiers around @param serial, in their order. */
function framesAround(store: FrameStore, services: ServiceMap, serial: number): Side[] {
  const { number = 1, node = 0 } = services.of(store.idOf(serial));
  const t = store.timeOf(serial);
  const sides: Side[] = [];
  const lowest = Math.max(store.first, serial - kMostLooked);
  for (let at = serial; at >= lowest && sides.length < kMostBefore; --at) {
    if (t - store.timeOf(at) > kLongestPause) break;
    const side = sideOf(store, services, at, number, node);
    if (side !== undefined) sides.unshift(side);
  }
  const highest = Math.min(store.next, serial + kMostLooked);
  const most = sides.length + kMostAfter;
  for (let at = serial + 1; at < highest && sides.length < most; ++at) {
    if (store.timeOf(at) - t > kLongestPause) break;
    const side = sideOf(store, services, at, number, node);
    if (side !== undefined) sides.push(side);
  }
  return sides;
}

/** The response to a request, or the request of a response. */
function partnerOf(frames: readonly Side[], own: number): number | undefined {
  const place = frames.findIndex((side) => side.serial === own);
  const isRequest = frames[place]?.isRequest ?? false;
  if (isRequest) return frames.slice(place + 1).find((side) => !side.isRequest)?.serial;
  return frames.slice(0, place).findLast((side) => side.isRequest)?.serial;
}

/** The frame @param serial of @param store (of an SDO) in its transfer. */
export function transferAt(store: FrameStore, services: ServiceMap, serial: number): TransferPlace | undefined {
  const reader = new SdoReader();
  let frames: Side[] = [];
  let found: SdoStep | undefined;
  let transfer: SdoTransfer | undefined;
  for (const side of framesAround(store, services, serial)) {
    const frame = store.frame(side.serial);
    if (frame === undefined) continue;
    const step = reader.read(frame.data, side.isRequest);
    if (step.begins && found !== undefined) break;
    if (step.begins) frames = [];
    frames.push(side);
    if (side.serial === serial) found = step;
    if (found !== undefined) transfer = reader.transfer;
  }
  if (found === undefined) return undefined;
  return { frames: frames.map((side) => side.serial), transfer, step: found, partner: partnerOf(frames, serial) };
}
