import { useEffect, useMemo, useState } from "preact/hooks";

import { replaceQuery, route, usePage } from "../app/context";
import { useProfile } from "../app/use_profile";
import { hasParameters } from "../model/profile";
import { useRecordedEvents } from "../overview/recorded_events";
import type { StateMachine } from "../source/types";
import { Conditions, type AxisPlace } from "../states/conditions";
import { edgesOf, edgeWords, visitsOf, type Edge } from "../states/edges";
import { layoutOf, type Layout } from "../states/layout";
import { Picture } from "../states/picture";
import { TransitionList } from "../states/transition_list";
import { VisitList } from "../states/visit_list";
import { AxisChoice, useAxis } from "../ui/axis_choice";
import { Notice } from "../ui/notice";
import { useResource } from "../ui/resource";
import { StateChip } from "../ui/state_chip";

/** From one look to the next (ms). */
const kPeriod = 500;
/** So many changes of the state are listed. */
const kVisits = 12;

/** The drawing that fits the window and the states of @param machine. */
function useLayout(machine: StateMachine): Layout {
  const media = useMemo(() => matchMedia("(max-width: 700px)"), []);
  const [isNarrow, setIsNarrow] = useState(media.matches);
  useEffect(() => {
    const look = (): void => setIsNarrow(media.matches);
    media.addEventListener("change", look);
    return () => media.removeEventListener("change", look);
  }, [media]);
  return layoutOf(machine.states, isNarrow);
}

/** What the transition needs that is looked at. */
function Needed(props: { machine: StateMachine; edge: Edge | undefined; place: AxisPlace }) {
  const { machine, edge } = props;
  return (
    <section class="card" aria-labelledby="states-needs">
      <h2 id="states-needs">{edge === undefined ? "Conditions" : edgeWords(edge)}</h2>
      {edge === undefined ? (
        <p class="muted">Choose a transition in the picture, or in the list: its conditions are shown here.</p>
      ) : (
        <Conditions edge={edge} state={machine.state} place={props.place} />
      )}
    </section>
  );
}

function Machine(props: { machine: StateMachine; unit: string }) {
  const { machine, unit } = props;
  const { events, source } = usePage();
  const layout = useLayout(machine);
  const place = { unit, axis: machine.axis, hasParameters: hasParameters(useProfile(unit) ?? "s120") };
  const visits = visitsOf(events.all.value, unit, machine.axis, kVisits);
  const [looked, setLooked] = useState("");
  const [chosen, setChosen] = useState("");
  const edges = useMemo(() => edgesOf(machine), [machine]);
  const fallback = edges.find((edge) => edge.isOpen) ?? edges.find((edge) => edge.from === machine.state);
  const edge = edges.find((each) => each.key === (looked || chosen)) ?? fallback;
  return (
    <>
      <div class="states-columns">
        <div class="card">
          <Picture machine={machine} edges={edges} layout={layout} shown={edge?.key ?? ""} visits={visits} onLook={setLooked} onChoose={setChosen} />
          <p class="muted states-legend">
            Bold green: open. Solid: from here, not open. Thin: from elsewhere. Dashed: the way it has come lately. Numbers are those of CiA 402.
          </p>
        </div>
        <div class="states-side">
          <Needed machine={machine} edge={edge} place={place} />
          <VisitList unit={unit} visits={visits} isLive={source.isLive} />
        </div>
      </div>
      <TransitionList machine={machine} edges={edges} place={place} />
    </>
  );
}

/** The state machine of an axis: where it is, which ways are open, what each of them needs. */
export function States(props: { unit: string }) {
  const { source, units, events } = usePage();
  useRecordedEvents();
  const asked = Number(route.value.query.get("axis") ?? "0");
  const axes = units.find(props.unit)?.axes ?? [];
  const [axis, setAxis] = useAxis(axes, asked);
  const path = `axes/${axis}/state-machine`;
  const machine = useResource(() => source.get<StateMachine>(props.unit, path), [source, props.unit, path], source.isLive ? kPeriod : undefined);
  const choose = (next: number): void => {
    setAxis(next);
    replaceQuery(new URLSearchParams({ axis: String(next) }));
  };
  return (
    <>
      <div class="states-title">
        <h1>State machine</h1>
        <AxisChoice axes={axes} axis={axis} onChange={choose} />
        <span role="status">{machine.value !== undefined && <StateChip state={machine.value.state} />}</span>
      </div>
      {machine.error !== "" && <Notice kind="warning">{`No answer about the state machine: ${machine.error}`}</Notice>}
      {machine.value === undefined ? (
        <VisitList unit={props.unit} visits={visitsOf(events.all.value, props.unit, axis, kVisits)} isLive={source.isLive} />
      ) : (
        <Machine machine={machine.value} unit={props.unit} />
      )}
    </>
  );
}
