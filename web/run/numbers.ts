/** Numbers in a text, and steps of them. */

/** A number in a text, from `from` to before `to`. */
export interface Found {
  from: number;
  to: number;
  text: string;
}

/** The number at a position, or the first after it in the same line; not in a comment or a name. */
export function numberAt(text: string, at: number): Found | null {
  const start = text.lastIndexOf("\n", at - 1) + 1;
  const end = text.indexOf("\n", at);
  const line = text.slice(start, end < 0 ? text.length : end);
  const comment = /^(?:[^#"]|"[^"]*")*/.exec(line)?.[0].length ?? line.length;
  const value = line.indexOf("=") + 1;
  let last: Found | null = null;
  for (const match of line.matchAll(/(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w.])/g)) {
    if (match.index < value || match.index >= comment) continue;
    const from = start + match.index;
    last = { from, to: from + match[0].length, text: match[0] };
    if (last.to >= at) return last;
  }
  return last;
}

/** The number one step up or down: about a tenth of it, in its own decimals or one more. */
export function stepped(text: string, up: boolean): string {
  const value = Number(text);
  const power = value === 0 ? 0 : Math.floor(Math.log10(Math.abs(value)) + 1e-9) - 1;
  const decimals = Math.max(/\.(\d+)/.exec(text)?.[1]?.length ?? 0, -power, 0);
  const next = value + (up ? 1 : -1) * 10 ** (value === 0 ? -decimals : power);
  return (Object.is(next, -0) ? 0 : next).toFixed(Math.min(decimals, 12));
}
