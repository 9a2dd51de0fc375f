import type { UnitOverview } from "../source/types";
import { kStateLooks } from "../ui/state_words";
import type { Cell } from "./cells";

/** Bus and node of a unit's name: "vcan0/5". */
function partsOf(unit: string): [string, number] {
  const slash = unit.lastIndexOf("/");
  return [unit.slice(0, slash), Number(unit.slice(slash + 1))];
}

/** Whether @param a comes before @param b, by bus and then by number of the node. */
export function byName(a: string, b: string): number {
  const [busA, nodeA] = partsOf(a);
  const [busB, nodeB] = partsOf(b);
  if (busA === busB) return nodeA - nodeB;
  return busA.localeCompare(busB, "en", { numeric: true });
}

/** Units whose name, axes or state have all words of @param text, by bus and node. */
export function unitsWith(text: string, units: readonly UnitOverview[]): UnitOverview[] {
  const words = text.toLowerCase().split(/\s+/).filter((word) => word !== "");
  const all = (unit: UnitOverview): string => {
    const axes = (unit.axes ?? []).map((axis) => `${axis.name} ${axis.type} ${axis.state} ${axis.mode ?? ""}`);
    return [unit.unit, unit.profile ?? "", unit.nmt_state ?? "", unit.error ?? "", ...axes].join(" ").toLowerCase();
  };
  const fitting = words.length === 0 ? [...units] : units.filter((unit) => words.every((word) => all(unit).includes(word)));
  return fitting.sort((a, b) => byName(a.unit, b.unit));
}

/** @param cells with the greatest value first; those that are alike stay as they were. */
export function byValue(cells: readonly Cell[]): Cell[] {
  return [...cells].sort((a, b) => b.value - a.value);
}

/** How many cells have each state, in the order in which states are told everywhere; others behind. */
export function countsOf(cells: readonly Cell[]): [state: string, count: number][] {
  const counts = new Map<string, number>(Object.keys(kStateLooks).map((state) => [state, 0]));
  for (const { state } of cells) counts.set(state, (counts.get(state) ?? 0) + 1);
  return [...counts].filter(([, count]) => count > 0);
}

/** Where a cell is on the screen. */
export interface Spot {
  left: number;
  top: number;
}

function nearestInRow(spots: readonly Spot[], top: number, left: number): number {
  let best = -1;
  spots.forEach((spot, index) => {
    if (spot.top !== top) return;
    const isNearer = best < 0 || Math.abs(spot.left - left) < Math.abs((spots[best]?.left ?? 0) - left);
    if (isNearer) best = index;
  });
  return best;
}

function rowFrom(spots: readonly Spot[], index: number, step: 1 | -1): number {
  const here = spots[index];
  if (here === undefined) return index;
  const tops = spots.map((spot) => spot.top).filter((top) => (top - here.top) * step > 0);
  return tops.length === 0 ? index : nearestInRow(spots, step > 0 ? Math.min(...tops) : Math.max(...tops), here.left);
}

/** The cell that @param key leads to from cell @param index; undefined: the key leads nowhere. */
export function nextCell(spots: readonly Spot[], index: number, key: string): number | undefined {
  switch (key) {
    case "ArrowRight":
      return Math.min(index + 1, spots.length - 1);
    case "ArrowLeft":
      return Math.max(index - 1, 0);
    case "ArrowDown":
      return rowFrom(spots, index, 1);
    case "ArrowUp":
      return rowFrom(spots, index, -1);
    case "Home":
      return 0;
    case "End":
      return spots.length - 1;
    default:
      return undefined;
  }
}
