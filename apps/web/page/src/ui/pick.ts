// Files that the user picks.

/** Asks for one file, or for several, and gives them. */
export function askForFiles(picked: (files: File[]) => void, { multiple = false, accept = '' } = {}) {
  const input = document.createElement('input');
  Object.assign(input, { type: 'file', multiple, accept });
  input.onchange = () => picked([...(input.files ?? [])]);
  input.click();
}
