/** To be written. */
export function Scope(props: { unit: string }) {
  return <h1>Scope {props.unit}</h1>;
}
