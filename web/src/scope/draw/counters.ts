import type { Material } from "../data/material";
import { LiveMaterial } from "../data/live_material";

/** What the scope has done, for measurements from outside: window.axisdScope. */
export interface ScopeCounters {
  /** Pictures since the scope was opened. */
  framesDrawn: number;
  /** Pictures of the last second. */
  fps: number;
  /** Time that the last one took, and the longest of all (ms). */
  drawMs: number;
  longestDrawMs: number;
  samples: number;
  busFrames: number;
  lost: number;
  /** Answers to questions for what is new. */
  answers: number;
  /** Samples and frames that are kept. */
  keptSamples: number;
  keptFrames: number;
}

declare global {
  interface Window {
    axisdScope?: ScopeCounters;
  }
}

export const counters: ScopeCounters = {
  framesDrawn: 0,
  fps: 0,
  drawMs: 0,
  longestDrawMs: 0,
  samples: 0,
  busFrames: 0,
  lost: 0,
  answers: 0,
  keptSamples: 0,
  keptFrames: 0,
};

let second = 0;
let drawnInSecond = 0;

/** A picture of @param material has been drawn in @param ms. */
export function drawn(ms: number, material: Material): void {
  window.axisdScope = counters;
  ++counters.framesDrawn;
  ++drawnInSecond;
  counters.drawMs = ms;
  counters.longestDrawMs = Math.max(ms, counters.longestDrawMs);
  const present = Math.floor(performance.now() / 1000);
  if (present !== second) {
    counters.fps = present === second + 1 ? drawnInSecond : 0;
    second = present;
    drawnInSecond = 0;
  }
  counters.lost = material.lost;
  counters.keptSamples = material.samples.size;
  counters.keptFrames = material.frames.size;
  if (!(material instanceof LiveMaterial)) return;
  counters.samples = material.counts.samples;
  counters.busFrames = material.counts.frames;
  counters.answers = material.counts.answers;
}
