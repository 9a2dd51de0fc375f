import type { Decoded, DecodedRow } from "../../canopen/decode";
import { frameText, hexOf } from "../../canopen/frame";
import { causeOfState, storyOfFault, type Cause, type Pointer, type Step } from "../../model/cause";
import type { UnitEvent } from "../../source/types";
import { eventLook, eventWords, originWords, placeWords } from "../../overview/event_words";
import { pastOf } from "../data/material";
import type { ScopeState } from "../data/scope_state";
import { differenceText } from "../view/scale";
import { BitTable } from "./bit_table";
import { useSlowTurn } from "./slow_turn";

function instant(t: number): string {
  return `${t.toFixed(6)}\u2009s`;
}

/** Goes to where @param pointer points. */
function follow(state: ScopeState, pointer: Pointer): void {
  state.model.goTo(pointer.t);
  if (pointer.frame !== undefined) state.model.select({ kind: "frame", serial: pointer.frame });
  else if (pointer.event !== undefined) state.model.select({ kind: "event", event: pointer.event });
}

function PointerButton(props: { state: ScopeState; pointer: Pointer }) {
  const { pointer } = props;
  if (pointer.frame === undefined && pointer.event === undefined) return null;
  return (
    <button type="button" class="scope-small" onClick={() => follow(props.state, pointer)}>
      {pointer.frame === undefined ? "Show event" : "Show frame"}
    </button>
  );
}

function Rows(props: { rows: readonly DecodedRow[] }) {
  if (props.rows.length === 0) return null;
  return (
    <dl class="scope-rows">
      {props.rows.map((row, i) => (
        <div key={i}>
          <dt>
            {row.name} {row.object !== undefined && <code>{row.object}</code>} {row.raw !== undefined && <code>{row.raw}</code>}
          </dt>
          <dd>{row.value}</dd>
          {row.bits !== undefined && (
            <dd>
              <BitTable bits={row.bits} />
            </dd>
          )}
        </div>
      ))}
    </dl>
  );
}

/** The other frames of the SDO transfer. */
function Transfer(props: { state: ScopeState; decoded: Decoded; serial: number }) {
  const { decoded, state } = props;
  const serials = decoded.transfer ?? (decoded.partner === undefined ? [] : [props.serial, decoded.partner]);
  const { frames } = state.model.material.value;
  if (serials.length < 2) return null;
  return (
    <>
      <h3>The transfer</h3>
      <ol class="scope-steps">
        {serials.slice(0, 60).map((serial) => {
          const frame = frames.frame(serial);
          if (frame === undefined) return null;
          return (
            <li key={serial}>
              <button
                type="button"
                class="scope-link"
                aria-current={serial === props.serial ? "true" : undefined}
                onClick={() => follow(state, { t: frame.t, frame: serial })}
              >
                {instant(frame.t)} {frame.sent ? "sent" : "received"} <code>{frameText(frame)}</code>
              </button>
            </li>
          );
        })}
      </ol>
      {serials.length > 60 && <p class="muted">{`and ${serials.length - 60} more`}</p>}
    </>
  );
}

function FrameDetail(props: { state: ScopeState; serial: number }) {
  const { state, serial } = props;
  const { frames, decoder } = state.model.material.value;
  const frame = frames.frame(serial);
  if (frame === undefined) return <p>This frame is no longer kept.</p>;
  const decoded = decoder.decodeAt(frames, serial);
  const hasEds = decoder.settings.eds !== undefined;
  return (
    <>
      <h2>{decoded?.headline ?? frameText(frame)}</h2>
      <p>
        {instant(frame.t)}, {frame.sent ? "sent by the unit" : "received by the unit"}
        {decoded !== undefined && `, ${decoded.service.name}`}
        <br />
        <code>{frameText(frame)}</code>
        {!frame.isRemote && frame.length > 0 && <span class="muted mono"> [{frame.length}] {hexOf(frame.data, " ")}</span>}
      </p>
      {decoded?.remark !== undefined && decoded.remark !== "" && <p class="notice notice-warning">{decoded.remark}</p>}
      <Rows rows={decoded?.rows ?? []} />
      {decoded !== undefined && <Transfer state={state} decoded={decoded} serial={serial} />}
      {!hasEds && <p class="muted">There is no EDS of this unit: objects are shown by their numbers.</p>}
    </>
  );
}

