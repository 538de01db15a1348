// A labelled control, with a line of help and room for what is wrong with it.
import { cloneElement, toChildArray, type ComponentChildren, type VNode } from 'preact';
import { useLayoutEffect, useRef, useState } from 'preact/hooks';

let fields = 0;

interface FieldProps {
  label: string;
  /** Stands below the control and describes it. */
  help?: ComponentChildren;
  /** What is wrong with the value. */
  error?: string;
  hidden?: boolean;
  class?: string;
  /** The control, and what stands below all. */
  children: ComponentChildren;
}

/** Brings an error into sight, unless somebody is writing elsewhere and would lose the place. */
export function showError(error: HTMLElement) {
  if (!document.activeElement?.matches('input, select, textarea, [contenteditable]'))
    error.scrollIntoView({ block: 'nearest' });
}

export function Field({ label, help, error = '', hidden, class: name = '', children }: FieldProps) {
  const [id] = useState(() => `field-${++fields}`);
  const row = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => void (error && showError(row.current!)), [error]);
  const [control, ...below] = toChildArray(children) as [VNode<object>, ...ComponentChildren[]];
  const described = `${help !== undefined ? `${id}-help ` : ''}${id}-error`;
  return (
    <div class={`field ${name}`.trim()} hidden={hidden} ref={row}>
      <label for={id}>{label}</label>
      {cloneElement(control, { id, 'aria-describedby': described, 'aria-invalid': error ? 'true' : undefined })}
      {help !== undefined && (
        <span class="field-help" id={`${id}-help`}>
          {help}
        </span>
      )}
      <span class="field-error" id={`${id}-error`} role="alert">
        {error}
      </span>
      {below}
    </div>
  );
}

/**
 * At which of these fields a message of the core stands: the one that it names in quotes ("'budget' is outside the range 1 to
 * 1000000"), or else `usual`. Gives the message of each field.
 */
export function errorAt<Name extends string>(message: string, names: Name[], usual: NoInfer<Name>) {
  const named = names.find((name) => message.includes(`'${name}'`)) ?? usual;
  return (name: Name) => (name === named ? message : '');
}
