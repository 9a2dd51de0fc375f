/** Patterns of CiA 303-3 and the names of their classes. */
const kPatterns: Record<string, string> = {
  off: "off",
  on: "on",
  blinking: "blinking",
  flickering: "flickering",
  "single flash": "single",
  "double flash": "double",
  "triple flash": "triple",
};

/** An indicator of CiA 303-3, with its pattern in words. */
export function Led(props: { name: string; colour: "green" | "red"; pattern: string }) {
  const pattern = kPatterns[props.pattern] ?? "off";
  return (
    <span class="led">
      <span class={`led-lamp led-${props.colour} led-${pattern}`} aria-hidden="true" />
      {props.name} <span class="led-words">{props.pattern}</span>
    </span>
  );
}
