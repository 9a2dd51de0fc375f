import { useEffect, useState } from "preact/hooks";

import { usePage } from "../../app/context";
import type { ParameterEntry, Place } from "../../source/types";
import { sourcePlaces, suggestionsOf } from "./bico";
import type { ParameterSource } from "../data/parameter_source";
import { rangeText, valueText, whenWords } from "../text/value_text";
import { WriteField } from "../shared/write_field";

/** Time after the last letter until sources are looked for (ms). */
const kPause = 250;

/** The outputs that @param typed finds in the places an input at @param place usually takes from. */
async function outputsFor(source: ParameterSource, place: Place, typed: string): Promise<ParameterEntry[]> {
  const text = typed.replace(/ of (drive object|axis).*$/, "");
  if (text.trim().length < 2) return [];
  const lists = await Promise.all(
    sourcePlaces(place).map((each) => source.part({ place: each, text, filter: "outputs" }, 0)),
  );
  return lists.flatMap((list) => list.entries);
}

/** The texts that are suggested to a BICO input for what was typed; undefined: it is none. */
function useSuggestions(source: ParameterSource, place: Place, entry: ParameterEntry, typed: string): string[] | undefined {
  const [found, setFound] = useState<ParameterEntry[]>([]);
  const type = entry.type === "BI" || entry.type === "CI" ? entry.type : undefined;
  useEffect(() => {
    if (type === undefined || typed === "") return;
    let isOver = false;
    const look = (): void => {
      outputsFor(source, place, typed).then(
        (outputs) => !isOver && setFound(outputs),
        () => undefined,
      );
    };
    const timer = setTimeout(look, kPause);
    return () => {
      isOver = true;
      clearTimeout(timer);
    };
  }, [source, place, type, typed]);
  return type === undefined ? undefined : suggestionsOf(found, type, entry.drive_object, typed);
}

function hintOf(entry: ParameterEntry): string {
  if (entry.type === "BI") return "A bit: r0899.2, r0722.3 of drive object 1, 0 or 1.";
  if (entry.type === "CI") return "A connector: r0063[0], r0755 of drive object 1, or 0.";
  const range = rangeText(entry.minimum, entry.maximum);
  return `${range === "" ? "" : `${range}${entry.unit === "" ? "" : `\u2009${entry.unit}`}, `}${whenWords(entry.when)}.`;
}

/** The field that writes a parameter. */
export function ParameterWrite(props: {
  unit: string;
  source: ParameterSource;
  place: Place;
  entry: ParameterEntry;
  onWritten: () => void;
}) {
  const { entry, place } = props;
  const page = usePage();
  const [typed, setTyped] = useState("");
  const suggestions = useSuggestions(props.source, place, entry, typed);
  const write = async (text: string): Promise<void> => {
    await page.source.act("PUT", props.unit, `parameters/${encodeURIComponent(entry.parameter)}`, { value: text }, { axis: place });
    props.onWritten();
  };
  return (
    <WriteField
      key={`${place}/${entry.parameter}`}
      label={entry.type === "BI" || entry.type === "CI" ? "Source" : "Value"}
      present={valueText(entry.value)}
      unit={entry.unit}
      hint={hintOf(entry)}
      {...(entry.refusal === undefined ? {} : { refusal: `Not now: ${entry.refusal}.` })}
      {...(suggestions === undefined ? {} : { suggestions, onTyped: setTyped })}
      write={write}
    />
  );
}
