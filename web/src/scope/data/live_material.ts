import { signal } from "@preact/signals";

import { Decoder } from "../../canopen/decode";
import { parseEds, type Eds } from "../../canopen/eds";
import { ServiceMap } from "../../canopen/services";
import { FrameStore } from "../../model/frame_store";
import { poll } from "../../model/poll";
import { profileAt } from "../../model/profile";
import { SampleStore, type SignalHead } from "../../model/sample_store";
import { timelineOf, type KnownStates, type Timeline } from "../../model/timeline";
import { Refusal, wordsOf } from "../../source/refusal";
import type { LiveNews, Source } from "../../source/source";
import type { Pdo, UnitEvent } from "../../source/types";
import { LiveClock } from "../view/live_clock";
import { extentOf, type Material } from "./material";
import { presentRun } from "./present_run";

/** Time from an answer to the next question (ms). */
const kPeriod = 100;
/** How long a remark stays (ms). */
const kRemark = 15_000;
/** What is kept (s). */
const kKept = 600;

const later = (ms: number): Promise<void> => new Promise((done) => setTimeout(done, ms));
const now = (): number => performance.now() / 1000;

/** A unit that lives: asks for its frames and samples again and again, and keeps them. */
export class LiveMaterial implements Material {
  readonly isLive = true;
  readonly marks = [];
  readonly startedAt = undefined;
  readonly clock = new LiveClock();
  /** Why nothing comes; empty: something does. */
  readonly problem = signal("");
  /** When the last answer came (ms since 1970); 0: none has. */
  readonly heardAt = signal(0);
  /** Frames and samples that have come, and answers. */
  readonly counts = { frames: 0, samples: 0, answers: 0 };
  frames: FrameStore;
  samples = new SampleStore([]);
  decoder: Decoder;
  version = 0;
  lost = 0;
  remark = "";
  /** Whether somebody looks: otherwise it asks once a second. */
  isWatched = true;
  private services = new ServiceMap();
  private periodMs = 4;
  private cursor: string | undefined;
  private known: KnownStates = {};
  private own: readonly UnitEvent[] = [];
  private ran: readonly UnitEvent[] = [];
  private states: { of: readonly UnitEvent[]; known: string; timeline: Timeline } | undefined;

  constructor(
    readonly unit: string,
    private readonly source: Source,
  ) {
    this.frames = new FrameStore(this.services.laneOf);
    this.decoder = new Decoder({ services: this.services, events: () => this.ran });
    void this.learn();
  }

  get name(): string {
    return this.unit;
  }

  /** Begins to ask. Returns how to end it. */
  start(): () => void {
    return poll(() => this.ask(), kPeriod);
  }

  /** Asks for other signals; what is known of those that stay is kept. */
  choose(signals: readonly SignalHead[], periodMs: number): void {
    const before = this.samples;
    const same = signals.map(({ signal: name }) => before.signals.findIndex((each) => each.signal === name));
    const isSame = same.length === before.signals.length && same.every((from, to) => from === to);
    if (isSame && periodMs === this.periodMs && signals.every(({ unit }, i) => unit === before.signals[i]?.unit)) return;
    const capacity = Math.ceil((kKept * 1000) / periodMs);
    this.samples = new SampleStore(signals, Math.min(600_000, capacity), Math.max(0.02, (periodMs / 1000) * 2.5));
    if (before.size > 0 && same.some((from) => from >= 0))
      for (const { t, values } of before.rows(before.to - 60, before.to))
        this.samples.append(t, same.map((from) => values[from] ?? null));
    this.periodMs = periodMs;
    ++this.version;
  }

  /** Takes what has happened in all units. */
  take(events: readonly UnitEvent[]): void {
    const own = events.filter((event) => event.unit === this.unit);
    if (own.length === this.own.length && own.at(-1) === this.own.at(-1)) return;
    const isOther = own.slice(this.own.length).some((event) => ["boot-up", "restore", "object"].includes(event.kind));
    this.own = own;
    this.ran = presentRun(own);
    const last = this.ran.at(-1);
    if (last !== undefined) this.clock.note(last.t, now());
    ++this.version;
    if (isOther) void this.learn();
  }

  /** Takes what the overview says: the states of now, and the time of the unit. */
  takeStates(known: KnownStates, uptime: number | undefined): void {
    this.known = known;
    if (uptime !== undefined && this.extent().to < uptime - 2) this.clock.note(uptime, now());
  }

  events(): readonly UnitEvent[] {
    return this.ran;
  }

  timeline(): Timeline {
    const known = JSON.stringify(this.known);
    if (this.states?.of !== this.ran || this.states.known !== known)
      this.states = { of: this.ran, known, timeline: timelineOf(this.ran, this.known) };
    return this.states.timeline;
  }

  extent(): { from: number; to: number } {
    return extentOf([this.frames.from, this.frames.to, this.samples.from, this.samples.to]);
  }

  /** Asks what identifiers and objects mean. */
  private async learn(): Promise<void> {
    const eds = await this.source.eds(this.unit).then((text): Eds => parseEds(text, this.unit)).catch(() => undefined);
    const pdos = await this.source.all<Pdo>(this.unit, "pdos", "pdos", { all: true }).catch(() => undefined);
    const nodeId = Number(this.unit.split("/").at(-1));
    this.services = new ServiceMap({ nodeId, pdos, eds });
    this.frames.relane(this.services.laneOf);
    const profile = await profileAt(this.source, this.unit);
    this.decoder = new Decoder({ services: this.services, eds, pdos, profile, events: () => this.ran });
    ++this.version;
  }

  private async ask(): Promise<void> {
    const store = this.samples;
    const names = store.signals.map(({ signal: name }) => name);
    try {
      const news = await this.source.live(this.unit, { signals: names, periodMs: this.periodMs, frames: true }, this.cursor);
      ++this.counts.answers;
      this.heardAt.value = Date.now();
      this.problem.value = "";
      if (store !== this.samples) return;
      this.noticeStart(news);
      this.cursor = news.cursor;
      this.add(news);
      if (!this.isWatched) await later(900);
    } catch (error) {
      this.problem.value = wordsOf(error);
      if (error instanceof Refusal && !error.isAbsence) this.cursor = undefined;
      await later(900);
    }
  }

  private add(news: LiveNews): void {
    this.lost += news.lost;
    for (const batch of news.samples) {
      this.samples.appendBatch(batch);
      this.counts.samples += batch.t.length;
      this.lost += batch.lost;
    }
    for (const batch of news.frames) {
      this.lost += batch.lost + this.frames.appendLines(batch.frames);
      this.counts.frames += batch.frames.length;
    }
    const newest = Math.max(...news.frames.map(({ t }) => t), ...news.samples.map(({ t }) => t.at(-1) ?? 0));
    if (Number.isFinite(newest)) this.clock.note(newest, now());
    if (news.frames.length + news.samples.length > 0) ++this.version;
  }

  /** If time has gone back, the unit was started anew. */
  private noticeStart(news: LiveNews): void {
    const first = Math.min(...news.frames.map(({ t }) => t), ...news.samples.map(({ t }) => t[0] ?? Infinity));
    if (!(first < this.extent().to - 0.5)) return;
    this.remark = "The unit was started anew: its time counts from zero again.";
    void later(kRemark).then(() => (this.remark = ""));
    this.frames.clear();
    this.samples.clear();
    this.clock.reset();
  }
}
