import { fixed } from "../../ui/number";

/** What the axis does at the moment. */
export interface Values {
  speed?: number | null | undefined;
  setpoint?: number | null | undefined;
  torque?: number | null | undefined;
}

/** A value on a scale around zero. */
function Meter(props: { name: string; value: number | null | undefined; mark?: number | null | undefined; end: number; unit: string }) {
  const share = (value: number): number => Math.max(-1, Math.min(1, value / props.end));
  const value = share(props.value ?? 0);
  return (
    <div class="hands-meter">
      <span>{props.name}</span>
      <span class="mono hands-meter-value">{fixed(props.value, props.unit === "rpm" ? 1 : 2, props.unit)}</span>
      <svg viewBox="-100 0 200 14" preserveAspectRatio="none" aria-hidden="true">
        <rect class="hands-meter-back" x={-100} y={3} width={200} height={8} />
        <rect class="hands-meter-bar" x={value < 0 ? value * 100 : 0} y={3} width={Math.abs(value) * 100} height={8} />
        <rect class="hands-meter-zero" x={-0.4} y={0} width={0.8} height={14} />
        {props.mark !== undefined && props.mark !== null && (
          <rect class="hands-meter-mark" x={share(props.mark) * 100 - 0.8} y={0} width={1.6} height={14} />
        )}
      </svg>
      <span class="muted hands-meter-end">
        ±{props.end} {props.unit}
      </span>
    </div>
  );
}

/** The next round number above @param value: 1, 2 or 5 times a power of ten. */
export function scaleEnd(value: number): number {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1)));
  return power * ([1, 2, 5, 10].find((step) => step * power >= value) ?? 10);
}

/** Speed with its setpoint, and torque. */
export function Meters(props: { values: Values; speedEnd: number; torqueEnd: number }) {
  return (
    <div class="hands-meters">
      <Meter name="Speed" value={props.values.speed} mark={props.values.setpoint} end={props.speedEnd} unit="rpm" />
      <Meter name="Torque" value={props.values.torque} end={props.torqueEnd} unit="N·m" />
    </div>
  );
}
