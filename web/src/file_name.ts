/** Names of files, as the server accepts them: letters, digits, `-` and `_`. */

/** Longest name (characters). */
export const LONGEST_NAME = 60;

/** What a name must be, in words. */
export const NAME_RULE = `A file name has 1 to ${LONGEST_NAME} letters, digits, - and _.`;

export const isFileName = (name: string): boolean =>
  name.length <= LONGEST_NAME && /^[A-Za-z0-9_-]+$/.test(name);

/** A file name that reads like a title; empty for a title without Latin letters and digits. */
export const fileNameOf = (title: string): string =>
  title
    // Accents become marks of their own, which are dropped.
    .normalize("NFD")
    .replaceAll(/\p{M}/gu, "")
    .replaceAll(/[^A-Za-z0-9-]+/g, "_")
    .slice(0, LONGEST_NAME)
    .replaceAll(/^_+|_+$/g, "");

/** Each space that is typed into a field of a file name becomes `_`. */
export function withoutSpaces(name: HTMLInputElement): void {
  name.addEventListener("input", () => {
    if (!/\s/.test(name.value)) return;
    const at = name.selectionStart;
    name.value = name.value.replaceAll(/\s/g, "_");
    name.setSelectionRange(at, at);
  });
}

/** Fills in the file name from the title, until a name is typed. */
export function followTitle(title: HTMLInputElement, name: HTMLInputElement): void {
  let filled = name.value;
  title.addEventListener("input", () => {
    if (name.value !== filled) return;
    filled = fileNameOf(title.value);
    name.value = filled;
    name.dispatchEvent(new Event("input"));
  });
  withoutSpaces(name);
}
