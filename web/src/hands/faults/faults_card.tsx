import { useState } from "preact/hooks";

import { usePage } from "../../app/context";
import { FaultChips } from "../../overview/fault_chips";
import type { Message, UnitOverview } from "../../source/types";
import { Card, Problem, useAction, type Hand } from "../action";
import { InjectField } from "./inject_field";

interface Active {
  faults: Message[];
  alarms: Message[];
}

function activeAt(unit: UnitOverview | undefined, place: number): Active {
  const found = place === 0 ? unit?.control_unit : unit?.axes?.find((axis) => axis.axis === place);
  return found ?? { faults: [], alarms: [] };
}

/** Faults and alarms of the axis or of the control unit: acknowledges them, and makes them occur. */
export function FaultsCard(props: { hand: Hand }) {
  const { hand } = props;
  const { units } = usePage();
  const action = useAction(hand.journal);
  const [isUnit, setIsUnit] = useState(false);
  const place = isUnit ? 0 : hand.axis;
  const active = activeAt(units.find(hand.unit), place);
  const name = isUnit ? "the control unit" : `axis ${place}`;
  return (
    <Card title="Faults and alarms">
      <label class="field">
        Of
        <select value={isUnit ? "unit" : "axis"} onChange={(event) => setIsUnit(event.currentTarget.value === "unit")}>
          <option value="axis">axis {hand.axis}</option>
          <option value="unit">control unit</option>
        </select>
      </label>
      <FaultChips unit={hand.unit} place={place} faults={active.faults} alarms={active.alarms} />
      {active.faults.length + active.alarms.length === 0 && <p class="muted">None is active.</p>}
      <div class="buttons">
        <button
          type="button"
          disabled={action.isBusy}
          onClick={() => void action.run(`Acknowledge the faults of ${name}`, () => hand.source.act("POST", hand.unit, `axes/${place}/faults/acknowledge`))}
        >
          Acknowledge
        </button>
      </div>
      <Problem lines={action.problem} />
      <InjectField key={place} hand={hand} place={place} />
    </Card>
  );
}
