import type { Decoder } from "../../canopen/decode";
import type { UnitEvent } from "../../source/types";
import type { FrameStore } from "../frame_store";

/** What is known about the time around an event. */
export interface Past {
  /** In the order of their time. */
  events: readonly UnitEvent[];
  frames: FrameStore;
  decoder: Decoder;
  /** Process-data cycle (s); 4 ms if not given. */
  cycleS?: number | undefined;
}

/** Something in the past that a sentence points to. */
export interface Pointer {
  t: number;
  /** Serial number of a frame. */
  frame?: number;
  event?: UnitEvent;
}

/** The pointer to a frame or an event. */
export function pointerOf(place: { t: number; frame?: number | undefined; event?: UnitEvent | undefined }): Pointer {
  const pointer: Pointer = { t: place.t };
  if (place.frame !== undefined) pointer.frame = place.frame;
  if (place.event !== undefined) pointer.event = place.event;
  return pointer;
}
