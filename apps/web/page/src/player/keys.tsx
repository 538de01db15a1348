// The keyboard, and the help that lists it.
import { speeds, usualSpeed } from './clock';
import { layerNames, toggled } from './layers';
import { lookKeys } from './looks';
import type { Actions, State } from './state';
import { needsKey } from '../ui/needs-key';

const list: [string, string][] = [
  ['Space', 'play or pause'],
  ['← →', 'one step (move, straight or turn) back or forward; ten with Shift'],
  ['Home End', 'to the start or the end'],
  ['G R N', 'to the first step in the goal, to the speed run, to the first lost step'],
  ['+ −', 'faster or slower'],
  ['T', 'play all of it in 20 seconds'],
  ['L', 'repeat from the start'],
  ['1 … 9, 0', 'the layers, in the order of the legend'],
  ['Z X', 'nearer, farther; the wheel does it, too, and two fingers'],
  ['W A S D', 'look up, left, down or right, when near'],
  ['P', 'put the panel away, or back'],
  ['F', 'full screen'],
];

export const KeyHelp = () => (
  <details class="help">
    <summary>Keys</summary>
    <table aria-label="Keys">
      <tbody>
        {list.map(([keys, words]) => (
          <tr>
            <th scope="row">
              <kbd>{keys}</kbd>
            </th>
            <td>{words}</td>
          </tr>
        ))}
      </tbody>
    </table>
  </details>
);

/** Does what that key is for; says whether it is for anything. */
export function press(key: string, shift: boolean, state: State, actions: Actions): boolean {
  const { clock, layers, sides } = state;
  const layer = /^[0-9]$/.test(key) ? layerNames[(Number(key) + 9) % 10] : undefined;
  const believes = sides.some(({ track }) => track.play.known.length > 0);
  const faster = (by: number) =>
    actions.setSpeed(Math.min(Math.max(clock.speed < 0 ? usualSpeed : clock.speed + by, 0), speeds.length - 1));
  if (layer) actions.setLayers(toggled(layers, layer, believes));
  else if (key === ' ') actions.toggle();
  else if (key === 'ArrowLeft') actions.step(shift ? -10 : -1);
  else if (key === 'ArrowRight') actions.step(shift ? 10 : 1);
  else if (key === 'Home') actions.jump('start');
  else if (key === 'End') actions.jump('end');
  else if (key === 'g' || key === 'G') actions.jump('goal');
  else if (key === 'r' || key === 'R') actions.jump('speed');
  else if (key === 'n' || key === 'N') actions.jump('loss');
  else if (key === '+' || key === '=') faster(1);
  else if (key === '-' || key === '−') faster(-1);
  else if (key === 't' || key === 'T') actions.setSpeed(-1);
  else if (lookKeys[key.toLowerCase()]) lookKeys[key.toLowerCase()](actions);
  else if (key === 'l' || key === 'L') actions.setLoop(!clock.loop);
  else return false;
  return true;
}

/** Listens while the player is to be seen and nothing else wants the keys. */
export function listen(room: () => HTMLElement | null, state: State, actions: Actions) {
  document.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    // Of an editor in a shadow root, the event names only what stands around it.
    const [target] = event.composedPath();
    if (state.sides.length === 0 || !room()?.checkVisibility() || needsKey(target, event.key)) return;
    if (press(event.key, event.shiftKey, state, actions)) event.preventDefault();
  });
}
