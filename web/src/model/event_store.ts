import type { UnitEvent } from "../source/types";

/** Events of a unit in the order of their time; an event that comes twice (same id) is kept once. */
export class EventStore {
  /** @param most that are kept, the newest; @param unit whose events are taken; undefined: all. */
  constructor(
    readonly most = 20_000,
    readonly unit?: string,
  ) {}

  /** All of them, the oldest first. It is another array after each change. */
  get all(): readonly UnitEvent[] {
    return [];
  }
  /** Adds what is new in @param events. Returns how many these are. */
  add(events: readonly UnitEvent[]): number {
    return events.length;
  }
  clear(): void {}
  /** Those in [from, to). */
  window(from: number, to: number): readonly UnitEvent[] {
    void from;
    void to;
    return [];
  }
  /** The newest @param count, the newest first. */
  latest(count: number): UnitEvent[] {
    void count;
    return [];
  }
}
