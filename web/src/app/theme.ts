import { effect, signal } from "@preact/signals";

export type Theme = "system" | "light" | "dark";
const kThemes: readonly Theme[] = ["system", "light", "dark"];
const kKey = "axisd-theme";

function stored(): Theme {
  const value = localStorage.getItem(kKey) as Theme | null;
  return value !== null && kThemes.includes(value) ? value : "system";
}

/** Light, dark, or as the system has it. */
export const theme = signal<Theme>(stored());

effect(() => {
  if (theme.value === "system") delete document.documentElement.dataset["theme"];
  else document.documentElement.dataset["theme"] = theme.value;
  localStorage.setItem(kKey, theme.value);
});

/** The next one of the three. */
export function nextTheme(): void {
  theme.value = kThemes[(kThemes.indexOf(theme.value) + 1) % kThemes.length] ?? "system";
}
