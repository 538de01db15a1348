// The script of the sandboxed frame, word for word as the page's policy has its hash. It starts workers from the text that
// the page sends, and hands on what they say, as long as they say no more than one can read.
'use strict';
{
  // Between two things that the page says to it, a program sends no more than so many messages and letters.
  const most = { messages: 5000, letters: 1e6 };

  const isText = (value) => typeof value === 'string';
  const isLine = (value) => Number.isSafeInteger(value) && value > 0;

  // What a worker said, rebuilt, for it may say anything; null where it means nothing.
  const read = (said) => {
    if (typeof said !== 'object' || said === null) return null;
    const { kind, lines, rest, text, message, line, code } = said;
    if (kind === 'ready') return { kind };
    if (kind === 'reply' && Array.isArray(lines) && lines.every(isText))
      return { kind, lines: [...lines], rest: isText(rest) ? rest : '' };
    if (kind === 'print' && isText(text)) return { kind, text };
    if (kind === 'failed' && isText(message)) return { kind, message, line: isLine(line) ? line : null };
    if (kind === 'exited') return { kind, code: Number.isSafeInteger(code) && code >= 0 && code < 256 ? code : 255 };
    return null;
  };
  const letters = ({ lines = [], rest = '', text = '', message = '' }) =>
    lines.reduce((sum, line) => sum + line.length + 1, 0) + rest.length + text.length + message.length;

  const run = (source, linesBefore, port) => {
    const url = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
    const worker = new Worker(url);
    let count = 0;
    let size = 0;
    const end = (last) => {
      worker.terminate();
      worker.onmessage = worker.onerror = null;
      URL.revokeObjectURL(url);
      if (last) port.postMessage(last);
    };
    worker.onmessage = ({ data }) => {
      const said = read(data);
      count += 1;
      size += said ? letters(said) : 0;
      if (count > most.messages || size > most.letters) end({ kind: 'flooded' });
      else if (said) port.postMessage(said);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      const line = event.lineno > linesBefore ? event.lineno - linesBefore : null;
      end({ kind: 'failed', message: String(event.message ?? 'it could not be started'), line });
    };
    port.onmessage = ({ data }) => {
      count = size = 0;
      if (data === null) end();
      else worker.postMessage(data);
    };
  };
  addEventListener('message', ({ data, ports }) => run(data.source, data.linesBefore, ports[0]));
}
