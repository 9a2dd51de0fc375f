import { signal } from "@preact/signals";

import { Refusal, wordsOf } from "../../source/refusal";
import type { Panel } from "../../source/types";

/** How the panel of an axis is reached. */
export interface PanelPort {
  take: (timeoutMs: number) => Promise<Panel>;
  set: (on: boolean, speedRpm: number) => Promise<Panel>;
  release: () => Promise<Panel>;
}

/** What the panel commands. */
export interface PanelCommand {
  on: boolean;
  speedRpm: number;
}

/** Without a renewal for so long (ms) the unit stops the axis by itself. */
export const kTimeout = 500;
/** From one renewal to the next (ms). */
const kRenewal = 150;
/** From one look whether answers come to the next (ms). */
const kWatch = 100;

/** OFF1. */
export const kOff: PanelCommand = { on: false, speedRpm: 0 };

/**
 * Holds the master control of an axis: says what is commanded again and again, so that the unit stops the axis
 * by itself as soon as this page, or the way to it, is gone. After such a silence nothing is switched on again by itself.
 */
export class PanelLink {
  readonly isHeld = signal(false);
  readonly command = signal<PanelCommand>(kOff);
  readonly panel = signal<Panel | undefined>(undefined);
  /** Why the control is lost or answers are missing; empty: all is well. */
  readonly trouble = signal("");
  private timer: ReturnType<typeof setTimeout> | undefined;
  private watch: ReturnType<typeof setInterval> | undefined;
  private isSending = false;
  private isUrgent = false;
  private answeredAt = 0;

  constructor(private readonly port: PanelPort) {}

  /** Takes the control; rejected with the refusal. */
  async take(): Promise<void> {
    this.trouble.value = "";
    this.panel.value = await this.port.take(kTimeout);
    this.command.value = kOff;
    this.answeredAt = Date.now();
    this.isHeld.value = true;
    this.watch = setInterval(() => this.look(), kWatch);
    this.renewSoon();
  }

  /** Commands with the next renewal, which comes as soon as the last one was answered: for what moves, as a slider. */
  follow(command: PanelCommand): void {
    if (!this.isHeld.value) return;
    this.command.value = command;
    if (this.isSending) this.isUrgent = true;
    else void this.renew();
  }

  /** Commands at once, whatever is still under way, and from then on. Resolved with what the axis did then. */
  async order(command: PanelCommand): Promise<string> {
    if (!this.isHeld.value) throw new Refusal("not-held", "this page has not taken the master control");
    this.command.value = command;
    const problem = await this.send();
    if (problem !== "") throw new Refusal("panel", problem);
    return `the axis was in ${this.panel.value?.state ?? "?"}`;
  }

  /** Switches off (OFF1) at once, whatever is still under way. */
  stop(): Promise<string> {
    return this.order(kOff);
  }

  /** Gives the control back; the unit does so by itself if it does not hear of it. */
  async release(): Promise<void> {
    if (!this.isHeld.value) return;
    this.end();
    this.panel.value = await this.port.release();
  }

  private end(): void {
    this.isHeld.value = false;
    this.command.value = kOff;
    clearTimeout(this.timer);
    clearInterval(this.watch);
  }

  private renewSoon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.renew(), this.isUrgent ? 0 : kRenewal);
    this.isUrgent = false;
  }

  private async renew(): Promise<void> {
    clearTimeout(this.timer);
    this.isSending = true;
    await this.send();
    this.isSending = false;
    if (this.isHeld.value) this.renewSoon();
  }

  /** Says what is commanded; empty: it was taken. */
  private async send(): Promise<string> {
    const { on, speedRpm } = this.command.value;
    try {
      const panel = await this.port.set(on, speedRpm);
      if (!this.isHeld.value) return "";
      this.panel.value = panel;
      this.answeredAt = Date.now();
      if (!panel.active) return this.lose("The master control has gone back.");
      this.trouble.value = "";
    } catch (error) {
      if (!this.isHeld.value) return "";
      if (!(error instanceof Refusal && error.isAbsence)) return this.lose(`The master control is lost: ${wordsOf(error)}.`);
      this.trouble.value = `${wordsOf(error)}. The axis stops by itself.`;
    }
    return this.trouble.value;
  }

  private lose(why: string): string {
    this.end();
    this.trouble.value = why;
    return why;
  }

  private look(): void {
    const silence = Date.now() - this.answeredAt;
    if (silence < kTimeout) return;
    this.command.value = kOff;
    this.trouble.value = `No answer for ${(silence / 1000).toFixed(1)}\u2009s: the axis stops by itself (OFF1).`;
  }
}
