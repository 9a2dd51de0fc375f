import { useState } from "preact/hooks";

import { usePage } from "../../app/context";
import type { InjectedFault, InjectKind } from "../../source/types";
import { useResource } from "../../ui/resource";
import { Notice } from "../../ui/notice";
import { Card, Problem, useAction, type Hand } from "../action";
import { bodyOf, fieldsOf, missingOf, type WireField } from "./wire_form";
import { WireList } from "./wire_list";

type Texts = Record<string, string>;

function Field(props: { field: WireField; text: string; onInput: (text: string) => void }) {
  const { field } = props;
  return (
    <label class="field" title={`${field.summary}: ${field.expected}`}>
      {field.key}
      {field.required ? " (needed)" : ""}
      <input
        value={props.text}
        placeholder={field.absent === "" ? field.expected : field.absent}
        onInput={(event) => props.onInput(event.currentTarget.value)}
      />
      <span class="hands-hint">{field.summary}</span>
    </label>
  );
}

function Fields(props: { fields: readonly WireField[]; texts: Texts; setTexts: (texts: Texts) => void }) {
  return (
    <div class="hands-grid">
      {props.fields.map((field) => (
        <Field
          key={field.key}
          field={field}
          text={props.texts[field.key] ?? ""}
          onInput={(text) => props.setTexts({ ...props.texts, [field.key]: text })}
        />
      ))}
    </div>
  );
}

function Form(props: { hand: Hand; kinds: InjectKind[]; onDone: () => void }) {
  const { hand, kinds } = props;
  const action = useAction(hand.journal);
  const [chosen, setChosen] = useState(kinds[0]?.kind ?? "");
  const [texts, setTexts] = useState<Texts>({});
  const kind = kinds.find((each) => each.kind === chosen);
  if (kind === undefined) return null;
  const { own, when } = fieldsOf(kind);
  const known = new Set([...own, ...when].map((field) => field.key));
  const given = Object.fromEntries(Object.entries(texts).filter(([key]) => known.has(key)));
  const inject = (event: Event): void => {
    event.preventDefault();
    const missing = missingOf(kind, given);
    if (missing.length > 0) action.refuse(`${kind.kind} needs ${missing.join(" and ")}.`);
    else void action.run(`Inject ${kind.kind}`, () => hand.source.act("POST", hand.unit, "injected", bodyOf(kind.kind, given))).then(props.onDone);
  };
  return (
    <form onSubmit={inject}>
      <label class="field">
        Kind
        <select value={chosen} onChange={(event) => setChosen(event.currentTarget.value)}>
          {kinds.map((each) => (
            <option key={each.kind} value={each.kind}>
              {each.kind}: {each.summary}
            </option>
          ))}
        </select>
      </label>
      <Fields fields={own} texts={texts} setTexts={setTexts} />
      <details>
        <summary>When it acts ({kind.nature === "each" ? `each ${kind.event}` : kind.nature === "moment" ? "happens once" : "holds"})</summary>
        <Fields fields={when} texts={texts} setTexts={setTexts} />
      </details>
      <div class="buttons">
        <button type="submit" disabled={action.isBusy}>
          Inject it
        </button>
      </div>
      <Problem lines={action.problem} />
    </form>
  );
}

/** Faults on the wire: what can be injected, and what is. */
export function WireCard(props: { hand: Hand }) {
  const { source, unit } = props.hand;
  const { units } = usePage();
  const isAnswering = units.absence.value === "";
  const kinds = useResource(() => source.get<{ kinds: InjectKind[] }>(unit, "injected/kinds"), [source, unit, isAnswering]);
  const list = useResource(() => source.get<{ faults: InjectedFault[] }>(unit, "injected"), [source, unit], source.isLive ? 1000 : undefined);
  return (
    <Card title="Faults on the wire" wide>
      {kinds.error !== "" && <Notice kind="warning">{`What can be injected is not known: ${kinds.error}`}</Notice>}
      {kinds.value !== undefined && <Form hand={props.hand} kinds={kinds.value.kinds} onDone={list.again} />}
      <WireList hand={props.hand} list={list} />
    </Card>
  );
}
