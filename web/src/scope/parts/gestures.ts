import type { RefObject } from "preact";
import { useEffect } from "preact/hooks";

import type { ScopeState } from "../data/scope_state";
import { selectAt } from "../draw/hits";
import type { Picture } from "../draw/picture";
import { xOf } from "../draw/time_field";

/** A pointer that has moved less (CSS pixels) has clicked. */
const kClick = 4;
/** How near to a cursor's line a pointer takes hold of it (CSS pixels). */
const kGrip = 7;

interface Drag {
  x: number;
  y: number;
  /** Where it was last. */
  at: number;
  what: "pan" | "zoom" | "a" | "b";
  hasMoved: boolean;
}

/** What pointers do on the stage: hover, pan, zoom, pinch, take hold of cursors, click. */
class Gestures {
  private drag: Drag | undefined;
  private readonly pointers = new Map<number, number>();

  constructor(
    private readonly stage: HTMLElement,
    private readonly lower: HTMLElement,
    private readonly state: ScopeState,
    private readonly pictureOf: () => Picture | null,
  ) {}

  down = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    this.stage.setPointerCapture(event.pointerId);
    const x = this.x(event);
    this.pointers.set(event.pointerId, x);
    this.drag = { x, y: event.clientY, at: x, what: event.shiftKey ? "zoom" : (this.gripped(x) ?? "pan"), hasMoved: false };
  };

  move = (event: PointerEvent): void => {
    const x = this.x(event);
    if (this.pointers.size === 2) {
      this.pinch(event.pointerId, x);
      return;
    }
    this.hover(x);
    const { drag } = this;
    if (drag === undefined || !this.pointers.has(event.pointerId)) return;
    if (Math.abs(x - drag.x) > kClick) drag.hasMoved = true;
    if (!drag.hasMoved) return;
    if (drag.what === "pan") this.state.model.pan(-(x - drag.at) * this.secondsPerPixel());
    if (drag.what === "a" || drag.what === "b") this.state.model.setMark(drag.what, this.timeAt(x));
    drag.at = x;
  };

  up = (event: PointerEvent): void => {
    const { drag } = this;
    this.pointers.delete(event.pointerId);
    this.drag = undefined;
    if (drag === undefined) return;
    if (drag.hasMoved && drag.what === "zoom") this.zoomTo(drag.x, this.x(event));
    if (!drag.hasMoved) this.click(event);
  };

  cancel = (event: PointerEvent): void => {
    this.pointers.delete(event.pointerId);
    this.drag = undefined;
  };

  leave = (event: PointerEvent): void => {
    if (event.pointerType === "mouse" && this.drag === undefined) this.state.model.setCursor(null);
  };

  wheel = (event: WheelEvent): void => {
    event.preventDefault();
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY))
      this.state.model.pan((event.deltaX || event.deltaY) * this.secondsPerPixel());
    else this.state.model.zoom(1.0015 ** event.deltaY, this.timeAt(this.x(event)));
  };

  private click(event: PointerEvent): void {
    const picture = this.pictureOf();
    if (picture === null) return;
    const y = event.clientY - this.lower.getBoundingClientRect().top;
    this.hover(this.x(event));
    if (y >= 0) selectAt(this.state.model, picture, this.x(event), y);
  }

  private pinch(pointer: number, x: number): void {
    const [one = 0, two = 0] = this.pointers.values();
    this.pointers.set(pointer, x);
    const [nextOne = 0, nextTwo = 0] = this.pointers.values();
    const [before, now] = [Math.abs(one - two), Math.abs(nextOne - nextTwo)];
    if (this.drag !== undefined) this.drag.hasMoved = true;
    if (before > 10 && now > 10) this.state.model.zoom(before / now, this.timeAt((nextOne + nextTwo) / 2));
  }

  private zoomTo(one: number, two: number): void {
    if (Math.abs(one - two) < kClick) return;
    this.state.model.show({ from: this.timeAt(Math.min(one, two)), to: this.timeAt(Math.max(one, two)) });
  }

  private hover(x: number): void {
    const field = this.pictureOf()?.field();
    if (field === undefined) return;
    this.state.model.setCursor(Math.min(1, Math.max(0, (x - field.left) / field.width)));
  }

  private gripped(x: number): "a" | "b" | undefined {
    const field = this.pictureOf()?.field();
    const { a, b } = this.state.model;
    const isNear = (t: number | null): boolean => field !== undefined && t !== null && Math.abs(xOf(field, t) - x) < kGrip;
    if (isNear(a.peek())) return "a";
    return isNear(b.peek()) ? "b" : undefined;
  }

  private timeAt(x: number): number {
    const field = this.pictureOf()?.field();
    if (field === undefined) return 0;
    return field.from + ((x - field.left) / field.width) * (field.to - field.from);
  }

  private secondsPerPixel(): number {
    const field = this.pictureOf()?.field();
    return field === undefined ? 0 : (field.to - field.from) / field.width;
  }

  private x(event: MouseEvent): number {
    return event.clientX - this.stage.getBoundingClientRect().left;
  }
}

/** Lets pointers work on the stage. */
export function useGestures(
  stage: RefObject<HTMLElement | null>,
  lower: RefObject<HTMLElement | null>,
  picture: RefObject<Picture | null>,
  state: ScopeState,
): void {
  useEffect(() => {
    const element = stage.current;
    if (element === null || lower.current === null) return undefined;
    const gestures = new Gestures(element, lower.current, state, () => picture.current);
    const rows = [
      ["pointerdown", gestures.down],
      ["pointermove", gestures.move],
      ["pointerup", gestures.up],
      ["pointercancel", gestures.cancel],
      ["pointerleave", gestures.leave],
      ["wheel", gestures.wheel],
    ] as [string, EventListener][];
    for (const [name, listener] of rows) element.addEventListener(name, listener, { passive: false });
    return () => rows.forEach(([name, listener]) => element.removeEventListener(name, listener));
  }, [state]);
}
