/** To be written. */
export function States(props: { unit: string }) {
  return <h1>States {props.unit}</h1>;
}
