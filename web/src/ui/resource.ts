import { useEffect, useState } from "preact/hooks";

import { wordsOf } from "../source/refusal";
import { poll } from "../model/poll";

/** Something that was asked for: what came last, and why nothing comes now. */
export interface Resource<T> {
  value?: T;
  error: string;
  again: () => void;
}

/** Asks by @param ask whenever @param keys change, and every @param period ms if that is given; the last answer stays. */
export function useResource<T>(ask: () => Promise<T>, keys: readonly unknown[], period?: number): Resource<T> {
  const [value, setValue] = useState<T | undefined>(undefined);
  const [error, setError] = useState("");
  const [turn, setTurn] = useState(0);
  useEffect(() => {
    let isOver = false;
    const look = async (): Promise<void> => {
      try {
        const answer = await ask();
        if (isOver) return;
        setValue(() => answer);
        setError("");
      } catch (why) {
        if (!isOver) setError(wordsOf(why));
      }
    };
    const stop = period === undefined ? () => undefined : poll(look, period);
    if (period === undefined) void look();
    return () => {
      isOver = true;
      stop();
    };
  }, [...keys, turn, period]);
  const again = (): void => setTurn((before) => before + 1);
  return value === undefined ? { error, again } : { value, error, again };
}
