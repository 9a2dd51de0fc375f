/** Samples whose extremes are kept together. */
const kBlock = 64;
/** The part of the columns that is reserved first; they double until the capacity is reached. */
const kFirstRoom = 4096;

/** The columns of a SampleStore in a ring: a time, a value a signal, and the extremes of each 64 samples. A sample has a serial number, which stays. */
export class SampleBlocks {
  begin = 0;
  end = 0;
  private room = 0;
  private t = new Float64Array(0);
  private values: Float64Array[];
  private lowest: Float64Array[];
  private highest: Float64Array[];
  private readonly capacity: number;
  private readonly pair: [number, number] = [NaN, NaN];

  constructor(rows: number, capacity: number) {
    this.capacity = Math.ceil(Math.max(capacity, 1) / kBlock) * kBlock;
    const none = () => Array.from({ length: rows }, () => new Float64Array(0));
    this.values = none();
    this.lowest = none();
    this.highest = none();
  }

  timeOf(serial: number): number {
    return this.t[serial % this.room] ?? NaN;
  }
  valueOf(serial: number, row: number): number {
    return this.values[row]?.[serial % this.room] ?? NaN;
  }

  /** Begins the sample at @param t. Returns its place for put(); close() ends it. */
  next(t: number): number {
    if (this.end - this.begin >= this.room) this.makeRoom();
    const at = this.end % this.room;
    this.t[at] = t;
    return at;
  }
  put(at: number, row: number, value: number): void {
    const column = this.values[row];
    if (column !== undefined) column[at] = value;
  }
  close(): void {
    ++this.end;
    if (this.end % kBlock === 0) this.note(this.end - kBlock);
  }
  clear(): void {
    this.begin = this.end = Math.ceil(this.end / kBlock) * kBlock;
  }

  /** Serial number of the first sample of [low, high) not before @param t. */
  at(t: number, low = this.begin, high = this.end): number {
    while (low < high) {
      const middle = Math.floor((low + high) / 2);
      if (this.timeOf(middle) < t) low = middle + 1;
      else high = middle;
    }
    return low;
  }
  /** Serial number of the first sample after @param t. */
  after(t: number): number {
    const found = this.at(t);
    return found < this.end && this.timeOf(found) === t ? found + 1 : found;
  }

  /** Lowest and highest value of @param row in [begin, end), in the order in which they come; NaN: none. The array is used again. */
  extremes(row: number, begin: number, end: number): readonly [number, number] {
    const { room } = this;
    const column = this.values[row] ?? this.t;
    const lowest = this.lowest[row] ?? this.t;
    const highest = this.highest[row] ?? this.t;
    let low = Infinity;
    let high = -Infinity;
    let lowAt = begin;
    let highAt = begin;
    for (let serial = begin, at = begin % room; serial < end; ) {
      const isWhole = at % kBlock === 0 && serial + kBlock <= end;
      const least = (isWhole ? lowest[at / kBlock] : column[at]) ?? NaN;
      const greatest = (isWhole ? highest[at / kBlock] : least) ?? NaN;
      if (least < low) {
        low = least;
        lowAt = serial;
      }
      if (greatest > high) {
        high = greatest;
        highAt = serial;
      }
      const step = isWhole ? kBlock : 1;
      serial += step;
      at = at + step === room ? 0 : at + step;
    }
    const isLowFirst = lowAt <= highAt;
    this.pair[0] = low > high ? NaN : isLowFirst ? low : high;
    this.pair[1] = low > high ? NaN : isLowFirst ? high : low;
    return this.pair;
  }

  /** Notes the extremes of the block that begins with @param serial. */
  private note(serial: number): void {
    const at = serial % this.room;
    this.values.forEach((column, row) => {
      let low = Infinity;
      let high = -Infinity;
      for (let i = at; i < at + kBlock; ++i) {
        const value = column[i] ?? NaN;
        if (value < low) low = value;
        if (value > high) high = value;
      }
      const lowest = this.lowest[row];
      const highest = this.highest[row];
      if (lowest !== undefined) lowest[at / kBlock] = low;
      if (highest !== undefined) highest[at / kBlock] = high;
    });
  }

  /** More columns, or a block of the oldest samples less. */
  private makeRoom(): void {
    if (this.room === this.capacity) {
      this.begin = Math.floor(this.begin / kBlock) * kBlock + kBlock;
      return;
    }
    const old = this.room;
    this.room = Math.min(this.capacity, Math.max(kFirstRoom, 2 * old));
    this.t = this.moved(this.t, old);
    this.values = this.values.map((column) => this.moved(column, old));
    this.lowest = this.lowest.map(() => new Float64Array(this.room / kBlock));
    this.highest = this.highest.map(() => new Float64Array(this.room / kBlock));
    for (let serial = Math.ceil(this.begin / kBlock) * kBlock; serial + kBlock <= this.end; serial += kBlock)
      this.note(serial);
  }

  private moved(column: Float64Array, old: number): Float64Array<ArrayBuffer> {
    const moved = new Float64Array(this.room);
    for (let serial = this.begin; serial < this.end; ++serial) moved[serial % this.room] = column[serial % old] ?? NaN;
    return moved;
  }
}
