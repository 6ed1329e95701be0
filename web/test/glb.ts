/** A small binary glTF file of triangles, for tests. */

const padded = (bytes: Uint8Array, fill: number): Uint8Array => {
  const all = new Uint8Array(Math.ceil(bytes.length / 4) * 4).fill(fill);
  all.set(bytes);
  return all;
};

/** `corners`: places x, y, z of the corners of triangles, in the axes of glTF [m]. */
export function glb(corners: number[]): ArrayBuffer {
  const places = new Float32Array(corners);
  const axis = (i: number) => corners.filter((_, k) => k % 3 === i);
  const limits = (of: (...all: number[]) => number) => [0, 1, 2].map((i) => of(...axis(i)));
  const json = {
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: corners.length > 0 ? [0] : [] }],
    nodes: corners.length > 0 ? [{ mesh: 0 }] : [],
    ...(corners.length > 0 && {
      meshes: [{ primitives: [{ attributes: { POSITION: 0 }, material: 0 }] }],
      materials: [
        { pbrMetallicRoughness: { baseColorFactor: [1, 0.1, 0.1, 1] }, doubleSided: true },
      ],
      accessors: [
        {
          bufferView: 0,
          componentType: 5126,
          count: corners.length / 3,
          type: "VEC3",
          min: limits(Math.min),
          max: limits(Math.max),
        },
      ],
      bufferViews: [{ buffer: 0, byteLength: places.byteLength }],
      buffers: [{ byteLength: places.byteLength }],
    }),
  };
  const chunks: [number, Uint8Array][] = [
    [0x4e4f534a, padded(new TextEncoder().encode(JSON.stringify(json)), 0x20)],
    [0x004e4942, padded(new Uint8Array(places.buffer), 0)],
  ];
  const length = 12 + chunks.reduce((sum, [, bytes]) => sum + 8 + bytes.length, 0);
  const file = new DataView(new ArrayBuffer(length));
  [0x46546c67, 2, length].forEach((word, i) => file.setUint32(4 * i, word, true));
  let at = 12;
  for (const [kind, bytes] of chunks) {
    file.setUint32(at, bytes.length, true);
    file.setUint32(at + 4, kind, true);
    new Uint8Array(file.buffer, at + 8).set(bytes);
    at += 8 + bytes.length;
  }
  return file.buffer;
}
