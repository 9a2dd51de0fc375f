import { linkTo } from "../app/route";
import { hasParameters, type Profile } from "../model/profile";
import type { AxisOverview } from "../source/types";
import { fixed, shown } from "../ui/number";
import { StateChip } from "../ui/state_chip";
import { FaultChips } from "./fault_chips";

function Figure(props: { name: string; text: string }) {
  return (
    <div>
      <dt>{props.name}</dt>
      <dd>{props.text}</dd>
    </div>
  );
}

/** What an axis does, and why it does not turn. */
export function AxisBlock(props: { unit: string; profile: Profile; axis: AxisOverview; reasons: string[] | undefined }) {
  const { unit, axis } = props;
  const query = { axis: axis.axis };
  return (
    <section class="overview-axis" aria-label={`Axis ${axis.axis} ${axis.name}`}>
      <div class="overview-line">
        <h3>
          Axis {axis.axis} {axis.name} <span class="muted">{axis.type}</span>
        </h3>
        <StateChip state={axis.state} />
      </div>
      <dl class="overview-figures">
        {axis.mode !== undefined && <Figure name="Mode" text={axis.mode} />}
        {axis.homed !== undefined && <Figure name="Homed" text={axis.homed ? "yes" : "no"} />}
        <Figure name="Speed" text={fixed(axis.speed_rpm, 1, "rpm")} />
        <Figure name="Setpoint" text={fixed(axis.setpoint_rpm, 1, "rpm")} />
        <Figure name="Torque" text={fixed(axis.torque_Nm, 2, "N·m")} />
        <Figure name="Current" text={fixed(axis.current_A, 2, "A")} />
        <Figure name="Position" text={shown(axis.position)} />
        <Figure name="Motor" text={fixed(axis.motor_temperature_C, 1, "°C")} />
      </dl>
      <FaultChips unit={unit} place={axis.axis} faults={axis.faults} alarms={axis.alarms} />
      {props.reasons !== undefined && props.reasons.length > 0 && (
        <ul class="overview-reasons">
          {props.reasons.map((reason) => (
            <li key={reason}>{reason}</li>
          ))}
        </ul>
      )}
      <p class="overview-links">
        <a href={linkTo("states", unit, query)}>State machine</a>
        <a href={linkTo("scope", unit, query)}>Scope</a>
        {hasParameters(props.profile) ? (
          <a href={linkTo("parameters", unit, { place: axis.axis })}>Parameters</a>
        ) : (
          <a href={linkTo("objects", unit)}>Objects</a>
        )}
        <a href={linkTo("hands", unit, query)}>Hands</a>
      </p>
    </section>
  );
}
