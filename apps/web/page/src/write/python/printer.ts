// What a program prints, in pieces that do not flood the page.

/** Bytes of all that is shown of one program. Its frame ends those that say more than a million letters at a time. */
export const mostPrinted = 500_000;

/** Lines at a time that are shown at once, so that they are seen also where the program then hangs; more go together. */
const promptLines = 100;
const piece = 16 * 1024;
const newline = 10;

export function createPrinter(show: (text: string) => void) {
  const decoder = new TextDecoder();
  let bytes: number[] = [];
  let lines = 0;
  let printed = 0;

  function pass() {
    if (bytes.length > 0) show(decoder.decode(new Uint8Array(bytes), { stream: true }));
    bytes = [];
  }
  return {
    put(byte: number) {
      if (++printed > mostPrinted) return;
      bytes.push(byte);
      if (printed === mostPrinted) bytes.push(...new TextEncoder().encode('\n… it printed more than is shown\n'));
      const ends = byte === newline && ++lines <= promptLines;
      if (ends || bytes.length >= piece || printed === mostPrinted) pass();
    },
    /** Shows what is left; lines are prompt again. */
    flush() {
      pass();
      lines = 0;
    },
  };
}
