import type { UnitEvent } from "../source/types";
import { kAnew } from "./frame_store";

/** Place in @param events of the first one not before @param t. */
export function eventAt(events: readonly UnitEvent[], t: number): number {
  let low = 0;
  let high = events.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((events[middle]?.t ?? 0) < t) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** The place of an event of the same time or later than all: behind them. */
function placeOf(events: readonly UnitEvent[], t: number): number {
  let place = events.length;
  while (place > 0 && (events[place - 1]?.t ?? 0) > t) --place;
  return place;
}

/**
 * Events of a unit in the order of their time; an event that comes twice (same id) is kept once. A time that begins
 * anew (the unit was switched off and on) forgets what was before.
 */
export class EventStore {
  private events: UnitEvent[] = [];
  private ids = new Set<number>();

  /** @param most that are kept, the newest; @param unit whose events are taken; undefined: all. */
  constructor(
    readonly most = 20_000,
    readonly unit?: string,
  ) {}

  /** All of them, the oldest first. It is another array after each change. */
  get all(): readonly UnitEvent[] {
    return this.events;
  }

  /** Adds what is new in @param events. Returns how many these are. */
  add(events: readonly UnitEvent[]): number {
    const fresh = events.filter((event) => this.isNew(event));
    if (fresh.length === 0) return 0;
    let all = [...this.events];
    for (const event of fresh) {
      if (event.id !== undefined) this.ids.add(event.id);
      if (event.t < (all.at(-1)?.t ?? event.t) - kAnew) all = [];
      all.splice(placeOf(all, event.t), 0, event);
    }
    this.events = all.slice(-this.most);
    if (this.ids.size > 2 * this.most) this.forgetIds();
    return fresh.length;
  }

  clear(): void {
    this.events = [];
    this.ids.clear();
  }

  /** Those in [from, to). */
  window(from: number, to: number): readonly UnitEvent[] {
    return this.events.slice(eventAt(this.events, from), eventAt(this.events, to));
  }

  /** The newest @param count, the newest first. */
  latest(count: number): UnitEvent[] {
    return count <= 0 ? [] : this.events.slice(-count).reverse();
  }

  private isNew(event: UnitEvent): boolean {
    if (this.unit !== undefined && event.unit !== undefined && event.unit !== this.unit) return false;
    return event.id === undefined || !this.ids.has(event.id);
  }

  private forgetIds(): void {
    this.ids = new Set(this.events.flatMap((event) => (event.id === undefined ? [] : [event.id])));
  }
}
