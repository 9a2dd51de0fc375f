import { Notice } from "../../ui/notice";
import type { PagedList } from "./paged_list";

/** How many rows of @param list were found, and why nothing comes. */
export function FoundLine<T, W>(props: { list: PagedList<T, W> }) {
  const { list } = props;
  const count = list.rows.value.length;
  const progress = list.progress.value;
  const words = progress === "asking" ? "Searching …" : `${count}${progress === "partial" ? " and more" : ""} found`;
  return (
    <>
      <p role="status" class="muted">
        {words}
      </p>
      {list.error.value !== "" && (
        <Notice kind="warning">
          {`${list.error.value}. `}
          {count > 0 && `What is shown is of ${new Date(list.seenAt).toLocaleTimeString()}. `}
          <button type="button" onClick={() => void list.more()}>
            Ask again
          </button>
        </Notice>
      )}
    </>
  );
}
