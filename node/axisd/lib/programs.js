'use strict';
// Programs and folders of which nothing is left, whatever ends this process.
const { spawn } = require('node:child_process');
const { EventEmitter } = require('node:events');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { Ended, Missing, Timeout } = require('./errors');

const OWN = ['axisd', 'canhub', 'with-can'];
const KEPT_LINES = 200;
const TOLD_LINES = 10;
const LONGEST_END = 5000; // ms, from SIGTERM to SIGKILL
const NOT_INHERITED = ['NOTIFY_SOCKET', 'WATCHDOG_USEC', 'WATCHDOG_PID', 'STATE_DIRECTORY', 'RUNTIME_DIRECTORY', 'CAN_BUS', 'LD_PRELOAD'];

function isProgram(file) {
  try {
    fs.accessSync(file, fs.constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/** The path of a program: one of axisd in $AXISD_BIN_DIR if that is set, else in the build or the sources around, else in PATH; throws Missing. */
function find(name) {
  const folder = OWN.includes(name) ? process.env.AXISD_BIN_DIR : '';
  const around = path.resolve(__dirname, '../../..');
  const places = folder ? [folder]
    : [path.join(around, 'bin'), path.join(around, 'build/release/bin'), ...(process.env.PATH ?? '').split(':').filter(Boolean)];
  const found = places.map((place) => path.join(place, name)).find(isProgram);
  if (found) return found;
  throw new Missing(folder ? `${name}: not in $AXISD_BIN_DIR (${folder})`
    : `${name}: neither in PATH nor around the package; install axisd, can-userbus and can-utils`);
}

/** A promise that is rejected with a Timeout after `ms`; `message` makes its text. */
function within(ms, promise, message) {
  let timer;
  const late = new Promise((_, reject) => { timer = setTimeout(() => reject(new Timeout(message())), ms); });
  return Promise.race([promise, late]).finally(() => clearTimeout(timer));
}

/** A running program: emits `line` (standard error), `output` (lines of standard output) and `end`. */
class Program extends EventEmitter {
  constructor(words, environment = {}) {
    super();
    this.setMaxListeners(0);
    this.name = path.basename(words[0]);
    this.lines = [];
    this.how = '';
    const inherited = Object.entries(process.env).filter(([key]) => !NOT_INHERITED.includes(key));
    // It ends with this process, and is left alone by the keys of the terminal.
    this.process = spawn(find('setpriv'), ['--pdeathsig', 'KILL', ...words],
      { stdio: ['ignore', 'pipe', 'pipe'], detached: true, env: { ...Object.fromEntries(inherited), ...environment } });
    this.split(this.process.stderr, (line) => {
      this.lines = [...this.lines, line].slice(-KEPT_LINES);
      this.emit('line', line);
    });
    this.split(this.process.stdout, (line) => this.emit('output', line));
    this.hasEnded = new Promise((done) => {
      this.process.on('error', (error) => { this.how = error.message; done(); });
      this.process.on('close', (status, signal) => {
        this.how = signal ? `was ended by ${signal}` : `has ended with status ${status}`;
        this.status = status;
        done();
      });
    }).then(() => this.emit('end'));
  }

  /** Hands the lines of a stream to `take`. */
  split(stream, take) {
    let rest = '';
    stream.setEncoding('utf8').on('data', (text) => {
      const lines = (rest + text).split('\n');
      rest = lines.pop();
      lines.forEach(take);
    });
  }

  /** The first line on standard error that matches; rejects with Ended or Timeout. */
  expect(pattern, ms) {
    const found = this.lines.find((line) => pattern.test(line));
    if (found) return Promise.resolve(found);
    let look;
    const line = new Promise((done, fail) => {
      look = (text) => pattern.test(text) && done(text);
      this.on('line', look);
      this.hasEnded.then(() => fail(this.ended()));
    });
    return within(ms, line, () => `${this.name} has not written ${pattern} within ${ms} ms; ${this.told()}`)
      .finally(() => this.off('line', look));
  }

  /** The error that says that it has ended. */
  ended() { return new Ended(`${this.name} ${this.how || 'has closed its connections'}; ${this.told()}`); }

  told() { return this.lines.length ? `its log: ${this.lines.slice(-TOLD_LINES).join('\n')}` : 'it has written nothing'; }

  /** Ends it by SIGTERM, by SIGKILL if that takes long. */
  async end() {
    this.process.kill('SIGTERM');
    const timer = setTimeout(() => this.process.kill('SIGKILL'), LONGEST_END);
    await this.hasEnded;
    clearTimeout(timer);
  }
}

/** A new folder, which goes with remove(), and with this process: a shell waits for the end of a pipe. */
class Folder {
  constructor() {
    this.path = fs.mkdtempSync(path.join(os.tmpdir(), 'axisd-'));
    this.guard = spawn('/bin/sh', ['-c', 'read -r end; rm -rf -- "$1"', 'axisd-guard', this.path],
      { stdio: ['pipe', 'ignore', 'ignore'], detached: true, cwd: '/' });
    this.gone = new Promise((done) => { this.guard.on('close', done); });
    this.guard.unref();
    this.guard.stdin.on('error', () => {}).unref?.();
  }

  file(name) { return path.join(this.path, name); }

  async remove() {
    this.guard.ref();
    this.guard.stdin.end();
    await this.gone;
  }
}

module.exports = { Folder, Program, find, within };
