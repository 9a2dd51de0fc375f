/**
 * Writes texts one after the other. Of those that come while one is being written the newest is next, unless it is that
 * one; after a refusal none is.
 */
export class WriteQueue {
  private underWay: string | null = null;
  private next: string | null = null;

  /** Writes @param text by @param write, which says whether it was taken, and then what has come meanwhile. */
  async add(text: string, write: (text: string) => Promise<boolean>): Promise<void> {
    if (this.underWay !== null) {
      this.next = text === this.underWay ? null : text;
      return;
    }
    for (let wanted: string | null = text; wanted !== null; wanted = this.next) {
      this.underWay = wanted;
      this.next = null;
      if (!(await write(wanted))) this.next = null;
    }
    this.underWay = null;
  }
}
