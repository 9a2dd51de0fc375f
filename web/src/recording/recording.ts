import type { UnitEvent } from "../source/types";
import type { FrameStore } from "../model/frame_store";
import type { SampleStore } from "../model/sample_store";

/** Kinds of files that the page opens. */
export type RecordingFormat = "axrec" | "candump" | "trace-csv" | "trace-json";

/** Text of the head of an .axrec file (docs/reference/recording.md). */
export interface RecordingHead {
  program: string;
  version: string;
  name: string;
  unit: string;
  interface?: string;
  node_id?: number;
  profile?: string;
  axes?: { axis: number; name: string; type: string }[];
  cycle_s?: number;
  every_s?: number;
  on_fault?: boolean;
  before_s?: number;
  after_s?: number;
  wall_clock?: string;
  wall_clock_ns?: number;
  signals: { name: string; unit: string }[];
}

/** A file, as the scope shows it. Times are seconds since the start of the unit; of a candump log since its first frame. */
export interface Recording {
  /** Of the file. */
  name: string;
  format: RecordingFormat;
  /** "vcan0/5"; empty: the file does not say it. */
  unit: string;
  head?: RecordingHead;
  /** What there is from and to; 0 and 0: nothing. */
  from: number;
  to: number;
  frames: FrameStore;
  samples: SampleStore;
  events: UnitEvent[];
  /** Of a trace. */
  triggerT?: number;
  /** Time zero as seconds since 1970; undefined: unknown. */
  startedAt?: number;
  /** Records that had no room. */
  lost: number;
  /** Damaged, cut, incomplete: what is missing and where. Empty: nothing. */
  remark: string;
}
