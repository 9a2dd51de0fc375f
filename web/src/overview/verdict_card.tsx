import type { Verdict } from "../source/source";
import { fixed } from "../ui/number";
import { stepsOf, summaryOf, type ReportStep } from "./report";

const kMarks: Record<ReportStep["outcome"], { glyph: string; tone: string }> = {
  passed: { glyph: "✓", tone: "run" },
  failed: { glyph: "✗", tone: "fault" },
  "not run": { glyph: "–", tone: "off" },
};

function StepRow(props: { step: ReportStep }) {
  const { step } = props;
  const mark = kMarks[step.outcome];
  return (
    <tr>
      <td class="number">{step.number}</td>
      <td class="number">{step.outcome === "not run" ? "–" : fixed(step.t, 3, "s")}</td>
      <td>
        <span class={`chip tone-${mark.tone}`}>
          <span aria-hidden="true">{mark.glyph} </span>
          {step.outcome}
        </span>
      </td>
      <td>{step.text}</td>
      <td>{step.remark}</td>
    </tr>
  );
}

function Steps(props: { steps: ReportStep[] }) {
  if (props.steps.length === 0) return null;
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label="Steps">
      <table>
        <thead>
          <tr>
            <th class="number">Step</th>
            <th class="number">Began</th>
            <th>Outcome</th>
            <th>What it does</th>
            <th>What came of it</th>
          </tr>
        </thead>
        <tbody>
          {props.steps.map((step) => (
            <StepRow key={step.number} step={step} />
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** What was said of a recorded session as a whole, with the steps of its scenario. */
export function VerdictCard(props: { verdict: Verdict }) {
  const { verdict } = props;
  const summary = summaryOf(verdict.report);
  return (
    <section class="card overview-verdict" aria-labelledby="verdict-title">
      <div class="overview-line">
        <h2 id="verdict-title">{verdict.title === "" ? "Recorded session" : verdict.title}</h2>
        {verdict.passed !== undefined && (
          <span class={`chip tone-${verdict.passed ? "run" : "fault"}`}>{verdict.passed ? "✓ passed" : "✗ failed"}</span>
        )}
      </div>
      {summary !== "" && <p class="muted">{summary}</p>}
      <Steps steps={stepsOf(verdict.report)} />
      {verdict.text !== "" && (
        <details open={stepsOf(verdict.report).length === 0}>
          <summary>Report as text</summary>
          <pre class="overview-report" tabIndex={0}>
            {verdict.text}
          </pre>
        </details>
      )}
    </section>
  );
}
