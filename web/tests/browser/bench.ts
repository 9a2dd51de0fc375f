// A bench for tests of the page: units on the bus of with-can, the gateway, and a browser, in a folder of their own.
import { execFileSync, spawn, type ChildProcess } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { chromium, type Browser, type Page } from "playwright-core";

/** Longest wait for what should come at once (ms): machines of others are slow. */
export const kPatience = 30_000;

/** Where the programs are: build/release/bin. */
export const kBin: string = process.env["AXISD_BIN"] ?? "../build/release/bin";

/** A program and what it has written so far to standard error. */
class Program {
  private text = "";
  private readonly name: string;
  private readonly process: ChildProcess;
  private readonly waiting: (() => void)[] = [];

  constructor(name: string, words: string[], environment: NodeJS.ProcessEnv) {
    this.name = name;
    this.process = spawn(join(kBin, name), words, { env: environment, stdio: ["ignore", "ignore", "pipe"] });
    this.process.stderr?.on("data", (part: Buffer) => {
      this.text += part.toString();
      this.waiting.forEach((look) => look());
    });
    this.process.on("exit", () => this.waiting.forEach((look) => look()));
  }

  /** Waits until @param pattern has been written. */
  expect(pattern: RegExp): Promise<RegExpExecArray> {
    return new Promise((done, fail) => {
      const late = setTimeout(() => fail(new Error(`${this.name} has not written ${pattern.source}, only: ${this.text}`)), kPatience);
      const look = (): void => {
        const found = pattern.exec(this.text);
        if (found === null) return;
        clearTimeout(late);
        done(found);
      };
      this.waiting.push(look);
      look();
    });
  }

  /** Ends it by @param signal and waits until it has ended. */
  end(signal: NodeJS.Signals = "SIGTERM"): Promise<void> {
    return new Promise((done) => {
      if (this.process.exitCode !== null || this.process.signalCode !== null) { done(); return; }
      this.process.once("exit", () => done());
      this.process.kill(signal);
    });
  }

  get id(): number {
    return this.process.pid ?? 0;
  }
}

export interface BenchOptions {
  /** Configuration of the unit with node-ID 5. */
  config?: object;
  readOnly?: boolean;
  viewport?: { width: number; height: number };
  colorScheme?: "light" | "dark";
}

/** Units, gateway and browser. */
export class Bench {
  private readonly folder = mkdtempSync(join(tmpdir(), "axisd-web-"));
  private readonly environment: NodeJS.ProcessEnv;
  private readonly options: BenchOptions;
  private browser: Browser | undefined;
  private readonly programs: Program[] = [];
  unit!: Program;
  gateway!: Program;
  page!: Page;
  /** Where the gateway serves. */
  url = "";
  /** What the page has written to the console as errors, and what it could not load. */
  readonly complaints: string[] = [];

  private constructor(options: BenchOptions) {
    this.options = options;
    this.environment = { HOME: this.folder, XDG_RUNTIME_DIR: this.folder, PATH: process.env["PATH"] };
  }

  static async start(options: BenchOptions = {}): Promise<Bench> {
    const bench = new Bench(options);
    await bench.startUnit(5, options.config ?? { axes: [{ name: "X", parameters: { p1120: 0.5, p1121: 0.5 } }] });
    await bench.startGateway();
    await bench.openBrowser();
    return bench;
  }

  /** Another unit on the bus; the one with node-ID 5 is `unit`. */
  async startUnit(node: number, config: object): Promise<Program> {
    const path = join(this.folder, `axisd-${node}.json`);
    writeFileSync(path, JSON.stringify(config));
    const bus = `unix:${process.env["CAN_BUS"] ?? ""}`;
    const unit = this.start("axisd", ["--interface", bus, "--node-id", String(node), "--config", path]);
    await unit.expect(/ready: node/);
    if (node === 5) this.unit = unit;
    return unit;
  }

  /** The gateway; a second start serves at the same address as the first. */
  async startGateway(): Promise<void> {
    const address = this.url === "" ? "127.0.0.1:0" : new URL(this.url).host;
    const words = ["--listen", address, "--token-file", join(this.folder, "token")];
    if (this.options.readOnly) words.push("--read-only");
    this.gateway = this.start("axisd-http", words);
    this.url = (await this.gateway.expect(/ready: (http:\S+)/))[1] ?? "";
  }

  get token(): string {
    return readFileSync(join(this.folder, "token"), "utf8").trim();
  }

  /** What axisctl prints. */
  axisctl(...words: string[]): string {
    return execFileSync(join(kBin, "axisctl"), words, { env: this.environment, encoding: "utf8" });
  }

  /** Sends frames as cansend does, from a member of the bus. */
  cansend(frame: string): void {
    execFileSync("cansend", ["vcan0", frame], { env: process.env });
  }

  path(name: string): string {
    return join(this.folder, name);
  }

  /** Waits until the gateway has told the page of a unit that answers. */
  async untilUnitIsThere(): Promise<void> {
    await this.page.waitForResponse(async (response) =>
      response.url().includes("/api/v1/overview") && response.ok() && /"axes":\[\{/.test(await response.text()));
  }

  /** Shows @param hash of the page. */
  async show(hash: string): Promise<void> {
    await this.page.goto(`${this.url}${hash}`);
    await this.page.getByRole("heading", { level: 1 }).first().waitFor({ timeout: kPatience });
  }

  /** Gives the page the token, as a user does. */
  async giveToken(text = this.token): Promise<void> {
    await this.page.getByRole("button", { name: "Token", exact: true }).click();
    await this.page.getByLabel("Token", { exact: true }).fill(text);
    await this.page.getByRole("button", { name: "Use it" }).click();
  }

  async close(): Promise<void> {
    await this.browser?.close();
    for (const program of this.programs.reverse()) await program.end("SIGKILL");
    rmSync(this.folder, { recursive: true, force: true });
  }

  private start(name: string, words: string[]): Program {
    const program = new Program(name, words, this.environment);
    this.programs.push(program);
    return program;
  }

  private async openBrowser(): Promise<void> {
    this.browser = await openChromium();
    const context = await this.browser.newContext({
      viewport: this.options.viewport ?? { width: 1280, height: 800 },
      colorScheme: this.options.colorScheme ?? "light",
      acceptDownloads: true,
    });
    context.setDefaultTimeout(kPatience);
    this.page = await context.newPage();
    this.page.on("console", (message) => {
      if (message.type() === "error") this.complaints.push(message.text());
    });
    this.page.on("pageerror", (error) => this.complaints.push(error.message));
  }
}

/** Debian's Chromium, which is not to join the bus: it would be preloaded with what programs of with-can are. */
export function openChromium(): Promise<Browser> {
  const environment = { ...process.env };
  delete environment["LD_PRELOAD"];
  return chromium.launch({
    executablePath: process.env["CHROMIUM"] ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-dev-shm-usage"],
    env: environment,
    timeout: 2 * kPatience,
  });
}
