import { useEffect, useMemo, useState } from "preact/hooks";

import { replaceQuery, route, usePage } from "../app/context";
import { TokenDialog } from "../app/token_dialog";
import { useProfile } from "../app/use_profile";
import { ControlwordCard } from "../hands/controlword_card";
import { FaultsCard } from "../hands/faults/faults_card";
import { WireCard } from "../hands/faults/wire_card";
import type { Hand } from "../hands/action";
import { IdentificationCard } from "../hands/identification_card";
import { Journal } from "../hands/journal";
import { JournalList } from "../hands/journal_list";
import { useValues } from "../hands/panel/live_values";
import { PanelCard } from "../hands/panel/panel_card";
import { PanelLink } from "../hands/panel/panel_link";
import { panelPort } from "../hands/panel/panel_port";
import { StopBar } from "../hands/panel/stop_bar";
import { EncoderCard, LoadCard, SupplyCard } from "../hands/plant_cards";
import type { AxisOverview } from "../source/types";
import { AxisChoice, useAxis } from "../ui/axis_choice";

/** Why nothing may be done, and the way to do something about it. */
function Refused() {
  const { permission, source } = usePage();
  const [asksToken, setAsksToken] = useState(false);
  if (permission.refusal.value === "") return null;
  const isHelped = source.isLive && permission.server.value?.read_only !== true;
  return (
    <div class="notice notice-warning hands-refused" role="status">
      <span>{permission.refusal.value}</span>
      {isHelped && (
        <button type="button" onClick={() => setAsksToken(true)}>
          Give the token
        </button>
      )}
      {asksToken && <TokenDialog onClose={() => setAsksToken(false)} />}
    </div>
  );
}

/** What every unit has: faults, machine and supply, the wire. */
function SharedCards(props: { hand: Hand }) {
  const { hand } = props;
  return (
    <>
      <JournalList journal={hand.journal} />
      <FaultsCard hand={hand} />
      <LoadCard hand={hand} />
      <SupplyCard hand={hand} />
      <EncoderCard hand={hand} />
      <WireCard hand={hand} />
    </>
  );
}

/** What acts on one axis of CiA 402. */
function Cia402Hands(props: { hand: Hand; axis: AxisOverview | undefined }) {
  return (
    <div class="hands-cards hands-cards-whole">
      <ControlwordCard hand={props.hand} axis={props.axis} />
      <SharedCards hand={props.hand} />
    </div>
  );
}

/** What acts on one axis of the drive unit; the control goes back with it. */
function AxisHands(props: { hand: Hand; axis: AxisOverview | undefined }) {
  const { hand, axis } = props;
  const { permission } = usePage();
  const link = useMemo(() => new PanelLink(panelPort(hand.source, hand.unit, hand.axis)), [hand.source, hand.unit, hand.axis]);
  const values = useValues(hand, axis);
  useEffect(() => {
    const leave = (): void => void link.release().catch(() => undefined);
    const leaveHidden = (): void => {
      if (document.hidden) leave();
    };
    addEventListener("pagehide", leave);
    document.addEventListener("visibilitychange", leaveHidden);
    return () => {
      removeEventListener("pagehide", leave);
      document.removeEventListener("visibilitychange", leaveHidden);
      leave();
    };
  }, [link]);
  const stop = (): void => {
    if (!link.isHeld.value) return;
    void hand.journal.run("Stop: OFF1", () => link.stop()).catch((error: unknown) => permission.note(error));
  };
  return (
    <>
      <div class="hands-cards">
        <PanelCard hand={hand} link={link} values={values} />
        <SharedCards hand={hand} />
        <IdentificationCard hand={hand} />
      </div>
      <StopBar link={link} axis={hand.axis} state={link.panel.value?.active === true ? link.panel.value.state : (axis?.state ?? "")} values={values} stop={stop} />
    </>
  );
}

/** Everything that acts on a unit by hand. */
export function Hands(props: { unit: string }) {
  const { units, source, permission } = usePage();
  const isAnswering = units.absence.value === "";
  useEffect(() => {
    if (isAnswering) void permission.ask();
  }, [isAnswering, permission]);
  const overview = units.find(props.unit);
  const profile = useProfile(props.unit);
  const axes = overview?.axes ?? [];
  const asked = Number(route.value.query.get("axis") ?? "0");
  const [axis, setAxis] = useAxis(axes, asked);
  const journal = useMemo(() => new Journal(), []);
  const hand = useMemo(() => ({ source, unit: props.unit, axis, journal }), [source, props.unit, axis, journal]);
  const choose = (next: number): void => {
    setAxis(next);
    replaceQuery(new URLSearchParams({ axis: String(next) }));
  };
  return (
    <>
      <div class="hands-head">
        <h1>Hands</h1>
        <AxisChoice axes={axes} axis={axis} onChange={choose} />
        <span class="muted">NMT state: {overview?.nmt_state ?? "unknown"}</span>
      </div>
      <Refused />
      {profile === "s120" && <AxisHands key={axis} hand={hand} axis={axes.find((each) => each.axis === axis)} />}
      {profile === "cia402" && <Cia402Hands key={axis} hand={hand} axis={axes.find((each) => each.axis === axis)} />}
    </>
  );
}
