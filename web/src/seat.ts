/**
 * The seat of this page: a secret in the browser's memory of this tab, so that a reload gets back the controls that the page left. A
 * copy of the tab has the secret too; the server gives it nothing while the first is there, and it takes a secret of its own.
 */

const KEY = "seat";
const BYTES = 16;
/** A page that is loaded again may be faster than the end of its former connection. */
const AGAIN_MS = 1500;

function fresh(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(BYTES));
  const key = Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
  sessionStorage.setItem(KEY, key);
  return key;
}

export class Seat {
  private told = false;

  /** `tell` gives the reason of a refusal, or `null`. */
  constructor(private readonly tell: (key: string) => Promise<string | null>) {}

  /** The connection is new: the server does not know the page. */
  forgotten(): void {
    this.told = false;
  }

  /** Tells the server the seat, once per connection. */
  async take(): Promise<void> {
    if (this.told) return;
    this.told = true;
    const key = sessionStorage.getItem(KEY) ?? fresh();
    if ((await this.tell(key)) === null || !this.told) return;
    await new Promise((done) => setTimeout(done, AGAIN_MS));
    if ((await this.tell(key)) !== null && this.told) await this.tell(fresh());
  }
}
