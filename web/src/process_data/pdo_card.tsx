import type { Pdo } from "../source/types";
import { linkTo } from "../app/route";
import { valueText } from "../parameters/text/value_text";
import { ByteDrawing } from "./byte_drawing";
import { bytesOf, fieldsOf, hexOf, positionText, rawOf, type Field } from "./layout";
import { ageText, identifierText, rateText, stateWords, transmissionWords } from "./words";

function Facts(props: { pdo: Pdo }) {
  const { pdo } = props;
  const facts: [string, string][] = [
    ["COB-ID", `${pdo.cob_id.toString(16).toUpperCase().padStart(8, "0")}h (${pdo.object}:01)`],
    ["Transmission type", `${pdo.transmission_type}: ${transmissionWords(pdo.direction, pdo.transmission_type)}`],
    ["Inhibit time", pdo.inhibit_time_us === undefined ? "" : `${valueText(pdo.inhibit_time_us / 1000)}\u2009ms`],
    ["Event time", pdo.event_time_ms === undefined ? "" : `${pdo.event_time_ms}\u2009ms`],
    ["Rate", rateText(pdo)],
    ["Last frame", pdo.frames === undefined ? "not counted" : `${ageText(pdo)}, ${pdo.frames} counted`],
  ];
  return (
    <dl class="pdo-facts">
      {facts
        .filter(([, value]) => value !== "")
        .map(([title, value]) => (
          <div key={title}>
            <dt>{title}</dt>
            <dd>{value}</dd>
          </div>
        ))}
    </dl>
  );
}

function Row(props: { unit: string; field: Field; bytes: readonly number[] }) {
  const { field } = props;
  const raw = rawOf(field, props.bytes);
  return (
    <tr>
      <td>{field.number}</td>
      <td>
        <a class="mono" href={linkTo("objects", props.unit, { text: field.object.replace("h", "") })}>
          {field.object}
        </a>{" "}
        {field.name}
      </td>
      <td>{positionText(field)}</td>
      <td class="number">{raw === undefined ? "–" : hexOf(raw, field.bits)}</td>
      <td class="number">{valueText(field.value)}</td>
    </tr>
  );
}

/** A PDO: how it is sent, what is where in its bytes, and the values. */
export function PdoCard(props: { unit: string; pdo: Pdo; hasSeveralAxes: boolean }) {
  const { pdo, unit } = props;
  const fields = fieldsOf(pdo);
  const bytes = bytesOf(pdo.data);
  const direction = pdo.direction === "receive" ? "received by the unit" : "sent by the unit";
  return (
    <section class="card" aria-label={`${pdo.pdo} axis ${pdo.axis}`}>
      <div class="pdo-head">
        <h2>
          {pdo.pdo} <span class="mono">{identifierText(pdo)}</span>
        </h2>
        <span class="muted">{props.hasSeveralAxes ? `axis ${pdo.axis}, ${direction}` : direction}</span>
        <span class={`chip tone-${pdo.is_active ? "run" : "off"}`}>{stateWords(pdo)}</span>
      </div>
      <Facts pdo={pdo} />
      {fields.length === 0 ? (
        <p class="muted">Nothing is mapped.</p>
      ) : (
        <>
          <ByteDrawing unit={unit} fields={fields} data={pdo.data} label={`Bytes 0 to 7 of ${pdo.pdo}`} />
          <div class="scroll" tabIndex={0} role="region" aria-label={`Fields of ${pdo.pdo} axis ${pdo.axis}`}>
            <table class="pdo-table">
              <thead>
                <tr>
                  <th scope="col">No.</th>
                  <th scope="col">Object</th>
                  <th scope="col">Where</th>
                  <th scope="col" class="number">
                    Last frame
                  </th>
                  <th scope="col" class="number">
                    Object now
                  </th>
                </tr>
              </thead>
              <tbody>
                {fields.map((field) => (
                  <Row key={field.number} unit={unit} field={field} bytes={bytes} />
                ))}
              </tbody>
            </table>
          </div>
        </>
      )}
    </section>
  );
}
