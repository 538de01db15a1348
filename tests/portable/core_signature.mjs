// The behaviour signature as the page's core computes it, under node.
// Usage: node core_signature.mjs CORE.wasm
import { readFileSync } from 'node:fs';

const module = new WebAssembly.Module(readFileSync(process.argv[2]));
const imports = {};
// It asks its system for nothing that matters here.
for (const { module: from, name } of WebAssembly.Module.imports(module)) (imports[from] ??= {})[name] = () => 0;
const { exports } = new WebAssembly.Instance(module, imports);
exports._initialize?.();
for (const [i, part] of ['signature', '{}'].entries()) {
  const place = exports.labmouse_room(i, part.length);
  new Uint8Array(exports.memory.buffer, place, part.length).set(Buffer.from(part));
}
exports.labmouse_call();
const answer = Buffer.from(exports.memory.buffer, exports.labmouse_answer(), exports.labmouse_answer_size());
console.log(JSON.parse(answer.toString()).answer.signature);
