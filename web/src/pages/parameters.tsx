/** To be written. */
export function Parameters(props: { unit: string }) {
  return <h1>Parameters {props.unit}</h1>;
}
