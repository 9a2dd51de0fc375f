import type { Decoder } from "../../canopen/decode";
import type { Past } from "../../model/cause";
import type { FrameStore } from "../../model/frame_store";
import type { SampleStore } from "../../model/sample_store";
import type { Timeline } from "../../model/timeline";
import type { UnitEvent } from "../../source/types";

/** An instant with a name: the trigger, a step of a scenario. */
export interface Mark {
  t: number;
  text: string;
  isFailed?: boolean;
}

/** What the scope shows: a unit that lives, or what was recorded of one. */
export interface Material {
  readonly isLive: boolean;
  /** What it is called. */
  readonly name: string;
  /** BUS/NODE; empty: unknown. */
  readonly unit: string;
  readonly frames: FrameStore;
  readonly samples: SampleStore;
  readonly decoder: Decoder;
  /** It counts up with every change. */
  readonly version: number;
  readonly marks: readonly Mark[];
  /** Seconds since 1970 at time zero; undefined: unknown. */
  readonly startedAt?: number | undefined;
  /** Frames and samples that were not drawn, for they did not come in time. */
  readonly lost: number;
  /** What is wrong with it; empty: nothing. */
  readonly remark: string;
  events(): readonly UnitEvent[];
  timeline(): Timeline;
  /** The oldest and the newest instant of which there is anything. */
  extent(): { from: number; to: number };
}

/** What is needed to find causes in @param material. */
export function pastOf(material: Material, cycleS?: number): Past {
  return { events: material.events(), frames: material.frames, decoder: material.decoder, cycleS };
}

/** The oldest and the newest of @param times that are any; 0 and 0 without. */
export function extentOf(times: readonly (number | undefined)[]): { from: number; to: number } {
  const known = times.filter((t): t is number => t !== undefined && Number.isFinite(t));
  return known.length === 0 ? { from: 0, to: 0 } : { from: Math.min(...known), to: Math.max(...known) };
}
