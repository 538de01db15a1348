// Robots in Python as the page plays them: what they say, print and lack, and what they cannot reach.
import { describe, expect, it } from 'vitest';
import { mostPrinted } from '../../src/write/python/printer';
import { robot, talk } from './talk';

/** What a line of Python prints. */
const printed = async (...code: string[]) => (await talk(robot(code.join('\n')))).printed.trim();

describe('a robot in Python', () => {
  it('greets once it was told all, and answers each reading', async () => {
    const { lines, failed } = await talk(robot('self.dim = maze_dim', '(90, sensors[1] - self.dim)'), [
      [0, 3, 0],
      [0, 0, 0],
    ]);
    expect(lines).toEqual(['labmouse 1', 'move 90 -9', 'move 90 -12']);
    expect(failed).toBeNull();
  });
  it('is read as the tester of the project reads it', async () => {
    const answers = [
      '(90.0, 2.9)',
      "['Reset', 'Reset']",
      '(45, 1)',
      "('right', 1)",
      '(0, 10 ** 30)',
      '(float("nan"), 1)',
    ];
    const said = await Promise.all(
      answers.map(async (answer) => (await talk(robot('pass', answer), [[1, 1, 1]])).lines[1]),
    );
    expect(said).toEqual(['move 90 2', 'reset', 'move 45 1', 'move 1 1', 'move 0 1000000', 'move 1 1']);
  });
  it('hears what it returned where that is no answer', async () => {
    for (const answer of ['None', '5', "(0, '1')", '(0, float("nan"))']) {
      const { failed } = await talk(robot('pass', answer), [[1, 1, 1]]);
      expect(failed?.message).toContain("('Reset', 'Reset')");
    }
  });
  it('says nothing after it failed', async () => {
    const { lines } = await talk(robot('self.left = 2', '(0, 1) if sensors[0] else 1 / 0'), [
      [1, 1, 1],
      [0, 1, 0],
      [1, 1, 1],
    ]);
    expect(lines).toEqual(['labmouse 1', 'move 0 1']);
  });
});

describe('its prints', () => {
  it('are shown, with and without an end of line', async () => {
    expect(await printed('print("mäuse", end=" ", flush=True)', 'print(maze_dim)')).toBe('mäuse 12');
  });
  it('come to an end', async () => {
    const { printed: text, lines } = await talk(robot('for n in range(700): print("x" * 1000)'));
    expect(text.length).toBeLessThan(mostPrinted + 100);
    expect(lines).toEqual(['labmouse 1']);
  });
});

describe('its failures', () => {
  const failure = async (program: string) => (await talk(program, [[0, 1, 0]])).failed;
  it('have the line of robot.py, also below a library', async () => {
    expect(await failure(robot('pass', '1 / 0'))).toMatchObject({
      line: 5,
      message: expect.stringMatching(/^ZeroDivisionError/),
    });
    expect(await failure('import heapq\n\nheapq.heappop([])\n')).toMatchObject({ line: 3 });
    expect(await failure('sorted([1], key=lambda n: n.x)\n')).toMatchObject({ line: 1 });
    expect(await failure('x = 1\ndef f(:\n')).toMatchObject({
      line: 2,
      message: expect.stringMatching(/^SyntaxError/),
    });
    expect(await failure('x = 1\n')).toMatchObject({ line: null, message: expect.stringContaining('class Robot') });
  });
  it('print the way there, of robot.py and no more', async () => {
    const { printed: text } = await talk(robot('self.middle()'));
    expect(text).toContain('File "robot.py", line 3, in __init__');
    expect(text).not.toContain('<stdin>');
  });
  it('say what to do where that is known', async () => {
    for (const code of [
      "print 'go'",
      'try:\n    pass\nexcept ValueError, e:\n    pass',
      'xrange(3)',
      'import Queue',
      '{}.has_key(1)',
    ])
      expect((await failure(`${code}\n`))?.message, code).toMatch(/Python 2.*--python python2\.7/);
    for (const code of [
      'import scipy.ndimage',
      'import dataclasses',
      'from numpy import zeros',
      'import numpy as np\nnp.zeros(3)',
    ])
      expect((await failure(`${code}\n`))?.message, code).toMatch(/(scipy|dataclasses|numpy).*capstone:robot\.py/);
    for (const code of ['a = [*[1]]', '"a".ljust(3)', 'match 1:\n    case 1: pass'])
      expect((await failure(`${code}\n`))?.message, code).toMatch(/MicroPython.*capstone:robot\.py/);
    expect((await failure('class Robot:\n    pass\n'))?.message).toContain('Robot(maze_dim)');
    expect((await failure('prnt(1)\n'))?.message).not.toMatch(/Python 2|MicroPython/);
  });
  it('are told in one line, whatever the error says', async () => {
    expect((await failure('raise ValueError("a\\nb")\n'))?.message).not.toContain('\n');
  });
  it('may be exits', async () => {
    expect(await failure('import sys\nsys.exit("enough")\n')).toMatchObject({ line: 2, message: 'enough' });
    expect(await failure('raise SystemExit\n')).toMatchObject({ line: 1 });
  });
});

