import type { Content } from "./decoded";
import { hexOf, unsignedOf, type CanFrame } from "./frame";
import { wordText, type BitRow } from "./words";

/** NMT commands (CiA 301, 7.2.8.3.1). */
const kCommands: Readonly<Record<number, string>> = {
  1: "Start remote node",
  2: "Stop remote node",
  128: "Enter pre-operational",
  129: "Reset node",
  130: "Reset communication",
};

/** NMT states of heartbeat and guarding (CiA 301, 7.2.8.3.2). */
const kStates: Readonly<Record<number, string>> = {
  0: "boot-up",
  4: "Stopped",
  5: "Operational",
  127: "Pre-operational",
};

/** Classes of emergency error codes by their upper byte, and codes of their own (CiA 301, table 26). */
const kEmergencies: Readonly<Record<number, string>> = {
  0x0000: "no error, or an error has gone",
  0x1000: "generic error",
  0x2000: "current",
  0x2100: "current, device input side",
  0x2200: "current inside the device",
  0x2300: "current, device output side",
  0x2310: "continuous overcurrent",
  0x2312: "continuous overcurrent, phase",
  0x2340: "short circuit, device output side",
  0x3000: "voltage",
  0x3100: "mains voltage",
  0x3200: "voltage inside the device",
  0x3210: "DC link overvoltage",
  0x3220: "DC link undervoltage",
  0x3300: "output voltage",
  0x4000: "temperature",
  0x4100: "ambient temperature",
  0x4200: "device temperature",
  0x4210: "excess temperature of the device",
  0x4310: "excess temperature of the drive",
  0x5000: "device hardware",
  0x6000: "device software",
  0x6100: "internal software",
  0x6200: "user software",
  0x6300: "data set",
  0x7000: "additional modules",
  0x7121: "motor blocked",
  0x7305: "incremental sensor 1 fault",
  0x8000: "monitoring",
  0x8100: "communication",
  0x8110: "CAN overrun (objects lost)",
  0x8120: "CAN in error passive mode",
  0x8130: "life guard error or heartbeat error",
  0x8140: "recovered from bus off",
  0x8150: "CAN-ID collision",
  0x8200: "protocol error",
  0x8210: "PDO not processed due to length error",
  0x8220: "PDO length exceeded",
  0x8230: "DAM MPDO not processed, destination object not available",
  0x8240: "unexpected SYNC data length",
  0x8250: "RPDO timeout",
  0x8400: "velocity speed controller",
  0x8500: "position controller",
  0x8611: "following error",
  0x8700: "synchronisation controller",
  0x9000: "external error",
  0xf000: "additional functions",
  0xff00: "device specific",
};

/** Milliseconds of a day. */
const kDayMs = 86_400_000;

/** Bits of the error register 1001h (CiA 301, 7.5.2.2). */
const kRegister = [
  "generic error",
  "current",
  "voltage",
  "temperature",
  "communication error",
  "device profile specific",
  "reserved",
  "manufacturer specific",
];

/** Meaning of an emergency error code: its own, or that of its class. */
export function emergencyText(code: number): string {
  return kEmergencies[code] ?? kEmergencies[code & 0xff00] ?? kEmergencies[code & 0xf000] ?? "unknown";
}

/** What is known of a message: "F07860", "External fault 1"; undefined: nothing. */
export type MessageTexts = (number: number, driveObject: number) => { name: string; text: string } | undefined;

export function decodeNmt({ data }: CanFrame): Content {
  const [command, node] = [data[0] ?? 0, data[1] ?? 0];
  const whom = node === 0 ? "all nodes" : `node ${node}`;
  const name = kCommands[command] ?? "unknown command";
  const rows = [
    { name: "Command", value: name, raw: wordText(command, 2) },
    { name: "Node", value: whom, raw: wordText(node, 2) },
  ];
  const content: Content = { text: `${name}, ${whom}`, rows };
  return data.length === 2 ? content : { ...content, remark: `an NMT command has 2 bytes, this frame has ${data.length}` };
}

