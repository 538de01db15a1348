// The worker of a robot in Python, in a browser, in a sandboxed frame that allows WebAssembly and nothing else.
import { writeFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { python } from '../../src/write/python/language';
import type { FromWorker } from '../../src/write/runtime';
import { open, proof, temporary } from './harness';

/** What a program says until it failed, answered or was silent for that time. */
async function played(program: string, patience = 20_000): Promise<FromWorker[]> {
  const file = temporary('frame.html');
  writeFileSync(file, '<!doctype html><title>frame</title><nav aria-label="Views">frame</nav>');
  const page = await open('', { file });
  const source = await python.workerSource(program);
  return page.evaluate(
    async ({ source, program, patience }) => {
      const policy = "default-src 'none'; script-src 'nonce-frame' 'wasm-unsafe-eval'; worker-src blob:";
      const script = `onmessage = ({ data, ports: [port] }) => {
        const worker = new Worker(URL.createObjectURL(new Blob([data], { type: 'text/javascript' })));
        worker.onmessage = (said) => port.postMessage(said.data);
        port.onmessage = (words) => worker.postMessage(words.data);
      };`;
      const frame = document.createElement('iframe');
      frame.setAttribute('sandbox', 'allow-scripts');
      frame.srcdoc = `<meta http-equiv="Content-Security-Policy" content="${policy}"><script nonce="frame">${script}</scr${'ipt>'}`;
      await new Promise((resolve) => {
        frame.onload = resolve;
        document.body.append(frame);
      });
      const { port1, port2 } = new MessageChannel();
      frame.contentWindow?.postMessage(source, '*', [port2]);
      port1.postMessage({ kind: 'start', program });
      for (const line of ['size 12 12', 'seed 1', 'begin', 'sense 0 11 0']) port1.postMessage({ kind: 'hear', line });
      const said: FromWorker[] = [];
      return new Promise<FromWorker[]>((resolve) => {
        const end = () => resolve(said);
        setTimeout(end, patience);
        port1.onmessage = ({ data }: MessageEvent<FromWorker>) => {
          said.push(data);
          if (data.kind === 'failed' || said.filter(({ kind }) => kind === 'reply').length === 2) end();
        };
      });
    },
    { source, program, patience },
  );
}

const last = async (program: string) => (await played(program)).at(-1);

it.runIf(proof)('plays every starting point', async () => {
  for (const { text } of python.templates)
    expect((await played(text)).map(({ kind }) => kind)).toEqual(['ready', 'reply', 'reply']);
});

it('calls as deep as a maze has cells, and hears of more', async () => {
  const depth = 'def depth(n):\n    return n if n == 0 else 1 + depth(n - 1)\n';
  expect(await played(`${depth}print(depth(256))\n`)).toContainEqual({ kind: 'print', text: '256\n' });
  const caught = `${depth}try:\n    depth(10 ** 6)\nexcept RecursionError:\n    print('caught')\n`;
  expect(await played(caught)).toContainEqual({ kind: 'print', text: 'caught\n' });
});

it('has an end of memory', async () => {
  expect(await last('hold = []\nwhile True:\n    hold.append([0] * 200000)\n')).toMatchObject({
    kind: 'failed',
    line: 3,
  });
});

it('shows what it printed before it hung', async () => {
  const said = await played('print("before")\nwhile True:\n    pass\n', 3000);
  expect(said).toContainEqual({ kind: 'print', text: 'before\n' });
  expect(said.at(-1)?.kind).toBe('print');
});

it('reaches no network by JavaScript', async () => {
  for (const code of [
    'js.fetch("https://example.org")',
    'js.eval("fetch(`https://example.org`)")',
    'js.importScripts("https://example.org")',
  ])
    expect(await last(`import js\n${code}\n`)).toMatchObject({ kind: 'failed', line: 2 });
});
