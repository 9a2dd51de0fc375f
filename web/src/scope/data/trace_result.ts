import { openFile } from "../../recording/open_file";
import type { Recording } from "../../recording/recording";
import type { Source } from "../../source/source";

/** Items of a page of trace/data. */
const kPage = 200;
const kParts = ["samples", "frames", "events"] as const;

interface DataPage {
  signals: { signal: string; unit: string; text: string }[];
  trigger_t?: number;
  next?: number;
  total: number;
  lost_frames: number;
  items: unknown[];
}

/** Reads a result of the unit's trace page by page. @param told: how much of all has come, 0..1. */
export async function readResult(source: Source, unit: string, result: number, told: (share: number) => void = () => undefined): Promise<Recording> {
  const whole: Record<string, unknown> = {};
  for (const part of kParts) {
    const items: unknown[] = [];
    let from: number | undefined = 0;
    while (from !== undefined) {
      const page: DataPage = await source.get(unit, "trace/data", { result, part, from, count: kPage });
      items.push(...page.items);
      from = page.next;
      if (part === "samples" && page.total > 0) told(items.length / page.total);
      Object.assign(whole, { signals: page.signals, lost_frames: page.lost_frames });
      if (page.trigger_t !== undefined) whole["trigger_t"] = page.trigger_t;
    }
    whole[part] = items;
  }
  const bytes = new TextEncoder().encode(JSON.stringify(whole));
  const recording = openFile(`trace ${result}`, bytes);
  return { ...recording, name: `trace ${result}`, unit: recording.unit === "" ? unit : recording.unit };
}
