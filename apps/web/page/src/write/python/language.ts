// Python in the page: robots of the capstone project, by MicroPython.
import packed from 'virtual:python';
import { unpack } from '../../core/unpack';
import type { Language } from '../runtime';
import empty from '../../../../../../templates/robots/empty.py?raw';
import floodAndReturn from '../../../../../../templates/robots/flood_and_return.py?raw';
import floodFill from '../../../../../../templates/robots/flood_fill.py?raw';
import wallFollower from '../../../../../../templates/robots/wall_follower.py?raw';

export const python: Language = {
  id: 'python',
  name: 'Python',
  fileName: 'robot.py',
  commandLine: 'capstone:robot.py',
  templates: [
    { name: 'Flood fill', text: floodFill },
    { name: 'Flood and return', text: floodAndReturn },
    { name: 'Wall follower', text: wallFollower },
    { name: 'Empty', text: empty },
  ],
  async workerSource() {
    const script = new TextDecoder().decode(await unpack(packed.script));
    return `const packedMicroPython = '${packed.wasm}';\n${script}`;
  },
  linesBefore: 0,
  usesWasm: true,
};
