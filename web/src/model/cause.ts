import type { BitRow } from "../canopen/words";
import type { Decoder } from "../canopen/decode";
import type { UnitEvent } from "../source/types";
import type { FrameStore } from "./frame_store";

/** What is known about the time around an event. */
export interface Past {
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

/** Why something has happened. */
export interface Cause {
  /** A sentence. */
  text: string;
  /** What it points to; undefined: by itself. */
  pointer?: Pointer;
  /** Of a controlword that has changed. */
  controlword?: { before?: number | undefined; now: number; changed: BitRow[] };
}

/** A thing that has led to a fault, or that has come of it. */
export interface Step extends Pointer {
  text: string;
  /** Seconds since the fault; negative: before. */
  after: number;
}

/** The story of a fault or alarm. */
export interface FaultStory {
  event: UnitEvent;
  /** "F07900: Motor blocked/speed controller at its limit". */
  title: string;
  /** "fault value 2 (0x2)", ... */
  value: string;
  /** What has probably led to it, the most probable first. */
  causes: Step[];
  /** What the unit did, in the order of time. */
  reaction: Step[];
}

/** Why the drive state (or NMT state) changed with @param event. */
export function causeOfState(event: UnitEvent, past: Past): Cause {
  void past;
  return { text: `by itself at ${event.t}` };
}

/** What a fault or alarm is, what has led to it, and what came of it. */
export function storyOfFault(event: UnitEvent, past: Past): FaultStory {
  void past;
  return { event, title: String(event.text), value: String(event.value), causes: [], reaction: [] };
}
