import { useEffect, useState } from "preact/hooks";

import { useResource } from "../../ui/resource";
import { Notice } from "../../ui/notice";
import type { Panel, ParameterEntry } from "../../source/types";
import { Card, Problem, useAction, type Action, type Hand } from "../action";
import { numberIn } from "../number_text";
import { JogButton } from "./jog_button";
import { Meters, scaleEnd, type Values } from "./meters";
import { kOff, type PanelLink } from "./panel_link";
import { SetpointFields } from "./setpoint_fields";

/** End of the scales (rpm) while p1082 is not known. */
const kUsualSpeed = 3000;

/** Who has the control while this page does not. */
function Holder(props: { hand: Hand }) {
  const { source, unit, axis } = props.hand;
  const path = `axes/${axis}/panel`;
  const panel = useResource(() => source.get<Panel>(unit, path), [source, unit, path], source.isLive ? 1000 : undefined);
  if (panel.error !== "") return <Notice kind="warning">{`Who has the control is not known: ${panel.error}`}</Notice>;
  if (panel.value === undefined) return null;
  if (panel.value.active) return <Notice kind="warning">Another operator panel has the master control of this axis.</Notice>;
  const { refusal } = panel.value;
  return refusal === undefined ? null : <Notice>{`It cannot be taken now: ${refusal}`}</Notice>;
}

function Taking(props: { hand: Hand; link: PanelLink; action: Action }) {
  const { link, action, hand } = props;
  const isHeld = link.isHeld.value;
  return (
    <div class="buttons">
      <button
        type="button"
        class="primary"
        disabled={isHeld || action.isBusy}
        onClick={() => void action.run(`Take the master control of axis ${hand.axis}`, () => link.take())}
      >
        Take the control
      </button>
      <button
        type="button"
        disabled={!isHeld}
        onClick={() => void action.run(`Give the master control of axis ${hand.axis} back`, () => link.release())}
      >
        Give it back
      </button>
    </div>
  );
}

function Jog(props: { link: PanelLink; action: Action; isOff: boolean }) {
  const { link, action } = props;
  const [text, setText] = useState("100");
  const speed = numberIn(text);
  const button = (sign: number, name: string) => (
    <JogButton
      disabled={props.isOff || speed === undefined}
      onBegin={() => void action.run(`Jog at ${sign * (speed ?? 0)} rpm`, () => link.order({ on: true, speedRpm: sign * (speed ?? 0) }))}
      onEnd={() => void action.run("Jog is let go: OFF1", () => link.stop())}
    >
      {name}
    </JogButton>
  );
  return (
    <div class="hands-jogs">
      {button(-1, "◀ Jog −")}
      <label class="field">
        Jog speed (rpm)
        <input class="hands-number" inputMode="decimal" value={text} aria-invalid={speed === undefined} onInput={(event) => setText(event.currentTarget.value)} />
      </label>
      {button(1, "Jog + ▶")}
      <span class="muted">Turns as long as it is held, by pointer, Space or Enter.</span>
    </div>
  );
}

function Operation(props: { link: PanelLink; action: Action; end: number }) {
  const { link, action } = props;
  const [isEnabled, setIsEnabled] = useState(false);
  const [setpoint, setSetpoint] = useState(0);
  const isOn = link.command.value.on;
  const isHeld = link.isHeld.value;
  useEffect(() => {
    if (!isOn) setIsEnabled(false);
  }, [isOn]);
  const enable = (): void => {
    setIsEnabled(true);
    void action.run(`ON at ${setpoint} rpm`, () => link.order({ on: true, speedRpm: setpoint }));
  };
  const change = (rpm: number): void => {
    setSetpoint(rpm);
    if (isEnabled) link.follow({ on: true, speedRpm: rpm });
  };
  const settle = (rpm: number): void => {
    if (isEnabled) void action.run(`Setpoint ${rpm} rpm`, () => link.order({ on: true, speedRpm: rpm }));
  };
  return (
    <fieldset class="hands-fields" disabled={!isHeld}>
      <SetpointFields value={setpoint} end={props.end} onChange={change} onSettled={settle} />
      <div class="buttons">
        <button type="button" class="primary" disabled={isEnabled} onClick={enable}>
          Enable
        </button>
        <button type="button" disabled={!isEnabled} onClick={() => void action.run("Disable: OFF1", () => link.order(kOff))}>
          Disable
        </button>
      </div>
      <Jog link={link} action={action} isOff={!isHeld || isEnabled} />
    </fieldset>
  );
}

/** The maximum speed of the axis (p1082, rpm), as far as the unit tells. */
function useHighestSpeed(hand: Hand): number {
  const { source, unit, axis } = hand;
  const ask = () => source.get<{ parameters: ParameterEntry[] }>(unit, "parameters/p1082", { axis });
  const value = Number(useResource(ask, [source, unit, axis]).value?.parameters[0]?.value);
  return Number.isFinite(value) && value > 0 ? Math.round(value) : kUsualSpeed;
}

/** The operator panel of an axis: master control, ON and OFF, setpoint, jog. */
export function PanelCard(props: { hand: Hand; link: PanelLink; values: Values }) {
  const { hand, link, values } = props;
  const action = useAction(hand.journal);
  const highest = useHighestSpeed(hand);
  const [most, setMost] = useState({ speed: 0, torque: 5 });
  const speed = Math.max(most.speed, Math.abs(values.speed ?? 0), Math.abs(values.setpoint ?? 0));
  const torque = Math.max(most.torque, Math.abs(values.torque ?? 0));
  if (speed > most.speed || torque > most.torque) setMost({ speed, torque });
  return (
    <Card title="Operator panel" wide>
      <Meters values={values} speedEnd={Math.max(highest, speed === 0 ? 0 : scaleEnd(speed))} torqueEnd={scaleEnd(torque)} />
      <div aria-live="polite">
        {link.trouble.value !== "" && <Notice kind="error">{link.trouble.value}</Notice>}
        {link.isHeld.value && link.trouble.value === "" && <Notice>This page has the master control. It says so several times a second: when it does not, the axis stops.</Notice>}
      </div>
      {!link.isHeld.value && <Holder hand={hand} />}
      <Taking hand={hand} link={link} action={action} />
      <Operation link={link} action={action} end={highest} />
      <Problem lines={action.problem} />
    </Card>
  );
}
