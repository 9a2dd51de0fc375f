import type { ParameterEntry, Place } from "../../source/types";
import { finds } from "../text/search_text";
import { bitWidth } from "../text/value_text";

/** Suggestions that a list shows at most. */
const kMost = 40;

/** How the source of an input is written that stands in drive object @param own. */
function sourceText(text: string, source: ParameterEntry, own: number): string {
  return source.drive_object === own ? text : `${text} of drive object ${source.drive_object}`;
}

/** The texts by which an input of type @param type takes from @param source. */
function textsOf(source: ParameterEntry, type: "BI" | "CI"): string[] {
  if (type === "CI") return [source.parameter];
  return Array.from({ length: bitWidth(source) }, (_, bit) => `${source.parameter}.${bit}`);
}

/** What an input of type @param type in drive object @param own can be wired to, out of @param sources, for what was @param typed. */
export function suggestionsOf(
  sources: readonly ParameterEntry[],
  type: "BI" | "CI",
  own: number,
  typed: string,
): string[] {
  const constants = type === "BI" ? ["0", "1"] : ["0"];
  const wanted = typed.replace(/ of (drive object|axis).*$/, "").toLowerCase();
  const texts = sources
    .filter((source) => source.uses !== undefined && finds(wanted, source))
    .flatMap((source) => textsOf(source, type).map((text) => sourceText(text, source, own)));
  const bit = /\.\d+$/.exec(wanted);
  const exact = bit === null ? texts : texts.filter((text) => text.startsWith(wanted));
  return [...constants, ...exact].slice(0, kMost);
}

/** The places whose outputs are suggested to an input at @param place: its own, and the control unit's. */
export function sourcePlaces(place: Place): Place[] {
  return place === 0 ? [0] : [place, 0];
}
