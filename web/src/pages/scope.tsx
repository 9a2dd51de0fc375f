import { useEffect, useMemo, useState } from "preact/hooks";

import { replaceQuery, route, usePage } from "../app/context";
import type { ScopeState as State } from "../scope/data/scope_state";
import { ScopeState } from "../scope/data/scope_state";
import { Detail } from "../scope/parts/detail";
import { Lists } from "../scope/parts/lists";
import { Says } from "../scope/parts/says";
import { SignalsPanel } from "../scope/parts/signals_panel";
import { Stage } from "../scope/parts/stage";
import { Toolbar } from "../scope/parts/toolbar";
import { TracePanel } from "../scope/parts/trace_panel";

/** Time after the last change until the address says it (ms). */
const kPause = 500;

/** Goes where the address says, and lets the address say where one is; one that was not followed yet is left as it is. */
function useAddress(state: State): void {
  const { query } = route.value;
  const [followed, setFollowed] = useState<URLSearchParams>();
  useEffect(() => void state.begin(query).then(() => setFollowed(query)), [state, query]);
  const address = state.address().toString();
  const isFollowed = followed === query;
  useEffect(() => {
    if (!isFollowed) return undefined;
    const { hash } = location;
    const timer = setTimeout(() => {
      if (location.hash === hash) replaceQuery(new URLSearchParams(address));
    }, kPause);
    return () => clearTimeout(timer);
  }, [address, isFollowed]);
}

/** Files that are dropped onto the page are opened. */
function useDrop(state: State): boolean {
  const [isOver, setIsOver] = useState(false);
  useEffect(() => {
    const over = (event: DragEvent): void => {
      event.preventDefault();
      setIsOver(true);
    };
    const leave = (event: DragEvent): void => {
      if (event.relatedTarget === null) setIsOver(false);
    };
    const drop = (event: DragEvent): void => {
      event.preventDefault();
      setIsOver(false);
      const file = event.dataTransfer?.files[0];
      if (file !== undefined) void state.openFile(file);
    };
    addEventListener("dragover", over);
    addEventListener("dragleave", leave);
    addEventListener("drop", drop);
    return () => {
      removeEventListener("dragover", over);
      removeEventListener("dragleave", leave);
      removeEventListener("drop", drop);
    };
  }, [state]);
  return isOver;
}

/** Signals, states, events and frames of a unit, or of a recording, on one time. */
export function Scope(props: { unit: string }) {
  const page = usePage();
  const state = useMemo(() => new ScopeState(page, props.unit), [page, props.unit]);
  const [isTracing, setIsTracing] = useState(false);
  useEffect(() => () => state.end(), [state]);
  useAddress(state);
  const isOver = useDrop(state);
  return (
    <div class={`scope ${isOver ? "scope-drop" : ""}`}>
      <h1 class="visually-hidden">Scope {props.unit}</h1>
      <Toolbar state={state} isTracing={isTracing} onTrace={() => setIsTracing(!isTracing)} />
      <Says state={state} />
      {isTracing && <TracePanel state={state} />}
      <div class="scope-columns">
        <Stage state={state} />
        <div class="scope-side">
          <div class="scope-side-inner">
            <SignalsPanel state={state} />
            <Detail state={state} />
            <Lists state={state} />
          </div>
        </div>
      </div>
    </div>
  );
}
