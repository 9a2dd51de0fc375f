'use strict';

/*
 * A small CANopen slave on npm socketcan, built on no CANopen library: slave.js INTERFACE EDS [MANNER]
 *
 * Serves the objects of EDS as node 5, says "ready" on standard error, and has one MANNER of slaves in the field:
 *   long-commands   obeys NMT commands of any length from two bytes on
 *   short-requests  answers SDO requests of fewer than eight bytes
 *   pending-error   has error 5000h, shows it in 1001h, and does not enter Operational
 *   echoed-aborts   answers aborts of the client by the same abort
 *   ends-on-reset   its process ends with a reset of the node
 */

const fs = require('fs');
const socketcan = require('socketcan');

const NODE = 5;
const SIZES = { 5: 1, 6: 2, 7: 4 };
const State = { STOPPED: 4, OPERATIONAL: 5, PRE_OPERATIONAL: 127 };
const Code = {
  TOGGLE: 0x05030000, COMMAND: 0x05040001, READ_ONLY: 0x06010002, NO_OBJECT: 0x06020000, NOT_MAPPABLE: 0x06040041,
  PDO_LENGTH: 0x06040042, INCOMPATIBLE: 0x06040043, TOO_LONG: 0x06070012, TOO_SHORT: 0x06070013,
  NO_SUB_INDEX: 0x06090011, INVALID: 0x06090030, STATE: 0x08000022,
};
const RESTRICTED = [[0, 0x7f], [0x101, 0x180], [0x581, 0x5ff], [0x601, 0x67f], [0x6e0, 0x6ff], [0x701, 0x77f]];
const invalid = (cobId) => cobId >= 0x80000000;

class Abort extends Error {
  constructor(code) {
    super();
    this.code = code;
  }
}

const key = (index, sub) => index * 256 + sub;

/** The objects of an EDS by key(). */
function readObjects(path) {
  const objects = new Map();
  for (const part of fs.readFileSync(path, 'ascii').split(/^\[/m)) {
    const [, index, , sub] = /^([0-9A-F]{4})(sub([0-9A-F]+))?\]/.exec(part) || [];
    const value = (name) => (new RegExp(`^${name}=(.*)$`, 'm').exec(part) || [])[1];
    if (!index || !value('DataType')) continue;
    const size = SIZES[Number(value('DataType'))];
    const text = value('DefaultValue') || '';
    let initial = text ? Buffer.from(text) : Buffer.alloc(100, 0x5a);
    if (size) {
      const relative = text.startsWith('$NODEID+');
      initial = Buffer.alloc(size);
      initial.writeUIntLE(Number(relative ? text.slice(8) : text) + (relative ? NODE : 0), 0, size);
    }
    objects.set(key(parseInt(index, 16), parseInt(sub || '0', 16)),
      { size, initial, value: initial, access: value('AccessType'), mappable: value('PDOMapping') === '1' });
  }
  return objects;
}

class Slave {
  constructor(channel, objects, manner) {
    this.channel = channel;
    this.objects = objects;
    this.manner = manner;
    this.boot(true);
  }

  send(id, data) {
    this.channel.send({ id, ext: false, rtr: false, data: Buffer.from(data) });
  }

  number(index, sub = 0) {
    const { value, size } = this.objects.get(key(index, sub));
    return value.readUIntLE(0, size);
  }

  boot(all) {
    for (const [at, object] of this.objects) if (all || at < key(0x2000, 0)) object.value = object.initial;
    if (this.manner === 'pending-error') this.objects.get(key(0x1001, 0)).value = Buffer.from([1]);
    this.state = State.PRE_OPERATIONAL;
    this.transfer = null;
    this.beat();
    this.send(0x700 + NODE, [0]);
  }

  beat() {
    clearInterval(this.timer);
    const period = this.number(0x1017);
    if (period) this.timer = setInterval(() => this.send(0x700 + NODE, [this.state]), period);
  }