describe('its bounds', () => {
  it('has memory for a robot, and an end of it', async () => {
    expect(await printed('n = len([0] * 5000000)', 'print(n)')).toBe('5000000');
    const { failed } = await talk('hold = []\nwhile True:\n    hold.append([0] * 200000)\n');
    expect(failed).toMatchObject({ line: 3, message: expect.stringMatching(/^MemoryError.*256 MB/) });
  });
  it('calls as deep as a maze of 16 by 16 has cells, and no deeper than it can', async () => {
    const depth = 'def depth(n):\n    return n if n == 0 else 1 + depth(n - 1)\n';
    expect((await talk(`${depth}print(depth(256))\n${robot('pass')}`)).printed.trim()).toBe('256');
    expect((await talk(`${depth}depth(10 ** 6)\n`)).failed).toMatchObject({
      line: 2,
      message: expect.stringContaining('recursion'),
    });
  });
  it('reads an empty input', async () => {
    expect(await printed('import sys', 'try:\n    input()\nexcept EOFError:\n    print(len(sys.stdin.read()))')).toBe(
      '0',
    );
  });
});

describe('JavaScript', () => {
  it('is out of its reach', async () => {
    for (const code of [
      'js.fetch',
      'js.eval("1")',
      'js["fetch"]',
      'js.globalThis',
      'js.Error("x")',
      'js.setTimeout(print, 1)',
      'js.undefined()',
    ])
      expect(await talk(`import js\nprint("tried")\n${code}\nprint("got it")\n`), code).toMatchObject({
        printed: expect.not.stringContaining('got it'),
        failed: expect.anything(),
      });
    for (const code of ['jsffi.to_js([1])', 'jsffi.create_proxy(print).apply', 'jsffi.JsProxy()'])
      expect(await talk(`import jsffi\nprint("tried")\n${code}\nprint("got it")\n`), code).toMatchObject({
        printed: expect.not.stringContaining('got it'),
        failed: expect.anything(),
      });
  });
});

describe('the library', () => {
  it('is Python’s where MicroPython’s differs', async () => {
    const tried: [string, string][] = [
      [
        'from collections import deque; d = deque([1, 2, 3], maxlen=3); d.append(4); d.rotate(1); d.appendleft(9); print(list(d), d.popleft(), len(d))',
        '[9, 4, 2] 9 2',
      ],
      ['from collections import deque; print(bool(deque()), 2 in deque([2]))', 'False True'],
      [
        'from collections import defaultdict; d = defaultdict(list); d[1].append(2); print(d[1], isinstance(d, dict), d.get(3))',
        '[2] True None',
      ],
      ['from collections import Counter; print(Counter("abca").most_common(1), Counter()["x"])', "[('a', 2)] 0"],
      [
        'print(sorted(["b1", "a1", "b0", "a0"] * 3, key=lambda text: text[0], reverse=True))',
        "['b1', 'b0', 'b1', 'b0', 'b1', 'b0', 'a1', 'a0', 'a1', 'a0', 'a1', 'a0']",
      ],
      [
        'import copy; a = {1: [{2}, (3, [4])]}; b = copy.deepcopy(a); b[1][0].add(5); b[1][1][1].append(6); print(a, b[1][1])',
        '{1: [{2}, (3, [4])]} (3, [4, 6])',
      ],
      [
        'import heapq; h = [3, 1, 2]; heapq.heapify(h); print(heapq.heappushpop(h, 0), heapq.nsmallest(2, h), heapq.nlargest(1, h))',
        '0 [1, 2] [3]',
      ],
      [
        'from itertools import product, islice, count, chain, combinations; print(list(product([1, 2], "a")), list(islice(count(), 2, 5)), list(chain([1], [2])), list(combinations("abc", 2)))',
        "[(1, 'a'), (2, 'a')] [2, 3, 4] [1, 2] [('a', 'b'), ('a', 'c'), ('b', 'c')]",
      ],
      [
        'from functools import lru_cache, reduce, cmp_to_key; print(lru_cache(None)(abs)(-1), reduce(max, [1, 3, 2]), sorted([1, 3, 2], key=cmp_to_key(lambda a, b: b - a)))',
        '1 3 [3, 2, 1]',
      ],
      [
        'from queue import PriorityQueue; q = PriorityQueue(); q.put((2, "b")); q.put((1, "a")); print(q.get(), q.empty())',
        "(1, 'a') False",
      ],
      [
        'import math, sys, time, bisect; sys.setrecursionlimit(5000); print(math.hypot(3, 4), math.gcd(12, 18), time.perf_counter() > 0, bisect.bisect([1, 2, 3], 2))',
        '5.0 6 True 2',
      ],
      [
        'from __future__ import print_function; from typing import List; import numpy as np; print(List[int] is not None)',
        'True',
      ],
      [
        'import operator; print(operator.itemgetter(1)([1, 2]), operator.attrgetter("a")(type("A", (), {"a": 3})))',
        '2 3',
      ],
    ];
    for (const [code, expected] of tried)
      expect((await talk(`${code}\n`)).printed.trim().split('\n')[0], code).toBe(expected);
  });
});
