// What the signs of the drawing mean.
import { Sample, type SampleName } from '../player/samples';

const entries: [SampleName, string][] = [
  ['walls', 'wall'],
  ['start', 'start; the arrow is the start heading'],
  ['goal', 'goal'],
];

/** `route`: whether the shortest run is drawn. */
export const Key = ({ route }: { route: boolean }) => (
  <ul class="draw-key" aria-label="Legend">
    {entries.map(([name, words]) => (
      <li>
        <Sample name={name} />
        <span>{words}</span>
      </li>
    ))}
    <li class="route" hidden={!route}>
      <Sample name="search" />
      <span>a shortest run</span>
    </li>
  </ul>
);
