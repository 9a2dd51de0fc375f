import { useState } from "preact/hooks";

import { linkTo } from "../app/route";
import type { UnitOverview } from "../source/types";
import { StateChip } from "../ui/state_chip";
import { UnitCard } from "./unit_card";

/** So many units have their cards open. */
export const kOpenCards = 8;
/** So many lines come at first. */
const kFirstLines = 60;

function UnitLine(props: { unit: UnitOverview; rate: number | undefined }) {
  const { unit } = props;
  const [isOpen, setIsOpen] = useState(false);
  const faults = (unit.axes ?? []).reduce((sum, axis) => sum + axis.faults.length, 0);
  return (
    <li>
      <div class="overview-line overview-unit-line">
        <button type="button" aria-expanded={isOpen} onClick={() => setIsOpen(!isOpen)}>
          <span aria-hidden="true">{isOpen ? "▾" : "▸"}</span> {unit.unit}
        </button>
        {unit.on ? (
          (unit.axes ?? []).map((axis) => <StateChip key={axis.axis} state={axis.state} />)
        ) : (
          <span class="muted">{unit.error ?? "off"}</span>
        )}
        {faults > 0 && <span class="chip tone-fault">{faults === 1 ? "1 fault" : `${faults} faults`}</span>}
      </div>
      {isOpen && <UnitCard unit={unit} rate={props.rate} />}
    </li>
  );
}

/** A line a unit, which opens to its card: for more units than fit on a screen. */
export function ManyUnits(props: { units: UnitOverview[]; rates: Map<string, number> }) {
  const [text, setText] = useState("");
  const [isWhole, setIsWhole] = useState(false);
  const fitting = props.units.filter((unit) => unit.unit.includes(text.trim()));
  const lines = isWhole ? fitting : fitting.slice(0, kFirstLines);
  return (
    <section class="card" aria-label="Units">
      <div class="row">
        <label class="field">
          Units whose name has
          <input type="search" value={text} onInput={(event) => setText(event.currentTarget.value)} />
        </label>
        <span class="muted" role="status">
          {fitting.length} of {props.units.length} units
        </span>
        <a href={linkTo("fleet")}>All of them as a map</a>
      </div>
      <ul class="overview-units">
        {lines.map((unit) => (
          <UnitLine key={unit.unit} unit={unit} rate={props.rates.get(unit.unit)} />
        ))}
      </ul>
      {lines.length < fitting.length && (
        <button type="button" onClick={() => setIsWhole(true)}>
          Show all {fitting.length}
        </button>
      )}
    </section>
  );
}