  command(data) {
    const wrong = this.manner === 'long-commands' ? data.length < 2 : data.length !== 2;
    if (wrong || (data[1] !== 0 && data[1] !== NODE)) return;
    if (data[0] === 1 && this.manner === 'pending-error') {
      this.send(0x80 + NODE, [0x00, 0x50, 0x01, 0, 0, 0, 0, 0]);
    } else if (data[0] === 1) {
      const entered = this.state !== State.OPERATIONAL;
      this.state = State.OPERATIONAL;
      if (entered) this.sendTpdos();
    } else if (data[0] === 2) {
      this.state = State.STOPPED;
    } else if (data[0] === 128) {
      this.state = State.PRE_OPERATIONAL;
    } else if (data[0] === 129 && this.manner === 'ends-on-reset') {
      process.exit(0);
    } else if (data[0] === 129 || data[0] === 130) {
      this.boot(data[0] === 129);
    }
  }

  mapped(index) {
    const objects = [];
    for (let sub = 1; sub <= this.number(index); ++sub) objects.push(this.objects.get(this.number(index, sub) >>> 8));
    return objects;
  }

  sendTpdos() {
    for (const number of [0, 1]) {
      const cobId = this.number(0x1800 + number, 1);
      if (!invalid(cobId)) this.send(cobId & 0x7ff, Buffer.concat(this.mapped(0x1a00 + number).map(({ value }) => value)));
    }
  }

  takeRpdo(id, data) {
    for (const number of [0, 1]) {
      const objects = this.mapped(0x1600 + number);
      const length = objects.reduce((sum, { size }) => sum + size, 0);
      const cobId = this.number(0x1400 + number, 1);
      if (invalid(cobId) || (cobId & 0x7ff) !== id || data.length < length) continue;
      let at = 0;
      for (const object of objects) object.value = Buffer.from(data.subarray(at, (at += object.size)));
    }
  }

  judgeCobId(index, value) {
    const before = this.number(index, 1);
    const remote = index >= 0x1800 && !(value & 0x40000000); // remote requests are not answered
    if (remote || value & 0x20000000) throw new Abort(Code.INVALID);
    if (invalid(value)) return;
    const id = value & 0x7ff;
    const moved = !invalid(before) && id !== (before & 0x7ff);
    if (moved || RESTRICTED.some(([low, high]) => id >= low && id <= high)) throw new Abort(Code.INVALID);
    if (this.number(index + 0x200) === 0) throw new Abort(Code.INCOMPATIBLE);
  }

  judgeMapping(index, sub, value) {
    if (!invalid(this.number(index - 0x200, 1))) throw new Abort(Code.STATE);
    if (sub === 0 && value > 2) throw new Abort(Code.PDO_LENGTH);
    if (sub !== 0 && this.number(index) !== 0) throw new Abort(Code.STATE);
    let words = value ? [value] : [];
    if (sub === 0) words = [1, 2].slice(0, value).map((each) => this.number(index, each));
    for (const word of words) {
      const object = this.objects.get(word >>> 8);
      if (word && !object) throw new Abort(Code.NO_OBJECT);
      const fits = object && object.mappable && (word & 0xff) === 8 * object.size;
      if (!fits || (index < 0x1a00) !== (object.access === 'rww')) throw new Abort(Code.NOT_MAPPABLE);
    }
  }

  find(index, sub) {
    const object = this.objects.get(key(index, sub));
    if (object) return object;
    throw new Abort([...this.objects.keys()].some((each) => each >> 8 === index) ? Code.NO_SUB_INDEX : Code.NO_OBJECT);
  }

  write(index, sub, data) {
    const object = this.find(index, sub);
    if (object.access === 'ro' || object.access === 'const') throw new Abort(Code.READ_ONLY);
    if (data.length !== object.size) throw new Abort(data.length > object.size ? Code.TOO_LONG : Code.TOO_SHORT);
    const value = data.readUIntLE(0, object.size);
    const parameters = (index >= 0x1400 && index < 0x1600) || (index >= 0x1800 && index < 0x1a00);
    if (parameters && sub === 1) this.judgeCobId(index, value);
    if (parameters && sub === 2 && value > 240 && value < 254) throw new Abort(Code.INVALID);
    if (!parameters && index >= 0x1600 && index < 0x1c00) this.judgeMapping(index, sub, value);
    if (index === 0x1016 && (value & 0x7f0000) && (value & 0xffff)) {
      const other = this.number(index, sub === 1 ? 2 : 1);
      if ((other & 0x7f0000) === (value & 0x7f0000)) throw new Abort(Code.INCOMPATIBLE);
    }
    object.value = Buffer.from(data);
    if (index === 0x1017) this.beat();
  }

