import { useMemo, useState } from "preact/hooks";

import { usePage } from "../app/context";
import type { UnitEvent } from "../source/types";
import { duration } from "../ui/number";
import { eventLook, eventWords, originWords, placeWords, withoutRepeats } from "./event_words";

/** Most events that are shown. */
const kMost = 100;

const kChoices = [
  { name: "everything", kinds: undefined },
  { name: "states", kinds: ["nmt", "drive-state", "power", "boot-up", "link", "bus"] },
  { name: "faults and alarms", kinds: ["fault", "alarm", "emcy"] },
  { name: "writes and actions", kinds: ["parameter", "object", "refusal", "store", "restore", "control"] },
] as const;

function EventLine(props: { event: UnitEvent; withUnit: boolean }) {
  const { event } = props;
  const look = eventLook(event);
  const place = [props.withUnit ? (event.unit ?? "") : "", placeWords(event)].filter((word) => word !== "").join(" ");
  return (
    <li class="event-line">
      <span class={`event-mark tone-${look.tone}`} title={look.title}>
        <span aria-hidden="true">{look.glyph}</span>
        <span class="visually-hidden">{look.title}</span>
      </span>
      <span class="event-time mono">{duration(event.t)}</span>
      <span class="event-words">
        {place === "" ? "" : <span class="muted">{place} </span>}
        {eventWords(event)}
      </span>
      <span class="event-origin muted">{originWords(event)}</span>
    </li>
  );
}

/** What changed last, the newest first. */
export function EventList() {
  const { events, units, source } = usePage();
  const [choice, setChoice] = useState(0);
  const kinds: readonly string[] | undefined = kChoices[choice]?.kinds;
  const told = useMemo(() => withoutRepeats(events.all.value), [events.all.value]);
  const all = told.filter((event) => kinds === undefined || kinds.includes(event.kind));
  const newest = all.slice(-kMost).reverse();
  return (
    <section class="card overview-events" aria-labelledby="events-title">
      <div class="overview-line">
        <h2 id="events-title">What changed last</h2>
        <label class="muted">
          Show{" "}
          <select value={choice} onChange={(event) => setChoice(Number(event.currentTarget.value))}>
            {kChoices.map(({ name }, index) => (
              <option key={name} value={index}>
                {name}
              </option>
            ))}
          </select>
        </label>
      </div>
      {events.lost.value > 0 && <p class="muted">{events.lost.value} events came faster than they could be taken.</p>}
      {newest.length === 0 && <p class="muted">{source.isLive ? "Nothing has happened since the page was opened." : "No events were recorded."}</p>}
      <ol class="event-lines" tabIndex={0} aria-label="Events, the newest first">
        {newest.map((event, index) => (
          <EventLine key={event.id ?? `${all.length - index}`} event={event} withUnit={units.all.value.length > 1} />
        ))}
      </ol>
      {all.length > newest.length && <p class="muted">{all.length - newest.length} more before these.</p>}
    </section>
  );
}
