// Text that has to fit into a width.

type Measuring = Pick<CanvasRenderingContext2D, 'measureText'>;

/**
 * The text, or as much of its beginning as fits into that width, and at least one letter of it, with `…` behind. What is
 * measured is as long as what fits, however long the text is.
 */
export function fitting(context: Measuring, text: string, width: number): string {
  const cut = (end: number) => (end < text.length ? `${text.slice(0, end)}…` : text);
  const fits = (end: number) => context.measureText(cut(end)).width <= width;
  let most = 1;
  while (most < text.length && fits(most)) most = Math.min(2 * most, text.length);
  if (most >= text.length && fits(text.length)) return text;
  // A length that fits, or 1, and one that does not.
  let least = Math.max(1, most >> 1);
  if (!fits(least)) least = 1;
  while (most - least > 1) {
    const middle = (least + most) >> 1;
    if (fits(middle)) least = middle;
    else most = middle;
  }
  return cut(least);
}
