import { useRef, useState } from "preact/hooks";

import { route } from "../../app/context";
import { wordsOf } from "../../source/refusal";
import type { ScopeState } from "../data/scope_state";
import { exportCandump, exportCsv } from "../data/exports";
import { exportPng } from "../draw/png";
import { kPeriods } from "../view/link";
import { kSpans } from "../view/window";

function spanText(span: number): string {
  return span >= 1 ? `${Number(span.toPrecision(3))}\u2009s` : `${Number((span * 1000).toPrecision(3))}\u2009ms`;
}

function TimeTools(props: { state: ScopeState }) {
  const { model, live, periodMs } = props.state;
  const { follows, span } = model.window.value;
  const isLive = model.material.value.isLive;
  const isUsual = kSpans.some((each) => each === span);
  return (
    <>
      {isLive && (
        <button type="button" class={follows ? "" : "primary"} aria-pressed={!follows} onClick={() => model.pause(follows)}>
          {follows ? "❚❚ Pause" : "▶ Live"}
        </button>
      )}
      {!isLive && live !== undefined && (
        <button type="button" class="primary" onClick={() => props.state.open(undefined)}>
          ▶ Live
        </button>
      )}
      <label class="field scope-inline">
        Window
        <select value={String(span)} onChange={(event) => model.setSpan(Number(event.currentTarget.value))}>
          {!isUsual && <option value={String(span)}>{spanText(span)}</option>}
          {kSpans.map((each) => (
            <option key={each} value={String(each)}>
              {spanText(each)}
            </option>
          ))}
        </select>
      </label>
      <span class="scope-group" role="group" aria-label="Zoom">
        <button type="button" aria-label="Zoom in" title="Zoom in (+)" onClick={() => model.zoom(0.5)}>
          +
        </button>
        <button type="button" aria-label="Zoom out" title="Zoom out (−)" onClick={() => model.zoom(2)}>
          −
        </button>
        <button type="button" aria-label="Earlier" title="Earlier (Page Up)" onClick={() => model.pan(-span / 2)}>
          ◀
        </button>
        <button type="button" aria-label="Later" title="Later (Page Down)" onClick={() => model.pan(span / 2)}>
          ▶
        </button>
        {!isLive && (
          <button type="button" onClick={() => model.showAll()}>
            All
          </button>
        )}
      </span>
      {isLive && (
        <label class="field scope-inline">
          Sample each
          <select value={String(periodMs.value)} onChange={(event) => props.state.setPeriod(Number(event.currentTarget.value))}>
            {kPeriods.map((each) => (
              <option key={each} value={String(each)}>{`${each}\u2009ms`}</option>
            ))}
          </select>
        </label>
      )}
    </>
  );
}

function CursorTools(props: { state: ScopeState }) {
  const { model } = props.state;
  const hasAny = model.a.value !== null || model.b.value !== null;
  return (
    <span class="scope-group" role="group" aria-label="Cursors A and B">
      <button type="button" aria-pressed={model.a.value !== null} title="Cursor A to where the cursor is (a)" onClick={() => model.setMark("a")}>
        A
      </button>
      <button type="button" aria-pressed={model.b.value !== null} title="Cursor B to where the cursor is (b)" onClick={() => model.setMark("b")}>
        B
      </button>
      {hasAny && (
        <button type="button" onClick={() => model.clearMarks()}>
          No cursors
        </button>
      )}
    </span>
  );
}

function ExportTools(props: { state: ScopeState }) {
  const { state } = props;
  const [said, setSaid] = useState("");
  const copy = async (): Promise<void> => {
    const path = location.hash.split("?", 1)[0] ?? "";
    const hash = path.startsWith("#/scope") ? path : `#/scope/${state.unit}`;
    const address = `${location.href.split("#", 1)[0] ?? ""}${hash}?${state.address().toString()}`;
    try {
      await navigator.clipboard.writeText(address);
      setSaid("copied");
    } catch {
      prompt("The link to this view", address);
    }
    setTimeout(() => setSaid(""), 2500);
  };
  const done = (work: () => void | Promise<void>) => (): void => {
    void Promise.resolve()
      .then(work)
      .catch((error: unknown) => {
        state.problem.value = wordsOf(error);
      });
  };
  return (
    <>
      <span class="scope-group" role="group" aria-label="Export what the window shows">
        <button type="button" title="Samples in the window" onClick={done(() => exportCsv(state))}>
          CSV
        </button>
        <button type="button" title="Frames in the window as candump -l writes them" onClick={done(() => exportCandump(state))}>
          candump
        </button>
        <button type="button" title="The picture" onClick={done(() => exportPng(state))}>
          PNG
        </button>
      </span>
      <button type="button" onClick={() => void copy()}>
        Copy link
      </button>
      <span class="visually-hidden" role="status">
        {said === "" ? "" : "The link was copied."}
      </span>
      {said !== "" && <span aria-hidden="true">✓ copied</span>}
    </>
  );
}

function FileTools(props: { state: ScopeState }) {
  const { state } = props;
  const input = useRef<HTMLInputElement>(null);
  const own = state.page.source.recordings.filter((each) => each.unit === state.unit || state.unit === "");
  const shown = route.value.query.get("recording") ?? state.model.material.value.name;
  return (
    <>
      {own.length > 1 && (
        <label class="field scope-inline">
          Recording
          <select value={shown} onChange={(event) => void state.openRecording(event.currentTarget.value)}>
            {own.map((each) => (
              <option key={each.name} value={each.name}>
                {each.name}
              </option>
            ))}
          </select>
        </label>
      )}
      <button type="button" title=".axrec, candump log, CSV or JSON of a trace; or drop it here" onClick={() => input.current?.click()}>
        Open file…
      </button>
      <input
        ref={input}
        type="file"
        class="visually-hidden"
        tabIndex={-1}
        aria-label="Recording to open"
        onChange={(event) => {
          const file = event.currentTarget.files?.[0];
          if (file !== undefined) void state.openFile(file);
          event.currentTarget.value = "";
        }}
      />
    </>
  );
}

/** What can be done with the picture. */
export function Toolbar(props: { state: ScopeState; isTracing: boolean; onTrace: () => void }) {
  const { state } = props;
  return (
    <div class="scope-toolbar" role="group" aria-label="Scope">
      <TimeTools state={state} />
      <CursorTools state={state} />
      {state.live !== undefined && (
        <button type="button" aria-expanded={props.isTracing} onClick={props.onTrace}>
          Trigger
        </button>
      )}
      <ExportTools state={state} />
      <FileTools state={state} />
    </div>
  );
}
