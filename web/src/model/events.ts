import { signal } from "@preact/signals";

import type { Source } from "../source/source";
import type { UnitEvent } from "../source/types";
import { poll } from "./poll";

/** Time between two looks (ms). */
const kPeriod = 300;
/** Most events that are kept. */
const kMost = 2000;

/** What has happened in all units, the oldest first. */
export class Events {
  readonly all = signal<UnitEvent[]>([]);
  /** Events that came faster than they could be taken. */
  readonly lost = signal(0);
  private last: number | undefined;

  constructor(private readonly source: Source) {}

  /** Looks again and again. Returns how to end it. */
  start(): () => void {
    return this.source.isLive ? poll(() => this.look(), kPeriod) : () => undefined;
  }

  /** Adds events that were recorded. */
  add(events: UnitEvent[]): void {
    if (events.length > 0) this.all.value = [...this.all.value, ...events].slice(-kMost);
  }

  private async look(): Promise<void> {
    try {
      const news = await this.source.events(this.last);
      this.last = news.last;
      this.lost.value += news.lost;
      this.add(news.events);
    } catch {
      // units say why nobody answers
    }
  }
}
