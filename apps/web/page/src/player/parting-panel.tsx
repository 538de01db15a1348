// Says of two mice in one maze where they part, and leads there.
import { partingOf, type Parting } from './parting';
import { isComparable, type PanelProps, type Side } from './state';
import { Button } from '../ui/controls';

const does = ({ name }: Side, action: string | null) => (action === null ? `${name} has ended` : `${name}: ${action}`);

function wordsOf([one, other]: Side[], { frame, cell, actions }: Parting) {
  const where = `step ${frame + 1}, in cell (${cell[0]},${cell[1]})`;
  return `They part at ${where}. ${does(one, actions[0])}; ${does(other, actions[1])}.`;
}

export function PartingPoint({ state: { sides }, actions }: PanelProps) {
  if (!isComparable(sides)) return null;
  const parting = partingOf(sides[0].track.play, sides[1].track.play);
  if (!parting) return <p class="parting">Both go the same way, step by step.</p>;
  const time = Math.max(...sides.map(({ track }) => track.time[Math.min(parting.frame, track.last)]));
  return (
    <p class="parting">
      {wordsOf(sides, parting)} <Button label="Go there" act={() => actions.seek(time)} />
    </p>
  );
}
