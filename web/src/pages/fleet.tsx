import { useMemo, useState } from "preact/hooks";

import { replaceQuery, route, usePage } from "../app/context";
import { cellsOf, kMeasures, scaleOf, type MeasureName } from "../fleet/cells";
import { HeatMap } from "../fleet/heat_map";
import { Legend } from "../fleet/legend";
import { byValue, countsOf, unitsWith } from "../fleet/order";
import { Notice } from "../ui/notice";

/** What is looked at; it stands in the address. */
interface View {
  by: MeasureName;
  sort: "name" | "value";
  text: string;
  /** Only cells of this state; empty: of all. */
  state: string;
}

function viewOf(query: URLSearchParams): View {
  const by = query.get("by") ?? "";
  return {
    by: by in kMeasures ? (by as MeasureName) : "state",
    sort: query.get("sort") === "value" ? "value" : "name",
    text: query.get("text") ?? "",
    state: query.get("state") ?? "",
  };
}

function queryOf(view: View): URLSearchParams {
  const words = Object.entries({ ...view }).filter(([key, word]) => word !== "" && !(key === "by" && word === "state") && word !== "name");
  return new URLSearchParams(words);
}

function Choices(props: { view: View; change: (part: Partial<View>) => void }) {
  const { view, change } = props;
  return (
    <div class="row fleet-choices">
      <label class="field">
        Show
        <select value={view.by} onChange={(event) => change({ by: event.currentTarget.value as MeasureName })}>
          {Object.entries(kMeasures).map(([name, { title }]) => (
            <option key={name} value={name}>
              {title}
            </option>
          ))}
        </select>
      </label>
      <label class="field">
        Sorted by
        <select value={view.sort} onChange={(event) => change({ sort: event.currentTarget.value === "value" ? "value" : "name" })}>
          <option value="name">bus and node</option>
          <option value="value">value, greatest first</option>
        </select>
      </label>
      <label class="field">
        Units, axes or states with
        <input type="search" value={view.text} onInput={(event) => change({ text: event.currentTarget.value })} />
      </label>
    </div>
  );
}

function Counts(props: { counts: [string, number][]; state: string; change: (part: Partial<View>) => void }) {
  return (
    <div class="buttons" role="group" aria-label="Only cells of a state">
      {props.counts.map(([state, count]) => (
        <button
          key={state}
          type="button"
          aria-pressed={props.state === state}
          onClick={() => props.change({ state: props.state === state ? "" : state })}
        >
          {state} {count}
        </button>
      ))}
    </div>
  );
}

/** All units at a glance, a cell an axis. */
export function Fleet() {
  const { units } = usePage();
  const [view, setView] = useState(() => viewOf(route.value.query));
  const change = (part: Partial<View>): void => {
    const next = { ...view, ...part };
    setView(next);
    replaceQuery(queryOf(next));
  };
  const all = units.all.value;
  const fitting = useMemo(() => unitsWith(view.text, all), [all, view.text]);
  const cells = useMemo(() => cellsOf(view.by, fitting), [fitting, view.by]);
  const isOfUnit = kMeasures[view.by].isOfUnit;
  const counts = useMemo(() => (isOfUnit ? [] : countsOf(cells)), [cells, isOfUnit]);
  const chosen = view.state === "" || isOfUnit ? cells : cells.filter((cell) => cell.state === view.state);
  const shown = view.sort === "value" ? byValue(chosen) : chosen;
  return (
    <>
      <h1>Fleet</h1>
      <Choices view={view} change={change} />
      <Counts counts={counts} state={view.state} change={change} />
      <p class="muted" role="status">
        {shown.length === 1 ? "1 cell" : `${shown.length} cells`} of {fitting.length === 1 ? "1 unit" : `${fitting.length} units`}
      </p>
      {all.length > 0 && shown.length === 0 && <Notice>Nothing fits: change what is looked for.</Notice>}
      {all.length === 0 && units.absence.value === "" && <Notice>There is no unit yet: start axisd, it will be found.</Notice>}
      <Legend measure={view.by} scale={scaleOf(view.by, fitting)} />
      <HeatMap cells={shown} toCause={view.by === "faults"} />
    </>
  );
}
