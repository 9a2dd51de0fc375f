import { useEffect } from "preact/hooks";

import { usePage } from "../app/context";
import type { Events } from "../model/events";
import { readAxrec } from "../recording/axrec";
import type { RecordingFile } from "../source/source";
import type { UnitEvent } from "../source/types";

/** What has happened in @param recordings, the oldest first; of a damaged one what can be read. */
export function eventsIn(recordings: readonly RecordingFile[]): UnitEvent[] {
  const events: UnitEvent[] = [];
  for (const { name, unit, bytes } of recordings) {
    try {
      readAxrec(name, bytes, { frame: () => undefined, samples: () => undefined, event: (event) => events.push({ ...event, unit }) });
    } catch {
      // the scope says what is wrong with it
    }
  }
  return events.sort((a, b) => a.t - b.t);
}

/** Events of recordings that were added already. */
const added = new WeakSet<Events>();

/** Brings the events of a recorded session into the list of all events, once. */
export function useRecordedEvents(): void {
  const { events, source } = usePage();
  useEffect(() => {
    if (source.isLive || added.has(events)) return;
    added.add(events);
    events.add(eventsIn(source.recordings));
  }, [events, source]);
}
