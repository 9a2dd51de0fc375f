import { useAddress, type Address } from "../parameters/shared/address";
import { usePage } from "../app/context";
import { PdoCard } from "../process_data/pdo_card";
import { pdosOf, type Pdos, type WantedPdos } from "../process_data/pdo_source";
import { WatchBar } from "../process_data/watch_bar";
import { Notice } from "../ui/notice";
import { useResource } from "../ui/resource";

/** Time between two looks (ms). */
const kPeriod = 500;

function Tools(props: { axes: number; wanted: WantedPdos; address: Address }) {
  const { wanted, address } = props;
  return (
    <div class="row">
      <label class="field">
        Axis
        <select value={String(wanted.axis)} onChange={(event) => address.replace({ axis: event.currentTarget.value })}>
          <option value="0">All</option>
          {Array.from({ length: Math.max(props.axes, wanted.axis) }, (_, at) => (
            <option key={at} value={String(at + 1)}>{`Axis ${at + 1}`}</option>
          ))}
        </select>
      </label>
      <label class="pdo-check">
        <input
          type="checkbox"
          checked={wanted.all}
          onChange={(event) => address.replace({ all: event.currentTarget.checked ? "1" : undefined })}
        />{" "}
        Those too that are not valid
      </label>
    </div>
  );
}

function Cards(props: { unit: string; pdos: Pdos; axes: number }) {
  const groups = [
    { direction: "receive", title: "Received by the unit (RPDO)" },
    { direction: "transmit", title: "Sent by the unit (TPDO)" },
  ];
  return (
    <>
      {groups.map(({ direction, title }) => (
        <section key={direction} class="pdo-group" aria-label={title}>
          <div class="pdo-cards">
            {props.pdos.pdos
              .filter((pdo) => pdo.direction === direction)
              .map((pdo) => (
                <PdoCard key={`${pdo.axis} ${pdo.object}`} unit={props.unit} pdo={pdo} hasSeveralAxes={props.axes > 1} />
              ))}
          </div>
        </section>
      ))}
    </>
  );
}

/** The PDOs of a unit: how they are sent, what is mapped where, values, frames. */
export function ProcessData(props: { unit: string }) {
  const { source, units } = usePage();
  const { unit } = props;
  const address = useAddress("process-data", unit);
  const wanted: WantedPdos = { axis: Number(address.query.get("axis")) || 0, all: address.query.has("all") };
  const pdos = useResource(
    () => pdosOf(source, unit, wanted),
    [source, unit, wanted.axis, wanted.all],
    source.isLive ? kPeriod : undefined,
  );
  const axes = units.find(unit)?.axes?.length ?? 1;
  return (
    <div class="process-data">
      <h1>Process data</h1>
      <Tools axes={axes} wanted={wanted} address={address} />
      {pdos.error !== "" && <Notice kind="warning">{`${pdos.error}. What is shown may be old.`}</Notice>}
      {pdos.value !== undefined && (
        <>
          <WatchBar unit={unit} pdos={pdos.value} onDone={pdos.again} />
          {pdos.value.pdos.length === 0 && <Notice>No PDO is valid here.</Notice>}
          <Cards unit={unit} pdos={pdos.value} axes={axes} />
        </>
      )}
    </div>
  );
}
