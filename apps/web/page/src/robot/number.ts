/** With at most so many digits after the point, and without zeros at its end: `226.42`, `850`. */
export const decimal = (value: number, digits: number): string => String(Number(value.toFixed(digits)));
