import { abortText } from "./abort_codes";
import { hexOf, unsignedOf } from "../frame";
import { wordText } from "../words";

/** A transfer of an object from a client to a server (download) or back (upload). */
export interface SdoTransfer {
  direction: "download" | "upload";
  form: "expedited" | "segmented" | "block";
  index: number;
  subIndex: number;
  /** As it was announced (bytes). */
  size?: number;
  data: number[];
  state: "open" | "done" | "aborted";
  abortCode?: number;
}

/** What one frame of a transfer says. */
export interface SdoStep {
  text: string;
  rows: { name: string; value: string; raw?: string }[];
  remark?: string;
  /** It names the object: the first request, its response, an abort. */
  object?: { index: number; subIndex: number };
  /** The value, or the piece of it, in this frame. */
  data?: Uint8Array;
  /** Whether a transfer begins. */
  begins: boolean;
}

type Fields = SdoStep["rows"];

const kAbort = 4;
/** Place and size of the identification of an object (CiA 301, 7.2.4.3). */
const kIndexAt = 1;
const kSubIndexAt = 3;
const kDataAt = 4;

function objectIn(data: Uint8Array): { index: number; subIndex: number } {
  return { index: unsignedOf(data, kIndexAt, 2), subIndex: data[kSubIndexAt] ?? 0 };
}

function bit(byte: number, place: number): number {
  return (byte >> place) & 1;
}

/** Reads the frames of one pair of SDO identifiers one after the other, and knows what transfer they make. */
export class SdoReader {
  transfer: SdoTransfer | undefined;
  /** Who sends blocks at the moment. */
  private blocks: "none" | "client" | "server" = "none";
  private blockSize = 127;
  /** Bytes that are not acknowledged yet, and whether the last segment is among them. */
  private pending: number[] = [];
  private isLastSeen = false;

  /** The next frame: a request of the client or a response of the server. */
  read(data: Uint8Array, isRequest: boolean): SdoStep {
    const first = data[0] ?? 0;
    if (data.length !== 8)
      return { text: `${data.length} bytes`, rows: [], remark: "SDO frames have 8 bytes", begins: false };
    if (first === kAbort << 5) return this.abort(data, isRequest);
    if (this.blocks === (isRequest ? "client" : "server")) return this.blockSegment(data);
    return isRequest ? this.request(data) : this.response(data);
  }

  private request(data: Uint8Array): SdoStep {
    const first = data[0] ?? 0;
    switch (first >> 5) {
      case 0:
        return this.segment("download segment", data, "download");
      case 1:
        return this.beginDownload(data);
      case 2:
        return this.begin("upload", "expedited", "upload request", data, []);
      case 3:
        return this.plain("upload segment request", [toggleOf(first)]);
      case 5:
        return this.blockUploadRequest(data);
      case 6:
        return this.blockDownloadRequest(data);
      default:
        return unknown(first);
    }
  }

  private response(data: Uint8Array): SdoStep {
    const first = data[0] ?? 0;
    switch (first >> 5) {
      case 0:
        return this.segment("upload segment", data, "upload");
      case 1:
        return this.plain("download segment response", [toggleOf(first)]);
      case 2:
        return this.uploadResponse(data);
      case 3:
        if (this.transfer?.direction === "download" && this.transfer.form === "expedited") this.transfer.state = "done";
        return { ...this.plain("download response", []), object: objectIn(data) };
      case 5:
        return this.blockDownloadResponse(data);
      case 6:
        return this.blockUploadResponse(data);
      default:
        return unknown(first);
    }
  }

  private begin(
    direction: SdoTransfer["direction"],
    form: SdoTransfer["form"],
    text: string,
    data: Uint8Array,
    rows: Fields,
  ): SdoStep {
    const object = objectIn(data);
    this.blocks = "none";
    this.pending = [];
    this.isLastSeen = false;
    this.transfer = { direction, form, ...object, data: [], state: "open" };
    return { text, rows, object, begins: true };
  }

  private plain(text: string, rows: Fields): SdoStep {
    return { text, rows, begins: false };
  }

  /** A value of up to four bytes, or how many will come; for both ways. */
  private initial(step: SdoStep, data: Uint8Array, transfer: SdoTransfer | undefined): SdoStep {
    const first = data[0] ?? 0;
    const isSized = bit(first, 0) === 1;
    if (bit(first, 1) === 0) {
      const size = unsignedOf(data, kDataAt, 4);
      if (transfer !== undefined) transfer.form = "segmented";
      if (transfer !== undefined && isSized) transfer.size = size;
      step.rows.push({ name: "Size", value: isSized ? `${size} bytes follow in segments` : "not announced" });
      return step;
    }
    const value = data.slice(kDataAt, isSized ? 8 - ((first >> 2) & 3) : 8);
    if (transfer !== undefined) transfer.data = [...value];
    return { ...step, data: value };
  }

  private beginDownload(data: Uint8Array): SdoStep {
    const step = this.begin("download", "expedited", "download request", data, []);
    return this.initial(step, data, this.transfer);
  }

  private uploadResponse(data: Uint8Array): SdoStep {
    const { transfer } = this;
    if (transfer?.direction === "upload" && transfer.form === "block") transfer.form = "expedited";
    const step = { ...this.plain("upload response", []), object: objectIn(data) };
    const done = this.initial(step, data, transfer);
    if (transfer?.form === "expedited") transfer.state = "done";
    return done;
  }

