import type { UnitOverview } from "../source/types";

interface Seen {
  uptime: number;
  frames: number;
  rate: number | undefined;
}

/** Frames a second of each unit, from one look at all units to the next. */
export class FrameRates {
  private seen = new Map<string, Seen>();

  /** The rates between the look before and @param units; a unit that was not there before has none yet. */
  update(units: readonly UnitOverview[]): Map<string, number> {
    const next = new Map<string, Seen>();
    for (const unit of units) {
      const seen = this.look(unit);
      if (seen !== undefined) next.set(unit.unit, seen);
    }
    this.seen = next;
    const rates = new Map<string, number>();
    for (const [name, { rate }] of next) if (rate !== undefined) rates.set(name, rate);
    return rates;
  }

  private look(unit: UnitOverview): Seen | undefined {
    if (unit.bus === undefined || unit.uptime_s === undefined) return undefined;
    const frames = unit.bus.received + unit.bus.sent;
    const before = this.seen.get(unit.unit);
    if (before === undefined || unit.uptime_s < before.uptime || frames < before.frames)
      return { uptime: unit.uptime_s, frames, rate: undefined };
    if (unit.uptime_s === before.uptime) return before;
    return { uptime: unit.uptime_s, frames, rate: (frames - before.frames) / (unit.uptime_s - before.uptime) };
  }
}
