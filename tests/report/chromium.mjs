// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A headless Chromium driven over its DevTools pipe: no port, no package. It has no network: every name is unknown to it.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const answerTimeout = 60_000;

export class Chromium {
  #process;
  #profile = mkdtempSync(join(tmpdir(), "glider-report-"));
  #next = 1;
  #waiting = new Map();
  #listeners = [];
  #rest = "";

  constructor(program) {
    this.#process = spawn(program, [
      "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync", "--hide-scrollbars", "--host-resolver-rules=MAP * ~NOTFOUND",
      `--user-data-dir=${this.#profile}`, "--remote-debugging-pipe", "about:blank",
    ], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"], detached: true });
    this.#process.stdio[4].setEncoding("utf8").on("data", (text) => this.#take(text));
    this.#process.stdio[3].on("error", () => {});
    this.#process.on("error", (error) => this.#failAll(error));
    this.#process.on("exit", () => this.#failAll(new Error("the browser ended")));
  }

  #failAll(error) {
    for (const { reject } of this.#waiting.values()) reject(error);
    this.#waiting.clear();
  }

  #take(text) {
    const pieces = (this.#rest + text).split("\0");
    this.#rest = pieces.pop();
    for (const message of pieces.map((piece) => JSON.parse(piece))) {
      const waiting = this.#waiting.get(message.id);
      this.#waiting.delete(message.id);
      if (!waiting) this.#listeners.forEach((listener) => listener(message));
      else if (message.error) waiting.reject(new Error(message.error.message));
      else waiting.resolve(message.result);
    }
  }

  send(method, params = {}, sessionId = undefined) {
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      const timer = setTimeout(() => reject(new Error(`${method}: no answer`)), answerTimeout);
      const done = (act) => (value) => { clearTimeout(timer); act(value); };
      this.#waiting.set(id, { resolve: done(resolve), reject: done(reject) });
      this.#process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    });
  }

  /** Opens `url` in a new page of this size and waits until the report in it is drawn. */
  async open(url, width = 1500, height = 1000) {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    const page = new Page(this, sessionId, targetId);
    this.#listeners.push((message) => { if (message.sessionId === sessionId) page.note(message); });
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await page.send(`${domain}.enable`);
    await page.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: false });
    await page.send("Page.navigate", { url });
    return page;
  }

  async close() {
    const ended = new Promise((resolve) => this.#process.once("exit", resolve));
    await this.send("Browser.close").catch(() => process.kill(-this.#process.pid, "SIGKILL"));
    await ended;
    rmSync(this.#profile, { recursive: true, force: true, maxRetries: 10, retryDelay: 100 });
  }
}

class Page {
  /** Errors and warnings that the page caused. */
  complaints = [];
  /** Addresses that the page asked for, its own and data: left out. */
  requests = [];

  constructor(browser, sessionId, targetId) {
    Object.assign(this, { browser, sessionId, targetId });
  }

  send(method, params) { return this.browser.send(method, params, this.sessionId); }

  note({ method, params }) {
    if (method === "Runtime.exceptionThrown") this.complaints.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === "Runtime.consoleAPICalled" && ["error", "warning"].includes(params.type)) {
      this.complaints.push(params.args.map((a) => a.value ?? a.description).join(" "));
    }
    // A test that looks at pixels causes the last one itself.
    if (method === "Log.entryAdded" && ["error", "warning"].includes(params.entry.level) && !params.entry.text.includes("willReadFrequently")) this.complaints.push(params.entry.text);
    if (method === "Network.requestWillBeSent" && !/^(file|data|about):/.test(params.request.url)) this.requests.push(params.request.url);
  }

  /** The value of `expression` in the page. */
  async eval(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", { expression, returnByValue: true, awaitPromise: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /** Waits until `expression` is true in the page. */
  async until(expression) {
    for (let tries = 0; tries < 300; ++tries) {
      // While the page is being opened there may be no document to ask.
      if (await this.eval(expression).catch(() => false)) return;
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    throw new Error(`never true: ${expression}; ${this.complaints.join("; ")}`);
  }

  async mouse(type, x, y, more = {}) { await this.send("Input.dispatchMouseEvent", { type, x, y, ...more }); }

  async key(key) {
    const text = key.length === 1 ? { text: key } : {};
    await this.send("Input.dispatchKeyEvent", { type: "keyDown", key, ...text });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", key });
  }

  async close() { await this.browser.send("Target.closeTarget", { targetId: this.targetId }); }
}