export function decodeHeartbeat(frame: CanFrame): Content {
  if (frame.isRemote) return { text: "node guarding request", rows: [] };
  const value = frame.data[0] ?? 0;
  const state = kStates[value & 0x7f] ?? "unknown state";
  const toggle = value >> 7;
  const rows = [{ name: "State", value: state, raw: wordText(value & 0x7f, 2) }];
  if (toggle === 1) rows.push({ name: "Toggle bit", value: "1: a guarding response", raw: wordText(value, 2) });
  const content: Content = { text: toggle === 1 ? `${state}, guarding response with toggle bit 1` : state, rows };
  return frame.data.length === 1 ? content : { ...content, remark: "error control has one byte of data" };
}

export function decodeSync({ data }: CanFrame): Content {
  if (data.length === 0) return { text: "without a counter", rows: [] };
  const counter = data[0] ?? 0;
  const content: Content = { text: `counter ${counter}`, rows: [{ name: "Counter", value: String(counter) }] };
  return data.length === 1 ? content : { ...content, remark: "SYNC has at most one byte" };
}

/** TIME: milliseconds after midnight and days since 1984 (CiA 301, 7.2.6). */
export function decodeTime({ data }: CanFrame): Content {
  if (data.length !== 6) return { text: `${data.length} bytes`, rows: [], remark: "TIME has 6 bytes" };
  const milliseconds = unsignedOf(data, 0, 4) % 0x10000000;
  const days = unsignedOf(data, 4, 2);
  const text = new Date(Date.UTC(1984, 0, 1) + days * kDayMs + milliseconds).toISOString();
  return { text, rows: [{ name: "Time of day", value: text, raw: hexOf(data, " ") }] };
}

function registerBits(register: number): BitRow[] {
  return kRegister.map((name, bit) => ({ bit: String(bit), name, value: (register >> bit) & 1 }));
}

/** Error code and error register of an emergency message. */
function emergencyRows(code: number, register: number): Content["rows"] {
  const set = registerBits(register).filter((bit) => bit.value === 1);
  return [
    { name: "Error code", value: emergencyText(code), raw: wordText(code) },
    {
      name: "Error register",
      value: set.length === 0 ? "nothing set" : set.map((bit) => bit.name).join(", "),
      raw: wordText(register, 2),
      object: "1001h:00",
      bits: registerBits(register),
    },
  ];
}

function goneText(register: number): string {
  return register === 0 ? "no error is left" : "an error has gone, others are left";
}

/** EMCY of a CiA 402 device: code, register, and the axis if it is one of an axis. */
export function decodeAxisEmergency({ data }: CanFrame): Content {
  if (data.length !== 8) return { text: `${data.length} bytes`, rows: [], remark: "an emergency message has 8 bytes" };
  const [code, register, axis] = [unsignedOf(data, 0, 2), data[2] ?? 0, unsignedOf(data, 3, 2)];
  const rows = emergencyRows(code, register);
  if (axis > 0) rows.push({ name: "Axis", value: String(axis), raw: wordText(axis) });
  if (code === 0) return { text: goneText(register), rows };
  return { text: `${wordText(code)} ${emergencyText(code)}${axis > 0 ? `: axis ${axis}` : ""}`, rows };
}

/** EMCY of a SINAMICS: code, register, number of the fault or alarm, number of the drive object. */
export function decodeEmergency({ data }: CanFrame, texts: MessageTexts): Content {
  if (data.length !== 8) return { text: `${data.length} bytes`, rows: [], remark: "an emergency message has 8 bytes" };
  const [code, register, number] = [unsignedOf(data, 0, 2), data[2] ?? 0, unsignedOf(data, 3, 2)];
  const object = data[5] ?? 0;
  const meaning = emergencyText(code);
  const rows = emergencyRows(code, register);
  if (code === 0) return { text: goneText(register), rows };
  const known = texts(number, object);
  const message = known === undefined ? `F/A${String(number).padStart(5, "0")}` : `${known.name} ${known.text}`;
  rows.push({ name: "Message", value: message, raw: wordText(number) });
  rows.push({ name: "Drive object", value: String(object), raw: wordText(object, 2) });
  rows.push({ name: "Rest", value: hexOf(data.subarray(6), " ") });
  return { text: `${wordText(code)} ${meaning}: ${message}`, rows };
}
