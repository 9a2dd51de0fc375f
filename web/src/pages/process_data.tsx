/** To be written. */
export function ProcessData(props: { unit: string }) {
  return <h1>ProcessData {props.unit}</h1>;
}
