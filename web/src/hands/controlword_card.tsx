import { useState } from "preact/hooks";

import { linkTo } from "../app/route";
import type { AxisOverview } from "../source/types";
import { fixed } from "../ui/number";
import { StateChip } from "../ui/state_chip";
import { Card, Problem, useAction, type Hand } from "./action";
import { indexFor, kModes, kOrders, wordsFor } from "./drive_orders";

function Present(props: { axis: AxisOverview }) {
  const { axis } = props;
  return (
    <p role="status">
      <StateChip state={axis.state} /> {axis.mode !== undefined && `mode: ${axis.mode}`}
      {axis.homed !== undefined && `, ${axis.homed ? "homed" : "not homed"}`}
      <span class="mono"> {fixed(axis.speed_rpm, 1, "rpm")}</span>
    </p>
  );
}

/** Writes controlword and mode of an axis of CiA 402, as a master does by SDO. */
export function ControlwordCard(props: { hand: Hand; axis: AxisOverview | undefined }) {
  const { hand, axis } = props;
  const action = useAction(hand.journal);
  const [mode, setMode] = useState(1);
  const write = (words: string, index: number, values: readonly number[]): void => {
    const path = `objects/${indexFor(index, hand.axis)}`;
    const work = async (): Promise<void> => {
      for (const value of values) await hand.source.act("PUT", hand.unit, path, { value }, { sub_index: 0 });
    };
    void action.run(words, work);
  };
  const title = kModes.find((each) => each.value === mode)?.title ?? "";
  return (
    <Card title="Controlword and mode" wide>
      {axis !== undefined && <Present axis={axis} />}
      <div class="buttons" role="group" aria-label="Controlword">
        {kOrders.map((order) => (
          <button key={order.value} type="button" disabled={action.isBusy} onClick={() => write(`Controlword: ${order.title}`, 0x6040, wordsFor(order.value, axis?.state))}>
            {order.title}
          </button>
        ))}
      </div>
      <div class="row">
        <label class="field">
          Mode of operation
          <select value={mode} onChange={(event) => setMode(Number(event.currentTarget.value))}>
            {kModes.map((each) => (
              <option key={each.value} value={each.value}>
                {each.value}: {each.title}
              </option>
            ))}
          </select>
        </label>
        <button type="button" disabled={action.isBusy} onClick={() => write(`Mode of operation: ${title}`, 0x6060, [mode])}>
          Set the mode
        </button>
      </div>
      <Problem lines={action.problem} />
      <p class="muted">
        A master that sends process data has the last word. Its profile cia402 has no operator panel and no identification; targets and limits are among the{" "}
        <a href={linkTo("objects", hand.unit, { text: indexFor(0x6000, hand.axis).slice(0, 2) })}>objects</a>.
      </p>
    </Card>
  );
}
