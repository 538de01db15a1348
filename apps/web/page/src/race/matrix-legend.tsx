// The legend of the matrix.
import type { ComponentChildren } from 'preact';
import { toneLabels, toneName } from './scale';

const Picture = ({ class: name, children }: { class?: string; children: ComponentChildren }) => (
  <svg width={14} height={14} viewBox="0 0 14 14" aria-hidden="true" class={name}>
    {children}
  </svg>
);

/** Some failed: the corner in its two tones, as it is on light and on dark cells. */
const Corner = ({ step, tone }: { step: number; tone: string }) => (
  <Picture class="corner">
    <rect width={14} height={14} class={toneName(step)} />
    <path d="M0 0 L7 0 L0 7 Z" class={tone} />
  </Picture>
);

/** What the tones and signs of the matrix mean. */
export const MatrixLegend = () => (
  <div class="scale">
    <span>score / best, mean over the finished contests:</span>
    <ul>
      {toneLabels.map((label, step) => (
        <li>
          <span class={`swatch ${toneName(step)}`} />
          {label}
        </li>
      ))}
      <li>
        <Picture>
          <path d="M3 3 L11 11 M11 3 L3 11" />
        </Picture>
        all contests failed
      </li>
      <li>
        <Corner step={1} tone="on-light" />
        <Corner step={5} tone="on-dark" />
        some failed
      </li>
      <li>
        <Picture class="dash">
          <path d="M3 7 L11 7" />
        </Picture>
        no route, or no contest
      </li>
    </ul>
  </div>
);
