import type { Material } from "../data/material";
import { clustersOf } from "../view/event_marks";
import { rowAt, type Row } from "../view/layout";
import type { ScopeModel, Selection } from "../view/scope_model";
import { kMarkDistance } from "./marks";
import type { Picture } from "./picture";
import { xOf, type TimeField } from "./time_field";

/** How far a click may be beside what it means (CSS pixels). */
const kNear = 9;

/** What is at @param x in @param row; null: nothing that can be clicked. */
export function hit(material: Material, row: Row, field: TimeField, x: number): Selection | null {
  const t = field.from + ((x - field.left) / field.width) * (field.to - field.from);
  if (row.kind === "frames" && row.lane !== undefined) {
    const within = (kNear / field.width) * (field.to - field.from);
    const serial = material.frames.nearest(t, row.lane, within);
    return serial === undefined ? null : { kind: "frame", serial };
  }
  if (row.kind === "marks") {
    const events = material.events().filter((event) => event.t >= field.from && event.t <= field.to);
    const clusters = clustersOf(events, (at) => xOf(field, at), kMarkDistance);
    const near = clusters.filter((cluster) => Math.abs(cluster.x - x) <= kNear + 4);
    const best = near.toSorted((one, two) => Math.abs(one.x - x) - Math.abs(two.x - x))[0];
    return best === undefined ? null : { kind: "event", event: best.event };
  }
  const bands = row.kind === "nmt" ? material.timeline().nmt : (row.place === undefined ? undefined : material.timeline().axes.get(row.place)) ?? [];
  const slack = (4 / field.width) * (field.to - field.from);
  const band = bands.findLast(({ from, to }) => from <= t + slack && to >= t);
  return band?.event === undefined ? null : { kind: "event", event: band.event };
}

/** Selects what was clicked at (@param x, @param y) of the lower picture. Whether there was anything. */
export function selectAt(model: ScopeModel, picture: Picture, x: number, y: number): boolean {
  const row = rowAt(picture.lower.rows, y);
  if (row === undefined) return false;
  const found = hit(model.material.peek(), row, picture.field(), x);
  if (found !== null) model.select(found);
  return found !== null;
}

/** Selects what is nearest to the cursor: an event, else a state that begins there, else a frame. */
export function selectAtCursor(model: ScopeModel, picture: Picture | null): void {
  const cursor = model.cursor();
  if (picture === null || cursor === null) return;
  const field = picture.field();
  const order = ["marks", "axis", "nmt", "frames"];
  const rows = picture.lower.rows.toSorted((one, two) => order.indexOf(one.kind) - order.indexOf(two.kind));
  for (const row of rows) {
    const found = hit(model.material.peek(), row, field, xOf(field, cursor));
    if (found === null) continue;
    const isHere = found.kind === "frame" || Math.abs(xOf(field, found.event.t) - xOf(field, cursor)) <= kNear;
    if (!isHere) continue;
    model.select(found);
    return;
  }
}
