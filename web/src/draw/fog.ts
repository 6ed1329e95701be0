/** Draws how far people see: a veil over what lies beyond it, and for the instructor, who sees everything, a circle. */
import { toScreen } from "../geometry";
import { Rank } from "./labels";
import type { Scene } from "./scene";

export function drawFog(scene: Scene): void {
  const { to, camera, colours, frame, live, bodies, hello } = scene;
  const { visibility_m } = frame;
  const eye = bodies[hello.vessels[live.conned()]?.body ?? -1];
  if (visibility_m === null || !eye) return;
  const centre = toScreen(camera, [eye[0], eye[1]]);
  const radius = visibility_m * camera.pixels_per_m;
  to.beginPath();
  to.arc(...centre, radius, 0, 2 * Math.PI);
  if (hello.role.name === "instructor") {
    to.strokeStyle = colours.dim;
    to.lineWidth = 1.5;
    to.setLineDash([4, 6]);
    to.stroke();
    to.setLineDash([]);
  } else {
    to.rect(0, 0, camera.width, camera.height);
    to.fillStyle = colours.fog;
    to.fill("evenodd");
  }
  scene.labels.push({
    key: "visibility",
    text: `visibility ${visibility_m} m`,
    rank: Rank.Detail,
    at: [centre[0], centre[1] - radius],
    colour: colours.text,
    size: 12,
  });
}
