import { signal } from "@preact/signals";

import type { UnitEvent } from "../../source/types";
import type { Material } from "../data/material";
import { LiveMaterial } from "../data/live_material";
import { around, paused, panned, rangeOf, showing, within, zoomed, type Range, type TimeWindow } from "./window";

/** What was clicked. */
export type Selection = { kind: "frame"; serial: number } | { kind: "event"; event: UnitEvent };

/** Part of the window by which a step of the cursor goes. */
const kStep = 1 / 200;

/** What the scope shows, where and how; everything that is drawn or said depends on it. */
export class ScopeModel {
  readonly material;
  readonly window = signal<TimeWindow>({ follows: true, span: 10, to: 0 });
  readonly a = signal<number | null>(null);
  readonly b = signal<number | null>(null);
  readonly selection = signal<Selection | null>(null);
  /** Where the cursor is: a part of the window, 0..1; null: nowhere. */
  readonly cursorShare = signal<number | null>(null);
  /** It counts up when values beside the picture are to be read again. */
  readonly readings = signal(0);
  /** Told of every change that is to be drawn. */
  onChange: () => void = () => undefined;

  constructor(material: Material) {
    this.material = signal(material);
  }

  /** The newest instant. */
  end(): number {
    const material = this.material.peek();
    if (material instanceof LiveMaterial) return material.clock.at(performance.now() / 1000);
    return material.extent().to;
  }

  range(): Range {
    return rangeOf(this.window.peek(), this.end());
  }

  /** The instant of the cursor; null: there is none. */
  cursor(): number | null {
    const share = this.cursorShare.peek();
    const { from, to } = this.range();
    return share === null ? null : from + share * (to - from);
  }

  setWindow(window: TimeWindow): void {
    this.window.value = window;
    this.onChange();
    ++this.readings.value;
  }

  pause(isPaused: boolean): void {
    if (!isPaused && !this.material.peek().isLive) return;
    this.setWindow(paused(this.window.peek(), isPaused, this.end()));
  }

  /** Zooms about the cursor, or about the middle. */
  zoom(factor: number, about?: number): void {
    const { from, to } = this.range();
    this.setWindow(zoomed(this.window.peek(), factor, about ?? this.cursor() ?? (from + to) / 2, this.end()));
  }

  pan(by: number): void {
    this.setWindow(panned(this.window.peek(), by, this.end()));
  }

  setSpan(span: number): void {
    const window = this.window.peek();
    const about = this.cursor() ?? this.range().to - window.span / 2;
    this.setWindow(window.follows ? { ...window, span } : around(window, about, span));
  }

  show(range: Range): void {
    this.setWindow(showing(range));
  }

  /** All that there is. */
  showAll(): void {
    const { from, to } = this.material.peek().extent();
    const room = Math.max((to - from) * 0.02, 1e-4);
    this.show({ from: from - room, to: to + room });
  }

  /** Puts the cursor to @param t, which is brought into the window. */
  goTo(t: number): void {
    const window = this.window.peek();
    let { from, to } = this.range();
    if (t < from || t > to || window.follows) {
      this.setWindow(t >= from && t <= to ? paused(window, true, this.end()) : around(window, t));
      ({ from, to } = this.range());
    }
    this.setCursor((within(t, { from, to }) - from) / (to - from));
  }

  setCursor(share: number | null): void {
    if (share === this.cursorShare.peek()) return;
    this.cursorShare.value = share;
    this.onChange();
    ++this.readings.value;
  }

  /** Moves the cursor by @param steps; at an edge a window that stands still goes with it. */
  step(steps: number): void {
    const share = (this.cursorShare.peek() ?? 0.5) + steps * kStep;
    const window = this.window.peek();
    if (!window.follows && (share < 0 || share > 1)) this.pan(window.span * (share < 0 ? share : share - 1));
    this.setCursor(Math.min(1, Math.max(0, share)));
  }

  /** Sets cursor A or B to where the cursor is, or takes it away if it is there. */
  setMark(which: "a" | "b", t = this.cursor()): void {
    if (t === null) t = (this.range().from + this.range().to) / 2;
    this[which].value = t;
    this.onChange();
    ++this.readings.value;
  }

  clearMarks(): void {
    this.a.value = null;
    this.b.value = null;
    this.onChange();
    ++this.readings.value;
  }

  select(selection: Selection | null): void {
    this.selection.value = selection;
    this.onChange();
  }

  /** Shows other data: @param window of them. */
  open(material: Material): void {
    this.material.value = material;
    this.selection.value = null;
    if (material.isLive) this.setWindow({ follows: true, span: 10, to: 0 });
    else this.showAll();
  }
}
