import { signal } from "@preact/signals";

import { wordsOf } from "../source/refusal";
import type { Source } from "../source/source";
import type { UnitOverview } from "../source/types";
import { poll } from "./poll";

/** Time between two looks at all units (ms). */
const kPeriod = 1000;

/** All units as they were seen last; what was seen stays while nobody answers. */
export class Units {
  readonly all = signal<UnitOverview[]>([]);
  /** Why there is no answer at the moment; empty: there is one. */
  readonly absence = signal("");
  /** When the last answer came (ms since 1970); 0: none has. */
  readonly seenAt = signal(0);

  constructor(private readonly source: Source) {}

  /** Looks again and again; a recording once. Returns how to end it. */
  start(): () => void {
    if (this.source.isLive) return poll(() => this.look(), kPeriod);
    void this.look();
    return () => undefined;
  }

  async look(): Promise<void> {
    try {
      this.all.value = await this.source.overview();
      this.seenAt.value = Date.now();
      this.absence.value = "";
    } catch (error) {
      this.absence.value = wordsOf(error);
    }
  }

  /** The unit called @param name, or the only one if that is empty. */
  find(name: string): UnitOverview | undefined {
    if (name === "") return this.all.value[0];
    return this.all.value.find((unit) => unit.unit === name);
  }
}
