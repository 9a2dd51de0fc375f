import type { ComponentChildren } from "preact";

/** What has to be said at a place; an error is announced at once. */
export function Notice(props: { kind?: "error" | "warning" | "info"; children: ComponentChildren }) {
  const kind = props.kind ?? "info";
  return (
    <p class={`notice notice-${kind}`} role={kind === "error" ? "alert" : "status"}>
      {props.children}
    </p>
  );
}
