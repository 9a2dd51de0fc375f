import type { UnitEvent } from "../../source/types";

/** How events of a kind look among the others: a shape, a letter, a tone, and a rank for who is in front. */
export interface MarkLook {
  shape: "triangle" | "diamond" | "square" | "circle" | "cross";
  letter: string;
  tone: string;
  rank: number;
  name: string;
}

const kLooks: Record<string, MarkLook> = {
  fault: { shape: "triangle", letter: "F", tone: "fault", rank: 9, name: "fault" },
  alarm: { shape: "diamond", letter: "A", tone: "brake", rank: 8, name: "alarm" },
  refusal: { shape: "cross", letter: "X", tone: "fault", rank: 7, name: "refused write" },
  control: { shape: "circle", letter: "C", tone: "ready", rank: 6, name: "action over the control socket" },
  emcy: { shape: "triangle", letter: "E", tone: "brake", rank: 5, name: "emergency message" },
  bus: { shape: "diamond", letter: "B", tone: "brake", rank: 4, name: "CAN controller" },
  link: { shape: "diamond", letter: "L", tone: "brake", rank: 4, name: "bus" },
  parameter: { shape: "square", letter: "P", tone: "on", rank: 3, name: "written parameter" },
  object: { shape: "square", letter: "O", tone: "on", rank: 3, name: "written object" },
  power: { shape: "circle", letter: "I", tone: "off", rank: 2, name: "power" },
  "boot-up": { shape: "circle", letter: "U", tone: "off", rank: 2, name: "boot-up" },
  store: { shape: "square", letter: "S", tone: "off", rank: 1, name: "saved" },
  restore: { shape: "square", letter: "R", tone: "off", rank: 1, name: "factory settings" },
};

/** How @param event looks among the marks; undefined: it is a band (states) instead. */
export function markLook(event: UnitEvent): MarkLook | undefined {
  if (event.kind === "drive-state" || event.kind === "nmt") return undefined;
  return kLooks[event.kind] ?? { shape: "circle", letter: "?", tone: "off", rank: 0, name: event.kind };
}

/** Marks that are drawn as one. */
export interface Cluster {
  x: number;
  /** The most important one, of equals the first. */
  event: UnitEvent;
  look: MarkLook;
  count: number;
}

/** Joins marks that are closer than @param distance to the first of their cluster. */
export function clustersOf(events: readonly UnitEvent[], xOf: (t: number) => number, distance: number): Cluster[] {
  const clusters: Cluster[] = [];
  for (const event of events) {
    const look = markLook(event);
    if (look === undefined) continue;
    const x = xOf(event.t);
    const last = clusters.at(-1);
    if (last === undefined || x - last.x > distance) clusters.push({ x, event, look, count: 1 });
    else {
      ++last.count;
      if (look.rank > last.look.rank) Object.assign(last, { event, look });
    }
  }
  return clusters;
}
