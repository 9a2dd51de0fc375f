import type { InjectedFault } from "../../source/types";
import type { Resource } from "../../ui/resource";
import { Notice } from "../../ui/notice";
import { Problem, useAction, type Hand } from "../action";
import { faultWords } from "./wire_form";

/** Faults on the wire that are injected, with what they have hit; each can be taken back. */
export function WireList(props: { hand: Hand; list: Resource<{ faults: InjectedFault[] }> }) {
  const { hand, list } = props;
  const action = useAction(hand.journal);
  const remove = (words: string, query: Record<string, number>): void => {
    void action.run(words, () => hand.source.act("DELETE", hand.unit, "injected", undefined, query)).then(list.again);
  };
  const faults = list.value?.faults ?? [];
  return (
    <>
      <h3>Injected</h3>
      {list.error !== "" && <Notice kind="warning">{`What is injected is not known: ${list.error}`}</Notice>}
      {list.value !== undefined && faults.length === 0 && <p class="muted">None.</p>}
      <ul class="hands-injected">
        {faults.map((fault) => (
          <li key={fault.id}>
            <span>
              <strong class="mono">{fault.kind}</strong> <span class="muted">{faultWords(fault.fault)}</span>
              <br />
              {fault.state}, {fault.hits} hits of {fault.opportunities} opportunities
            </span>
            <button type="button" onClick={() => remove(`Take ${fault.kind} (${fault.id}) back`, { id: fault.id })}>
              Take back<span class="visually-hidden"> {fault.kind}</span>
            </button>
          </li>
        ))}
      </ul>
      {faults.length > 1 && (
        <button type="button" onClick={() => remove("Take all injected faults back", {})}>
          Take all back
        </button>
      )}
      <Problem lines={action.problem} />
    </>
  );
}
