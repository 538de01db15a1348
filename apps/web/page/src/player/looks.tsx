// How one looks at a stage: nearer and farther, aside, alone on the screen, without what stands at its side.
import { useEffect, useRef, useState } from 'preact/hooks';
import { needsKey } from '../ui/needs-key';
import type { Stage } from '../maze/stage';
import { Sign } from './sign';
import type { Actions } from './state';

export type LookActions = Pick<Actions, 'zoom' | 'pan' | 'fold' | 'enlarge'>;

/** Of a step of the keys that look aside, in pixels of the page; and how much nearer one press brings. */
const aside = 80;
const nearer = 1.4;

export const zoomStage = (stage: Stage | undefined, by: number) =>
  by === 0 ? stage?.whole() : stage?.zoomBy(nearer ** by);
export const panStage = (stage: Stage | undefined, x: number, y: number) => stage?.panBy(aside * x, aside * y);

/** To the full screen, or back. */
export function enlarge(element: HTMLElement) {
  if (document.fullscreenElement) void document.exitFullscreen();
  else void element.requestFullscreen?.().catch(() => undefined);
}

export const Looks = ({ folded, actions }: { folded: boolean; actions: LookActions }) => (
  <div class="looks" role="group" aria-label="Picture">
    <Sign icon="nearer" label="Nearer" class="nearer" keys="Z, wheel, two fingers" act={() => actions.zoom(1)} />
    <Sign icon="farther" label="Farther" class="nearer" keys="X" act={() => actions.zoom(-1)} />
    <Sign
      class="screen"
      icon="screen"
      label="Full screen"
      keys="F"
      hidden={!document.fullscreenEnabled}
      act={actions.enlarge}
    />
    <Sign class="fold" icon="panel" label="The panel" keys="P" pressed={!folded} act={actions.fold} />
  </div>
);

/** What those keys do; where a view has another use for one, it takes the key before it comes here. */
export const lookKeys: Record<string, (actions: LookActions) => void> = {
  z: ({ zoom }) => zoom(1),
  x: ({ zoom }) => zoom(-1),
  w: ({ pan }) => pan(0, 1),
  a: ({ pan }) => pan(1, 0),
  s: ({ pan }) => pan(0, -1),
  d: ({ pan }) => pan(-1, 0),
  p: ({ fold }) => fold(),
  f: ({ enlarge }) => enlarge(),
};

/** The buttons and the keys of a stage without a player, in `.desk`, which fills the screen and in which the panel folds. */
export function StageLooks({ stage }: { stage: Stage }) {
  const [folded, setFolded] = useState(false);
  const element = useRef<HTMLDivElement>(null);
  const room = () => element.current!.closest<HTMLElement>('.desk')!;
  const actions: LookActions = {
    zoom: (by) => zoomStage(stage, by),
    pan: (x, y) => panStage(stage, x, y),
    fold: () => setFolded(room().classList.toggle('folded')),
    enlarge: () => enlarge(room()),
  };
  useEffect(() => {
    document.addEventListener('keydown', (event) => {
      const act = lookKeys[event.key.toLowerCase()];
      if (!act || event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
      if (!element.current?.checkVisibility() || needsKey(event.composedPath()[0], event.key)) return;
      act(actions);
      event.preventDefault();
    });
  }, []);
  return (
    <div class="looks-room" ref={element}>
      <Looks folded={folded} actions={actions} />
    </div>
  );
}
