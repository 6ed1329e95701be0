/** Models of ships among the texts of a scenario's files: the text of a binary glTF file is its bytes in base64. */

export const isModel = (name: string): boolean => /\.glb$/i.test(name);

/** How many bytes become characters at once. */
const PART = 0x8000;

export function textOf(bytes: ArrayBuffer): string {
  const all = new Uint8Array(bytes);
  const parts: string[] = [];
  for (let i = 0; i < all.length; i += PART)
    parts.push(String.fromCharCode(...all.subarray(i, i + PART)));
  return btoa(parts.join(""));
}

export const bytesOf = (text: string): ArrayBuffer =>
  Uint8Array.from(atob(text), (character) => character.charCodeAt(0)).buffer;
