import type { ScopeState } from "../data/scope_state";

/** The trace of the unit. */
export function TracePanel(props: { state: ScopeState }) {
  return <section class="card">{props.state.unit}</section>;
}
