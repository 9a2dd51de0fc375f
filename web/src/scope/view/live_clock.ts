/** What lies between an instant in the unit and its being shown (s): batches, polls, a late answer. */
const kDelay = 0.2;

/** Lets the right edge of a live picture go evenly although data come by fits and starts. */
export class LiveClock {
  /** Time of the unit less that of the page (s), of the data that came the soonest. */
  private offset: number | undefined;
  /** Newest instant of which there are data. */
  private newest = 0;

  /** Data up to @param t have come at @param now (both s). */
  note(t: number, now: number): void {
    const offset = t - now;
    if (this.offset === undefined || offset > this.offset || offset < this.offset - 2) this.offset = offset;
    else this.offset += (offset - this.offset) * 0.01;
    this.newest = Math.max(this.newest, t);
  }

  /** Begins anew: the unit counts from zero again. */
  reset(): void {
    this.offset = undefined;
    this.newest = 0;
  }

  /** The instant that is shown at the right edge at @param now; it stands still when nothing comes. */
  at(now: number): number {
    if (this.offset === undefined) return this.newest;
    return Math.max(0, Math.min(this.newest, now + this.offset - kDelay));
  }
}
