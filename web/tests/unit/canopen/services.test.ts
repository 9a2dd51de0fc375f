import { describe, expect, it } from "vitest";

import { parseEds } from "../../../src/canopen/eds";
import { pdosOfEds } from "../../../src/canopen/pdo";
import { isOfSlave, laneNumber, ServiceMap } from "../../../src/canopen/services";
import { projectText } from "../data/files";

describe("services", () => {
  const services = new ServiceMap({ nodeId: 5 });

  it.each([
    [0x000, "nmt", "NMT command"],
    [0x080, "sync", "SYNC"],
    [0x085, "emcy", "EMCY"],
    [0x100, "other", "TIME"],
    [0x185, "tpdo", "TPDO 1"],
    [0x205, "rpdo", "RPDO 1"],
    [0x487, "tpdo", "TPDO 4 of node 7"],
    [0x505, "rpdo", "RPDO 4"],
    [0x585, "sdo", "SDO response"],
    [0x605, "sdo", "SDO request"],
    [0x607, "sdo", "SDO request of node 7"],
    [0x705, "heartbeat", "heartbeat"],
    [0x7e5, "other", "frame"],
    [0x700, "other", "frame"],
  ])("knows %i by the predefined connection set", (id, lane, name) => {
    expect(services.of(id)).toMatchObject({ lane, name });
    expect(services.laneOf(id, false)).toBe(laneNumber(services.of(id).lane));
  });

  it("takes 29 bits for something else", () => {
    expect(services.of(0x205, true).lane).toBe("other");
  });

  it("takes PDOs by the COB-IDs that the unit has", () => {
    const pdos = pdosOfEds(parseEds(projectText("eds/axisd.eds")), 5);
    const moved = pdos.map((pdo) => (pdo.pdo === "RPDO 1" ? { ...pdo, cob_id: 0x321 } : pdo));
    const map = new ServiceMap({ nodeId: 5, pdos: [...moved, { ...(pdos[0] ?? moved[0]), axis: 2, cob_id: 0x20000400 } as never] });
    expect(map.of(0x321)).toMatchObject({ kind: "rpdo", name: "RPDO 1", number: 1 });
    expect(map.of(0x400, true).name).toBe("RPDO 1 of axis 2");
    expect(map.laneOf(0x400, true)).toBe(laneNumber("rpdo"));
  });

  it("takes no PDO that is not valid", () => {
    const pdos = pdosOfEds(parseEds(projectText("eds/axisd.eds")), 5);
    expect(pdos.filter((pdo) => pdo.is_valid)).toHaveLength(8);
    expect(new ServiceMap({ nodeId: 5, pdos }).of(0x6df).kind).not.toBe("rpdo");
  });

  it("takes SDO servers and SYNC from the EDS and from what it is told", () => {
    const eds = parseEds(projectText("eds/axisd.eds"));
    const map = new ServiceMap({ nodeId: 5, eds, sdoServers: [{ server: 2, request: 0x620, response: 0x5a0 }] });
    expect(map.of(0x620)).toMatchObject({ name: "SDO request 2", kind: "sdo-request", number: 2 });
    expect(map.of(0x5a0).kind).toBe("sdo-response");
    expect(map.of(0x605).kind).toBe("sdo-request");
    expect(map.of(0x080).kind).toBe("sync");
  });

  it("knows which side sends an identifier", () => {
    expect([0x185, 0x585, 0x705, 0x085].every(isOfSlave)).toBe(true);
    expect([0x205, 0x605, 0x000, 0x080].some(isOfSlave)).toBe(false);
  });
});
