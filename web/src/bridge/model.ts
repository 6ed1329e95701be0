/** The user's model of a ship: a binary glTF file in place of the hull and the deck that the view draws. */
import {
  Box3,
  DoubleSide,
  Group,
  Light,
  Line,
  Material,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  type Object3D,
  Points,
} from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { type Shared, paintwork } from "./paintwork";

/** A model whose length is not within these shares of the ship's has other units, or is another ship's. */
const LENGTHS = [0.5, 2] as const;

export interface Model {
  group: Group;
  /** What is wrong with the model, in words; empty if nothing is. */
  note: string;
}

/**
 * Reads a model. Its axes are those of glTF, y up and z ahead, and become those of the picture aboard a ship: x to starboard, y up
 * and z astern. Its materials get the light and the haze of the view. Fails with the reason if the file cannot be read.
 */
export async function modelOf(
  bytes: ArrayBuffer,
  { file, length_m }: { file: string; length_m: number },
  shared: Shared,
): Promise<Model> {
  const { scene } = await new GLTFLoader().parseAsync(bytes, "");
  const others: Object3D[] = [];
  let meshes = 0;
  scene.traverse((each) => {
    // Lights, lines and points have no place in the light and the haze of the view.
    if (each instanceof Light || each instanceof Line || each instanceof Points) others.push(each);
    if (!(each instanceof Mesh)) return;
    meshes += 1;
    const hasColours = each.geometry.hasAttribute("color");
    const paint = (of: Material) => painted(of, hasColours, shared);
    each.material = Array.isArray(each.material) ? each.material.map(paint) : paint(each.material);
    each.castShadow = each.receiveShadow = true;
  });
  if (meshes === 0) throw new Error("it has no surfaces");
  for (const other of others) other.removeFromParent();
  scene.updateMatrixWorld(true);
  const box = new Box3().setFromObject(scene);
  const long = box.max.z - box.min.z;
  const share = long / Math.max(1, length_m);
  const note =
    share < LENGTHS[0] || share > LENGTHS[1]
      ? `${file} is ${long.toPrecision(3)} m long and the ship ${length_m.toFixed(0)} m: a model has metres, and its z axis points ahead`
      : "";
  const group = new Group();
  scene.rotation.y = Math.PI;
  group.add(scene);
  return { group, note };
}

/** The colours and pictures of a material of the file, on a material of the view. */
function painted(of: Material, hasColours: boolean, shared: Shared): Material {
  const material = paintwork(shared, "plain", of.side === DoubleSide);
  material.vertexColors = hasColours;
  material.transparent = of.transparent;
  material.depthWrite = of.depthWrite;
  material.opacity = of.opacity;
  material.alphaTest = of.alphaTest;
  if (of instanceof MeshStandardMaterial || of instanceof MeshBasicMaterial) {
    material.color.copy(of.color);
    material.map = of.map;
    const { map } = of;
    // Whoever clears the picture disposes the materials of its meshes.
    if (map) material.addEventListener("dispose", () => map.dispose());
  }
  of.dispose();
  return material;
}
