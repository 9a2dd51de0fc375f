import { useEffect, useRef } from "preact/hooks";

/** Keys that hold a button down. */
const kKeys = [" ", "Enter"];

/** What is done when a button is pressed, and when it is let go. */
interface Hold {
  isDown: boolean;
  begin: () => void;
  end: () => void;
}

/** Keeps a button held only while its page is seen and has the focus. */
function useHold(onBegin: () => void, onEnd: () => void, isOff: boolean): { begin: () => void; end: () => void } {
  const hold = useRef<Hold>({ isDown: false, begin: onBegin, end: onEnd });
  hold.current.begin = onBegin;
  hold.current.end = onEnd;
  const begin = (): void => {
    if (hold.current.isDown || isOff) return;
    hold.current.isDown = true;
    hold.current.begin();
  };
  const end = (): void => {
    if (!hold.current.isDown) return;
    hold.current.isDown = false;
    hold.current.end();
  };
  useEffect(() => {
    const endHidden = (): void => {
      if (document.hidden) end();
    };
    addEventListener("blur", end);
    document.addEventListener("visibilitychange", endHidden);
    return () => {
      removeEventListener("blur", end);
      document.removeEventListener("visibilitychange", endHidden);
      end();
    };
  }, []);
  useEffect(() => {
    if (isOff) end();
  }, [isOff]);
  return { begin, end };
}

/** A button that acts as long as it is held down, by pointer or by key. */
export function JogButton(props: { onBegin: () => void; onEnd: () => void; disabled: boolean; children: string }) {
  const { begin, end } = useHold(props.onBegin, props.onEnd, props.disabled);
  return (
    <button
      type="button"
      class="hands-jog"
      disabled={props.disabled}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        begin();
      }}
      onPointerUp={end}
      onPointerCancel={end}
      onLostPointerCapture={end}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => {
        if (!kKeys.includes(event.key)) return;
        event.preventDefault();
        if (!event.repeat) begin();
      }}
      onKeyUp={(event) => {
        if (kKeys.includes(event.key)) end();
      }}
      onBlur={end}
    >
      {props.children}
    </button>
  );
}
