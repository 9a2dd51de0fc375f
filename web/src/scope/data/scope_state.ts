import { effect, signal } from "@preact/signals";

import type { Page } from "../../app/context";
import { wordsOf } from "../../source/refusal";
import type { UnitEvent } from "../../source/types";
import { readLink, writeLink, type ScopeLink } from "../view/link";
import { ScopeModel } from "../view/scope_model";
import type { LiveMaterial } from "./live_material";
import { leave, listenTo } from "./live_units";
import type { Material } from "./material";
import { bufferedFault } from "./buffered_fault";
import { findFault, materialOf, openMaterial, stepMarks } from "./recordings";
import { emptyMaterial } from "./recorded_material";
import { SignalHeads, usualSignals, type FoundSignal } from "./signal_heads";
import { openFile } from "../../recording/open_file";
import { readResult } from "./trace_result";

/** How long a fault that is wanted is waited for (ms): events of before come with the first answers. */
const kPatience = 2500;

/** What the scope of a unit works with, from its opening until it is left. */
export class ScopeState {
  readonly model: ScopeModel;
  readonly live: LiveMaterial | undefined;
  readonly heads: SignalHeads;
  /** Names of the live signals. */
  readonly names = signal<readonly string[]>([]);
  readonly found = signal<readonly FoundSignal[]>([]);
  readonly periodMs = signal(4);
  /** What could not be done at last; empty: all could. */
  readonly problem = signal("");
  /** What a screen reader is told. */
  readonly told = signal("");
  /** A fault that is wanted and has not been found yet. */
  private query: URLSearchParams | undefined;
  private wanted: ScopeLink["fault"];
  private opened: Pick<ScopeLink, "result" | "recording"> = {};
  private readonly ends: (() => void)[] = [];

  constructor(
    readonly page: Page,
    readonly unit: string,
  ) {
    const { source } = page;
    if (source.isLive && unit !== "") this.live = listenTo(unit, source);
    this.heads = new SignalHeads(source, unit);
    this.model = new ScopeModel(this.live ?? emptyMaterial());
    if (this.live !== undefined) this.follow(this.live);
  }

  /** Goes to what @param query says; what it does not say is as usual. */
  async begin(query: URLSearchParams): Promise<void> {
    const { link, wrong } = readLink(query);
    this.query = query;
    this.problem.value = wrong.length === 0 ? "" : `The address says what the scope does not know: ${wrong.join(", ")}.`;
    try {
      if (this.live !== undefined) {
        this.periodMs.value = link.periodMs ?? this.periodMs.peek();
        const before = this.live.samples.signals.map((head) => head.signal);
        const usual = before.length > 0 ? before : await usualSignals(this.page.source, this.unit);
        await this.choose(link.signals ?? usual);
      }
      await this.openLinked(link);
    } catch (error) {
      this.problem.value = wordsOf(error);
    }
    if (this.query === query) this.look(link);
  }

  /** Shows the live signals called @param names. */
  async choose(names: readonly string[]): Promise<void> {
    this.names.value = names;
    this.found.value = this.heads.present(names);
    const found = await this.heads.find(names);
    if (this.names.peek() !== names) return;
    this.found.value = found;
    this.apply();
  }

  setPeriod(periodMs: number): void {
    this.periodMs.value = periodMs;
    this.apply();
  }

  /** Shows @param material, and the unit again without it. */
  open(material: Material | undefined, opened: Pick<ScopeLink, "result" | "recording"> = {}): void {
    this.opened = opened;
    const shown = material ?? this.live ?? emptyMaterial();
    this.model.open(shown);
    this.told.value = shown.isLive ? "live again" : `${shown.name} is shown`;
  }

  /** Opens a file that the user has. */
  async openFile(file: File): Promise<void> {
    try {
      const bytes = new Uint8Array(await file.arrayBuffer());
      this.open(await openMaterial(this.page.source, file.name, bytes, this.unit));
      this.problem.value = "";
    } catch (error) {
      this.problem.value = `${file.name} cannot be shown: ${wordsOf(error)}`;
    }
  }

  /** Opens the recording of the session called @param name. */
  async openRecording(name: string): Promise<void> {
    const { source } = this.page;
    const file = source.recordings.find((each) => each.name === name && (each.unit === this.unit || this.unit === ""));
    if (file === undefined) throw new Error(`the session has no recording called ${name} of this unit`);
    const recording = { ...openFile(file.name, file.bytes), unit: file.unit };
    const steps = stepMarks(source.verdict?.report, recording.from);
    this.open(await materialOf(source, recording, file.unit, steps), { recording: name });
  }

