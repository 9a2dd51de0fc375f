/** Colours of the pictures, as the style has them. */
export interface Palette {
  back: string;
  line: string;
  text: string;
  muted: string;
  accent: string;
  curves: string[];
  tones: Record<string, { text: string; soft: string }>;
}

const kTones = ["off", "ready", "on", "run", "brake", "fault"] as const;

/** Fonts of the pictures. */
export const kFont = '12px system-ui, "Noto Sans", "DejaVu Sans", sans-serif';
export const kSmallFont = '11px system-ui, "Noto Sans", "DejaVu Sans", sans-serif';

/** The colours of the light theme, whichever is shown. */
export function lightPalette(): Palette {
  const { dataset } = document.documentElement;
  const before = dataset["theme"];
  dataset["theme"] = "light";
  const palette = paletteOf();
  if (before === undefined) delete dataset["theme"];
  else dataset["theme"] = before;
  return palette;
}

/** The colours in the present theme. */
export function paletteOf(): Palette {
  const probe = document.createElement("span");
  document.body.append(probe);
  const colour = (name: string): string => {
    probe.style.color = `var(--${name})`;
    return getComputedStyle(probe).color;
  };
  const palette: Palette = {
    back: colour("surface"),
    line: colour("line"),
    text: colour("text"),
    muted: colour("muted"),
    accent: colour("accent"),
    curves: Array.from({ length: 8 }, (_, i) => colour(`curve-${i + 1}`)),
    tones: Object.fromEntries(kTones.map((tone) => [tone, { text: colour(tone), soft: colour(`${tone}-soft`) }])),
  };
  probe.remove();
  return palette;
}

/** Dashes by which the curves of a lane differ for who does not see their colours. */
export const kDashes: readonly number[][] = [[], [8, 3], [3, 3], [10, 3, 3, 3]];
