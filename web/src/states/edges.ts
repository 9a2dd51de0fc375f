import type { DriveState, StateMachine, UnitEvent } from "../source/types";

/** A transition of the state machine, with what it needs. */
export type Transition = StateMachine["transitions"][number];

/** All transitions from one state to another: one line of the picture. */
export interface Edge {
  /** "from>to". */
  key: string;
  from: DriveState;
  to: DriveState;
  transitions: Transition[];
  /** One of them is open. */
  isOpen: boolean;
  /** Numbers of CiA 402: "2", "12, 13"; empty: none has one. */
  numbers: string;
}

/** The transitions of @param machine as edges. */
export function edgesOf(machine: StateMachine): Edge[] {
  const groups = new Map<string, Transition[]>();
  for (const transition of machine.transitions) {
    const key = `${transition.from}>${transition.to}`;
    groups.set(key, [...(groups.get(key) ?? []), transition]);
  }
  return [...groups].flatMap(([key, transitions]) => {
    const first = transitions[0];
    if (first === undefined) return [];
    const numbers = new Set(transitions.flatMap(({ number }) => (number === undefined ? [] : [number])));
    const isOpen = transitions.some((transition) => transition.is_open);
    return [{ key, from: first.from, to: first.to, transitions, isOpen, numbers: [...numbers].join(", ") }];
  });
}

/** A transition in words: "2: Switch on disabled → Ready to switch on". */
export function edgeWords(edge: Edge): string {
  return `${edge.numbers === "" ? "" : `${edge.numbers}: `}${edge.from} → ${edge.to}`;
}

/** How far a transition is from being taken. */
export function opennessWords(transition: Transition, state: string): string {
  if (transition.is_open) return "open";
  const missing = transition.conditions.filter((condition) => !condition.met).length;
  if (missing === 0) return transition.from === state ? "all conditions are met" : "starts from another state";
  return missing === 1 ? "1 condition is missing" : `${missing} conditions are missing`;
}

/** A state that the axis has come to. */
export interface Visit {
  t: number;
  before: string;
  state: string;
  /** How long it stayed (s); undefined: it is there still. */
  stayed: number | undefined;
}

/** The last @param most states of an axis, the newest first. */
export function visitsOf(events: readonly UnitEvent[], unit: string, axis: number, most: number): Visit[] {
  const own = events.filter((event) => event.kind === "drive-state" && event.axis === axis && (event.unit ?? unit) === unit);
  const visits = own.map((event, index) => {
    const next = own[index + 1];
    const stayed = next === undefined || next.t < event.t ? undefined : next.t - event.t;
    return { t: event.t, before: String(event.before ?? "?"), state: event.state ?? "?", stayed };
  });
  return visits.slice(-most).reverse();
}
