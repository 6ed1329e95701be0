/** The user's models of ships: read, turned into the axes of the picture, and refused with the reason. */
import { Mesh, MeshLambertMaterial, Vector3 } from "three";
import { expect, test } from "vitest";
import { bytesOf, isModel, textOf } from "../run/model_text";
import { modelOf } from "../src/bridge/model";
import { skyUniforms } from "../src/bridge/sky";
import { glb } from "./glb";

const SHARED = { ...skyUniforms(), uLamps: { value: 0 } };
const SHIP = { file: "feeder.glb", length_m: 170 };
/** A sail of three corners: its foot at stern and bow, its top over the bow, and all of it 10 m to port. */
const SAIL = [10, 0, -80, 10, 0, 90, 10, 20, 90];

test("a model lies ahead, up and to port as its file says, in the paint of the view", async () => {
  const { group, note } = await modelOf(glb(SAIL), SHIP, SHARED);
  expect(note).toBe("");
  group.updateMatrixWorld(true);
  const meshes: Mesh[] = [];
  group.traverse((each) => each instanceof Mesh && meshes.push(each));
  const [mesh] = meshes;
  if (!mesh) throw new Error("there is a mesh");
  const places = mesh.geometry.getAttribute("position");
  const at = (i: number) =>
    new Vector3().fromBufferAttribute(places, i).applyMatrix4(mesh.matrixWorld);
  // glTF's x is to port where y is up and z ahead; aboard, x is to starboard and z astern.
  const top = at(2);
  [-10, 20, -90].forEach((v, i) => expect(top.getComponent(i)).toBeCloseTo(v, 5));
  const stern = at(0);
  [-10, 0, 80].forEach((v, i) => expect(stern.getComponent(i)).toBeCloseTo(v, 5));
  const material = mesh.material as MeshLambertMaterial;
  expect(material).toBeInstanceOf(MeshLambertMaterial);
  expect(material.color.r).toBeCloseTo(1, 5);
  expect(material.vertexColors).toBe(false);
});

test("a model in millimetres, or lying across, is told by its length", async () => {
  const small = await modelOf(glb(SAIL.map((v) => v / 1000)), SHIP, SHARED);
  expect(small.note).toBe(
    "feeder.glb is 0.170 m long and the ship 170 m: a model has metres, and its z axis points ahead",
  );
});

test("a broken or empty model is refused with the reason", async () => {
  await expect(modelOf(glb([]), SHIP, SHARED)).rejects.toThrow("it has no surfaces");
  await expect(modelOf(new ArrayBuffer(20), SHIP, SHARED)).rejects.toThrow();
  const cut = glb(SAIL).slice(0, 200);
  await expect(modelOf(cut, SHIP, SHARED)).rejects.toThrow();
});

test("the page without a server keeps a model as text, whatever its size", () => {
  const bytes = Uint8Array.from({ length: 100_003 }, (_, i) => (i * 7) % 256).buffer;
  expect(new Uint8Array(bytesOf(textOf(bytes)))).toEqual(new Uint8Array(bytes));
  expect(isModel("Feeder.GLB") && !isModel("feeder.toml")).toBe(true);
});
