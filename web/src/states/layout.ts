import type { DriveState } from "../source/types";

/** A point of the picture. */
export interface Point {
  x: number;
  y: number;
}

/** Where the states are, and how large their boxes are. */
export interface Layout {
  width: number;
  height: number;
  box: { width: number; height: number };
  /** How far an edge bows aside; both directions between two states so lie apart. */
  bow: number;
  places: Record<DriveState, Point>;
  /** Edges that go round at a side, by "from>to": which one, and how far out. */
  detours: Record<string, { side: "left" | "right"; reach: number }>;
}

/** How far along its curve the number of an edge stands, where not in the middle. */
const kLabelShares: Record<string, number> = {
  "STOP2>Switch on disabled": 0.28,
  "Operation enabled>Fault": 0.78,
  "Operation enabled>Quick stop active": 0.66,
  "Quick stop active>Switch on disabled": 0.4,
};

/** The point of a quadratic curve at @param share of it. */
function pointAt(share: number, start: Point, control: Point, end: Point): Point {
  const [a, b, c] = [(1 - share) ** 2, 2 * share * (1 - share), share ** 2];
  return { x: a * start.x + b * control.x + c * end.x, y: a * start.y + b * control.y + c * end.y };
}

/** States without pulses on the left, as in CiA 402; those that brake in the middle; faults on the right. */
export const kWide: Layout = {
  width: 960,
  height: 620,
  box: { width: 176, height: 44 },
  bow: 20,
  places: {
    "Not ready to switch on": { x: 200, y: 40 },
    "Switch on disabled": { x: 200, y: 160 },
    "Ready to switch on": { x: 200, y: 285 },
    "Switched on": { x: 200, y: 410 },
    "Operation enabled": { x: 200, y: 570 },
    "Quick stop active": { x: 500, y: 290 },
    "OFF1 braking": { x: 500, y: 485 },
    Fault: { x: 800, y: 160 },
    STOP2: { x: 800, y: 420 },
    "Fault reaction active": { x: 800, y: 570 },
  },
  detours: {
    "Operation enabled>Switch on disabled": { side: "left", reach: 130 },
    "Switched on>Switch on disabled": { side: "left", reach: 80 },
    "Fault reaction active>Fault": { side: "right", reach: 80 },
  },
};

/** The same for a phone. */
export const kNarrow: Layout = {
  width: 540,
  height: 700,
  box: { width: 134, height: 50 },
  bow: 14,
  places: {
    "Not ready to switch on": { x: 112, y: 40 },
    "Switch on disabled": { x: 112, y: 170 },
    "Ready to switch on": { x: 112, y: 310 },
    "Switched on": { x: 112, y: 450 },
    "Operation enabled": { x: 112, y: 640 },
    "Quick stop active": { x: 282, y: 330 },
    "OFF1 braking": { x: 282, y: 560 },
    Fault: { x: 430, y: 170 },
    STOP2: { x: 430, y: 480 },
    "Fault reaction active": { x: 430, y: 640 },
  },
  detours: {
    "Operation enabled>Switch on disabled": { side: "left", reach: 44 },
    "Switched on>Switch on disabled": { side: "left", reach: 26 },
    "Fault reaction active>Fault": { side: "right", reach: 34 },
  },
};

/** The machine of CiA 402 alone: Quick stop active has the middle for itself, and two edges lead past the state between. */
export const kWideCia402: Layout = {
  ...kWide,
  places: { ...kWide.places, "Quick stop active": { x: 500, y: 390 } },
  detours: {
    "Operation enabled>Switch on disabled": { side: "left", reach: 130 },
    "Switched on>Switch on disabled": { side: "left", reach: 80 },
    "Ready to switch on>Operation enabled": { side: "left", reach: 45 },
    "Operation enabled>Ready to switch on": { side: "right", reach: 60 },
  },
};

/** The same for a phone. */
export const kNarrowCia402: Layout = {
  ...kNarrow,
  places: { ...kNarrow.places, "Quick stop active": { x: 286, y: 400 } },
  detours: {
    "Operation enabled>Switch on disabled": { side: "left", reach: 44 },
    "Switched on>Switch on disabled": { side: "left", reach: 32 },
    "Ready to switch on>Operation enabled": { side: "left", reach: 18 },
    "Operation enabled>Ready to switch on": { side: "right", reach: 24 },
  },
};

/** The drawing for a machine with @param states; only that of the drive unit knows OFF1. */
export function layoutOf(states: readonly DriveState[], isNarrow: boolean): Layout {
  if (states.includes("OFF1 braking")) return isNarrow ? kNarrow : kWide;
  return isNarrow ? kNarrowCia402 : kWideCia402;
}

/** An edge as it is drawn. */
export interface Curve {
  /** Of an SVG path. */
  path: string;
  /** Where its number stands. */
  label: Point;
}

/** Where the ray from the middle of a box to @param to leaves the box. */
export function borderPoint(box: Layout["box"], middle: Point, to: Point): Point {
  const dx = to.x - middle.x;
  const dy = to.y - middle.y;
  const share = Math.min(
    dx === 0 ? Infinity : box.width / 2 / Math.abs(dx),
    dy === 0 ? Infinity : box.height / 2 / Math.abs(dy),
  );
  return { x: middle.x + dx * share, y: middle.y + dy * share };
}

function written(...points: Point[]): string {
  return points.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join(" ");
}

function detour(layout: Layout, from: Point, to: Point, { side, reach }: { side: "left" | "right"; reach: number }): Curve {
  const out = side === "left" ? -1 : 1;
  const start = { x: from.x + (out * layout.box.width) / 2, y: from.y };
  const end = { x: to.x + (out * layout.box.width) / 2, y: to.y + reach / 10 };
  const first = { x: start.x + out * reach, y: start.y };
  const second = { x: start.x + out * reach, y: end.y };
  return {
    path: `M ${written(start)} C ${written(first, second, end)}`,
    label: { x: start.x + out * reach * 0.75, y: (start.y + end.y) / 2 },
  };
}

function bow(layout: Layout, from: Point, to: Point, labelShare: number): Curve {
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  const aside = { x: (-(to.y - from.y) / length) * layout.bow, y: ((to.x - from.x) / length) * layout.bow };
  const control = { x: (from.x + to.x) / 2 + aside.x * 2, y: (from.y + to.y) / 2 + aside.y * 2 };
  const nearStart = { x: from.x + aside.x, y: from.y + aside.y };
  const nearEnd = { x: to.x + aside.x, y: to.y + aside.y };
  const start = borderPoint(layout.box, from, { x: nearStart.x + (control.x - nearStart.x) / 2, y: nearStart.y + (control.y - nearStart.y) / 2 });
  const end = borderPoint(layout.box, to, { x: nearEnd.x + (control.x - nearEnd.x) / 2, y: nearEnd.y + (control.y - nearEnd.y) / 2 });
  return { path: `M ${written(start)} Q ${written(control, end)}`, label: pointAt(labelShare, start, control, end) };
}

/** The curve from one state to another. */
export function curveOf(layout: Layout, from: DriveState, to: DriveState): Curve {
  const key = `${from}>${to}`;
  const around = layout.detours[key];
  const [start, end] = [layout.places[from], layout.places[to]];
  return around === undefined ? bow(layout, start, end, kLabelShares[key] ?? 0.5) : detour(layout, start, end, around);
}
