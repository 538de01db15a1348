// What Live shows, as the part of the page's address behind `#`: `live&mouse=SPEC&maze=LINK&seed=N&budget=N`, and in
// seconds `live&mouse=SPEC&maze=LINK&seed=N&robot=NAME&rules=NAME`.

export interface LiveAddress {
  mouse?: string;
  /** A maze as the core's `link`. */
  maze?: string;
  seed?: number;
  budget?: number;
  /** Of a contest in seconds. */
  robot?: string;
  rules?: string;
}

/** A SPEC in a link stays legible. */
const legible = (text: string) =>
  encodeURIComponent(text).replace(/%3A/g, ':').replace(/%3D/g, '=').replace(/%2F/g, '/').replace(/%2C/g, ',');

export function addressOf({ mouse, maze, seed, budget, robot, rules }: LiveAddress): string {
  const fields = { mouse, maze, seed, budget, robot, rules };
  const parts = Object.entries(fields).filter(([, value]) => value !== undefined);
  return ['live', ...parts.map(([name, value]) => `${name}=${legible(String(value))}`)].join('&');
}

function decoded(text: string) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** A number of an address: whole, not negative and exact; undefined for anything else. */
function whole(text: string | undefined) {
  const number = text !== undefined && /^\d+$/.test(text) ? Number(text) : NaN;
  return Number.isSafeInteger(number) ? number : undefined;
}

/** What an address says of Live; null where it speaks of something else. What it does not say is left out. */
export function readAddress(hash: string): LiveAddress | null {
  const [view, ...parts] = hash.replace(/^#/, '').split('&');
  if (view !== 'live') return null;
  const fields = new Map<string, string>();
  for (const part of parts) {
    const equals = part.indexOf('=');
    if (equals > 0) fields.set(part.slice(0, equals), decoded(part.slice(equals + 1)));
  }
  const address: LiveAddress = {
    mouse: fields.get('mouse') || undefined,
    maze: fields.get('maze') || undefined,
    seed: whole(fields.get('seed')),
    budget: whole(fields.get('budget')),
    robot: fields.get('robot') || undefined,
    rules: fields.get('rules') || undefined,
  };
  return Object.fromEntries(Object.entries(address).filter(([, value]) => value !== undefined));
}
