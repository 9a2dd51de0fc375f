import { useEffect, useRef } from "preact/hooks";

import { theme } from "../../app/theme";
import type { ScopeState } from "../data/scope_state";
import { Picture } from "../draw/picture";
import { useGestures } from "./gestures";
import { keyAction } from "./keys";

/** The pictures over each other on one time, with the lines of the cursors over them. */
export function Stage(props: { state: ScopeState }) {
  const { model } = props.state;
  const stage = useRef<HTMLDivElement>(null);
  const ruler = useRef<HTMLCanvasElement>(null);
  const plots = useRef<HTMLDivElement>(null);
  const lower = useRef<HTMLCanvasElement>(null);
  const cursorLine = useRef<HTMLDivElement>(null);
  const lineA = useRef<HTMLDivElement>(null);
  const lineB = useRef<HTMLDivElement>(null);
  const picture = useRef<Picture | null>(null);

  useEffect(() => {
    const places = [stage.current, ruler.current, plots.current, lower.current, cursorLine.current, lineA.current, lineB.current];
    if (places.some((place) => place === null)) return undefined;
    const [stageElement, rulerElement, plotsElement, lowerElement, cursor, a, b] = places as [
      HTMLElement, HTMLCanvasElement, HTMLElement, HTMLCanvasElement, HTMLElement, HTMLElement, HTMLElement,
    ];
    const made = new Picture(model, { stage: stageElement, ruler: rulerElement, plots: plotsElement, lower: lowerElement, cursor, a, b });
    picture.current = made;
    model.onChange = () => made.want();
    const measure = (): void => made.measure();
    const watcher = new ResizeObserver(measure);
    watcher.observe(stageElement);
    if (stageElement.parentElement?.parentElement) watcher.observe(stageElement.parentElement.parentElement);
    addEventListener("resize", measure);
    const dark = matchMedia("(prefers-color-scheme: dark)");
    const recolour = (): void => made.recolour();
    dark.addEventListener("change", recolour);
    const unsubscribe = theme.subscribe(() => requestAnimationFrame(recolour));
    measure();
    return () => {
      watcher.disconnect();
      removeEventListener("resize", measure);
      dark.removeEventListener("change", recolour);
      unsubscribe();
      model.onChange = () => undefined;
      made.end();
    };
  }, [model]);

  useGestures(stage, lower, picture, props.state);

  const onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const action = keyAction(event.key, event.shiftKey);
    if (action === undefined) return;
    event.preventDefault();
    action(props.state, picture.current);
  };

  return (
    <div
      ref={stage}
      class="scope-stage"
      tabIndex={0}
      role="application"
      aria-label="Signals, states, events and frames on one time axis"
      aria-describedby="scope-keys"
      onKeyDown={onKey}
    >
      <canvas ref={ruler} class="scope-canvas" aria-hidden="true" />
      <div ref={plots} class="scope-plots" aria-hidden="true" />
      <canvas ref={lower} class="scope-canvas" aria-hidden="true" />
      <div ref={cursorLine} class="scope-line scope-line-cursor" aria-hidden="true">
        <span />
      </div>
      <div ref={lineA} class="scope-line scope-line-a" aria-hidden="true">
        <span />
      </div>
      <div ref={lineB} class="scope-line scope-line-b" aria-hidden="true">
        <span />
      </div>
      <p id="scope-keys" class="visually-hidden">
        Arrow keys move the cursor, with Shift ten times as far; Home and End go to the edges; plus and minus zoom; Page Up and Page Down move
        the window; Space pauses; A and B set the two cursors; Enter shows what is at the cursor; Escape takes the cursor away.
      </p>
    </div>
  );
}
