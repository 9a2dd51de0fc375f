import type { Source } from "../../source/source";
import { LiveMaterial } from "./live_material";

/** A unit that nobody looks at any more is listened to for so long (ms): whoever comes back finds what has happened. */
const kPatience = 300_000;

interface Listened {
  material: LiveMaterial;
  end: () => void;
  timer?: ReturnType<typeof setTimeout>;
}

let present: Listened | undefined;

function end(): void {
  if (present === undefined) return;
  clearTimeout(present.timer);
  present.end();
  present = undefined;
}

/** What comes of the unit called @param unit; another one is no longer listened to. */
export function listenTo(unit: string, source: Source): LiveMaterial {
  if (present?.material.unit !== unit) present = begin(unit, source);
  clearTimeout(present.timer);
  present.material.isWatched = true;
  return present.material;
}

function begin(unit: string, source: Source): Listened {
  end();
  const material = new LiveMaterial(unit, source);
  return { material, end: material.start() };
}

/** Nobody looks at @param material any more. */
export function leave(material: LiveMaterial): void {
  if (present?.material !== material) return;
  material.isWatched = false;
  present.timer = setTimeout(end, kPatience);
}
