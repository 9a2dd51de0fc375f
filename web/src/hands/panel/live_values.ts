import { useResource } from "../../ui/resource";
import type { AxisOverview } from "../../source/types";
import type { Hand } from "../action";
import type { Values } from "./meters";

/** From one look to the next (ms). */
const kPeriod = 200;

interface SignalValues {
  signals: { signal: string; value: number | null }[];
}

/** What the axis does, five times a second; of a recording as it was at its end. */
export function useValues(hand: Hand, axis: AxisOverview | undefined): Values {
  const { source, unit } = hand;
  const names = ["speed", "speed_setpoint", "torque"].map((name) => `${hand.axis}/${name}`);
  const ask = (): Promise<SignalValues> =>
    source.isLive ? source.get(unit, "signals/values", { signals: names.join(",") }) : Promise.resolve({ signals: [] });
  const answer = useResource(ask, [source, unit, hand.axis], source.isLive ? kPeriod : undefined);
  const values = answer.value?.signals ?? [];
  if (values.length < names.length) return { speed: axis?.speed_rpm, setpoint: axis?.setpoint_rpm, torque: axis?.torque_Nm };
  return { speed: values[0]?.value, setpoint: values[1]?.value, torque: values[2]?.value };
}
