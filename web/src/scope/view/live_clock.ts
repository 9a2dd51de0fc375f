/** What lies between an instant in the unit and its being shown, at least and at most (s): batches, polls, slow networks. */
const kLeastDelay = 0.15;
const kMostDelay = 2;
/** What is added to the time between two answers (s). */
const kReserve = 0.1;

/** Lets the right edge of a live picture go evenly although data come by fits and starts. */
export class LiveClock {
  /** Time of the unit less that of the page (s), of the data that came the soonest. */
  private offset: number | undefined;
  /** Newest instant of which there are data. */
  private newest = 0;
  private shown = 0;
  private delay = 0.2;
  private notedAt: number | undefined;

  /** Data up to @param t have come at @param now (both s). */
  note(t: number, now: number): void {
    const offset = t - now;
    if (this.offset === undefined || offset > this.offset || offset < this.offset - 2 * kMostDelay) this.offset = offset;
    else this.offset += (offset - this.offset) * 0.01;
    if (t > this.newest) this.adapt(now);
    this.newest = Math.max(this.newest, t);
  }

  /** Begins anew: the unit counts from zero again. */
  reset(): void {
    this.offset = undefined;
    this.newest = 0;
    this.shown = 0;
  }

  /** The newest instant of which there is anything. */
  get latest(): number {
    return this.newest;
  }

  /** The instant that is shown at the right edge at @param now; it never goes back, and stands still when nothing comes. */
  at(now: number): number {
    if (this.offset !== undefined) this.shown = Math.max(this.shown, Math.min(this.newest, now + this.offset - this.delay));
    return this.shown;
  }

  /** The rarer something comes, the later it is shown: more at once at a late answer, less by and by. */
  private adapt(now: number): void {
    const wanted = Math.min(kMostDelay, Math.max(kLeastDelay, now - (this.notedAt ?? now) + kReserve));
    this.delay += (wanted - this.delay) * (wanted > this.delay ? 0.5 : 0.03);
    this.notedAt = now;
  }
}
