import type { Query, Source } from "../../source/source";
import type { ParameterDifference, ParameterEntry, Place } from "../../source/types";
import { holds } from "../text/filters";
import { placeOf } from "../text/names";
import type { Part } from "../shared/paged_list";
import type { Differences, Elsewhere, ParameterSource, Reference, Wanted } from "./parameter_source";
import { finds, searchedText } from "../text/search_text";

/** So many parameters are read with one request. */
const kMostAtOnce = 32;

interface Page<T> {
  parameters: T[];
  next?: number;
  total: number;
}

function partOf<T>(page: Page<T>, chosen: (entry: T) => boolean): Part<T> {
  const part: Part<T> = { entries: page.parameters.filter(chosen), total: page.total };
  if (page.next !== undefined) part.next = page.next;
  return part;
}

/** The parameters of a unit that lives. */
export class LiveParameters implements ParameterSource {
  constructor(
    private readonly source: Source,
    private readonly unit: string,
  ) {}

  async part(wanted: Wanted, from: number): Promise<Part<ParameterEntry>> {
    const { place, text, filter } = wanted;
    const isShort = filter === "changed" || filter === "unsaved";
    if (text.trim() === "" || isShort) {
      const page = await this.page<ParameterEntry>(`axes/${place}/parameters`, { filter, from });
      return partOf(page, (entry) => finds(text, entry));
    }
    const page = await this.page<ParameterEntry>("parameters", { text: searchedText(text), axis: place, from });
    return partOf(page, (entry) => holds(filter, entry));
  }

  async read(place: Place, names: readonly string[]): Promise<ParameterEntry[]> {
    const entries: ParameterEntry[] = [];
    for (let first = 0; first < names.length; first += kMostAtOnce) {
      const some = names.slice(first, first + kMostAtOnce).map(encodeURIComponent).join(",");
      const page = await this.page<ParameterEntry>(`parameters/${some}`, { axis: place });
      entries.push(...page.parameters);
    }
    return entries;
  }

  async elsewhere(text: string): Promise<Elsewhere[]> {
    type Found = { parameter: string; name: string; axes: (number | string)[] };
    const page = await this.page<Found>("parameters", { text: searchedText(text) });
    return page.parameters.map(({ parameter, name, axes }) => ({ parameter, name, places: axes.map(placeOf) }));
  }

  async differences(against: Reference, from: number): Promise<Differences> {
    const page = await this.source.get<Page<ParameterDifference> & { is_stored: boolean }>(this.unit, "parameters/diff", {
      against,
      from,
    });
    return { ...partOf(page, () => true), isStored: page.is_stored };
  }

  private page<T>(resource: string, query: Query): Promise<Page<T>> {
    return this.source.get(this.unit, resource, query);
  }
}
