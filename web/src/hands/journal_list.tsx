import type { Entry, Journal } from "./journal";

const kOutcomes: Record<Entry["outcome"], { glyph: string; tone: string }> = {
  waiting: { glyph: "…", tone: "off" },
  done: { glyph: "✓", tone: "run" },
  refused: { glyph: "✗", tone: "fault" },
};

/** What was sent from this page, the newest first. */
export function JournalList(props: { journal: Journal }) {
  const entries = [...props.journal.entries.value].reverse();
  return (
    <section class="card hands-card" aria-label="What was sent">
      <h2>What was sent</h2>
      {entries.length === 0 && <p class="muted">Nothing yet.</p>}
      <ol class="hands-journal" aria-live="polite" aria-label="What was sent, the newest first" tabIndex={0}>
        {entries.map((entry) => (
          <li key={entry.id}>
            <span class="mono muted">{new Date(entry.at).toLocaleTimeString()}</span>
            <span class={`chip tone-${kOutcomes[entry.outcome].tone}`}>
              <span aria-hidden="true">{kOutcomes[entry.outcome].glyph} </span>
              {entry.outcome}
            </span>
            <span class="hands-journal-words">
              {entry.words}
              {entry.text === "" ? "" : `: ${entry.text}`}
            </span>
          </li>
        ))}
      </ol>
    </section>
  );
}
