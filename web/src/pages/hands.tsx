/** To be written. */
export function Hands(props: { unit: string }) {
  return <h1>Hands {props.unit}</h1>;
}
