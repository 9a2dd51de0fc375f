import { signal } from "@preact/signals";

import { wordsOf } from "../source/refusal";

/** Something that was sent, and what came of it. */
export interface Entry {
  id: number;
  /** When it was sent (ms since 1970). */
  at: number;
  words: string;
  outcome: "waiting" | "done" | "refused";
  /** What the unit has said. */
  text: string;
}

/** Most entries that are kept. */
const kMost = 100;

/** What was sent by hand from this page, the oldest first. */
export class Journal {
  readonly entries = signal<Entry[]>([]);
  private next = 1;

  /** Notes an action that is sent now. Returns how to say what came of it. */
  begin(words: string): (outcome: "done" | "refused", text?: string) => void {
    const id = this.next++;
    this.entries.value = [...this.entries.value, { id, at: Date.now(), words, outcome: "waiting" as const, text: "" }].slice(-kMost);
    return (outcome, text = "") => {
      this.entries.value = this.entries.value.map((entry) => (entry.id === id ? { ...entry, outcome, text } : entry));
    };
  }

  /** Does @param work, and notes it as @param words with the text that it ends with, if that is one. What it throws goes on. */
  async run<T>(words: string, work: () => Promise<T>): Promise<T> {
    const end = this.begin(words);
    try {
      const answer = await work();
      end("done", typeof answer === "string" ? answer : "");
      return answer;
    } catch (error) {
      end("refused", wordsOf(error));
      throw error;
    }
  }
}
