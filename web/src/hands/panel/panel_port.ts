import type { Source } from "../../source/source";
import type { PanelPort } from "./panel_link";

/** The panel of an axis, by the gateway. */
export function panelPort(source: Source, unit: string, axis: number): PanelPort {
  const path = `axes/${axis}/panel`;
  return {
    take: (timeoutMs) => source.act("POST", unit, path, { timeout_ms: timeoutMs }),
    set: (on, speedRpm) => source.act("PUT", unit, path, { on, speed_rpm: speedRpm }),
    release: () => source.act("DELETE", unit, path),
  };
}