  answer(...parts) {
    const frame = Buffer.alloc(8);
    Buffer.concat(parts.map((part) => Buffer.from(part))).copy(frame);
    this.send(0x580 + NODE, frame);
  }

  upload(index, sub, head) {
    const { value } = this.find(index, sub);
    if (value.length <= 4) {
      this.answer([0x43 | (4 - value.length) << 2], head, value);
    } else {
      this.transfer = { up: true, index, sub, left: value, toggle: 0 };
      this.answer([0x41], head, [value.length, 0, 0, 0]);
    }
  }

  download(command, index, sub, head, data) {
    const object = this.find(index, sub);
    if (command & 2) {
      this.write(index, sub, data.subarray(0, command & 1 ? 4 - (command >> 2 & 3) : object.size || 4));
    } else {
      if (object.access === 'ro' || object.access === 'const') throw new Abort(Code.READ_ONLY);
      const size = command & 1 ? data.readUInt32LE(0) : object.size;
      if (size !== object.size) throw new Abort(size > object.size ? Code.TOO_LONG : Code.TOO_SHORT);
      this.transfer = { up: false, index, sub, taken: Buffer.alloc(0), toggle: 0 };
    }
    this.answer([0x60], head);
  }

  segment(command, data) {
    const { transfer } = this;
    if (!transfer || transfer.up !== (command >> 5 === 3)) throw new Abort(Code.COMMAND);
    if ((command & 0x10) !== transfer.toggle) throw new Abort(Code.TOGGLE);
    transfer.toggle ^= 0x10;
    if (transfer.up) {
      const part = transfer.left.subarray(0, 7);
      transfer.left = transfer.left.subarray(7);
      const last = transfer.left.length === 0;
      if (last) this.transfer = null;
      this.answer([(command & 0x10) | (7 - part.length) << 1 | (last ? 1 : 0)], part);
      return;
    }
    transfer.taken = Buffer.concat([transfer.taken, data.subarray(0, 7 - (command >> 1 & 7))]);
    if (transfer.taken.length > this.find(transfer.index, transfer.sub).size) throw new Abort(Code.TOO_LONG);
    if (command & 1) {
      this.transfer = null;
      this.write(transfer.index, transfer.sub, transfer.taken);
    }
    this.answer([0x20 | (command & 0x10)]);
  }

  request(received) {
    if (this.state === State.STOPPED || (received.length < 8 && this.manner !== 'short-requests')) return;
    const data = Buffer.alloc(8);
    received.copy(data);
    const [command] = data;
    const head = data.subarray(1, 4);
    let [index, sub] = [head.readUInt16LE(0), head[2]];
    const goesOn = command >> 5 === 0 || command >> 5 === 3;
    try {
      if (goesOn) {
        if (this.transfer) ({ index, sub } = this.transfer);
        this.segment(command, data.subarray(1));
        return;
      }
      this.transfer = null;
      if (command >> 5 === 4) {
        if (this.manner === 'echoed-aborts') this.answer(data);
      } else if (command >> 5 === 2) {
        this.upload(index, sub, head);
      } else if (command >> 5 === 1) {
        this.download(command, index, sub, head, data.subarray(4));
      } else {
        throw new Abort(Code.COMMAND);
      }
    } catch (error) {
      if (!(error instanceof Abort)) throw error;
      this.transfer = null;
      const code = Buffer.alloc(4);
      code.writeUInt32LE(error.code);
      this.answer([0x80, index & 0xff, index >> 8, sub], code);
    }
  }

  receive({ id, data, rtr, ext }) {
    if (rtr || ext) return;
    if (id === 0) this.command(data);
    else if (id === 0x600 + NODE) this.request(data);
    else if (this.state === State.OPERATIONAL) this.takeRpdo(id, data);
  }
}

const [name, eds, manner] = process.argv.slice(2);
const channel = socketcan.createRawChannel(name);
let slave = null;
channel.addListener('onMessage', (frame) => slave && slave.receive(frame));
channel.start();
slave = new Slave(channel, readObjects(eds), manner);
console.error('ready');
