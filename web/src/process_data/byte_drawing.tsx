import { linkTo } from "../app/route";
import { bytesOf, type Field } from "./layout";

/** Colours of fields; the number in it tells them apart, too. */
const kColours = 6;

function column(firstBit: number, bits: number): { gridColumn: string } {
  return { gridColumn: `${firstBit + 1} / span ${bits}` };
}

/** Eight bytes with what is mapped into them, and the data of the last frame below. */
export function ByteDrawing(props: { unit: string; fields: readonly Field[]; data: string | undefined; label: string }) {
  const { fields, data } = props;
  const bytes = bytesOf(data);
  return (
    <div class="pdo-bytes" role="group" aria-label={props.label}>
      {Array.from({ length: 8 }, (_, at) => (
        <span key={at} class="pdo-byte-head" style={{ ...column(8 * at, 8), gridRow: 1 }}>
          {at}
        </span>
      ))}
      {fields.map((field) => (
        <a
          key={field.number}
          class={`pdo-field pdo-colour-${(field.number - 1) % kColours}`}
          style={{ ...column(field.firstBit, field.bits), gridRow: 2 }}
          href={linkTo("objects", props.unit, { text: field.object.replace("h", "") })}
          aria-label={`${field.number} ${field.name === "" ? field.object : field.name}`}
          title={`${field.object} ${field.name}`}
        >
          {field.bits < 8 ? field.number : `${field.number} ${field.name === "" ? field.object : field.name}`}
        </a>
      ))}
      {bytes.slice(0, 8).map((byte, at) => (
        <span key={at} class="pdo-byte mono" style={{ ...column(8 * at, 8), gridRow: 3 }}>
          {byte.toString(16).toUpperCase().padStart(2, "0")}
        </span>
      ))}
    </div>
  );
}
