import type { Material } from "../data/material";
import type { ScopeModel } from "../view/scope_model";
import { differenceText, instantText } from "../view/scale";
import { drawn } from "./counters";
import { LowerPicture } from "./lower_picture";
import { paletteOf, type Palette } from "./palette";
import { kRight, Plot } from "./plot";
import { drawRuler, kMarksHeight, kRulerHeight, rulerTicks } from "./ruler";
import { cleared, xOf, type TimeField } from "./time_field";

/** The elements that are drawn on. */
export interface Places {
  stage: HTMLElement;
  ruler: HTMLCanvasElement;
  plots: HTMLElement;
  lower: HTMLCanvasElement;
  cursor: HTMLElement;
  a: HTMLElement;
  b: HTMLElement;
}

/** Height of all curves, at least and at most, and what stays free below (CSS pixels). */
const kLeastPlot = 150;
const kMostPlot = 900;
const kBelow = 14;
/** Shortest time between two pictures (ms). */
const kShortest = 30;
/** Time between two looks of what stands beside the picture (ms). */
const kReadings = 120;
/** Part of a pixel by which a picture that follows has to have moved. */
const kMotion = 0.25;

/** Draws what the model says, when something has changed, in the time of the screen. */
export class Picture {
  readonly lower = new LowerPicture();
  private readonly plot: Plot;
  private palette: Palette = paletteOf();
  private width = 0;
  private plotHeight = 200;
  private lowerHeight = 0;
  private isWanted = true;
  private built: unknown[] = [];
  private last = { at: 0, read: 0, to: NaN, version: -1, material: undefined as Material | undefined, decoder: undefined as unknown };
  private request = 0;

  constructor(
    private readonly model: ScopeModel,
    private readonly places: Places,
  ) {
    this.plot = new Plot(places.plots);
    this.request = requestAnimationFrame((at) => this.turn(at));
  }

  end(): void {
    cancelAnimationFrame(this.request);
    this.plot.end();
  }

  /** Draws at the next opportunity. */
  want(): void {
    this.isWanted = true;
  }

  /** Takes the size of the stage; the curves get the height that the window leaves. */
  measure(): void {
    const { stage } = this.places;
    this.width = stage.clientWidth;
    const top = stage.getBoundingClientRect().top + scrollY;
    const others = this.rulerHeight() + this.lowerHeight + kBelow;
    const room = innerHeight - Math.min(top, innerHeight / 3) - others;
    this.plotHeight = Math.round(Math.max(kLeastPlot, Math.min(room, kMostPlot)));
    this.want();
  }

  /** The theme has changed. */
  recolour(): void {
    this.palette = paletteOf();
    this.built = [];
    this.want();
  }

  /** Where the time lies at present. */
  field(): TimeField {
    const left = this.width < 600 ? 66 : 96;
    return { left, width: Math.max(50, this.width - left - kRight), ...this.model.range() };
  }

  private rulerHeight(): number {
    return kRulerHeight + (this.model.material.peek().marks.length > 0 ? kMarksHeight : 0);
  }

  private turn(at: number): void {
    this.request = requestAnimationFrame((next) => this.turn(next));
    if (this.width === 0 || at - this.last.at < kShortest) return;
    const material = this.model.material.peek();
    const field = this.field();
    if (!this.isWanted && !this.hasMoved(material, field)) return;
    this.isWanted = false;
    const begin = performance.now();
    this.draw(material, field);
    drawn(performance.now() - begin, material);
    this.last = { ...this.last, at, to: field.to, version: material.version, material, decoder: material.decoder };
    if (at - this.last.read > kReadings) {
      this.last.read = at;
      ++this.model.readings.value;
    }
  }

  private hasMoved(material: Material, field: TimeField): boolean {
    if (material !== this.last.material) return true;
    const step = ((field.to - field.from) / field.width) * kMotion;
    if (Math.abs(field.to - this.last.to) >= step) return true;
    return material.version !== this.last.version && field.to >= material.extent().to - 2;
  }

  private draw(material: Material, field: TimeField): void {
    if (material !== this.last.material || material.decoder !== this.last.decoder) this.lower.forget();
    if (material !== this.last.material) this.measure();
    const ruler = cleared(this.places.ruler, this.width, this.rulerHeight());
    if (ruler !== null) drawRuler(ruler, field, material.marks, this.palette);
    this.drawCurves(material, field);
    const { bins, height } = this.lower.prepare(material, field);
    const lower = cleared(this.places.lower, this.width, height);
    if (height !== this.lowerHeight) {
      this.lowerHeight = height;
      this.measure();
    }
    if (lower !== null) this.lower.draw(lower, material, field, bins, this.model.selection.peek(), this.palette);
    this.placeLines(field);
  }

  private drawCurves(material: Material, field: TimeField): void {
    const { signals } = material.samples;
    const build = [signals, this.width, this.plotHeight, this.palette, field.left, devicePixelRatio];
    if (build.some((value, i) => value !== this.built[i])) {
      this.plot.build(signals, this.width, this.plotHeight, field.left, this.palette);
      this.built = build;
    }
    this.plot.ticks = rulerTicks(field);
    this.plot.draw(material.samples.window(field.from, field.to, Math.round(field.width)), field);
  }

  private placeLines(field: TimeField): void {
    const { a, b } = this.model;
    const step = (field.to - field.from) / field.width;
    const cursor = this.model.cursor();
    place(this.places.cursor, cursor, cursor === null ? "" : instantText(cursor, step), field);
    place(this.places.a, a.peek(), "A", field);
    const distance = a.peek() !== null && b.peek() !== null ? ` ${differenceText((b.peek() ?? 0) - (a.peek() ?? 0))}` : "";
    place(this.places.b, b.peek(), `B${distance}`, field);
  }
}

function place(line: HTMLElement, t: number | null, text: string, field: TimeField): void {
  const isShown = t !== null && t >= field.from && t <= field.to;
  line.style.display = isShown ? "block" : "none";
  if (!isShown) return;
  const x = xOf(field, t);
  line.style.transform = `translateX(${x.toFixed(1)}px)`;
  line.classList.toggle("scope-line-left", x > field.left + field.width - 110);
  const label = line.firstElementChild;
  if (label !== null && label.textContent !== text) label.textContent = text;
}
