// What belongs to every test with a browser. Files of tests share the harness, so that they share the browser.
import { afterEach } from 'vitest';
import { endOfTest } from './harness';

afterEach(endOfTest);
