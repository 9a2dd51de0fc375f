import type { ParameterEntry, Place } from "../../source/types";
import { placeOf, placeWords, type PlacedName } from "../text/names";
import { bitsOf, quantity, valueText } from "../text/value_text";

/** A box of the drawing. */
export interface Node {
  /** Where it leads to; absent: the parameter that is looked at, or a constant. */
  target?: PlacedName;
  title: string;
  name: string;
  value: string;
  column: 0 | 1 | 2;
  row: number;
  isCentre: boolean;
}

/** A line from the right side of a box to the left side of another, with the bit or index that is taken. */
export interface Edge {
  from: number;
  to: number;
  label: string;
}

/** What is drawn around a parameter. */
export interface Wiring {
  nodes: Node[];
  edges: Edge[];
  rows: number;
  /** What is not drawn, in words. */
  remark: string;
}

/** What is known of the neighbours, by place and name. */
export type Neighbours = ReadonlyMap<string, ParameterEntry>;

type Use = NonNullable<ParameterEntry["used_by"]>[number];

/** The key of a neighbour. */
export function keyOf(place: Place, name: string): string {
  return `${place}/${name}`;
}

function titleOf(place: Place, name: string, own: Place): string {
  return place === own ? name : `${name}, ${placeWords(place)}`;
}

function presentOf(entry: ParameterEntry | undefined): string {
  return entry === undefined ? "" : quantity(entry.value, entry.unit);
}

/** The part of an output that an input of @param type takes: a bit, or an index. */
function portOf(position: number, type: string | undefined, indices: number): string {
  if (indices > 1) return `[${position}]`;
  return type === "BI" ? `bit ${position}` : "";
}

function useNode(use: Use, own: Place, known: Neighbours, column: 1 | 2, row: number): Node {
  const place = placeOf(use.axis);
  const entry = known.get(keyOf(place, use.parameter));
  return {
    target: { place, name: use.parameter },
    title: titleOf(place, use.parameter, own),
    name: entry?.name ?? "",
    value: presentOf(entry),
    column,
    row,
    isCentre: false,
  };
}

function centreOf(entry: ParameterEntry): Node {
  return {
    title: entry.parameter,
    name: entry.name,
    value: quantity(entry.value, entry.unit),
    column: 1,
    row: 0,
    isCentre: true,
  };
}

/** The parameters whose names and values the drawing of @param entry wants. */
export function neighboursOf(entry: ParameterEntry): PlacedName[] {
  const { source } = entry;
  if (source !== undefined) return [{ place: placeOf(source.axis ?? entry.axis), name: source.parameter }];
  return usersOf(entry).map((use) => ({ place: placeOf(use.axis), name: use.parameter }));
}

/** Who uses @param entry; of a bit who uses that bit. */
export function usersOf(entry: ParameterEntry): Use[] {
  const all = entry.used_by ?? [];
  return entry.bit === undefined ? all : all.filter((use) => use.position === entry.bit);
}

/** Drawing of an input: its source, itself, and below it the others that take the same. */
function inputWiring(entry: ParameterEntry, known: Neighbours): Wiring {
  const own = placeOf(entry.axis);
  const { source } = entry;
  const nodes = [centreOf(entry)];
  if (source === undefined) {
    nodes.push({ title: valueText(entry.value), name: "constant", value: "", column: 0, row: 0, isCentre: false });
    return { nodes, edges: [{ from: 1, to: 0, label: "" }], rows: 1, remark: "" };
  }
  const place = placeOf(source.axis ?? entry.axis);
  const owner = known.get(keyOf(place, source.parameter));
  const value = source.value === undefined ? "" : quantity(source.value, entry.type === "BI" ? "" : (owner?.unit ?? ""));
  const target = { place, name: source.parameter };
  nodes.push({ target, title: titleOf(place, source.parameter, own), name: source.name ?? "", value, column: 0, row: 0, isCentre: false });
  const others = (owner?.used_by ?? []).filter(
    (use) => use.position === source.position && !(placeOf(use.axis) === own && use.parameter === entry.parameter),
  );
  nodes.push(...others.map((use, at) => useNode(use, own, known, 1, at + 1)));
  const label = portOf(source.position, entry.type, owner?.indices ?? 1);
  const edges = [{ from: 1, to: 0, label }, ...others.map((_, at) => ({ from: 1, to: at + 2, label: "" }))];
  return { nodes, edges, rows: others.length + 1, remark: "" };
}

/** Drawing of an output: itself, and who uses it. */
function outputWiring(entry: ParameterEntry, known: Neighbours): Wiring {
  const own = placeOf(entry.axis);
  const users = usersOf(entry);
  const nodes = [centreOf(entry), ...users.map((use, at) => useNode(use, own, known, 2, at))];
  const edges = users.map((use, at) => {
    const type = known.get(keyOf(placeOf(use.axis), use.parameter))?.type;
    return { from: 0, to: at + 1, label: portOf(use.position, type, entry.indices) };
  });
  const left = (entry.uses ?? 0) - (entry.used_by ?? []).length;
  const remark = left > 0 ? `${left} more inputs use it than are drawn.` : users.length === 0 ? "No input uses it." : "";
  return { nodes, edges, rows: Math.max(1, users.length), remark };
}

/** What is drawn around @param entry; undefined: it is neither input nor output of BICO. */
export function wiringOf(entry: ParameterEntry, known: Neighbours): Wiring | undefined {
  if (entry.type === "BI" || entry.type === "CI") return inputWiring(entry, known);
  return entry.uses === undefined ? undefined : outputWiring(entry, known);
}

/** A bit of a word, with who uses it. */
export interface Bit {
  bit: number;
  isSet: boolean;
  users: Use[];
}

/** The bits of @param entry, @param width of them. */
export function bitRows(entry: ParameterEntry, width: number): Bit[] {
  return bitsOf(Number(entry.value), width).map((isSet, bit) => ({
    bit,
    isSet,
    users: (entry.used_by ?? []).filter((use) => use.position === bit),
  }));
}
