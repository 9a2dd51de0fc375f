import type { SignalHead } from "../../model/sample_store";
import { shown } from "../../ui/number";
import type { ScopeState } from "../data/scope_state";
import { LiveMaterial } from "../data/live_material";
import { watchReadings } from "./slow_turn";
import { differenceText, instantText } from "../view/scale";
import { kDashes } from "../draw/palette";
import { plotLanes } from "../view/layout";
import { kMostSignals } from "../view/link";
import { SignalSearch } from "./signal_search";

interface Reading {
  head: SignalHead;
  number: number;
  /** Which curve of its lane it is. */
  inLane: number;
  values: (number | null)[];
}

/** Values of all signals at the cursor (or at the right edge) and at A and B. */
function readingsOf(state: ScopeState): Reading[] {
  const { model } = state;
  const { samples } = model.material.value;
  const edge = Math.min(model.range().to, model.end());
  const at = [model.cursor() ?? (samples.size > 0 ? Math.min(edge, samples.to) : edge), model.a.value, model.b.value];
  const columns = at.map((t) => (t === null ? [] : samples.valuesAt(t)));
  const lanes = plotLanes(samples.signals);
  const inLane = (number: number): number => lanes.find((lane) => lane.signals.includes(number))?.signals.indexOf(number) ?? 0;
  return samples.signals.map((head, number) => ({ head, number, inLane: inLane(number), values: columns.map((column) => column[number] ?? null) }));
}

/** A curve as it is drawn: its colour and its dashes. */
function Swatch(props: { number: number; dash: number }) {
  return <span class={`scope-swatch scope-swatch-${props.number + 1} scope-dash-${props.dash}`} aria-hidden="true" />;
}

function SignalRow(props: { state: ScopeState; reading: Reading; hasA: boolean; hasB: boolean }) {
  const { head, number, inLane, values } = props.reading;
  const [now = null, a = null, b = null] = values;
  const isLive = props.state.model.material.value.isLive;
  const remove = (): void => void props.state.choose(props.state.names.peek().filter((name) => name !== head.signal));
  return (
    <tr>
      <th scope="row">
        <Swatch number={number} dash={inLane % kDashes.length} />
        <code title={head.text ?? ""}>{head.signal}</code>{" "}
        {head.text !== undefined && head.text !== "" && <span class="scope-signal-text" title={head.text}>{head.text}</span>}
      </th>
      <td class="number">{shown(now, head.unit, 5)}</td>
      {props.hasA && <td class="number">{shown(a, "", 5)}</td>}
      {props.hasB && <td class="number">{shown(b, "", 5)}</td>}
      {props.hasA && props.hasB && <td class="number">{a === null || b === null ? "–" : shown(b - a, "", 5)}</td>}
      <td>
        {isLive && (
          <button type="button" class="scope-small" onClick={remove} aria-label={`Take ${head.signal} away`}>
            ×
          </button>
        )}
      </td>
    </tr>
  );
}

/** Instants of the cursors and what lies between A and B. */
function Instants(props: { state: ScopeState }) {
  const { model } = props.state;
  watchReadings(model);
  const step = model.window.value.span / 2000;
  const [a, b] = [model.a.value, model.b.value];
  const cursor = model.cursor();
  if (a === null && b === null && cursor === null) return null;
  const difference = a !== null && b !== null ? b - a : null;
  return (
    <p class="scope-instants mono">
      {cursor !== null && <span>t {instantText(cursor, step)}</span>}
      {a !== null && <span>A {instantText(a, step)}</span>}
      {b !== null && <span>B {instantText(b, step)}</span>}
      {difference !== null && <span>B−A {differenceText(difference)}</span>}
      {difference !== null && difference !== 0 && <span>1/(B−A) {shown(1 / Math.abs(difference), "Hz")}</span>}
    </p>
  );
}

/** The signals with their values, and the search for more. */
export function SignalsPanel(props: { state: ScopeState }) {
  const { state } = props;
  watchReadings(state.model);
  const material = state.model.material.value;
  const [hasA, hasB] = [state.model.a.value !== null, state.model.b.value !== null];
  const refused = material instanceof LiveMaterial ? state.found.value.filter(({ problem }) => problem !== "") : [];
  const readings = readingsOf(state);
  return (
    <section class="card scope-signals" aria-label="Signals">
      <Instants state={state} />
      {readings.length > 0 && (
        <div class={`scroll ${hasA || hasB ? "scope-marked" : ""}`} tabIndex={0} role="region" aria-label="Values of the signals">
          <table>
            <thead>
              <tr>
                <th scope="col">Signal</th>
                <th scope="col" class="number">{state.model.cursorShare.value === null ? "Right edge" : "Cursor"}</th>
                {hasA && <th scope="col" class="number">A</th>}
                {hasB && <th scope="col" class="number">B</th>}
                {hasA && hasB && <th scope="col" class="number">B−A</th>}
                <th scope="col">
                  <span class="visually-hidden">Take away</span>
                </th>
              </tr>
            </thead>
            <tbody>
              {readings.map((reading) => (
                <SignalRow key={reading.head.signal} state={state} reading={reading} hasA={hasA} hasB={hasB} />
              ))}
            </tbody>
          </table>
        </div>
      )}
      {readings.length === 0 && <p class="muted">{material.isLive ? "No signal is chosen." : "It has no signals."}</p>}
      {refused.map(({ head, problem }) => (
        <p key={head.signal} class="notice notice-error" role="alert">
          {head.signal}: {problem}{" "}
          <button type="button" class="scope-small" onClick={() => void state.choose(state.names.peek().filter((name) => name !== head.signal))}>
            Take it away
          </button>
        </p>
      ))}
      {material.isLive && <SignalSearch state={state} isFull={state.names.value.length >= kMostSignals} />}
    </section>
  );
}
