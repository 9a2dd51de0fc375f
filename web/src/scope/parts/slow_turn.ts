import { useEffect, useState } from "preact/hooks";

import type { ScopeState } from "../data/scope_state";
import type { ScopeModel } from "../view/scope_model";

/** Time between two looks while the picture moves (ms). */
const kPeriod = 500;

/** Counts up twice a second while readings change, for what need not follow each picture. */
export function useSlowTurn(state: ScopeState): number {
  const [turn, setTurn] = useState(0);
  useEffect(() => {
    let isDue = false;
    const unsubscribe = state.model.readings.subscribe(() => {
      isDue = true;
    });
    const timer = setInterval(() => {
      if (isDue) setTurn((before) => before + 1);
      isDue = false;
    }, kPeriod);
    return () => {
      clearInterval(timer);
      unsubscribe();
    };
  }, [state]);
  return turn;
}

/** Lets who calls it look again whenever values beside the picture are to be read. */
export function watchReadings(model: ScopeModel): number {
  return model.readings.value;
}
