import { describe, expect, it } from "vitest";

import { laneNumber, ServiceMap } from "../../../src/canopen/services";
import { FrameStore } from "../../../src/model/frame_store";
import { Density } from "../../../src/scope/view/density";

function store(): FrameStore {
  return new FrameStore(new ServiceMap().laneOf, 10_000);
}

function append(frames: FrameStore, from: number, to: number): void {
  const lines: string[] = [];
  for (let t = from; t < to - 1e-9; t += 0.01) lines.push(`${t.toFixed(6)} S 185#3706`);
  expect(frames.appendLines(lines)).toBe(0);
}

/** Frames of TPDOs that are counted. */
function counted(density: Density, frames: FrameStore, from: number, to: number): number[] {
  const bins = density.of(frames, from, to, 10);
  const begin = laneNumber("tpdo") * bins.count;
  return Array.from(bins.counts.subarray(begin, begin + bins.count));
}

describe("counts of frames for a picture", () => {
  it("are the same whether they are counted anew or taken from the picture before", () => {
    const frames = store();
    const moving = new Density();
    append(frames, 0.005, 1);
    counted(moving, frames, 0, 1);
    for (let end = 1; end < 3; end += 0.13) {
      append(frames, frames.to + 0.01, end + 0.13);
      const from = end + 0.13 - 1;
      expect(counted(moving, frames, from, from + 1)).toEqual(counted(new Density(), frames, from, from + 1));
    }
  });

  it("are counted anew for another length and for earlier times", () => {
    const frames = store();
    append(frames, 0.005, 3);
    const density = new Density();
    for (const [from, to] of [[2, 3], [1, 2], [0, 3], [1.5, 1.6], [1.51, 1.61]] as const)
      expect(counted(density, frames, from, to)).toEqual(counted(new Density(), frames, from, to));
  });
});
