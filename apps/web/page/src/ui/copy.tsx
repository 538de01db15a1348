// A text to be copied: a button, and the text itself for where there is no clipboard.
import { useEffect, useRef, useState } from 'preact/hooks';
import { Button } from './controls';

interface Props {
  label: string;
  text: string;
  button?: string;
  /** Copies it as soon as it stands there. */
  atOnce?: boolean;
}

export function Copyable({ label, text, button = 'Copy', atOnce }: Props) {
  const field = useRef<HTMLInputElement>(null);
  const [said, say] = useState({ of: text, words: '' });
  async function copy() {
    try {
      await navigator.clipboard.writeText(text);
      say({ of: text, words: 'copied' });
    } catch {
      field.current?.focus();
      field.current?.select();
      say({ of: text, words: 'selected: copy it from the field' });
    }
  }
  useEffect(() => void (atOnce && copy()), []);
  return (
    <div class="copyable">
      <input type="text" readonly aria-label={label} spellcheck={false} value={text} ref={field} />
      <Button label={button} act={copy} />
      <span class="copied" role="status">
        {said.of === text && said.words}
      </span>
    </div>
  );
}
