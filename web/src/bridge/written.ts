/** Writes the words that the page shows over the view into a picture that is saved. */

/** Widths of letters are rounded otherwise in a larger picture: a line may be wider by this share. */
const ROUNDED = 1.02;
/** Lines of text stand apart by so many heights of letters. */
const LINE = 1.3;

/**
 * Draws each element's text on `picture` as the page shows it over `over`: at the same place, with the same colours and letters, larger
 * where the picture is larger.
 */
export function writeInto(
  picture: HTMLCanvasElement,
  over: HTMLElement,
  elements: HTMLElement[],
): void {
  const to = picture.getContext("2d");
  if (!to) return;
  const frame = over.getBoundingClientRect();
  const scale = picture.width / Math.max(1, frame.width);
  to.textBaseline = "middle";
  for (const each of elements) {
    const box = each.getBoundingClientRect();
    if (each.textContent === "" || box.width === 0) continue;
    const style = getComputedStyle(each);
    const [x, y] = [(box.left - frame.left) * scale, (box.top - frame.top) * scale];
    to.fillStyle = style.backgroundColor;
    to.beginPath();
    to.roundRect(
      x,
      y,
      box.width * scale,
      box.height * scale,
      Number.parseFloat(style.borderRadius) * scale || 0,
    );
    to.fill();
    const letters_px = Number.parseFloat(style.fontSize) * scale;
    to.font = `${style.fontWeight} ${letters_px}px ${style.fontFamily}`;
    to.fillStyle = style.color;
    const inner_px =
      (box.width - Number.parseFloat(style.paddingLeft) - Number.parseFloat(style.paddingRight)) *
      scale;
    const lines = (each.textContent ?? "")
      .split("\n")
      .flatMap((line) => broken(line, inner_px * ROUNDED, (text) => to.measureText(text).width));
    const first = y + (box.height * scale) / 2 - ((lines.length - 1) / 2) * LINE * letters_px;
    lines.forEach((line, i) =>
      to.fillText(
        line,
        x + Number.parseFloat(style.paddingLeft) * scale,
        first + i * LINE * letters_px,
      ),
    );
  }
}

/** A line of words as lines no wider than a width, where its words allow that. */
export function broken(line: string, width: number, measure: (text: string) => number): string[] {
  const lines: string[] = [];
  for (const word of line.split(" ")) {
    const longer = lines.length === 0 ? word : `${lines.at(-1)} ${word}`;
    if (lines.length > 0 && measure(longer) <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}
