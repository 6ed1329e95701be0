/** Films the canvas of the view into a WebM file by the browser's own recorder. */

/** Drawings a second that the film takes at most. */
const FPS = 25;
/** The film comes in pieces of this length [ms]. */
const PIECE_MS = 1000;
const KINDS = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"];

export class Film {
  private recorder: MediaRecorder | null = null;
  private pieces: Blob[] = [];

  /** The kind of film that this browser makes of a canvas; `null` if it makes none. */
  static kind(canvas: HTMLCanvasElement): string | null {
    if (typeof MediaRecorder === "undefined" || !("captureStream" in canvas)) return null;
    return KINDS.find((kind) => MediaRecorder.isTypeSupported(kind)) ?? null;
  }

  get runs(): boolean {
    return this.recorder !== null;
  }

  /** Begins. Returns whether this browser can. `failed`: hears why a film broke off. */
  start(canvas: HTMLCanvasElement, failed: (why: string) => void): boolean {
    const kind = Film.kind(canvas);
    if (kind === null) return false;
    try {
      const recorder = new MediaRecorder(canvas.captureStream(FPS), { mimeType: kind });
      this.pieces = [];
      recorder.addEventListener("dataavailable", ({ data }) => {
        if (data.size > 0) this.pieces.push(data);
      });
      recorder.addEventListener("error", () => failed("the browser's recorder stopped"));
      recorder.start(PIECE_MS);
      this.recorder = recorder;
      return true;
    } catch {
      return false;
    }
  }

  /** Ends, and gives the film. */
  async stop(): Promise<Blob | null> {
    const { recorder } = this;
    this.recorder = null;
    if (!recorder) return null;
    if (recorder.state !== "inactive") {
      const ended = new Promise((done) => recorder.addEventListener("stop", done, { once: true }));
      recorder.stop();
      await ended;
    }
    for (const track of recorder.stream.getTracks()) track.stop();
    const film = new Blob(this.pieces, { type: "video/webm" });
    this.pieces = [];
    return film.size > 0 ? film : null;
  }
}
