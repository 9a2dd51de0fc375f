import { signal } from "@preact/signals";

import { wordsOf } from "../source/refusal";
import type { ParameterEntry } from "../source/types";
import { parts, type ParameterSource, type Wanted } from "./parameter_source";

/** Rows that are added at once. */
const kStep = 64;

/** How far a list is: being asked for, with more to come, whole. */
export type Progress = "asking" | "partial" | "whole";

/** The parameters that are wanted, as many as were asked for, with their present values. */
export class ParameterList {
  readonly rows = signal<readonly ParameterEntry[]>([]);
  readonly progress = signal<Progress>("asking");
  /** Why there is no answer; empty: there was one. */
  readonly error = signal("");
  private wanted?: Wanted;
  private next = 0;
  /** Counts what was wanted: an answer to an earlier one is dropped. */
  private turn = 0;

  constructor(private readonly source: ParameterSource) {}

  /** Begins anew with @param wanted; the rows stay until the first new ones are there. */
  async ask(wanted: Wanted): Promise<void> {
    this.wanted = wanted;
    this.next = 0;
    const turn = ++this.turn;
    await this.fetched(turn, []);
  }

  /** Adds rows at the end, or asks again what failed. */
  async more(): Promise<void> {
    if (this.wanted === undefined || this.progress.value === "asking") return;
    await this.fetched(++this.turn, this.next === 0 ? [] : this.rows.value);
  }

  /** Reads those of @param names again that are listed; what cannot be read stays as it was. */
  async refresh(names: readonly string[]): Promise<void> {
    const { wanted, turn } = this;
    if (wanted === undefined || names.length === 0) return;
    try {
      const entries = await this.source.read(wanted.place, names);
      if (turn !== this.turn) return;
      const now = new Map(entries.map((entry) => [entry.parameter, entry]));
      this.rows.value = this.rows.value.map((row) => now.get(row.parameter) ?? row);
      this.error.value = "";
    } catch (why) {
      if (turn === this.turn) this.error.value = wordsOf(why);
    }
  }

  private async fetched(turn: number, before: readonly ParameterEntry[]): Promise<void> {
    const { wanted } = this;
    if (wanted === undefined) return;
    this.progress.value = "asking";
    let rows = before;
    let next: number | undefined = this.next;
    try {
      while (next !== undefined && rows.length - before.length < kStep) {
        const part = await this.source.part(wanted, next);
        if (turn !== this.turn) return;
        rows = [...rows, ...part.entries];
        next = part.next;
        if (part.entries.length > 0 || next === undefined) this.rows.value = rows;
        this.next = next ?? this.next;
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

/** All that @param wanted finds, for a file; @param told hears after each part how much of it there is (0..1). */
export async function everything(
  source: ParameterSource,
  wanted: Wanted,
  told: (share: number) => void,
): Promise<ParameterEntry[]> {
  const entries: ParameterEntry[] = [];
  for await (const part of parts((from) => source.part(wanted, from))) {
    entries.push(...part.entries);
    told(part.next === undefined || part.total === 0 ? 1 : part.next / part.total);
  }
  return entries;
}
