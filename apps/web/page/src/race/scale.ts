// Seven tones for the ratio of a score to the best possible one: light is good, and the ground of the page is not among them.

/** The highest ratio of each tone but the last, which takes all beyond. */
export const steps = [1.001, 1.05, 1.15, 1.3, 1.6, 2.5];

/** 0, the best, to 6. */
export const toneOf = (ratio: number) => {
  const found = steps.findIndex((step) => ratio <= step);
  return found < 0 ? steps.length : found;
};

/** What each tone stands for. */
export const toneLabels = [
  '1, the best possible',
  ...steps.slice(1).map((step) => `to ${step}`),
  `above ${steps[steps.length - 1]}`,
];

export const toneName = (step: number) => `ratio${step}`;
