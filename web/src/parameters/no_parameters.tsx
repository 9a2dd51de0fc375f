import { linkTo } from "../app/route";
import { Notice } from "../ui/notice";

/** In place of the parameters, for a unit that has none. */
export function NoParameters(props: { unit: string }) {
  return (
    <>
      <h1>Parameters</h1>
      <Notice>This device has no parameters: its profile is cia402.</Notice>
      <p>
        What it is told and what it says stands in its object dictionary: <a href={linkTo("objects", props.unit)}>Objects</a>.
      </p>
    </>
  );
}
