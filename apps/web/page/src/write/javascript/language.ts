// Mice in JavaScript, as they run under node.
import type { Language } from '../runtime';
import { linesBefore, workerSource } from './source';
import empty from './templates/empty.js?raw';
import floodAndReturn from './templates/flood-and-return.js?raw';
import floodFill from './templates/flood-fill.js?raw';
import wallFollower from './templates/wall-follower.js?raw';

export const javascript: Language = {
  id: 'javascript',
  name: 'JavaScript',
  fileName: 'mouse.js',
  commandLine: 'program:node mouse.js',
  templates: [
    { name: 'Flood fill', text: floodFill },
    { name: 'Flood and return', text: floodAndReturn },
    { name: 'Wall follower', text: wallFollower },
    { name: 'Empty', text: empty },
  ],
  workerSource: async (program) => workerSource(program),
  linesBefore,
  usesWasm: false,
};
