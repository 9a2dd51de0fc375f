/** To be written. */
export function Objects(props: { unit: string }) {
  return <h1>Objects {props.unit}</h1>;
}
