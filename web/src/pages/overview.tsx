import { useMemo, useRef } from "preact/hooks";

import { usePage } from "../app/context";
import { EventList } from "../overview/event_list";
import { FrameRates } from "../overview/frame_rates";
import { kOpenCards, ManyUnits } from "../overview/many_units";
import { useRecordedEvents } from "../overview/recorded_events";
import { UnitCard } from "../overview/unit_card";
import { VerdictCard } from "../overview/verdict_card";
import { Notice } from "../ui/notice";

/** Says in one sentence how many units are there; announced when it changes. */
function Summary() {
  const { units } = usePage();
  const all = units.all.value;
  const axes = all.flatMap((unit) => unit.axes ?? []);
  const faulty = axes.filter((axis) => axis.faults.length > 0).length;
  const running = axes.filter((axis) => axis.state === "Operation enabled").length;
  return (
    <p class="muted" role="status">
      {all.length === 1 ? "1 unit" : `${all.length} units`}, {axes.length === 1 ? "1 axis" : `${axes.length} axes`}: {running} in
      operation, {faulty} with faults.
    </p>
  );
}

/** All units: what they do, why an axis does not turn, what changed last. */
export function Overview() {
  const { units, source } = usePage();
  useRecordedEvents();
  const all = units.all.value;
  const rates = useRef(new FrameRates());
  const rate = useMemo(() => rates.current.update(all), [all]);
  const isWaiting = all.length === 0 && units.seenAt.value === 0;
  return (
    <>
      <h1>Overview</h1>
      {source.verdict !== undefined && <VerdictCard verdict={source.verdict} />}
      {all.length > 0 && <Summary />}
      {isWaiting && units.absence.value === "" && <Notice>Asking for the units …</Notice>}
      {all.length === 0 && !isWaiting && <Notice>There is no unit yet: start axisd, it will be found.</Notice>}
      <div class="overview-columns">
        {all.length > kOpenCards ? (
          <ManyUnits units={all} rates={rate} />
        ) : (
          <div class="overview-cards">
            {all.map((unit) => (
              <UnitCard key={unit.unit} unit={unit} rate={rate.get(unit.unit)} />
            ))}
          </div>
        )}
        <EventList />
      </div>
    </>
  );
}
