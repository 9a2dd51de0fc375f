import { useRef, useState } from "preact/hooks";

/** Time after the last letter until is searched (ms). */
const kPause = 250;

/** A search field that tells its text when nothing more is typed; Enter at once. */
export function SearchField(props: { label: string; hint: string; text: string; onText: (text: string) => void }) {
  const [typed, setTyped] = useState<string | null>(null);
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const tell = (text: string): void => {
    clearTimeout(timer.current);
    props.onText(text);
    setTyped(null);
  };
  const type = (text: string): void => {
    clearTimeout(timer.current);
    setTyped(text);
    timer.current = setTimeout(() => tell(text), kPause);
  };
  return (
    <label class="field search-field">
      {props.label}
      <input
        type="search"
        value={typed ?? props.text}
        placeholder={props.hint}
        autocomplete="off"
        spellcheck={false}
        onInput={(event) => type(event.currentTarget.value)}
        onKeyDown={(event) => event.key === "Enter" && tell(event.currentTarget.value)}
      />
    </label>
  );
}
