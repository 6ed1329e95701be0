/** Whether the browser has a headset. */

/** The part of WebXR that is asked. */
export interface Asked {
  isSessionSupported(mode: "immersive-vr"): Promise<boolean>;
}

/** Whether a browser offers sessions in a headset. A page that may not ask has none. `xr`: absent without a secure context. */
export async function hasHeadset(xr: Asked | undefined): Promise<boolean> {
  try {
    return (await xr?.isSessionSupported("immersive-vr")) ?? false;
  } catch {
    return false;
  }
}

/** Why a session in a headset did not start, in words. */
export function whyNot(error: unknown): string {
  const name = error instanceof Error ? error.name : "";
  if (name === "NotSupportedError") return "the browser found no headset that it can use";
  if (name === "SecurityError") return "the browser did not allow it";
  if (name === "InvalidStateError") return "the headset shows another page already";
  return error instanceof Error && error.message !== ""
    ? error.message
    : "the browser says no reason";
}
