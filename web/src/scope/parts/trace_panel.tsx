import { useState } from "preact/hooks";

import { wordsOf } from "../../source/refusal";
import type { TraceStatus } from "../../source/types";
import { Notice } from "../../ui/notice";
import { useResource } from "../../ui/resource";
import { kFirstForm, kTriggers, traceRequest, type TraceForm, type TriggerField } from "../data/trace_request";
import type { ScopeState } from "../data/scope_state";
import { differenceText } from "../view/scale";

const kPhases: Record<TraceStatus["phase"], string> = {
  off: "No trace has been started.",
  waiting: "It waits for the trigger.",
  recording: "It records.",
  done: "It is done.",
};

/** How often it is asked how far the trace is (ms). */
const kPeriod = 1000;

function Field(props: { field: TriggerField; form: TraceForm; signals: readonly string[]; onChange: (form: TraceForm) => void }) {
  const { field, form } = props;
  const value = form.typed[field.key] ?? "";
  const set = (text: string): void => props.onChange({ ...form, typed: { ...form.typed, [field.key]: text } });
  return (
    <label class="field">
      {field.label}
      {field.form === "choice" ? (
        <select value={value} onChange={(event) => set(event.currentTarget.value)}>
          {[...(field.isNeeded ? [""] : []), ...(field.choices ?? [])].map((choice) => (
            <option key={choice} value={choice}>
              {choice === "" ? (field.isNeeded ? "choose…" : "any") : choice}
            </option>
          ))}
        </select>
      ) : (
        <input
          type="text"
          value={value}
          placeholder={field.hint ?? (field.form === "signal" ? props.signals[0] : "")}
          list={field.form === "signal" ? "scope-trace-signals" : undefined}
          onInput={(event) => set(event.currentTarget.value)}
        />
      )}
    </label>
  );
}

function Form(props: { state: ScopeState; phase: TraceStatus["phase"] | undefined; again: () => void }) {
  const { state } = props;
  const [form, setForm] = useState<TraceForm>(kFirstForm);
  const [error, setError] = useState("");
  const { permission, source } = state.page;
  const signals = state.names.value;
  const kind = kTriggers.find(({ on }) => on === form.on);
  const isOn = props.phase === "waiting" || props.phase === "recording";
  const act = async (work: () => Promise<unknown>): Promise<void> => {
    try {
      await work();
      setError("");
    } catch (why) {
      permission.note(why);
      setError(wordsOf(why));
    }
    props.again();
  };
  const start = (event: Event): void => {
    event.preventDefault();
    void act(() => Promise.resolve().then(() => source.act("POST", state.unit, "trace/start", traceRequest(form, signals))));
  };
  return (
    <form onSubmit={start}>
      <datalist id="scope-trace-signals">
        {signals.map((name) => (
          <option key={name} value={name} />
        ))}
      </datalist>
      <div class="row">
        <label class="field">
          Trigger: it begins when
          <select value={form.on} onChange={(event) => setForm({ ...form, on: event.currentTarget.value })}>
            {kTriggers.map(({ on, text }) => (
              <option key={on} value={on}>
                {text}
              </option>
            ))}
          </select>
        </label>
        {kind?.fields.map((field) => (
          <Field key={`${form.on} ${field.key}`} field={field} form={form} signals={signals} onChange={setForm} />
        ))}
        <label class="field">
          Every (s, or cycle)
          <input type="text" value={form.every} size={9} onInput={(event) => setForm({ ...form, every: event.currentTarget.value })} />
        </label>
        <label class="field">
          Before the trigger (s)
          <input type="text" inputMode="decimal" size={6} value={form.before} onInput={(event) => setForm({ ...form, before: event.currentTarget.value })} />
        </label>
        <label class="field">
          Whole length (s)
          <input type="text" inputMode="decimal" size={6} value={form.length} onInput={(event) => setForm({ ...form, length: event.currentTarget.value })} />
        </label>
        <label class="scope-check">
          <input type="checkbox" checked={form.isRepeated} onChange={(event) => setForm({ ...form, isRepeated: event.currentTarget.checked })} /> again
          and again
        </label>
        <button type="submit" class="primary" disabled={permission.refusal.value !== "" || isOn}>
          Start
        </button>
        <button
          type="button"
          disabled={permission.refusal.value !== "" || !isOn}
          onClick={() => void act(() => source.act("POST", state.unit, "trace/stop"))}
        >
          Stop
        </button>
      </div>
      {permission.refusal.value !== "" && <p class="muted">{permission.refusal.value}</p>}
      {error !== "" && <Notice kind="error">{error}</Notice>}
    </form>
  );
}

function Results(props: { state: ScopeState; status: TraceStatus }) {
  const { state } = props;
  const results = (props.status.results ?? []).toReversed();
  const [reading, setReading] = useState(0);
  const open = (result: number): void => {
    setReading(result);
    state
      .openResult(result)
      .catch((error: unknown) => {
        state.problem.value = `Result ${result} cannot be read: ${wordsOf(error)}`;
      })
      .finally(() => setReading(0));
  };
  if (results.length === 0) return null;
  return (
    <ul class="scope-results" aria-label="Results of the trace">
      {results.map((each) => (
        <li key={each.result}>
          <button type="button" disabled={reading !== 0} onClick={() => open(each.result)}>
            {reading === each.result ? "Reading…" : `Show result ${each.result}`}
          </button>{" "}
          {each.trigger_t === undefined ? "stopped without a trigger" : `trigger at ${each.trigger_t.toFixed(6)}\u2009s`},{" "}
          {each.from_t === undefined || each.to_t === undefined ? "" : `${differenceText(each.to_t - each.from_t)}, `}
          {each.samples} samples, {each.frames} frames, {each.events} events
          {each.lost_frames + each.lost_events > 0 && `; no room for ${each.lost_frames} frames and ${each.lost_events} events`}
        </li>
      ))}
    </ul>
  );
}

/** The trace of the unit: what begins it, how far it is, and its results. */
export function TracePanel(props: { state: ScopeState }) {
  const { state } = props;
  const status = useResource(() => state.page.source.get<TraceStatus>(state.unit, "trace"), [state.unit], kPeriod);
  return (
    <section class="card scope-trace" aria-label="Trace of the unit">
      <h2>Trigger: the unit traces the signals of the picture by itself, each 125 µs if wanted</h2>
      <Form state={state} phase={status.value?.phase} again={status.again} />
      {status.error !== "" && <Notice kind="error">{status.error}</Notice>}
      {status.value !== undefined && (
        <p aria-live="polite">
          {kPhases[status.value.phase]}
          {status.value.phase === "recording" && status.value.recorded !== undefined ? ` ${status.value.recorded} samples so far.` : ""}
        </p>
      )}
      {status.value !== undefined && <Results state={state} status={status.value} />}
    </section>
  );
}
