import { useMemo, useState } from "preact/hooks";

import { usePage } from "../app/context";
import { useProfile } from "../app/use_profile";
import { hasParameters } from "../model/profile";
import { useAddress } from "../parameters/shared/address";
import { DifferencesView } from "../parameters/differences_view";
import { ListView } from "../parameters/list_view";
import { parametersOf } from "../parameters/data/parameter_source";
import { placesOf } from "../parameters/data/places";
import { NoParameters } from "../parameters/no_parameters";
import { StorageBar } from "../parameters/storage_bar";
import { Notice } from "../ui/notice";
import { useResource } from "../ui/resource";

/** Time between two looks at what drive objects there are (ms). */
const kPeriod = 5000;

/** The parameters of a unit that has some. */
function OwnParameters(props: { unit: string }) {
  const { source } = usePage();
  const { unit } = props;
  const address = useAddress("parameters", unit);
  const parameters = useMemo(() => parametersOf(source, unit), [source, unit]);
  const places = useResource(() => placesOf(source, unit), [source, unit], source.isLive ? kPeriod : undefined);
  const [turn, setTurn] = useState(0);
  const isDifferences = address.query.get("view") === "differences";
  return (
    <div class="parameters">
      <div class="parameters-head">
        <h1>Parameters</h1>
        <nav aria-label="Views of the parameters">
          <a href={address.link({ view: undefined })} aria-current={isDifferences ? undefined : "page"}>
            List
          </a>
          <a href={address.link({ view: "differences" })} aria-current={isDifferences ? "page" : undefined}>
            Differences
          </a>
        </nav>
        <StorageBar unit={unit} onDone={() => setTurn((before) => before + 1)} />
      </div>
      {places.error !== "" && places.value === undefined && <Notice kind="warning">{`${places.error}.`}</Notice>}
      {isDifferences ? (
        <DifferencesView unit={unit} source={parameters} address={address} turn={turn} />
      ) : (
        places.value !== undefined && <ListView unit={unit} source={parameters} places={places.value} address={address} />
      )}
    </div>
  );
}

/** The parameters of a unit: search, detail, wiring, writing, differences, saving; or that it has none. */
export function Parameters(props: { unit: string }) {
  const profile = useProfile(props.unit);
  if (profile === undefined) return <h1>Parameters</h1>;
  return hasParameters(profile) ? <OwnParameters unit={props.unit} /> : <NoParameters unit={props.unit} />;
}
