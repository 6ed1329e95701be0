/** Writes the words that the page shows over the view into a picture that is saved. */

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
    const lines = (each.textContent ?? "").split("\n").filter((line) => line !== "");
    const box = each.getBoundingClientRect();
    if (lines.length === 0 || box.width === 0) continue;
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