  private segment(text: string, data: Uint8Array, direction: SdoTransfer["direction"]): SdoStep {
    const first = data[0] ?? 0;
    const piece = data.slice(1, 8 - ((first >> 1) & 7));
    const isLast = bit(first, 0) === 1;
    const { transfer } = this;
    if (transfer?.direction === direction) transfer.data.push(...piece);
    if (transfer?.direction === direction && isLast) transfer.state = "done";
    const rows = [toggleOf(first), { name: "Last segment", value: isLast ? "yes" : "no" }];
    return { text: isLast ? `last ${text}` : text, rows, data: piece, begins: false };
  }

  private blockUploadRequest(data: Uint8Array): SdoStep {
    const first = data[0] ?? 0;
    switch (first & 3) {
      case 0:
        this.blockSize = data[4] ?? 127;
        return this.begin("upload", "block", "block upload request", data, [
          { name: "Segments a block", value: String(this.blockSize) },
          { name: "CRC", value: bit(first, 2) === 1 ? "yes" : "no" },
          { name: "Protocol switch", value: data[5] === 0 ? "not allowed" : `below ${data[5] ?? 0} bytes` },
        ]);
      case 1:
        if (this.transfer !== undefined) this.transfer.state = "done";
        return this.plain("block upload: end", []);
      case 2:
        return this.acknowledge("block upload", data, "server");
      default:
        this.blocks = "server";
        return this.plain("block upload: begin", []);
    }
  }

  private blockUploadResponse(data: Uint8Array): SdoStep {
    const first = data[0] ?? 0;
    if (bit(first, 0) === 1) return this.blockEnd("block upload: end", data);
    return { ...this.plain("block upload response", this.announced(data, bit(first, 1) === 1)), object: objectIn(data) };
  }

  private blockDownloadRequest(data: Uint8Array): SdoStep {
    const first = data[0] ?? 0;
    if (bit(first, 0) === 1) return this.blockEnd("block download: end", data);
    const step = this.begin("download", "block", "block download request", data, []);
    step.rows.push(...this.announced(data, bit(first, 1) === 1));
    return step;
  }

  private blockDownloadResponse(data: Uint8Array): SdoStep {
    const first = data[0] ?? 0;
    if ((first & 3) === 2) return this.acknowledge("block download", data, "client");
    if ((first & 3) === 1) {
      if (this.transfer !== undefined) this.transfer.state = "done";
      return this.plain("block download: ended", []);
    }
    this.blockSize = data[4] ?? 127;
    this.blocks = "client";
    const rows = [{ name: "Segments a block", value: String(this.blockSize) }];
    return { ...this.plain("block download response", rows), object: objectIn(data) };
  }

  private announced(data: Uint8Array, isSized: boolean): Fields {
    const size = unsignedOf(data, kDataAt, 4);
    if (this.transfer !== undefined && isSized) this.transfer.size = size;
    return [
      { name: "Size", value: isSized ? `${size} bytes` : "not announced" },
      { name: "CRC", value: bit(data[0] ?? 0, 2) === 1 ? "yes" : "no" },
    ];
  }

  /** Bytes 1 to 7 of each; how many of the last count stands in the end of the transfer. */
  private blockSegment(data: Uint8Array): SdoStep {
    const first = data[0] ?? 0;
    const sequence = first & 0x7f;
    const isLast = bit(first, 7) === 1;
    const piece = data.slice(1);
    this.pending.push(...piece);
    this.isLastSeen ||= isLast;
    if (isLast || sequence >= this.blockSize) this.blocks = "none";
    const text = `block segment ${sequence}${isLast ? ", the last" : ""}`;
    return { text, rows: [{ name: "Sequence number", value: String(sequence) }], data: piece, begins: false };
  }

  /** What was not acknowledged is sent again. */
  private acknowledge(what: string, data: Uint8Array, sender: "client" | "server"): SdoStep {
    const [sequence, next] = [data[1] ?? 0, data[2] ?? 0];
    this.transfer?.data.push(...this.pending.slice(0, 7 * sequence));
    const isOver = this.isLastSeen && 7 * sequence >= this.pending.length;
    this.pending = [];
    this.isLastSeen = false;
    this.blockSize = next;
    this.blocks = isOver ? "none" : sender;
    const rows = [
      { name: "Segments received", value: String(sequence) },
      { name: "Segments of the next block", value: String(next) },
    ];
    return this.plain(`${what}: block of ${sequence} received`, rows);
  }

  private blockEnd(text: string, data: Uint8Array): SdoStep {
    const unused = ((data[0] ?? 0) >> 2) & 7;
    const { transfer } = this;
    if (transfer !== undefined) transfer.data.length = Math.max(transfer.data.length - unused, 0);
    this.blocks = "none";
    const rows = [
      { name: "Bytes of the last segment", value: String(7 - unused) },
      { name: "CRC", value: wordText(unsignedOf(data, 1, 2)), raw: hexOf(data.slice(1, 3), " ") },
    ];
    return this.plain(text, rows);
  }

  private abort(data: Uint8Array, isRequest: boolean): SdoStep {
    const code = unsignedOf(data, kDataAt, 4);
    const { transfer } = this;
    if (transfer?.state === "open" || transfer?.state === "done") Object.assign(transfer, { state: "aborted", abortCode: code });
    this.blocks = "none";
    const rows = [
      { name: "Abort code", value: abortText(code), raw: wordText(code, 8) },
      { name: "By", value: isRequest ? "the client" : "the server" },
    ];
    return { text: `abort ${abortText(code)}`, rows, object: objectIn(data), begins: false };
  }
}

function toggleOf(first: number): Fields[number] {
  return { name: "Toggle bit", value: String(bit(first, 4)) };
}

function unknown(first: number): SdoStep {
  const text = `command specifier ${first >> 5}`;
  return { text, rows: [], remark: `${text} is none of CiA 301`, begins: false };
}
