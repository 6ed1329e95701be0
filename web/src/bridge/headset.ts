/** The view in a headset by WebXR: the eye's place is where the head is at the start, a metre is a metre, the head looks around. */
import { Group, PerspectiveCamera, Vector3, type WebGLRenderer } from "three";
import type { Triple } from "./axes";

/** Where the head is in the axes of the picture [m], and the direction in which it looks. */
export interface Head {
  at: Triple;
  ahead: Triple;
}

export class Headset {
  /** Stands at the eye's place, level with the deck; the head moves in it. */
  readonly rig = new Group();
  /** Takes the pose of the head. */
  readonly camera = new PerspectiveCamera(60, 1, 0.2, 70_000);
  private session: XRSession | null = null;

  constructor(private readonly renderer: WebGLRenderer) {
    this.rig.add(this.camera);
    this.rig.visible = false;
  }

  get runs(): boolean {
    return this.session !== null;
  }

  /**
   * Starts a session; `draws` is called for each picture of the headset, `ended` once after the last.
   *
   * Rejects if the browser gives no session.
   */
  async start(xr: XRSystem, draws: (now_ms: number) => void, ended: () => void): Promise<void> {
    const session = await xr.requestSession("immersive-vr");
    const manager = this.renderer.xr;
    session.addEventListener("end", () => {
      this.session = null;
      this.renderer.setAnimationLoop(null);
      manager.enabled = false;
      ended();
    });
    try {
      manager.enabled = true;
      // The head's pose at the start is the origin: the eye is where it is on the screen, whoever sits or stands.
      manager.setReferenceSpaceType("local");
      await manager.setSession(session);
    } catch (error) {
      await session.end();
      throw error;
    }
    this.session = session;
    this.renderer.setAnimationLoop((now_ms) => draws(now_ms));
  }

  async stop(): Promise<void> {
    await this.session?.end();
  }

  /** Puts the rig where a camera is. `level`: turned about the upright only, for an eye that stands on nothing. */
  stand(camera: PerspectiveCamera, level: boolean): void {
    this.rig.position.copy(camera.position);
    if (level) this.rig.rotation.set(0, camera.rotation.y, 0);
    else this.rig.quaternion.copy(camera.quaternion);
    this.rig.updateMatrixWorld(true);
  }

  /** Of the last drawing: between both eyes. */
  head(): Head {
    const { cameras } = this.renderer.xr.getCamera();
    const at = new Vector3();
    const ahead = new Vector3();
    for (const { matrixWorld } of cameras) {
      at.add(new Vector3().setFromMatrixPosition(matrixWorld));
      ahead.add(new Vector3().setFromMatrixColumn(matrixWorld, 2));
    }
    at.divideScalar(Math.max(1, cameras.length));
    return { at: at.toArray(), ahead: ahead.negate().normalize().toArray() };
  }
}
