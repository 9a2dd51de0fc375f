import type { StateMachine } from "../source/types";
import { Conditions, type AxisPlace } from "./conditions";
import { edgeWords, type Edge } from "./edges";

function Ways(props: { edges: Edge[]; machine: StateMachine; place: AxisPlace }) {
  return (
    <ul class="states-ways">
      {props.edges.map((edge) => (
        <li key={edge.key}>
          <details>
            <summary>
              {edgeWords(edge)} {edge.isOpen && <span class="chip tone-run">open</span>}
            </summary>
            <Conditions edge={edge} state={props.machine.state} place={props.place} />
          </details>
        </li>
      ))}
    </ul>
  );
}

/** All transitions as a list, those from the present state first. */
export function TransitionList(props: { machine: StateMachine; edges: Edge[]; place: AxisPlace }) {
  const { machine, edges } = props;
  const others = machine.states.filter((state) => state !== machine.state);
  return (
    <section class="card" aria-labelledby="states-list">
      <h2 id="states-list">All transitions</h2>
      <h3>From {machine.state}, where the axis is</h3>
      <Ways edges={edges.filter((edge) => edge.from === machine.state)} machine={machine} place={props.place} />
      {others.map((state) => {
        const ways = edges.filter((edge) => edge.from === state);
        return (
          ways.length > 0 && (
            <div key={state}>
              <h3>From {state}</h3>
              <Ways edges={ways} machine={machine} place={props.place} />
            </div>
          )
        );
      })}
    </section>
  );
}
