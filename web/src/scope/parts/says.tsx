import { useState } from "preact/hooks";

import { usePage } from "../../app/context";
import { Notice } from "../../ui/notice";
import { LiveMaterial } from "../data/live_material";
import { watchReadings } from "./slow_turn";
import type { ScopeState } from "../data/scope_state";

/** A count with thin spaces between thousands: 1 200. */
export function grouped(count: number): string {
  return String(Math.round(count)).replace(/\B(?=(\d{3})+$)/g, "\u2009");
}

/** Why nothing new comes; that the gateway is gone is said over every page. */
function Absence(props: { live: LiveMaterial }) {
  const { units } = usePage();
  const { problem, heardAt } = props.live;
  if (units.absence.value !== "") return null;
  const unit = units.find(props.live.unit);
  if (problem.value === "" && unit?.on === false) return <Notice kind="warning">{unit.error ?? `${unit.unit} is switched off.`}</Notice>;
  if (problem.value === "") return null;
  const since = heardAt.value === 0 ? "" : ` Last answer at ${new Date(heardAt.value).toLocaleTimeString()}.`;
  return <Notice kind="error">{`Nothing new comes of ${props.live.unit}: ${problem.value}.${since}`}</Notice>;
}

/** What did not come in time, until the user has seen it. */
function Loss(props: { state: ScopeState }) {
  const { model } = props.state;
  watchReadings(model);
  const material = model.material.value;
  const [seen, setSeen] = useState(0);
  const lost = material.lost - (material.isLive ? seen : 0);
  if (lost <= 0) return null;
  return (
    <Notice kind="warning">
      {material.isLive
        ? `${grouped(lost)} frames and samples were not drawn in time: they are missing in the picture. `
        : `${grouped(lost)} records had no room in this recording.`}
      {material.isLive && (
        <button type="button" class="scope-small" onClick={() => setSeen(material.lost)}>
          I have seen it
        </button>
      )}
    </Notice>
  );
}

/** What has to be said of the picture: what is missing in it, and why. */
export function Says(props: { state: ScopeState }) {
  const { state } = props;
  watchReadings(state.model);
  const material = state.model.material.value;
  const isEmpty = !material.isLive && material.name === "";
  return (
    <>
      <p class="visually-hidden" role="status">
        {state.told.value}
      </p>
      {material instanceof LiveMaterial && <Absence live={material} />}
      {state.problem.value !== "" && <Notice kind="error">{state.problem.value}</Notice>}
      {isEmpty && <Notice>Nothing is open. Open a recording (.axrec), a candump log, or a trace (CSV, JSON), or drop it here.</Notice>}
      {!material.isLive && !isEmpty && (
        <Notice>
          {`Recorded: ${material.name}${material.unit === "" ? "" : ` of ${material.unit}`}${
            material.startedAt === undefined ? "" : `, begun ${new Date((material.startedAt + material.extent().from) * 1000).toLocaleString()}`
          }`}
        </Notice>
      )}
      {material.remark !== "" && <Notice kind="warning">{material.remark}</Notice>}
      <Loss state={state} />
    </>
  );
}
