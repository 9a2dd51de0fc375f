import { useEffect, useRef, useState } from "preact/hooks";

import { usePage } from "./context";
import { token } from "./permission";

/** Asks for the token of the gateway. */
export function TokenDialog(props: { onClose: () => void }) {
  const { permission } = usePage();
  const dialog = useRef<HTMLDialogElement>(null);
  const [text, setText] = useState(token.value);
  useEffect(() => dialog.current?.showModal(), []);
  const take = async (event: Event): Promise<void> => {
    event.preventDefault();
    await permission.take(text);
    if (permission.refusal.value === "") props.onClose();
  };
  return (
    <dialog ref={dialog} class="dialog" aria-labelledby="token-title" onClose={props.onClose}>
      <form onSubmit={(event) => void take(event)}>
        <h2 id="token-title">Token of axisd-http</h2>
        <p>
          Whoever wants to change anything needs it. It stands in the file that <code>axisd-http</code> was told by{" "}
          <code>--token-file</code>: <code>~/.local/state/axisd-http/token</code>, of the service{" "}
          <code>/var/lib/axisd-http/token</code>. This tab keeps it until it is closed.
        </p>
        <label class="field">
          Token
          <input
            type="password"
            autocomplete="off"
            value={text}
            onInput={(event) => setText(event.currentTarget.value)}
          />
        </label>
        {permission.refusal.value !== "" && (
          <p class="notice notice-warning" role="status">
            {permission.refusal.value}
          </p>
        )}
        <div class="buttons">
          <button type="submit" class="primary">
            Use it
          </button>
          <button type="button" onClick={() => dialog.current?.close()}>
            Close
          </button>
        </div>
      </form>
    </dialog>
  );
}