  /** Opens a result of the unit's trace. */
  async openResult(result: number): Promise<void> {
    this.told.value = `reading result ${result} of the trace`;
    const recording = await readResult(this.page.source, this.unit, result);
    this.open(await materialOf(this.page.source, recording, this.unit), { result });
  }

  /** The words of an address that shows the same. */
  address(): URLSearchParams {
    const { window, a, b } = this.model;
    const { follows, span, to } = window.value;
    const link: ScopeLink = { ...this.opened, span };
    if (this.live !== undefined) Object.assign(link, { signals: [...this.names.value], periodMs: this.periodMs.value });
    if (!follows) Object.assign(link, { to, isPaused: true });
    if (a.value !== null) link.a = a.value;
    if (b.value !== null) link.b = b.value;
    return writeLink(link);
  }

  end(): void {
    this.ends.forEach((end) => end());
    if (this.live !== undefined) leave(this.live);
  }

  private apply(): void {
    const good = this.found.peek().filter(({ problem }) => problem === "").map(({ head }) => head);
    this.live?.choose(good, this.periodMs.peek());
    this.model.onChange();
    ++this.model.readings.value;
  }

  private async openLinked(link: ScopeLink): Promise<void> {
    if (this.live !== undefined) {
      if (link.result !== undefined) return this.openResult(link.result);
      if (!this.model.material.peek().isLive) this.open(undefined);
      return undefined;
    }
    const own = this.page.source.recordings.filter((each) => each.unit === this.unit || this.unit === "");
    const names = link.recording === undefined ? own.map(({ name }) => name).reverse() : [link.recording];
    for (const name of names) {
      await this.openRecording(name);
      if (link.fault === undefined || this.findWanted(link.fault) !== undefined) return undefined;
    }
    return undefined;
  }

  private findWanted({ place, number }: Required<ScopeLink>["fault"]): UnitEvent | undefined {
    return findFault(this.model.material.peek().events(), place, number);
  }

  private look(link: ScopeLink): void {
    const { model } = this;
    const isStill = link.to !== undefined && (link.isPaused === true || !model.material.peek().isLive);
    if (isStill) model.setWindow({ follows: false, span: link.span ?? 10, to: link.to ?? 0 });
    else if (link.span !== undefined && model.window.peek().follows) model.setSpan(link.span);
    model.a.value = link.a ?? null;
    model.b.value = link.b ?? null;
    this.wanted = link.fault;
    this.seek();
    if (this.wanted !== undefined) setTimeout(() => void this.showBuffered(), kPatience);
    model.onChange();
  }

  /** Shows the fault that is wanted, as soon as it is known. */
  private seek(): void {
    if (this.wanted === undefined) return;
    const event = this.findWanted(this.wanted);
    if (event === undefined) return;
    this.wanted = undefined;
    this.showEvent(event);
  }

  /** Of a fault that came before anything was heard of the unit there is what its fault buffer says. */
  private async showBuffered(): Promise<void> {
    if (this.wanted === undefined) return;
    const { place, number } = this.wanted;
    this.wanted = undefined;
    try {
      this.showEvent(await bufferedFault(this.page.source, this.unit, place, number));
      this.problem.value = "It came before this page began to listen: what led to it is not known here.";
    } catch (error) {
      this.problem.value = wordsOf(error);
    }
  }

  /** Chooses @param event, in the middle of a window in which its surroundings are seen. */
  private showEvent(event: UnitEvent): void {
    this.model.show({ from: event.t - 1, to: event.t + 1 });
    this.model.setCursor(0.5);
    this.model.select({ kind: "event", event });
  }

  private follow(live: LiveMaterial): void {
    const { units, events } = this.page;
    this.ends.push(
      effect(() => {
        live.take(events.all.value);
        this.seek();
        this.model.onChange();
      }),
      effect(() => {
        const unit = units.all.value.find((each) => each.unit === this.unit);
        const axes = unit?.axes?.map(({ axis, state }) => ({ axis, state }));
        live.takeStates({ nmt: unit?.nmt_state, axes }, unit?.uptime_s);
      }),
    );
  }
}
