/** To be written. */
export function Overview(props: { unit: string }) {
  return <h1>Overview {props.unit}</h1>;
}
