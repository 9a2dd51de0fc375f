/** Moves the focus from row to row of a table with the arrow keys, Home and End; each row has one link of class row-link. */
export function moveInRows(event: KeyboardEvent & { currentTarget: HTMLElement }): void {
  const links = [...event.currentTarget.querySelectorAll<HTMLElement>(".row-link")];
  const at = links.findIndex((link) => link === document.activeElement);
  if (at < 0) return;
  const steps: Record<string, number> = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: links.length - 1 };
  const to = steps[event.key];
  if (to === undefined) return;
  event.preventDefault();
  links[to]?.focus();
}

/** The data-name of the rows in @param box that can be seen, @param most at most. */
export function visibleNames(box: HTMLElement, most: number): string[] {
  const seen = box.getBoundingClientRect();
  const bottom = Math.min(seen.bottom, innerHeight);
  const names: string[] = [];
  for (const row of box.querySelectorAll<HTMLElement>("tr[data-name]")) {
    const { top, bottom: end } = row.getBoundingClientRect();
    if (end > seen.top && top < bottom) names.push(row.dataset["name"] ?? "");
    if (names.length === most) break;
  }
  return names;
}
