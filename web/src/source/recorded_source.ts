import { Refusal } from "./refusal";
import { bytesOf, type Session, type SessionUnit } from "./session";
import type { EventNews, LiveNews, Query, RecordingFile, Source, Verdict } from "./source";
import type { ServerInfo, Status, UnitOverview } from "./types";

function overviewOf(unit: SessionUnit): UnitOverview {
  const status = unit.resources[""] as (Status & Record<string, unknown>) | undefined;
  if (status === undefined) return { unit: unit.unit, on: false, error: "its state was not recorded" };
  return { on: true, ...status, unit: unit.unit };
}

/** The key of a resource in a session; `from` and `count` are of no account, lists are whole. */
function keyOf(resource: string, query: Query): string {
  const words = Object.entries(query)
    .filter(([key, value]) => value !== undefined && key !== "from" && key !== "count")
    .map(([key, value]) => `${key}=${String(value)}`);
  return words.length === 0 ? resource : `${resource}?${words.join("&")}`;
}

/** A recorded session: all is as it was at its end, and nothing can be changed. */
export class RecordedSource implements Source {
  readonly isLive = false;
  readonly recordings: RecordingFile[];
  readonly verdict?: Verdict;

  constructor(private readonly session: Session) {
    this.recordings = session.units.flatMap((unit) =>
      unit.recordings.map(({ name, data }) => ({ name, unit: unit.unit, bytes: bytesOf(data) })),
    );
    this.verdict = { title: session.title, text: session.verdict?.text ?? "", report: session.report };
    if (session.verdict !== undefined) this.verdict.passed = session.verdict.passed;
  }

  server(): Promise<ServerInfo> {
    return Promise.resolve({ program: this.session.made_by, version: "", read_only: true, token: "none" });
  }

  overview(): Promise<UnitOverview[]> {
    return Promise.resolve(this.session.units.map(overviewOf));
  }

  get<T>(unit: string, resource: string, query: Query = {}): Promise<T> {
    const resources = this.unit(unit)?.resources ?? {};
    const value = resources[keyOf(resource, query)] ?? resources[resource];
    if (value !== undefined) return Promise.resolve(value as T);
    return Promise.reject(new Refusal("not-recorded", `${resource === "" ? "the state" : resource} was not recorded`));
  }

  async all<T>(unit: string, resource: string, key: string, query: Query = {}): Promise<T[]> {
    return (await this.get<Record<string, T[]>>(unit, resource, query))[key] ?? [];
  }

  act<T>(): Promise<T> {
    return Promise.reject(new Refusal("recorded", "this is a recording: nothing can be changed"));
  }

  eds(unit: string): Promise<string> {
    const text = this.unit(unit)?.eds;
    if (text !== undefined) return Promise.resolve(text);
    return Promise.reject(new Refusal("not-recorded", "the EDS was not recorded"));
  }

  live(): Promise<LiveNews & { cursor: string }> {
    return Promise.resolve({ cursor: "", samples: [], frames: [], lost: 0, restarted: false });
  }

  events(): Promise<EventNews & { last: number }> {
    return Promise.resolve({ events: [], lost: 0, last: 0 });
  }

  private unit(name: string): SessionUnit | undefined {
    return this.session.units.find((unit) => unit.unit === name);
  }
}
