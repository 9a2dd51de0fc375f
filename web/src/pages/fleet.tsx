/** To be written. */
export function Fleet(props: { unit: string }) {
  return <h1>Fleet {props.unit}</h1>;
}
