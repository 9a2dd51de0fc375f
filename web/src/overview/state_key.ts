import type { AxisOverview, UnitOverview } from "../source/types";

function axisKey(axis: AxisOverview): string {
  const numbers = [...axis.faults, ...axis.alarms].map((message) => message.number).join("+");
  const turns = Math.abs(axis.speed_rpm) > 1 ? "turns" : "stands";
  return [axis.state, axis.mode, axis.homed, numbers, turns, axis.setpoint_rpm === 0 ? "zero" : "setpoint"].join(",");
}

/** What the reasons why @param unit does not turn depend on: they are asked for anew when this changes. */
export function stateKey(unit: UnitOverview): string {
  const own = [...(unit.control_unit?.faults ?? []), ...(unit.control_unit?.alarms ?? [])].map((message) => message.number);
  return [unit.on, unit.nmt_state, unit.bus?.state, unit.bus?.link, own.join("+"), ...(unit.axes ?? []).map(axisKey)].join(";");
}
