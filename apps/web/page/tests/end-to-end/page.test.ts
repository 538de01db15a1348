import { expect, test } from 'vitest';
import { barriers, drop, open, provoked } from './harness';

test('it opens from the disk, names its views, and asks nothing of a network', async () => {
  const page = await open();
  const views = await page.getByRole('navigation', { name: 'Views' }).getByRole('link').allTextContents();
  expect(views).toEqual(['Race', 'Replay', 'Live', 'Draw', 'Write', 'Robot']);
  expect(await barriers(page)).toEqual([]);
});

test('its policy lets no script in that is not its own, and nothing out', async () => {
  const page = await open('#draw');
  const policy = await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute('content');
  expect(policy).toContain("default-src 'none'");
  expect(policy!.match(/connect-src [^;]*/)![0]).toBe('connect-src ws://127.0.0.1:*');
  const blocked = await page.evaluate(async () => {
    const directives: string[] = [];
    const next = () =>
      new Promise((done) => {
        const note = (event: Event) =>
          done(directives.push((event as SecurityPolicyViolationEvent).effectiveDirective));
        addEventListener('securitypolicyviolation', note, { once: true });
      });
    const inAttribute = next();
    document.body.insertAdjacentHTML('beforeend', '<button onclick="window.intruder = 1">x</button>');
    document.querySelector<HTMLElement>('body > button')!.click();
    await inAttribute;
    const inElement = next();
    document.body.append(Object.assign(document.createElement('script'), { textContent: 'window.intruder = 2' }));
    await inElement;
    const outside = next();
    void fetch('http://localhost:1/').catch(() => null);
    await outside;
    return [...directives, (window as unknown as { intruder?: number }).intruder ?? 'no intruder'];
  });
  expect(blocked).toEqual(['script-src-attr', 'script-src-elem', 'connect-src', 'no intruder']);
  expect(provoked(/Content Security Policy/)).toBeGreaterThanOrEqual(3);
});

test('what is wrong is in sight wherever the page is scrolled to', async () => {
  const page = await open('#robot', { viewport: { width: 390, height: 700 } });
  const last = page.locator('.robot-form details[open] [data-key]').last();
  await last.scrollIntoViewIfNeeded();
  await last.fill('-1');
  const inSight = (text: string) =>
    expect
      .poll(async () => {
        const place = await page.getByRole('alert').filter({ hasText: text }).first().boundingBox();
        return place !== null && place.y >= 0 && place.y + place.height <= 700;
      })
      .toBe(true);
  await inSight('Refused');
  await drop(page, { name: 'bad.txt', content: 'x' });
  await inSight('bad.txt');
});
