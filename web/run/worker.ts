/** Runs scenarios away from the page's thread. */
import { FenderlineError, Run, berthOf, library, load, newExercise, version } from "fenderline";
import type { Answer, FromWorker, Job, Results, ToWorker } from "./messages";

/** Frames of a run that the page keeps for its timeline. */
const FRAMES = 600;
/** Time between two looks at messages [ms]. */
const SLICE_MS = 25;
/** Time between two frames that only show the progress [ms]. */
const SHOWN_EVERY_MS = 120;

const say = (message: FromWorker) => postMessage(message);
/** The run that is wanted, whose loop ends those of earlier ones, and the one that is to stop. */
const asked = { run: 0, stop: 0 };

const channel = new MessageChannel();
channel.port1.start();
/** Lets messages in. Quicker than a timer, which browsers hold back by 4 ms. */
const breathe = () =>
  new Promise<void>((go) => {
    channel.port1.addEventListener("message", () => go(), { once: true });
    channel.port2.postMessage(null);
  });

addEventListener("message", ({ data }: MessageEvent<ToWorker>) => {
  switch (data.type) {
    case "module":
      void load(Promise.resolve(data.module)).then(() =>
        say({ type: "ready", version: version() }),
      );
      break;
    case "stop":
      asked.stop = data.id;
      break;
    case "run":
      asked.run = data.id;
      void play(data.id, data.job);
      break;
    case "choices":
    case "make":
      say(answer(data));
  }
});

/** Answers a question that is no run, between two slices of one. */
function answer(question: Extract<ToWorker, { ask: number }>): Answer {
  const { ask } = question;
  try {
    if (question.type === "choices") {
      const berths = question.scenarios.map((job) => berthOf(job));
      return { type: "choices", ask, library: library(), berths };
    }
    const { exercise, berth } = question;
    return { type: "made", ask, text: newExercise(JSON.stringify(exercise), berth) };
  } catch (error) {
    return { type: "unmade", ask, why: error instanceof Error ? error.message : String(error) };
  }
}

async function play(id: number, job: Job): Promise<void> {
  // The loop of the run before sees that it is no longer wanted, and gives its memory back.
  await breathe();
  if (id !== asked.run) return;
  try {
    const run = new Run(job, { frames: true });
    say({ type: "begun", id, info: run.info, hello: run.hello() });
    await steps(id, run);
    run.free();
  } catch (error) {
    if (error instanceof FenderlineError) say({ type: "refused", id, problem: error.problem });
    else say({ type: "broken", id, why: String(error) });
  }
}

async function steps(id: number, run: Run): Promise<void> {
  const stride = Math.max(1, Math.ceil(run.info.steps / FRAMES));
  const begun = performance.now();
  let [size, shown_ms] = [1, begun];
  const frame = (kept: boolean) =>
    say({ type: "frame", id, frame: run.frame(), kept, step: run.step });
  frame(true);
  const goesOn = () => !run.isDone && asked.stop !== id;
  while (goesOn()) {
    const from = performance.now();
    let at = from;
    while (!run.isDone && at - from < SLICE_MS) {
      const before = performance.now();
      try {
        run.advance(Math.min(size, stride - (run.step % stride)));
      } catch (error) {
        if (!(error instanceof FenderlineError)) throw error;
        say({ type: "failed", id, problem: error.problem, results: results(run) });
        return;
      }
      at = performance.now();
      // Never much longer than half a slice.
      size = at - before < SLICE_MS / 4 ? Math.min(2 * size, 1 << 16) : Math.max(1, size >> 1);
      if (run.step % stride === 0 || run.isDone) {
        frame(true);
        shown_ms = at;
      } else if (at - shown_ms > SHOWN_EVERY_MS) {
        frame(false);
        shown_ms = at;
      }
    }
    await breathe();
    if (id !== asked.run) return;
  }
  if (!run.isDone) frame(true);
  const took_ms = performance.now() - begun;
  say({ type: "done", id, complete: run.isDone, took_ms, results: results(run) });
}

const results = (run: Run): Results => ({
  verdict: run.verdict(),
  summary: run.summaryText(),
  report: run.report(),
});
