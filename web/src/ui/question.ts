/** A question before what cannot be taken back. It stays until it is answered; Escape is a no. */
import { button, h } from "./dom";

/** Asks whether to do something. `yes` and `no` say what each answer does. */
export function ask(question: {
  title: string;
  text: string;
  yes: string;
  no: string;
}): Promise<boolean> {
  return new Promise((answer) => {
    let agreed = false;
    const dialog = h(
      "dialog",
      { class: "question", "aria-label": question.title },
      h("h2", {}, question.title),
      h("p", {}, question.text),
      h(
        "div",
        { class: "row" },
        button(question.no, () => dialog.close(), { autofocus: true }),
        button(
          question.yes,
          () => {
            agreed = true;
            dialog.close();
          },
          { class: "take" },
        ),
      ),
    );
    dialog.addEventListener("close", () => {
      dialog.remove();
      answer(agreed);
    });
    document.body.append(dialog);
    dialog.showModal();
  });
}

/** Asks whether the present run may end for another scenario or session. */
export const askToEnd = (title: string): Promise<boolean> =>
  ask({
    title: "End this run?",
    text: `“${title}” opens for everybody in place of this run. The recording of this run is kept, among the recorded sessions.`,
    yes: "End this run",
    no: "Go on with it",
  });
