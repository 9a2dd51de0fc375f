import { Refusal, wordsOf } from "./refusal";
import type { EventNews, LiveNews, LiveRequest, Query, RecordingFile, Source, Verb } from "./source";
import type { ServerInfo, UnitEvent, UnitOverview } from "./types";

/** Longest wait for an answer (ms): the gateway gives a daemon 10 s. */
const PATIENCE = 15_000;

function queryText(query: Query): string {
  const pairs = Object.entries(query).filter(([, value]) => value !== undefined);
  const words = new URLSearchParams(pairs.map(([key, value]) => [key, String(value)]));
  return pairs.length === 0 ? "" : `?${words.toString()}`;
}

/** The refusal in an answer with @param status and @param body. */
function refusalOf(status: number, body: unknown): Refusal {
  const error = (body as { error?: Record<string, unknown> } | null)?.error;
  if (error === undefined) return new Refusal("broken", `the gateway answers with status ${status}`, status);
  return new Refusal(String(error["code"]), String(error["message"]), status, error);
}

/** What the gateway serves that has sent the page. */
export class LiveSource implements Source {
  readonly isLive = true;
  readonly recordings: RecordingFile[] = [];
  /** @param token of the gateway's file, without which it changes nothing. */
  constructor(
    private readonly base: string,
    private readonly token: () => string,
  ) {}

  server(): Promise<ServerInfo> {
    return this.ask("GET", "/api/v1/server");
  }

  async overview(): Promise<UnitOverview[]> {
    return (await this.ask<{ units: UnitOverview[] }>("GET", "/api/v1/overview")).units;
  }

  get<T>(unit: string, resource: string, query: Query = {}): Promise<T> {
    return this.ask("GET", this.path(unit, resource, query));
  }

  async all<T>(unit: string, resource: string, key: string, query: Query = {}): Promise<T[]> {
    const items: T[] = [];
    let from: number | undefined = 0;
    while (from !== undefined) {
      const page: Record<string, unknown> = await this.get(unit, resource, { ...query, from });
      items.push(...(page[key] as T[]));
      from = page["next"] as number | undefined;
    }
    return items;
  }

  act<T>(verb: Verb, unit: string, resource: string, body?: unknown, query: Query = {}): Promise<T> {
    return this.ask(verb, this.path(unit, resource, query), body);
  }

  eds(unit: string): Promise<string> {
    return this.fetched("GET", this.path(unit, "eds", {})).then((answer) => answer.text());
  }

  live(unit: string, request: LiveRequest, cursor?: string): Promise<LiveNews & { cursor: string }> {
    const query: Query = { after: cursor };
    if (request.signals.length > 0) {
      query["signals"] = request.signals.join(",");
      query["period_ms"] = request.periodMs;
    }
    if (request.frames) query["frames"] = true;
    return this.get<Partial<LiveNews> & { cursor: string }>(unit, "live", query).then((news) => ({
      cursor: news.cursor,
      samples: news.samples ?? [],
      frames: news.frames ?? [],
      lost: news.lost ?? 0,
      restarted: news.restarted ?? false,
    }));
  }

  async events(after?: number): Promise<EventNews & { last: number }> {
    const path = `/api/v1/events/recent${queryText({ after })}`;
    return this.ask<{ last: number; events: UnitEvent[]; lost: number }>("GET", path);
  }

  private path(unit: string, resource: string, query: Query): string {
    return `/api/v1/units/${unit}${resource === "" ? "" : `/${resource}`}${queryText(query)}`;
  }

  private async ask<T>(verb: string, path: string, body?: unknown): Promise<T> {
    const answer = await this.fetched(verb, path, body);
    return (await answer.json()) as T;
  }

  private async fetched(verb: string, path: string, body?: unknown): Promise<Response> {
    const headers: Record<string, string> = {};
    if (verb !== "GET" || path.endsWith("/server")) headers["Authorization"] = `Bearer ${this.token()}`;
    const init: RequestInit = { method: verb, headers, signal: AbortSignal.timeout(PATIENCE), cache: "no-store" };
    if (body !== undefined) {
      headers["Content-Type"] = "application/json";
      init.body = JSON.stringify(body);
    }
    if (headers["Authorization"] === "Bearer ") delete headers["Authorization"];
    const answer = await fetch(this.base + path, init).catch((error: unknown) => {
      const isLate = error instanceof DOMException && error.name === "TimeoutError";
      const why = isLate ? `no answer within ${PATIENCE / 1000} s` : `cannot be reached (${wordsOf(error)})`;
      throw new Refusal("no-gateway", `axisd-http: ${why}`);
    });
    if (answer.ok) return answer;
    throw refusalOf(answer.status, await answer.json().catch(() => null));
  }
}
