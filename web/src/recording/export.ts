import type { FrameStore } from "../model/frame_store";
import type { SampleStore, SignalHead } from "../model/sample_store";
import { candumpLine } from "./candump_log";

function quoted(text: string): string {
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

function withUnit({ signal, unit }: SignalHead): string {
  return unit === undefined || unit === "" ? signal : `${signal} (${unit})`;
}

/** Samples in [from, to] as `axisctl trace read` writes them; @param triggerT: with a column of the time since the trigger. */
export function csvOfSamples(samples: SampleStore, from: number, to: number, triggerT?: number): string {
  const heads = ["t (s)", ...(triggerT === undefined ? [] : ["t from trigger (s)"]), ...samples.signals.map(withUnit)];
  const lines = [heads.map(quoted).join(",")];
  for (const { t, values } of samples.rows(from, to)) {
    const times = triggerT === undefined ? [t] : [t, t - triggerT];
    lines.push([...times.map((time) => time.toFixed(9)), ...values.map((value) => value ?? "")].join(","));
  }
  return `${lines.join("\n")}\n`;
}

/** Frames in [from, to] as candump -l writes them. @param startedAt: time zero (seconds since 1970). */
export function candumpOfFrames(frames: FrameStore, from: number, to: number, bus = "can0", startedAt = 0): string {
  const lines: string[] = [];
  for (let serial = frames.at(from); serial < frames.next; ++serial) {
    const frame = frames.frame(serial);
    if (frame === undefined || frame.t > to) break;
    lines.push(candumpLine(frame, bus, startedAt));
  }
  return lines.join("");
}
