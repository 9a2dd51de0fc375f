import { useEffect, useState } from "preact/hooks";

import type { AxisOverview } from "../source/types";

/** The axis that is looked at: that of the address (@param asked, 0: none), else the first; and how to choose another. */
export function useAxis(axes: readonly AxisOverview[], asked: number): [number, (axis: number) => void] {
  const [chosen, setChosen] = useState(asked);
  useEffect(() => setChosen(asked), [asked]);
  const axis = axes.find((each) => each.axis === chosen)?.axis ?? axes[0]?.axis ?? (chosen > 0 ? chosen : 1);
  return [axis, setChosen];
}

/** Chooses one of the axes of a unit. */
export function AxisChoice(props: { axes: readonly AxisOverview[]; axis: number; onChange: (axis: number) => void }) {
  return (
    <label class="field">
      Axis
      <select value={props.axis} onChange={(event) => props.onChange(Number(event.currentTarget.value))}>
        {props.axes.map((axis) => (
          <option key={axis.axis} value={axis.axis}>
            {axis.axis} {axis.name}
          </option>
        ))}
      </select>
    </label>
  );
}
