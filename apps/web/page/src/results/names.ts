// Names of mazes: paths in results, short ones for the eye.

/** The file's name without folders and its ending: "mazes/one.txt" is "one". */
export function stem(name: string): string {
  const file = name.slice(Math.max(name.lastIndexOf('/'), name.lastIndexOf('\\')) + 1);
  const dot = file.lastIndexOf('.');
  return dot > 0 && file.length - dot <= 6 ? file.slice(0, dot) : file || name;
}

/** Each name as short as it can be without being taken for another one of the list. */
export function shortNames(names: string[]): string[] {
  const count = new Map<string, number>();
  for (const name of names) count.set(stem(name), (count.get(stem(name)) ?? 0) + 1);
  return names.map((name) => (count.get(stem(name)) === 1 ? stem(name) : name));
}

/** What was filed under that name, or else under the only one with the same stem. */
export function find<Value>(values: Map<string, Value>, name: string): Value | undefined {
  const same = values.get(name);
  if (same !== undefined) return same;
  const alike = [...values.keys()].filter((other) => stem(other) === stem(name));
  return alike.length === 1 ? values.get(alike[0]) : undefined;
}
