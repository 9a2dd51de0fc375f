import { useMemo, useState } from "preact/hooks";

import { frameText } from "../../canopen/frame";
import { kLanes, laneNumber, type Lane } from "../../canopen/services";
import { eventLook, eventWords, placeWords } from "../../overview/event_words";
import type { UnitEvent } from "../../source/types";
import type { ScopeState } from "../data/scope_state";
import { useSlowTurn } from "./slow_turn";

const kMostEvents = 200;
const kMostFrames = 120;
function EventList(props: { state: ScopeState }) {
  const { model } = props.state;
  useSlowTurn(props.state);
  const { from, to } = model.range();
  const selection = model.selection.value;
  const inside = model.material.value.events().filter(({ t }) => t >= from && t <= to);
  const shown = inside.slice(-kMostEvents).reverse();
  const choose = (event: UnitEvent): void => {
    model.goTo(event.t);
    model.select({ kind: "event", event });
  };
  if (shown.length === 0) return <p class="muted">Nothing has happened in this window.</p>;
  return (
    <ul class="scope-list" tabIndex={0} aria-label="Events in the window">
      {shown.map((event, i) => {
        const look = eventLook(event);
        const isChosen = selection?.kind === "event" && selection.event === event;
        const place = placeWords(event);
        return (
          <li key={event.id ?? `${event.t} ${i}`}>
            <button type="button" class="scope-link" aria-current={isChosen ? "true" : undefined} onClick={() => choose(event)}>
              <span class="mono">{event.t.toFixed(3)}</span>{" "}
              <span class={`scope-glyph tone-${look.tone}`} aria-hidden="true">
                {look.glyph}
              </span>{" "}
              <strong>{look.title}</strong>
              {place === "" ? "" : ` ${place}`}: {eventWords(event)}
            </button>
          </li>
        );
      })}
      {inside.length > kMostEvents && <li class="muted">{`and ${inside.length - kMostEvents} earlier ones`}</li>}
    </ul>
  );
}

/** Serial numbers of at most @param most frames of @param lane in the window that are the nearest to the cursor. */
function framesNear(state: ScopeState, lane: Lane | "", most: number): number[] {
  const { model } = state;
  const { frames } = model.material.peek();
  const { from, to } = model.range();
  const [begin, end] = frames.range(from, to);
  const wanted = lane === "" ? -1 : laneNumber(lane);
  const middle = frames.at(model.cursor() ?? to);
  const found: number[] = [];
  for (let up = middle, n = 0; up < end && n < most / 2; ++up)
    if (wanted < 0 || frames.laneAt(up) === wanted) n = found.push(up);
  const after = found.length;
  for (let down = Math.min(middle, end) - 1; down >= begin && found.length - after < most - after; --down)
    if (wanted < 0 || frames.laneAt(down) === wanted) found.push(down);
  return found.toSorted((one, two) => one - two);
}

function FrameList(props: { state: ScopeState }) {
  const { model } = props.state;
  const [lane, setLane] = useState<Lane | "">("");
  const turn = useSlowTurn(props.state);
  const { frames, decoder } = model.material.value;
  const serials = useMemo(() => framesNear(props.state, lane, kMostFrames), [turn, lane, frames, model.window.value, model.cursorShare.value]);
  const selection = model.selection.value;
  const choose = (serial: number): void => {
    if (model.window.peek().follows) model.pause(true);
    model.select({ kind: "frame", serial });
  };
  return (
    <>
      <label class="field">
        Service
        <select value={lane} onChange={(event) => setLane(event.currentTarget.value as Lane | "")}>
          <option value="">all</option>
          {kLanes.map((row) => (
            <option key={row.lane} value={row.lane}>
              {row.name}
            </option>
          ))}
        </select>
      </label>
      {serials.length === 0 && <p class="muted">There are no frames in this window.</p>}
      <ul class="scope-list" tabIndex={0} aria-label="Frames at the cursor">
        {serials.map((serial) => {
          const frame = frames.frame(serial);
          if (frame === undefined) return null;
          const isChosen = selection?.kind === "frame" && selection.serial === serial;
          return (
            <li key={serial}>
              <button type="button" class="scope-link" aria-current={isChosen ? "true" : undefined} onClick={() => choose(serial)}>
                <span class="mono">
                  {frame.t.toFixed(6)} {frame.sent ? "S" : "R"} {frameText(frame)}
                </span>{" "}
                {decoder.settings.services.of(frame.id, frame.isExtended).name}
              </button>
            </li>
          );
        })}
      </ul>
    </>
  );
}

/** Events and frames as lists, for reading and for the keyboard. */
export function Lists(props: { state: ScopeState }) {
  const [shown, setShown] = useState<"events" | "frames">("events");
  return (
    <section class="card scope-lists" aria-label="Lists">
      <div class="buttons" role="group" aria-label="Which list">
        <button type="button" aria-pressed={shown === "events"} onClick={() => setShown("events")}>
          Events
        </button>
        <button type="button" aria-pressed={shown === "frames"} onClick={() => setShown("frames")}>
          Frames
        </button>
      </div>
      {shown === "events" ? <EventList state={props.state} /> : <FrameList state={props.state} />}
    </section>
  );
}
