import { linkTo } from "../app/route";
import { opennessWords, type Edge, type Transition } from "./edges";

/** Where the links to parameters lead. */
export interface AxisPlace {
  unit: string;
  axis: number;
  /** Whether there are parameters to lead to. */
  hasParameters: boolean;
}

function Condition(props: { condition: Transition["conditions"][number]; place: AxisPlace }) {
  const { condition, place } = props;
  return (
    <li class={condition.met ? "states-met" : "states-unmet"}>
      <span class="states-mark" aria-hidden="true">
        {condition.met ? "✓" : "✗"}
      </span>
      <span>
        <span class="visually-hidden">{condition.met ? "met: " : "not met: "}</span>
        {condition.text}{" "}
        {place.hasParameters && condition.parameter !== undefined && condition.parameter !== "" && (
          <a class="mono" href={linkTo("parameters", place.unit, { place: place.axis, text: condition.parameter })}>
            {condition.parameter}
          </a>
        )}
      </span>
    </li>
  );
}

function Needs(props: { transition: Transition; state: string; place: AxisPlace }) {
  const { transition } = props;
  return (
    <>
      <p>
        <span class={`chip tone-${transition.is_open ? "run" : "off"}`}>{opennessWords(transition, props.state)}</span>{" "}
        {transition.by_itself === true && <span class="muted">The unit takes it by itself.</span>}
      </p>
      <ul class="states-conditions">
        {transition.conditions.map((condition) => (
          <Condition key={condition.text} condition={condition} place={props.place} />
        ))}
      </ul>
      {transition.conditions.length === 0 && <p class="muted">It needs nothing.</p>}
    </>
  );
}

/** What the transitions of an edge need, met or not. */
export function Conditions(props: { edge: Edge; state: string; place: AxisPlace }) {
  return (
    <>
      {props.edge.transitions.map((transition, index) => (
        <Needs key={index} transition={transition} state={props.state} place={props.place} />
      ))}
    </>
  );
}
