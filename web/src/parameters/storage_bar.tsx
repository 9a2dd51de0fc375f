import { useRef, useState } from "preact/hooks";

import { usePage } from "../app/context";
import { useResource } from "../ui/resource";
import { refusalLines } from "./text/refusal_text";

interface Storage {
  file: string;
  is_stored: boolean;
  is_saving: boolean;
  saves: number;
}

/** Time between two looks at the storage (ms). */
const kPeriod = 2000;

/** What can be done with all parameters at once. */
const kActions = [
  {
    title: "Save all",
    question: "Save all parameters of all drive objects? What was saved before is lost.",
    resource: "storage/store",
    body: undefined,
    done: "The unit saves all parameters.",
  },
  {
    title: "Load what is saved",
    question: "Take back all parameters that were saved? What was changed since then is lost. Axes that are on refuse it.",
    resource: "storage/restore",
    body: { which: "stored" },
    done: "The parameters are those that were saved.",
  },
  {
    title: "Reset to factory",
    question: "Take back the parameters of a new unit, in all drive objects? All that was changed is lost, unless it was saved.",
    resource: "storage/restore",
    body: { which: "factory" },
    done: "The parameters are those of a new unit.",
  },
] as const;
type Action = (typeof kActions)[number];

function stateWords(storage: Storage | undefined): string {
  if (storage === undefined) return "";
  if (storage.is_saving) return "The unit is saving.";
  if (storage.file === "none" && !storage.is_stored) return "Nothing is saved.";
  return storage.is_stored ? "Parameters are saved." : "Nothing is saved yet.";
}

/** Asks before @param props.action is done. */
function Question(props: { action: Action; onAnswer: (isYes: boolean) => void }) {
  const show = (dialog: HTMLDialogElement | null): void => {
    if (dialog !== null && !dialog.open) dialog.showModal();
  };
  return (
    <dialog ref={show} class="dialog" aria-labelledby="storage-question" onCancel={() => props.onAnswer(false)}>
      <h2 id="storage-question">{props.action.title}</h2>
      <p>{props.action.question}</p>
      <div class="buttons">
        <button type="button" class="danger" onClick={() => props.onAnswer(true)}>
          {props.action.title}
        </button>
        <button type="button" onClick={() => props.onAnswer(false)}>
          Leave it
        </button>
      </div>
    </dialog>
  );
}

/** Saves all parameters, or takes them back, after a question. */
export function StorageBar(props: { unit: string; onDone: () => void }) {
  const { source, permission } = usePage();
  const storage = useResource(() => source.get<Storage>(props.unit, "storage"), [props.unit], source.isLive ? kPeriod : undefined);
  const [asked, setAsked] = useState<Action | null>(null);
  const [said, setSaid] = useState("");
  const button = useRef<HTMLElement | null>(null);
  const mayNot = permission.refusal.value;
  const answer = async (isYes: boolean): Promise<void> => {
    const action = asked;
    setAsked(null);
    button.current?.focus();
    if (!isYes || action === null) return;
    try {
      await source.act("POST", props.unit, action.resource, action.body ?? {});
      setSaid(action.done);
      storage.again();
      props.onDone();
    } catch (error) {
      permission.note(error);
      setSaid(`Refused: ${refusalLines(error).join(" ")}`);
    }
  };
  return (
    <div class="storage-bar">
      {kActions.map((action) => (
        <button
          key={action.title}
          type="button"
          disabled={mayNot !== "" || storage.value?.is_saving === true}
          onClick={(event) => {
            button.current = event.currentTarget;
            setAsked(action);
          }}
        >
          {action.title}
        </button>
      ))}
      <span role="status" class="muted">
        {said !== "" ? said : storage.error !== "" ? storage.error : stateWords(storage.value)}
      </span>
      {mayNot !== "" && <span class="muted">{mayNot}</span>}
      {asked !== null && <Question action={asked} onAnswer={(isYes) => void answer(isYes)} />}
    </div>
  );
}
