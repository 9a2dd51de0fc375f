import type { ScopeState } from "../data/scope_state";
import { selectAtCursor } from "../draw/hits";
import type { Picture } from "../draw/picture";

type Action = (state: ScopeState, picture: Picture | null) => void;

/** Steps of a key with Shift. */
const kFar = 10;

/** A row a key of the picture. */
const kActions: Record<string, (isFar: boolean) => Action> = {
  ArrowLeft: (isFar) => ({ model }) => model.step(isFar ? -kFar : -1),
  ArrowRight: (isFar) => ({ model }) => model.step(isFar ? kFar : 1),
  Home: () => ({ model }) => model.setCursor(0),
  End: () => ({ model }) => model.setCursor(1),
  PageUp: () => ({ model }) => model.pan(-model.window.peek().span / 2),
  PageDown: () => ({ model }) => model.pan(model.window.peek().span / 2),
  "+": () => ({ model }) => model.zoom(1 / 1.5),
  "=": () => ({ model }) => model.zoom(1 / 1.5),
  "-": () => ({ model }) => model.zoom(1.5),
  " ": () => ({ model }) => model.pause(model.window.peek().follows),
  a: () => ({ model }) => model.setMark("a"),
  b: () => ({ model }) => model.setMark("b"),
  Enter: () => (state, picture) => selectAtCursor(state.model, picture),
  Escape: () => ({ model }) => model.setCursor(null),
};

/** What @param key does; undefined: nothing. */
export function keyAction(key: string, isFar: boolean): Action | undefined {
  return (kActions[key] ?? kActions[key.toLowerCase()])?.(isFar);
}
