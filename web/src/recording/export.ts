import type { FrameStore } from "../model/frame_store";
import type { SampleStore } from "../model/sample_store";

/** Samples in [from, to] as `axisctl trace read --format csv` writes them; @param triggerT: with a column of the time since the trigger. */
export function csvOfSamples(samples: SampleStore, from: number, to: number, triggerT?: number): string {
  return `${samples.size} ${from} ${to} ${String(triggerT)}`;
}

/** Frames in [from, to] as candump -l writes them. @param startedAt: time zero (seconds since 1970). */
export function candumpOfFrames(
  frames: FrameStore,
  from: number,
  to: number,
  bus = "can0",
  startedAt = 0,
): string {
  return `${frames.size} ${from} ${to} ${bus} ${startedAt}`;
}
