import type { SignalHead } from "../../model/sample_store";
import { wordsOf } from "../../source/refusal";
import type { Source } from "../../source/source";
import type { SignalEntry, Status } from "../../source/types";

/** A signal that was looked up: the unit has it, or says why not. */
export interface FoundSignal {
  head: SignalHead;
  /** Empty: there is such a signal. */
  problem: string;
}

interface Values {
  signals: { signal: string; unit: string }[];
}

/** Looks up signals of a unit, each one once. */
export class SignalHeads {
  private readonly known = new Map<string, FoundSignal>();

  constructor(
    private readonly source: Source,
    private readonly unit: string,
  ) {}

  /** Takes what a search has found. */
  learn(entry: SignalEntry, name = entry.signal): void {
    this.known.set(name, { head: { signal: name, unit: entry.unit, text: entry.text }, problem: "" });
  }

  /** The signals called @param names, in their order. */
  async find(names: readonly string[]): Promise<FoundSignal[]> {
    return Promise.all(names.map((name) => this.findOne(name)));
  }

  /** What of @param names is known already, for what has to be shown at once. */
  present(names: readonly string[]): FoundSignal[] {
    return names.map((name) => this.known.get(name) ?? { head: { signal: name }, problem: "" });
  }

  private async findOne(name: string): Promise<FoundSignal> {
    const found = this.known.get(name);
    if (found !== undefined && found.problem === "") return found;
    const made = await this.ask(name);
    this.known.set(name, made);
    return made;
  }

  private async ask(name: string): Promise<FoundSignal> {
    try {
      const values = await this.source.get<Values>(this.unit, "signals/values", { signals: name });
      return { head: { signal: name, unit: values.signals[0]?.unit, text: await this.textOf(name) }, problem: "" };
    } catch (error) {
      return { head: { signal: name }, problem: wordsOf(error) };
    }
  }

  private async textOf(name: string): Promise<string> {
    const plain = name.replace(/\[\d+\]/, "").replace(/(\/[pr]\d+)\.\d+$/, "$1");
    const search = { search: plain, count: 20 };
    const page = await this.source.get<{ signals: SignalEntry[] }>(this.unit, "signals", search).catch(() => ({ signals: [] }));
    return page.signals.find(({ signal }) => signal === plain)?.text ?? "";
  }
}

/** What is shown of a unit at first: speed, its setpoint and torque of the first axis, and the DC link. */
export async function usualSignals(source: Source, unit: string): Promise<string[]> {
  const status = await source.get<Status>(unit, "").catch(() => undefined);
  const axis = status?.axes[0]?.axis;
  if (axis === undefined) return [];
  return [`${axis}/speed`, `${axis}/speed_setpoint`, `${axis}/torque`, "0/dc_voltage"];
}
