// Files come from everywhere: dropped anywhere on the page, chosen, or pasted.
import { useLayoutEffect, useState } from 'preact/hooks';

type Take = (files: File[]) => void;

const holdsFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;

const isWriting = (target: EventTarget | null) =>
  target instanceof HTMLElement && (target.isContentEditable || /^(input|textarea|select)$/i.test(target.tagName));

/** What was pasted, as files; a link to a maze or a moment is followed instead. */
function pasted(event: ClipboardEvent): File[] {
  const files = [...(event.clipboardData?.files ?? [])];
  const text = event.clipboardData?.getData('text/plain') ?? '';
  const link = /^\S*#((?:maze=|write=|[a-z]+&)\S+)$/.exec(text.trim());
  if (link) location.hash = link[1];
  if (link) return [];
  return files.length > 0 || text.trim() === '' ? files : [new File([text], 'pasted text')];
}

/** `over` hears whether something is held over the page. */
function listen(take: Take, over: (is: boolean) => void) {
  // Entering a child leaves its parent, so the two are counted.
  let depth = 0;
  const showing = (change: number) => {
    depth = Math.max(0, depth + change);
    over(depth > 0);
  };
  document.addEventListener('dragenter', (event) => holdsFiles(event) && (event.preventDefault(), showing(1)));
  document.addEventListener('dragleave', (event) => holdsFiles(event) && showing(-1));
  document.addEventListener('dragover', (event) => holdsFiles(event) && event.preventDefault());
  document.addEventListener('drop', (event) => {
    showing(-depth);
    if (!holdsFiles(event)) return;
    event.preventDefault();
    take([...(event.dataTransfer?.files ?? [])]);
  });
  document.addEventListener('paste', (event) => {
    const files = isWriting(event.target) ? [] : pasted(event);
    if (files.length === 0) return;
    event.preventDefault();
    take(files);
  });
}

/** Gives all files that reach the page to `take`; seen while something is held over the page. */
export function Drop({ take }: { take: Take }) {
  const [isOver, setOver] = useState(false);
  useLayoutEffect(() => listen(take, setOver), []);
  return (
    <div class="drop" hidden={!isOver}>
      <p>Drop mazes, records, race results or robots here</p>
    </div>
  );
}
