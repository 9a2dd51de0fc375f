import type { FrameBatch, SampleBatch, ServerInfo, UnitEvent, UnitOverview } from "./types";

export type Query = Record<string, string | number | boolean | undefined>;
/** How something is changed; POST begins, PUT and PATCH set, DELETE ends. */
export type Verb = "POST" | "PUT" | "PATCH" | "DELETE";

/** What is wanted of a unit, again and again. */
export interface LiveRequest {
  /** Up to eight names of signals. */
  signals: string[];
  /** From one sample to the next (ms). */
  periodMs: number;
  frames: boolean;
}

/** What has come since the last time. */
export interface LiveNews {
  samples: SampleBatch[];
  frames: FrameBatch[];
  /** Lines that were no longer kept: the page was too slow. */
  lost: number;
  /** What came before belongs to another run of the daemon. */
  restarted: boolean;
}

export interface EventNews {
  events: UnitEvent[];
  lost: number;
}

/** A recording that belongs to the session, as bytes of an .axrec file or a candump log. */
export interface RecordingFile {
  name: string;
  unit: string;
  bytes: Uint8Array;
}

/** What was said of a session as a whole: of a scenario that has failed, for instance. */
export interface Verdict {
  title: string;
  text: string;
  passed?: boolean;
  report?: unknown;
}

/** Where the page gets everything from: a gateway, or a recorded session. All promises are rejected with a Refusal. */
export interface Source {
  /** Whether there are units that live. */
  readonly isLive: boolean;
  server(): Promise<ServerInfo>;
  overview(): Promise<UnitOverview[]>;
  /** A resource of a unit: what stands behind /api/v1/units/BUS/NODE/. */
  get<T>(unit: string, resource: string, query?: Query): Promise<T>;
  /** All entries of a list that comes in pages, under @param key of each page. */
  all<T>(unit: string, resource: string, key: string, query?: Query): Promise<T[]>;
  /** Changes something; the gateway wants the token. */
  act<T>(verb: Verb, unit: string, resource: string, body?: unknown, query?: Query): Promise<T>;
  /** The EDS of the unit. */
  eds(unit: string): Promise<string>;
  /** What has come since @param cursor; undefined: begins. The next cursor stands in the answer. */
  live(unit: string, request: LiveRequest, cursor?: string): Promise<LiveNews & { cursor: string }>;
  /** Events of all units since @param after, the number of the last one that was seen. */
  events(after?: number): Promise<EventNews & { last: number }>;
  /** Recordings that came with the session. */
  readonly recordings: RecordingFile[];
  readonly verdict?: Verdict;
}
