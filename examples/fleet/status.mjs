// Reads the status of a unit of a farm and sends it a method, with a client of NATS that knows nothing of axisd:
//
//   npm install @nats-io/transport-node
//   node status.mjs nats://127.0.0.1:4222 lab line1/5
//   node status.mjs nats://127.0.0.1:4222 lab line1/5 load.set '{"axis": 1, "torque_Nm": 2}'
import { webcrypto } from "node:crypto";

globalThis.crypto ??= webcrypto; // which Node.js 18 does not have there
const { connect } = await import("@nats-io/transport-node");

const [url, farm, unit, method, params = "{}"] = process.argv.slice(2);
if (unit === undefined) {
  console.error("usage: status.mjs URL FARM BUS/NODE [METHOD [PARAMS]]");
  process.exit(2);
}

const subject = `axisd.${farm}.${unit.replace("/", ".")}.rpc`;
let connection;

/** The result of a method of the control socket. */
async function ask(method, params = {}) {
  const reply = await connection.request(subject, JSON.stringify({ method, params }), { timeout: 10_000 });
  const { result, error } = reply.json();
  if (error !== undefined) throw new Error(`${method}: ${error.message} (${error.code})`);
  return result;
}

try {
  connection = await connect({ servers: url });
  if (method !== undefined) console.log(`${method}: ${JSON.stringify(await ask(method, JSON.parse(params)))}`);
  const status = await ask("status");
  console.log(`${unit}: node ${status.node_id}, ${status.nmt_state}`);
  for (const axis of status.axes) console.log(`axis ${axis.axis}: ${axis.state}, load ${axis.load_torque_Nm} Nm`);
} catch (error) {
  console.error(error.message);
  process.exitCode = 1;
} finally {
  await connection?.close();
}
