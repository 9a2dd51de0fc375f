/** CRC-32 of each byte (ISO-HDLC, reflected polynomial EDB88320h), that of zlib. */
const kTable = Uint32Array.from({ length: 256 }, (_, byte) => {
  let value = byte;
  for (let bit = 0; bit < 8; ++bit) value = (value & 1) === 1 ? (value >>> 1) ^ 0xedb88320 : value >>> 1;
  return value;
});

/** CRC-32 of @param bytes from @param begin to before @param end. */
export function crc32(bytes: Uint8Array, begin = 0, end = bytes.length): number {
  let value = 0xffffffff;
  for (let i = begin; i < end; ++i) value = (value >>> 8) ^ (kTable[(value ^ (bytes[i] ?? 0)) & 0xff] ?? 0);
  return (value ^ 0xffffffff) >>> 0;
}
