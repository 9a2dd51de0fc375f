import type { Source } from "../../source/source";
import type { ParameterDifference, ParameterEntry, Place } from "../../source/types";
import { holds } from "../text/filters";
import { parsedName, placeOf, withoutBit } from "../text/names";
import type { Part } from "../shared/paged_list";
import type { Differences, Elsewhere, ParameterSource, Reference, Wanted } from "./parameter_source";
import { finds } from "../text/search_text";

/** Entries of a part: the page need not show thousands at once. */
const kPart = 64;

/** The entry that @param name means among @param entries, with the bit's value where it names one. */
export function entryNamed(entries: readonly ParameterEntry[], name: string): ParameterEntry | undefined {
  const parsed = parsedName(name);
  const whole = withoutBit(name);
  const found =
    entries.find((entry) => entry.parameter === whole) ??
    entries.find((entry) => entry.index === (parsed?.index ?? 0) && entry.parameter.startsWith(`${parsed?.base ?? whole}[`));
  if (found === undefined || parsed?.bit === undefined) return found;
  const value = Math.floor(Number(found.value) / 2 ** parsed.bit) % 2;
  return { ...found, parameter: name, bit: parsed.bit, value };
}

/** The parameters of a recorded session, which has the whole lists. */
export class RecordedParameters implements ParameterSource {
  constructor(
    private readonly source: Source,
    private readonly unit: string,
  ) {}

  async part(wanted: Wanted, from: number): Promise<Part<ParameterEntry>> {
    const all = await this.listOf(wanted.place);
    const part: Part<ParameterEntry> = { entries: [], total: all.length };
    for (let at = from; at < all.length; ++at) {
      if (part.entries.length === kPart) return { ...part, next: at };
      const entry = all[at];
      if (entry !== undefined && holds(wanted.filter, entry) && finds(wanted.text, entry)) part.entries.push(entry);
    }
    return part;
  }

  async read(place: Place, names: readonly string[]): Promise<ParameterEntry[]> {
    const all = await this.listOf(place);
    return names.map((name) => entryNamed(all, name)).filter((entry) => entry !== undefined);
  }

  async elsewhere(text: string): Promise<Elsewhere[]> {
    const found = new Map<string, Elsewhere>();
    for (const place of await this.places()) {
      const entries = await this.listOf(place).catch(() => []);
      for (const { parameter, name, axis, index } of entries.filter((entry) => finds(text, entry))) {
        if (index !== 0) continue;
        const known = found.get(parameter);
        if (known === undefined) found.set(parameter, { parameter, name, places: [placeOf(axis)] });
        else known.places.push(placeOf(axis));
      }
    }
    return [...found.values()];
  }

  async differences(against: Reference): Promise<Differences> {
    type Recorded = { parameters: ParameterDifference[]; is_stored?: boolean };
    const recorded = await this.source.get<Recorded>(this.unit, "parameters/diff", { against });
    const { parameters } = recorded;
    return { entries: parameters, total: parameters.length, isStored: recorded.is_stored ?? true };
  }

  private async listOf(place: Place): Promise<ParameterEntry[]> {
    return this.source.all(this.unit, `axes/${place}/parameters`, "parameters");
  }

  private async places(): Promise<Place[]> {
    const status = await this.source.get<{ axes?: { axis: number }[] }>(this.unit, "");
    return [0, ...(status.axes ?? []).map(({ axis }) => axis), "infeed"];
  }
}
