import type { UnitEvent } from "../../source/types";

/** Times of a run may go back by so much (s): events of two sources come in one list. */
const kTolerance = 0.5;

/** Those of @param events, in the order in which they came, which belong to the run that goes on: its time began anew. */
export function presentRun(events: readonly UnitEvent[]): readonly UnitEvent[] {
  let begin = 0;
  for (let i = 1; i < events.length; ++i) {
    const before = events[i - 1]?.t ?? 0;
    if ((events[i]?.t ?? 0) < before - kTolerance) begin = i;
  }
  return begin === 0 ? events : events.slice(begin);
}
