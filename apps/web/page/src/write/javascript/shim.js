// What a program in JavaScript finds in the page as it does under node: lines of standard input, two streams to write to,
// and the few modules that mice use. The program stands behind it, in the function that is given to `labmouse`.
var labmouse = (() => {
  'use strict';
  const post = self.postMessage.bind(self);
  const close = self.close.bind(self);
  const linesBefore = 0; /* set by the page */

  // Two writes of one turn go out together, as through a pipe.
  let written = '';
  let waits = false;
  function flush() {
    waits = false;
    const end = written.lastIndexOf('\n');
    const lines = end < 0 ? [] : written.slice(0, end).split('\n');
    written = written.slice(end + 1);
    post({ kind: 'reply', lines, rest: written });
  }
  function write(text) {
    written += text;
    if (!waits) queueMicrotask(flush);
    waits = true;
    return true;
  }
  function print(text) {
    post({ kind: 'print', text: String(text) });
    return true;
  }

  function shown(value, depth = 0) {
    if (typeof value === 'string') return depth === 0 ? value : `'${value}'`;
    if (typeof value === 'bigint') return `${value}n`;
    if (typeof value === 'function') return `[Function: ${value.name || '(anonymous)'}]`;
    if (value instanceof Error) return String(value.stack || value);
    if (typeof value !== 'object' || value === null) return Object.is(value, -0) ? '-0' : String(value);
    if (depth > 2) return Array.isArray(value) ? '[Array]' : '[Object]';
    const inner = (one) => shown(one, depth + 1);
    const within = (open, items, end) => (items.length > 0 ? `${open} ${items.join(', ')} ${end}` : `${open}${end}`);
    if (Array.isArray(value)) return within('[', value.map(inner), ']');
    if (value instanceof Set) return within(`Set(${value.size}) {`, [...value].map(inner), '}');
    if (value instanceof Map)
      return within(
        `Map(${value.size}) {`,
        [...value].map(([key, one]) => `${inner(key)} => ${inner(one)}`),
        '}',
      );
    return within(
      '{',
      Object.entries(value).map(([key, one]) => `${key}: ${inner(one)}`),
      '}',
    );
  }
  const line = (values) => `${values.map((value) => shown(value)).join(' ')}\n`;

  class Emitter {
    #listeners = new Map();
    on(name, listener) {
      this.#listeners.set(name, [...(this.#listeners.get(name) ?? []), listener]);
      this.listened?.(name);
      return this;
    }
    once(name, listener) {
      const once = (...values) => (this.off(name, once), listener(...values));
      return this.on(name, once);
    }
    off(name, listener) {
      this.#listeners.set(
        name,
        (this.#listeners.get(name) ?? []).filter((one) => one !== listener),
      );
      return this;
    }
    addListener(name, listener) {
      return this.on(name, listener);
    }
    removeListener(name, listener) {
      return this.off(name, listener);
    }
    removeAllListeners(name) {
      this.#listeners.delete(name);
      return this;
    }
    emit(name, ...values) {
      const listeners = this.#listeners.get(name) ?? [];
      for (const listener of listeners) listener(...values);
      return listeners.length > 0;
    }
    listenerCount(name) {
      return (this.#listeners.get(name) ?? []).length;
    }
  }

  // Texts that wait until somebody listens for them, under that name or by a loop.
  class Source extends Emitter {
    #name;
    #waiting = [];
    #taker = null;
    constructor(name) {
      super();
      this.#name = name;
    }
    listened(name) {
      if (name === this.#name) queueMicrotask(() => this.#waiting.splice(0).forEach((text) => this.emit(name, text)));
    }
    give(text) {
      if (this.#taker) this.#taker(text);
      else if (this.listenerCount(this.#name) === 0 || this.#waiting.length > 0) this.#waiting.push(text);
      else this.emit(this.#name, text);
    }
    [Symbol.asyncIterator]() {
      const take = (resolve) => (text) => ((this.#taker = null), resolve({ value: text, done: false }));
      return {
        next: () =>
          new Promise((resolve) => {
            if (this.#waiting.length > 0) resolve({ value: this.#waiting.shift(), done: false });
            else this.#taker = take(resolve);
          }),
        return: async () => ({ value: undefined, done: true }),
        [Symbol.asyncIterator]() {
          return this;
        },
      };
    }
    setEncoding() {
      return this;
    }
    resume() {
      return this;
    }
    pause() {
      return this;
    }
    ref() {
      return this;
    }
    unref() {
      return this;
    }
  }
  const stdin = Object.assign(new Source('data'), { isTTY: false, fd: 0 });
  const readers = [];
  function createInterface() {
    const reader = Object.assign(new Source('line'), { close() {}, setPrompt() {}, prompt() {} });
    readers.push(reader);
    return reader;
  }

  function exit(code = 0) {
    flush();
    post({ kind: 'exited', code: Number(code) & 255 });
    close();
    throw new Error('process.exit');
  }
  const stream = (to, fd) => ({ write: (text) => to(String(text)), isTTY: false, fd, on() {}, once() {}, end() {} });
  const process = Object.assign(new Emitter(), {
    stdin,
    stdout: stream(write, 1),
    stderr: stream(print, 2),
    argv: ['node', 'mouse.js'],
    env: {},
    exit,
    nextTick: (act, ...values) => queueMicrotask(() => act(...values)),
    hrtime: Object.assign(() => [Math.floor(performance.now() / 1e3), Math.floor((performance.now() % 1e3) * 1e6)], {
      bigint: () => BigInt(Math.floor(performance.now() * 1e6)),
    }),
    cwd: () => '/',
    uptime: () => performance.now() / 1e3,
    memoryUsage: () => ({ heapUsed: 0, heapTotal: 0, rss: 0 }),
    platform: 'browser',
    version: 'v20.0.0',
    versions: {},
    pid: 1,
  });
  const console = {};
  for (const name of ['log', 'info', 'debug']) console[name] = (...values) => void write(line(values));
  for (const name of ['error', 'warn', 'trace']) console[name] = (...values) => void print(line(values));
  console.assert = (truth, ...values) => void (truth || print(line(['Assertion failed', ...values])));
  console.time = console.timeEnd = console.group = console.groupEnd = () => undefined;

  const modules = {
    readline: { createInterface },
    process,
    events: Object.assign(Emitter, { EventEmitter: Emitter }),
    util: { inspect: (value) => shown(value, 1), format: (...values) => line(values).slice(0, -1) },
    os: { EOL: '\n' },
    perf_hooks: { performance },
    fs: {
      readFileSync() {
        throw new Error(
          'files and the whole of standard input cannot be read in the page; read line by line, by readline',
        );
      },
    },
  };
  function require(name) {
    const module = modules[String(name).replace(/^node:/, '')];
    if (module) return module;
    throw new Error(`Cannot find module '${name}' in the page; it has ${Object.keys(modules).join(', ')}`);
  }

  // Where in the program an error began: the first place of its stack that is not in here.
  const placed = (line) => (line > linesBefore ? line - linesBefore : null);
  function lineOf(error) {
    for (const [, line] of String(error?.stack ?? '').matchAll(/blob:[^\s)]*?:(\d+):\d+/g))
      if (placed(Number(line))) return placed(Number(line));
    return null;
  }
  function fail(event, message, line) {
    event.preventDefault();
    if (written) flush();
    post({ kind: 'failed', message, line });
    close();
  }
  self.addEventListener('error', (event) =>
    fail(event, String(event.message), lineOf(event.error) ?? placed(event.lineno)),
  );
  self.addEventListener('unhandledrejection', (event) => {
    const { reason } = event;
    fail(event, reason instanceof Error ? String(reason) : shown(reason), lineOf(reason));
  });

  Object.assign(self, {
    console,
    process,
    global: self,
    setImmediate: (act, ...values) => setTimeout(act, 0, ...values),
  });
  return (program) => {
    self.onmessage = ({ data }) => {
      if (data.kind === 'hear') {
        stdin.give(`${data.line}\n`);
        for (const reader of readers) reader.give(data.line);
        return;
      }
      const module = { exports: {} };
      program(module.exports, require, module, 'mouse.js', '.');
      post({ kind: 'ready' });
    };
  };
})();
