'use strict';

const assert = require('assert');

const DOMAIN = 0x2001;
const CRC_ERROR = 0x05040004;
const LARGE = 100000; // bytes
const SEGMENT = 7;
const SEGMENTS = 127; // of a sub-block at most

/** Sizes around those of a segment and of a sub-block. */
const SIZES = [1, 4, 5, 7, 8, SEGMENT * SEGMENTS - 1, SEGMENT * SEGMENTS, SEGMENT * SEGMENTS + 1, LARGE];

/** Bytes without a short period, other ones for each salt. */
const pattern = (size, salt = 0) => Buffer.from(Array.from({ length: size }, (_, i) => i * 167 + (i >> 8) * 59 + salt));

const asBlock = { blockTransfer: true, blockInterval: 0 };

async function bootUp({ bootUp: frame }) {
  const { id, data } = await frame;
  assert.deepStrictEqual([...data], [0]);
  return `${id.toString(16)}h with 00`;
}

function compare(actual, expected) {
  const at = actual.findIndex((byte, i) => byte !== expected[i]);
  assert.ok(actual.equals(expected), `${actual.length} of ${expected.length} bytes came, others from byte ${at} on`);
}

async function segmented({ node }) {
  const data = pattern(1000);
  await node.write(DOMAIN, 0, data);
  compare(await node.read(DOMAIN), data);
  return `${data.length} bytes there and back`;
}

/** Downloads by block transfer; the server must offer the CRC (bit 2 of its first answer). */
async function blockDownload(node, data) {
  const answer = node.frame(0x580 + node.id);
  await node.write(DOMAIN, 0, data, undefined, asBlock);
  assert.strictEqual((await answer).data[0], 0xA4, 'first answer to the block download');
}

/** Uploads by block transfer, of which the master checks size and CRC; the server must offer both. */
async function blockUpload(node) {
  const answer = node.frame(0x580 + node.id);
  const data = await node.read(DOMAIN, 0, undefined, asBlock);
  assert.strictEqual((await answer).data[0], 0xC6, 'first answer to the block upload');
  return data;
}

async function blocks({ node }) {
  for (const [salt, size] of SIZES.entries()) {
    const data = pattern(size, salt);
    await blockDownload(node, data);
    compare(await blockUpload(node), data);
  }
  return `${SIZES.join(', ')} bytes there and back, with CRC`;
}

async function smallBlocks({ node }) {
  const data = pattern(1000, 99);
  await blockDownload(node, data);
  for (const size of [1, 2, 10]) {
    node.master.sdo.setBlockSize(size);
    compare(await blockUpload(node), data);
  }
  node.master.sdo.setBlockSize(SEGMENTS);
  return 'sub-blocks of 1, 2 and 10 segments';
}

async function damaged({ node, bus }) {
  bus.tamper = (frame) => {
    const isEnd = frame.id === 0x600 + node.id && (frame.data[0] & 0xE3) === 0xC1 && frame.data.readUInt32LE(3) === 0;
    if (isEnd) frame.data[1] ^= 1; // the CRC
    return frame;
  };
  await node.refused(node.write(DOMAIN, 0, pattern(LARGE, 1), undefined, asBlock), CRC_ERROR, 'block with a wrong CRC');
  bus.tamper = (frame) => frame;
  const data = pattern(500, 2);
  await blockDownload(node, data);
  compare(await node.read(DOMAIN), data);
  return '05040004h, and the next transfer is in order';
}

module.exports = [
  { name: 'boot-up message', run: bootUp },
  { name: 'SDO segmented download and upload', run: segmented },
  { name: 'SDO block download and upload', run: blocks },
  { name: 'SDO block upload in small sub-blocks', run: smallBlocks },
  { name: 'SDO block download with a wrong CRC', run: damaged },
];