function CauseView(props: { state: ScopeState; cause: Cause }) {
  const { cause, state } = props;
  const word = cause.controlword;
  return (
    <>
      <h3>Why</h3>
      <p>{cause.text}</p>
      {word !== undefined && (
        <>
          <p>
            Controlword {word.before === undefined ? "" : `${hexWord(word.before)} → `}
            <strong>{hexWord(word.now)}</strong>
          </p>
          <BitTable bits={word.changed} />
        </>
      )}
      {cause.pointer !== undefined && <PointerButton state={state} pointer={cause.pointer} />}
    </>
  );
}

function hexWord(word: number): string {
  return `${word.toString(16).toUpperCase().padStart(4, "0")}h`;
}

function Steps(props: { state: ScopeState; title: string; steps: readonly Step[]; none: string }) {
  return (
    <>
      <h3>{props.title}</h3>
      {props.steps.length === 0 && <p class="muted">{props.none}</p>}
      <ol class="scope-steps">
        {props.steps.map((step, i) => (
          <li key={i}>
            <span class="mono">{step.after >= 0 ? `+${differenceText(step.after)}` : differenceText(step.after)}</span> {step.text}{" "}
            <PointerButton state={props.state} pointer={step} />
          </li>
        ))}
      </ol>
    </>
  );
}

function FaultDetail(props: { state: ScopeState; event: UnitEvent }) {
  const { state, event } = props;
  useSlowTurn(state);
  const story = storyOfFault(event, pastOf(state.model.material.value));
  const { from } = state.model.material.value.extent();
  const isBefore = state.model.material.value.isLive && from > event.t;
  const last = story.reaction.at(-1)?.after ?? 0;
  const around = (): void => state.model.show({ from: event.t - 0.05, to: event.t + Math.min(5, Math.max(0.1, last * 1.1)) });
  const place = placeWords(event);
  return (
    <>
      <h2>{story.title}</h2>
      <p>
        {instant(event.t)}
        {place === "" ? "" : `, ${place}`}
        {story.value === "" ? "" : `, ${story.value}`}
        {event.active === false ? ", has gone" : ""}
      </p>
      <div class="buttons">
        <button type="button" onClick={around}>
          Show all frames around it
        </button>
      </div>
      {isBefore && <p class="muted">{`Frames and signals of that time are not known: this page has listened since ${instant(from)}.`}</p>}
      <Steps state={state} title="What has led to it" steps={story.causes} none="Nothing that was recorded before it explains it." />
      <Steps state={state} title="What the unit did" steps={story.reaction} none="Nothing has followed yet." />
    </>
  );
}

function EventDetail(props: { state: ScopeState; event: UnitEvent }) {
  const { state, event } = props;
  const isState = event.kind === "drive-state" || event.kind === "nmt";
  const place = placeWords(event);
  return (
    <>
      <h2>
        {eventLook(event).title}: {eventWords(event)}
      </h2>
      <p>
        {instant(event.t)}
        {place === "" ? "" : `, ${place}`}, by: {originWords(event)}
      </p>
      {isState && <CauseView state={state} cause={causeOfState(event, pastOf(state.model.material.value))} />}
    </>
  );
}

/** What was clicked, in words: a frame decoded, a state with its cause, a fault with its story. */
export function Detail(props: { state: ScopeState }) {
  const { state } = props;
  const selection = state.model.selection.value;
  const isMessage = selection?.kind === "event" && (selection.event.kind === "fault" || selection.event.kind === "alarm");
  return (
    <section class="card scope-detail" aria-label="What was chosen" aria-live="polite" tabIndex={0}>
      {selection === null && (
        <p class="muted">Click on a frame, a state or an event, or choose one in the list: what it is and why it came stands here.</p>
      )}
      {selection?.kind === "frame" && <FrameDetail state={state} serial={selection.serial} />}
      {selection?.kind === "event" && isMessage && <FaultDetail state={state} event={selection.event} />}
      {selection?.kind === "event" && !isMessage && <EventDetail state={state} event={selection.event} />}
    </section>
  );
}
