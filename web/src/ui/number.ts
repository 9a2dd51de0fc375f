/** @param value with so many digits that it is readable, and a unit behind a thin space; "–" without a value. */
export function shown(value: number | null | undefined, unit = "", digits = 4): string {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  const text = Number.isInteger(value) && Math.abs(value) < 1e9 ? String(value) : Number(value.toPrecision(digits)).toString();
  return unit === "" ? text : `${text}\u2009${unit}`;
}

/** A quantity with a fixed number of decimals, for values that change: nothing moves. */
export function fixed(value: number | null | undefined, decimals: number, unit = ""): string {
  if (value === null || value === undefined) return "–";
  const text = (Object.is(Math.round(value * 10 ** decimals), -0) ? 0 : value).toFixed(decimals);
  return unit === "" ? text : `${text}\u2009${unit}`;
}

/** A time since the start of the unit: 12.345 s, 3 min 12 s, 2 h 5 min. */
export function duration(seconds: number): string {
  if (seconds < 120) return `${seconds.toFixed(seconds < 10 ? 3 : 1)}\u2009s`;
  const minutes = Math.floor(seconds / 60);
  if (minutes < 120) return `${minutes}\u2009min ${Math.floor(seconds % 60)}\u2009s`;
  return `${Math.floor(minutes / 60)}\u2009h ${minutes % 60}\u2009min`;
}
