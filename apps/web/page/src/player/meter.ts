// How long the frames of a player took, for whoever wants to know: `document.querySelector('.player').meter`.

export interface Meter {
  frames: number;
  /** Milliseconds of the last ones, in a ring. */
  costs: Float64Array;
}

export const createMeter = (): Meter => ({ frames: 0, costs: new Float64Array(1024) });

export function count(meter: Meter, milliseconds: number) {
  meter.costs[meter.frames % meter.costs.length] = milliseconds;
  meter.frames += 1;
}
