import { candumpOfFrames, csvOfSamples } from "../../recording/export";
import { Refusal } from "../../source/refusal";
import { download } from "../../ui/download";
import type { ScopeState } from "./scope_state";

/** A name of a file for what the window shows: vcan0-5 12.345 s. */
export function fileName(state: ScopeState, ending: string): string {
  const material = state.model.material.peek();
  const name = (material.name === "" ? "scope" : material.name).replace(/\.\w+$/, "").replace(/[^\w.-]+/g, "-");
  return `${name}-${state.model.range().from.toFixed(3)}s.${ending}`;
}

/** Hands the samples in the window to the user. */
export function exportCsv(state: ScopeState): void {
  const { samples, marks } = state.model.material.peek();
  const { from, to } = state.model.range();
  if (samples.size === 0) throw new Refusal("nothing", "There are no samples to export.");
  const trigger = marks.find(({ text }) => text === "trigger")?.t;
  download(fileName(state, "csv"), csvOfSamples(samples, from, to, trigger), "text/csv;charset=utf-8");
}

/** Hands the frames in the window to the user, with the wall clock if it is known. */
export function exportCandump(state: ScopeState): void {
  const material = state.model.material.peek();
  const { from, to } = state.model.range();
  const [begin, end] = material.frames.range(from, to);
  if (begin >= end) throw new Refusal("nothing", "There are no frames in this window to export.");
  const bus = busName(material.unit);
  download(fileName(state, "log"), candumpOfFrames(material.frames, from, to, bus, material.startedAt ?? wallClock(state)));
}

/** The bus of @param unit if an interface of the kernel can be called so, else can0. */
export function busName(unit: string): string {
  const name = unit.split("/")[0] ?? "";
  return /^[\w.-]{1,15}$/.test(name) ? name : "can0";
}

/** Time zero of a unit that lives (seconds since 1970), as well as the page knows it. */
function wallClock(state: ScopeState): number {
  return state.live === undefined ? 0 : Date.now() / 1000 - state.live.clock.latest;
}
