import { signal } from "@preact/signals";

import { wordsOf } from "../../source/refusal";

/** A part of a list; the next one begins at `next`, which is absent with the last one. */
export interface Part<T> {
  entries: T[];
  next?: number;
  /** Values that were or will be looked at for the whole list. */
  total: number;
}

/** Where the rows of a list come from. All promises are rejected with a Refusal. */
export interface RowSource<T, W> {
  /** A part of what is @param wanted. */
  part(wanted: W, from: number): Promise<Part<T>>;
  /** Those of @param rows as they are now; what cannot be told may be missing. */
  again(wanted: W, rows: readonly T[]): Promise<T[]>;
  /** What tells rows apart. */
  key(row: T): string;
}

/** How far a list is: being asked for, with more to come, whole. */
export type Progress = "asking" | "partial" | "whole";

/** Rows that are added at once. */
const kStep = 64;

/** A long list of which so much is there as was asked for, with its present values. */
export class PagedList<T, W> {
  readonly rows = signal<readonly T[]>([]);
  readonly progress = signal<Progress>("asking");
  /** Why there is no answer; empty: there was one. */
  readonly error = signal("");
  /** When the last answer came (ms since 1970); 0: none has. */
  seenAt = 0;
  private wanted?: W;
  private next = 0;
  /** Counts what was wanted: an answer to an earlier one is dropped. */
  private turn = 0;

  constructor(private readonly source: RowSource<T, W>) {}

  /** Begins anew with @param wanted; the rows stay until the first new ones are there. */
  async ask(wanted: W): Promise<void> {
    this.wanted = wanted;
    this.next = 0;
    await this.fetched(++this.turn, []);
  }

  /** Adds rows at the end, or asks again what failed. */
  async more(): Promise<void> {
    if (this.progress.value === "asking") return;
    await this.fetched(++this.turn, this.next === 0 ? [] : this.rows.value);
  }

  /** Reads the rows with @param keys again; no row moves, and what cannot be read stays as it was. */
  async refresh(keys: readonly string[]): Promise<void> {
    const { wanted, turn } = this;
    const some = this.rows.value.filter((row) => keys.includes(this.source.key(row)));
    if (wanted === undefined || some.length === 0) return;
    try {
      const entries = await this.source.again(wanted, some);
      if (turn !== this.turn) return;
      const now = new Map(entries.map((entry) => [this.source.key(entry), entry]));
      this.rows.value = this.rows.value.map((row) => now.get(this.source.key(row)) ?? row);
      this.seenAt = Date.now();
      this.error.value = "";
    } catch (why) {
      if (turn === this.turn) this.error.value = wordsOf(why);
    }
  }

  private async fetched(turn: number, before: readonly T[]): Promise<void> {
    const { wanted } = this;
    if (wanted === undefined) return;
    this.progress.value = "asking";
    let rows = before;
    let next: number | undefined = this.next;
    try {
      while (next !== undefined && rows.length - before.length < kStep) {
        const part: Part<T> = await this.source.part(wanted, next);
        if (turn !== this.turn) return;
        rows = [...rows, ...part.entries];
        next = part.next;
        if (part.entries.length > 0 || next === undefined) this.rows.value = rows;
        this.next = next ?? this.next;
        this.seenAt = Date.now();
      }
      this.error.value = "";
      this.progress.value = next === undefined ? "whole" : "partial";
    } catch (why) {
      if (turn !== this.turn) return;
      this.error.value = wordsOf(why);
      this.progress.value = "partial";
    }
  }
}

/** All parts that @param ask gives, one behind the other. */
export async function* parts<P extends { next?: number }>(ask: (from: number) => Promise<P>): AsyncGenerator<P> {
  let from: number | undefined = 0;
  while (from !== undefined) {
    const part: P = await ask(from);
    yield part;
    from = part.next;
  }
}

/** All that @param ask gives, for a file; @param told hears after each part how much of it there is (0..1). */
export async function everything<T>(
  ask: (from: number) => Promise<Part<T>>,
  told: (share: number) => void,
): Promise<T[]> {
  const entries: T[] = [];
  for await (const part of parts(ask)) {
    entries.push(...part.entries);
    told(part.next === undefined || part.total === 0 ? 1 : part.next / part.total);
  }
  return entries;
}
