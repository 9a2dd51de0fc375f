import { linkTo } from "../app/route";
import { duration } from "../ui/number";
import { StateChip } from "../ui/state_chip";
import type { Visit } from "./edges";

/** The way that the axis has come lately, the newest first. */
export function VisitList(props: { unit: string; visits: Visit[]; isLive: boolean }) {
  return (
    <section class="card" aria-labelledby="states-way">
      <h2 id="states-way">The way it has come</h2>
      {props.visits.length === 0 && (
        <p class="muted">{props.isLive ? "The state has not changed since the page was opened." : "No change of state was recorded."}</p>
      )}
      <ol class="states-visits">
        {props.visits.map((visit) => (
          <li key={`${visit.t} ${visit.state}`}>
            <span class="mono muted">{duration(visit.t)}</span> <StateChip state={visit.state} />{" "}
            <span class="muted">
              from {visit.before}
              {visit.stayed === undefined ? "" : `, for ${duration(visit.stayed)}`}
            </span>
          </li>
        ))}
      </ol>
      {props.visits.length > 0 && <a href={linkTo("scope", props.unit)}>What caused each of them: scope</a>}
    </section>
  );
}
