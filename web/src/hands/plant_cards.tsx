import { useState } from "preact/hooks";

import type { components } from "../../generated/openapi";
import { Notice } from "../ui/notice";
import { fixed, shown } from "../ui/number";
import { useResource, type Resource } from "../ui/resource";
import { Card, Problem, useAction, type Hand } from "./action";
import { numberIn } from "./number_text";

type Schemas = components["schemas"];

/** Asks every second, of a recording once. */
function useRegularly<T>(hand: Hand, path: string): Resource<T> {
  const { source, unit } = hand;
  return useResource(() => source.get<T>(unit, path), [source, unit, path], source.isLive ? 1000 : undefined);
}

function Unknown(props: { error: string }) {
  return props.error === "" ? null : <Notice kind="warning">{`Its state is not known: ${props.error}`}</Notice>;
}

/** Load torque and friction at the shaft. */
export function LoadCard(props: { hand: Hand }) {
  const { hand } = props;
  const path = `axes/${hand.axis}/load`;
  const load = useRegularly<Schemas["result.load.get"]>(hand, path);
  const action = useAction(hand.journal);
  const [text, setText] = useState("1");
  const [type, setType] = useState("constant");
  const set = (value: string): void => {
    const torque = numberIn(value);
    if (torque === undefined) action.refuse(`“${value}” is no torque: a number in N·m.`);
    else
      void action.run(`Load ${torque} N·m, ${type}`, () => hand.source.act("PUT", hand.unit, path, { torque_Nm: torque, type })).then(load.again);
  };
  return (
    <Card title="Load">
      <Unknown error={load.error} />
      {load.value !== undefined && (
        <p class="mono">
          {fixed(load.value.torque_Nm, 2, "N·m")} constant, {fixed(load.value.friction_Nm, 2, "N·m")} friction
        </p>
      )}
      <div class="row">
        <label class="field">
          Torque (N·m)
          <input class="hands-number" inputMode="decimal" value={text} onInput={(event) => setText(event.currentTarget.value)} />
        </label>
        <label class="field">
          Kind
          <select value={type} onChange={(event) => setType(event.currentTarget.value)}>
            <option value="constant">constant, as a weight</option>
            <option value="friction">friction, against the motion</option>
          </select>
        </label>
        <button type="button" onClick={() => set(text)}>
          Set
        </button>
        <button type="button" onClick={() => set("0")}>
          None
        </button>
      </div>
      <Problem lines={action.problem} />
    </Card>
  );
}

/** The line voltage of the unit: mains failure, and back. */
export function SupplyCard(props: { hand: Hand }) {
  const { hand } = props;
  const supply = useRegularly<Schemas["result.supply.get"]>(hand, "supply");
  const action = useAction(hand.journal);
  const [text, setText] = useState("400");
  const set = (value: string): void => {
    const voltage = numberIn(value);
    const words = voltage === 0 ? "Mains failure" : `Line voltage ${voltage ?? 0} V`;
    if (voltage === undefined) action.refuse(`“${value}” is no voltage: 0 to 1000 V.`);
    else void action.run(words, () => hand.source.act("PUT", hand.unit, "supply", { line_voltage_V: voltage })).then(supply.again);
  };
  return (
    <Card title="Supply">
      <Unknown error={supply.error} />
      {supply.value !== undefined && (
        <p class="mono">
          {supply.value.line_voltage_V === 0 ? "mains failure" : shown(supply.value.line_voltage_V, "V")}, DC link {fixed(supply.value.dc_link_V, 0, "V")}{" "}
          <span class="muted">
            ({shown(supply.value.undervoltage_V, "V")} to {shown(supply.value.overvoltage_V, "V")})
          </span>
        </p>
      )}
      <div class="row">
        <button type="button" onClick={() => set("0")}>
          Mains failure
        </button>
        <label class="field">
          Line voltage (V)
          <input class="hands-number" inputMode="decimal" value={text} onInput={(event) => setText(event.currentTarget.value)} />
        </label>
        <button type="button" onClick={() => set(text)}>
          Set, or back
        </button>
      </div>
      <Problem lines={action.problem} />
    </Card>
  );
}

const kDefects = [
  { defect: "none", title: "None" },
  { defect: "loss", title: "Signal loss" },
  { defect: "lost_pulses", title: "Lost pulses" },
  { defect: "reversed", title: "Reversed" },
] as const;

/** A defect of the encoder. */
export function EncoderCard(props: { hand: Hand }) {
  const { hand } = props;
  const path = `axes/${hand.axis}/encoder`;
  const encoder = useRegularly<Schemas["result.encoder.get"]>(hand, path);
  const action = useAction(hand.journal);
  const set = (defect: string, title: string): void => {
    void action.run(`Encoder defect: ${title}`, () => hand.source.act("PUT", hand.unit, path, { defect })).then(encoder.again);
  };
  return (
    <Card title="Encoder">
      <Unknown error={encoder.error} />
      {encoder.value !== undefined && (
        <p class="mono">
          {fixed(encoder.value.speed_rpm, 1, "rpm")} measured, {fixed(encoder.value.true_speed_rpm, 1, "rpm")} true
        </p>
      )}
      <div class="buttons" role="group" aria-label="Defect">
        {kDefects.map(({ defect, title }) => (
          <button key={defect} type="button" aria-pressed={encoder.value?.defect === defect} onClick={() => set(defect, title)}>
            {title}
          </button>
        ))}
      </div>
      <Problem lines={action.problem} />
    </Card>
  );
}
