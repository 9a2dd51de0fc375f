import type { Place } from "../../source/types";

/** A parameter as manuals print it: p1120, p1070[1], r0722.3. */
export interface ParameterName {
  /** p or r with the number: p1070. */
  base: string;
  index?: number;
  bit?: number;
}

const kName = /^([pr]\d{1,5})(?:\[(\d{1,4})\])?(?:\.(\d{1,2}))?$/;

/** The parts of @param text; undefined: it names no parameter. */
export function parsedName(text: string): ParameterName | undefined {
  const [, base, index, bit] = kName.exec(text.trim().toLowerCase()) ?? [];
  if (base === undefined) return undefined;
  const name: ParameterName = { base };
  if (index !== undefined) name.index = Number(index);
  if (bit !== undefined) name.bit = Number(bit);
  return name;
}

/** @param name without its bit: the parameter that has a value. */
export function withoutBit(name: string): string {
  return name.replace(/\.\d+$/, "");
}

/** A parameter of one of several drive objects. */
export interface PlacedName {
  place: Place;
  name: string;
}

/** The place that @param text names: 0, 1.., infeed; undefined: none. */
export function parsedPlace(text: string | null): Place | undefined {
  if (text === "infeed") return text;
  return text !== null && /^\d{1,2}$/.test(text) ? Number(text) : undefined;
}

/** `1/p0840` as an address has it. */
export function placedText({ place, name }: PlacedName): string {
  return `${place}/${name}`;
}

/** The reverse of placedText(). */
export function parsedPlaced(text: string | null): PlacedName | undefined {
  const [placeText = "", name = ""] = (text ?? "").split("/", 2);
  const place = parsedPlace(placeText);
  return place === undefined || parsedName(name) === undefined ? undefined : { place, name };
}

/** What a place is called. */
export function placeWords(place: number | string): string {
  if (place === "infeed") return "Infeed";
  return Number(place) === 0 ? "Control unit" : `Axis ${place}`;
}

/** The place of an entry, which the protocol has as a number or a text. */
export function placeOf(axis: number | string): Place {
  return axis === "infeed" ? "infeed" : Number(axis);
}
