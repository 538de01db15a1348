// Numbers as text. Results come from files, so anything may stand where a number should.

export const isNumber = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);

export const orNull = (value: unknown) => (isNumber(value) ? value : null);

/** With that many digits behind the point; a dash for what is no number. */
export function number(value: unknown, digits: number): string {
  if (!isNumber(value)) return '–';
  return value.toFixed(digits).replace('-', '−');
}

/** The same with its sign, also the plus. */
export const signed = (value: number, digits: number) => `${value > 0 ? '+' : ''}${number(value, digits)}`;

/** A score: whole ones without digits, all others with three. */
export const scoreText = (value: unknown) => number(value, isNumber(value) && Number.isInteger(value) ? 0 : 3);

export const counted = (count: number, one: string, many = `${one}s`) =>
  `${count.toLocaleString('en')} ${count === 1 ? one : many}`;

/** What went wrong, in words. */
export const errorText = (error: unknown) => (error instanceof Error ? error.message : String(error));

/** Notes on how a file was read, as sentences. */
export const notesOn = (name: string, notes: string[]): string[] => notes.map((note) => `${name}: ${note}.`);
