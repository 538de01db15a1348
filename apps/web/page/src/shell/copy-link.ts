// A link to what is seen now, for others.
import type { Notices } from './notices';
import type { Stage } from './stage';

/** Whether the browser took it. */
const copied = (text: string) =>
  (navigator.clipboard?.writeText(text) ?? Promise.reject()).then(
    () => true,
    () => false,
  );

/** Copies the link of the view on stage, or says why there is none. */
export async function copyLink(stage: Stage, notices: Notices) {
  const name = stage.current() ?? 'home';
  try {
    const address = (await stage.view(name)?.address()) ?? name;
    const link = `${location.href.split('#')[0]}#${address}`;
    const taken = await copied(link);
    // A page from a disk lies elsewhere on other machines.
    const how = location.protocol === 'file:' ? ': paste it into any labmouse page' : '';
    if (taken) return notices.tell(`The link is copied${how}.`);
    // Where the browser keeps the clipboard to itself, the address bar has it.
    history.replaceState(null, '', `#${address}`);
    notices.tell('The link is in the address bar: copy it from there.');
  } catch (error) {
    notices.complain(error);
  }
}
