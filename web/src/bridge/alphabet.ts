/** One picture with the characters that are painted on hulls, and the meshes of letters that show parts of it. */
import {
  BufferGeometry,
  CanvasTexture,
  Float32BufferAttribute,
  LinearMipmapLinearFilter,
  Mesh,
} from "three";
import type { Letter } from "./lettering";
import { type Shared, paintwork } from "./paintwork";
import type { Spot } from "./solids";

/** Size of a character's field, and of the letters in it [px]. */
const FIELD = 64;
const LETTER = 40;
/** Where letters stand in their field: their foot above its lower edge [px]. */
const FOOT = 12;
const COLUMNS = 16;
/** White paint that the weather has seen. */
const PAINT = [0.75, 0.76, 0.74];

/** The corners of a letter's field, from those of the letter. */
function fieldOf([a, b, c, d]: Letter["corners"]): Spot[] {
  const along = (from: Spot, to: Spot, share: number): Spot => [
    from[0] + share * (to[0] - from[0]),
    from[1] + share * (to[1] - from[1]),
    from[2] + share * (to[2] - from[2]),
  ];
  const [low, high] = [-FOOT / LETTER, (FIELD - FOOT) / LETTER];
  return [along(a, d, low), along(b, c, low), along(b, c, high), along(a, d, high)];
}

export class Alphabet {
  private readonly fields: Map<string, number>;
  private readonly widths: Map<string, number>;
  private readonly rows: number;
  private readonly material: ReturnType<typeof paintwork>;

  constructor(characters: string, shared: Shared) {
    const all = [...new Set(characters)];
    this.fields = new Map(all.map((character, i) => [character, i]));
    this.rows = Math.max(1, Math.ceil(all.length / COLUMNS));
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [COLUMNS * FIELD, this.rows * FIELD];
    const to = canvas.getContext("2d");
    if (!to) throw new Error("a browser has a canvas");
    to.fillStyle = "black";
    to.fillRect(0, 0, canvas.width, canvas.height);
    to.fillStyle = "white";
    to.textAlign = "center";
    // Capitals are about 0.72 of a font's size.
    to.font = `bold ${LETTER / 0.72}px "Liberation Sans", Arial, sans-serif`;
    this.widths = new Map(
      all.map((character) => [
        character,
        Math.min(FIELD, to.measureText(character).width) / LETTER,
      ]),
    );
    all.forEach((character, i) => {
      const [column, row] = [i % COLUMNS, Math.floor(i / COLUMNS)];
      to.fillText(character, (column + 0.5) * FIELD, (row + 1) * FIELD - FOOT, FIELD);
    });
    const picture = new CanvasTexture(canvas);
    picture.minFilter = LinearMipmapLinearFilter;
    picture.anisotropy = 4;
    const material = paintwork(shared, "plain");
    Object.assign(material, {
      alphaMap: picture,
      transparent: true,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -2,
      polygonOffsetUnits: -4,
    });
    // Whoever clears the picture disposes the materials of its meshes.
    material.addEventListener("dispose", () => picture.dispose());
    this.material = material;
  }

  /** Width of a character over its height. */
  readonly widthOf = (character: string): number => this.widths.get(character) ?? 0.5;

  /** A mesh of letters in the axes of a ship. */
  mesh(letters: Letter[]): Mesh {
    const [places, across, colours]: number[][] = [[], [], []];
    for (const { character, corners } of letters) {
      const field = this.fields.get(character);
      if (field === undefined) continue;
      const [column, row] = [field % COLUMNS, Math.floor(field / COLUMNS)];
      const half = (0.5 * this.widthOf(character) * LETTER) / FIELD;
      const [left, right] = [column + 0.5 - half, column + 0.5 + half].map((x) => x / COLUMNS);
      // A texture's second number goes up from the lower edge of the picture. The whole field is shown: some letters have dots
      // over them or a tail below.
      const [low, high] = [this.rows - 1 - row, this.rows - row].map((y) => y / this.rows);
      const whole = fieldOf(corners);
      const uv = [left, low, right, low, right, high, left, high];
      for (const i of [0, 1, 2, 0, 2, 3]) {
        const [forward, starboard, up] = whole[i] ?? [0, 0, 0];
        places?.push(starboard, up, -forward);
        across?.push(uv[2 * i] ?? 0, uv[2 * i + 1] ?? 0);
        colours?.push(...PAINT);
      }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(places ?? [], 3));
    geometry.setAttribute("uv", new Float32BufferAttribute(across ?? [], 2));
    geometry.setAttribute("color", new Float32BufferAttribute(colours ?? [], 3));
    geometry.computeVertexNormals();
    return new Mesh(geometry, this.material);
  }
}
