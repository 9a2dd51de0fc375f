import { useState } from "preact/hooks";

import type { Identification } from "../source/types";
import { Notice } from "../ui/notice";
import { shown } from "../ui/number";
import { useResource } from "../ui/resource";
import { Card, Problem, useAction, type Hand } from "./action";

const kChoices = [
  { parameter: "p1910", value: 1, title: "p1910 = 1: at standstill" },
  { parameter: "p1960", value: 1, title: "p1960 = 1: with a turning shaft" },
  { parameter: "p1900", value: 1, title: "p1900 = 1: both, one ON each" },
  { parameter: "p1900", value: 0, title: "p1900 = 0: none" },
] as const;

const kPhases: Record<Identification["phase"], { words: string; tone: string }> = {
  idle: { words: "nothing is selected", tone: "off" },
  waiting: { words: "waits for ON", tone: "ready" },
  measuring: { words: "measures", tone: "on" },
  done: { words: "done", tone: "run" },
  failed: { words: "failed", tone: "fault" },
};

function Results(props: { results: Identification["results"] }) {
  if (props.results.length === 0) return null;
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label="What was measured">
      <table>
        <thead>
          <tr>
            <th>Parameter</th>
            <th>Name</th>
            <th class="number">Measured</th>
            <th class="number">Data sheet</th>
            <th class="number">Deviation</th>
          </tr>
        </thead>
        <tbody>
          {props.results.map((result) => (
            <tr key={result.parameter}>
              <td class="mono">{result.parameter}</td>
              <td>{result.name}</td>
              <td class="number">{shown(result.value, result.unit)}</td>
              <td class="number">{shown(result.data_sheet, result.unit)}</td>
              <td class="number">{shown(result.deviation_percent, "%", 3)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Progress(props: { state: Identification }) {
  const { state } = props;
  const phase = kPhases[state.phase];
  return (
    <div role="status">
      <p>
        <span class={`chip tone-${phase.tone}`}>{phase.words}</span> {state.selected === "none" ? "" : state.selected} <span class="muted">{state.text}</span>
      </p>
      {state.phase === "measuring" && (
        <label class="field hands-progress">
          Progress
          <progress max={100} value={state.progress_percent}>
            {state.progress_percent} %
          </progress>
        </label>
      )}
    </div>
  );
}

/** Measurement of the motor: chosen, how far it is, what was found against the data sheet. */
export function IdentificationCard(props: { hand: Hand }) {
  const { hand } = props;
  const { source, unit, axis } = hand;
  const path = `axes/${axis}/identification`;
  const state = useResource(() => source.get<Identification>(unit, path), [source, unit, path], source.isLive ? 700 : undefined);
  const action = useAction(hand.journal);
  const [choice, setChoice] = useState(0);
  const select = (): void => {
    const chosen = kChoices[choice] ?? kChoices[0];
    void action
      .run(`Write ${chosen.parameter} = ${chosen.value}`, () => source.act("PUT", unit, `parameters/${chosen.parameter}`, { value: chosen.value }, { axis }))
      .then(state.again);
  };
  return (
    <Card title="Motor data identification" wide>
      {state.error !== "" && <Notice kind="warning">{`Its state is not known: ${state.error}`}</Notice>}
      {state.value !== undefined && <Progress state={state.value} />}
      <div class="row">
        <label class="field">
          Measurement
          <select value={choice} onChange={(event) => setChoice(Number(event.currentTarget.value))}>
            {kChoices.map(({ title }, index) => (
              <option key={title} value={index}>
                {title}
              </option>
            ))}
          </select>
        </label>
        <button type="button" disabled={action.isBusy} onClick={select}>
          Select it
        </button>
      </div>
      <p class="muted">It begins with the next ON: take the control and enable, at setpoint zero. p1960 turns the shaft.</p>
      <Problem lines={action.problem} />
      {state.value !== undefined && <Results results={state.value.results} />}
    </Card>
  );
}
