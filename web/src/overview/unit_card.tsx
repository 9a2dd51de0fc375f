import { usePage } from "../app/context";
import { linkTo } from "../app/route";
import { profileOf } from "../model/profile";
import type { Explanation, UnitOverview } from "../source/types";
import { Notice } from "../ui/notice";
import { duration, fixed } from "../ui/number";
import { useResource } from "../ui/resource";
import { AxisBlock } from "./axis_block";
import { FaultChips } from "./fault_chips";
import { Led } from "./led";
import { stateKey } from "./state_key";

function BusFigures(props: { unit: UnitOverview; rate: number | undefined }) {
  const { bus, dc_link_V: voltage, skipped_cycles: skipped } = props.unit;
  const load = bus?.load_percent === undefined ? "" : `${fixed(bus.load_percent, 1, "%")} of the bus, `;
  const rate = props.rate === undefined ? "" : fixed(props.rate, 0, "frames/s");
  const isUpset = bus !== undefined && (bus.state !== "error-active" || bus.link !== "up");
  return (
    <p class="overview-bus muted">
      {isUpset && <strong class="overview-upset">bus {bus.link}, {bus.state} </strong>}
      {load}
      {rate === "" ? "" : `${rate}, `}
      DC link {fixed(voltage, 0, "V")}
      {skipped !== undefined && skipped > 0 ? `, ${skipped} cycles were left out` : ""}
    </p>
  );
}

/** What the axes do; asks why they do not turn whenever something has changed that this depends on. */
function UnitBody(props: { unit: UnitOverview; rate: number | undefined }) {
  const { source, units } = usePage();
  const { unit } = props;
  const isAnswering = units.absence.value === "";
  const explained = useResource(() => source.get<Explanation>(unit.unit, "explain"), [source, unit.unit, stateKey(unit), isAnswering]);
  const reasonsOf = (axis: number): string[] | undefined =>
    explained.value?.axes?.find((each) => each.axis === axis)?.reasons ?? (unit.axes?.length === 1 ? explained.value?.reasons : undefined);
  return (
    <>
      <BusFigures unit={unit} rate={props.rate} />
      <FaultChips unit={unit.unit} place={0} faults={unit.control_unit?.faults ?? []} alarms={unit.control_unit?.alarms ?? []} />
      <div class="overview-axes">
        {(unit.axes ?? []).map((axis) => (
          <AxisBlock key={axis.axis} unit={unit.unit} profile={profileOf(unit)} axis={axis} reasons={reasonsOf(axis.axis)} />
        ))}
      </div>
      {explained.error !== "" && <Notice kind="warning">{`Why it does not turn is not known: ${explained.error}`}</Notice>}
    </>
  );
}

/** Without its axes: for a unit that does not answer, or is off. */
function Silence(props: { unit: UnitOverview }) {
  return <Notice kind="warning">{props.unit.error ?? "The unit is switched off."}</Notice>;
}

function UnitHead(props: { unit: UnitOverview }) {
  const { unit } = props;
  return (
    <div class="overview-line">
      <h2>
        <a href={linkTo("scope", unit.unit)}>{unit.unit}</a>
      </h2>
      {unit.host !== undefined && <span class="muted">on host {unit.host}</span>}
      {unit.on && (
        <span class="overview-node">
          <span class="chip tone-ready">{unit.nmt_state ?? "NMT state unknown"}</span>
          {unit.leds !== undefined && <Led name="RUN" colour="green" pattern={unit.leds.run} />}
          {unit.leds !== undefined && <Led name="ERR" colour="red" pattern={unit.leds.error} />}
          <span class="muted">
            {profileOf(unit) === "cia402" && "CiA 402, "}node {unit.node_id}, up {duration(Math.floor(unit.uptime_s ?? 0))}
          </span>
        </span>
      )}
    </div>
  );
}

/** A unit with its axes. */
export function UnitCard(props: { unit: UnitOverview; rate: number | undefined }) {
  const { unit } = props;
  return (
    <article class="card overview-card" aria-label={unit.unit}>
      <UnitHead unit={unit} />
      {unit.on ? <UnitBody unit={unit} rate={props.rate} /> : <Silence unit={unit} />}
    </article>
  );
}
