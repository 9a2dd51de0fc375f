import { useState } from "preact/hooks";

import { wordsOf } from "../../source/refusal";
import { download } from "../../ui/download";

/** A button that fetches a whole table and hands it out as CSV; it says how far it is, and why it failed. */
export function CsvButton(props: {
  name: string;
  /** Gives the text; hears how much is there (0..1). */
  text: (told: (share: number) => void) => Promise<string>;
}) {
  const [said, setSaid] = useState("");
  const [isBusy, setIsBusy] = useState(false);
  const fetchAll = async (): Promise<void> => {
    setIsBusy(true);
    setSaid("0 %");
    try {
      const text = await props.text((share) => setSaid(`${Math.round(100 * share)} %`));
      download(props.name, text, "text/csv;charset=utf-8");
      setSaid("");
    } catch (error) {
      setSaid(`Not downloaded: ${wordsOf(error)}.`);
    }
    setIsBusy(false);
  };
  return (
    <span class="csv-button">
      <button type="button" disabled={isBusy} onClick={() => void fetchAll()}>
        Download CSV
      </button>{" "}
      <span role="status" class="muted">
        {said}
      </span>
    </span>
  );
}
