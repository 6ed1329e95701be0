/** Builds and updates elements of the document. */

type Listeners = {
  [K in keyof HTMLElementEventMap as `on${K}`]?: (event: HTMLElementEventMap[K]) => void;
};
type Attributes = Record<
  string,
  string | number | boolean | null | undefined | ((event: never) => void)
>;
type Child = Node | string | null | undefined | false;

/** An element with its attributes (`true` sets an empty one, `false`, `null` none), listeners (`onclick`) and children. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes & Listeners = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    // The property, because the content security policy forbids the attribute.
    if (name === "style") element.style.cssText = String(value);
    else if (typeof value === "function")
      element.addEventListener(name.slice(2), value as EventListener);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined)
      element.setAttribute(name, String(value));
  }
  element.append(
    ...children.filter((child) => child !== null && child !== undefined && child !== false),
  );
  return element;
}

/** Sets a text only if it differs, so that the layout is not computed needlessly. */
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

export function setClass(element: Element, name: string, on: boolean): void {
  if (element.classList.contains(name) !== on) element.classList.toggle(name, on);
}

export function setAttribute(element: Element, name: string, value: string): void {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

export function setStyle(element: HTMLElement, name: string, value: string): void {
  if (element.style.getPropertyValue(name) !== value) element.style.setProperty(name, value);
}

/** A button that is large enough for a gloved finger. `name`: for screen readers, if the label is a symbol. */
export function button(
  label: string,
  press: () => void,
  more: Attributes & { name?: string } = {},
): HTMLButtonElement {
  const { name, ...rest } = more;
  return h(
    "button",
    { type: "button", "aria-label": name, title: name, ...rest, onclick: press },
    label,
  );
}

/** How long a button with confirmation waits for the second press. */
const SURE_MS = 6000;

/** A button with confirmation: it acts at the second press. */
export function sureButton(
  label: string,
  question: string,
  press: () => void,
  more: Attributes & { name?: string } = {},
): HTMLButtonElement {
  let timer = 0;
  const calm = () => {
    clearTimeout(timer);
    timer = 0;
    setText(own, label);
  };
  const own = button(
    label,
    () => {
      if (timer !== 0) {
        calm();
        press();
        return;
      }
      setText(own, question);
      timer = window.setTimeout(calm, SURE_MS);
    },
    more,
  );
  return own;
}

/** A group of buttons, of which one is pressed. */
export function choices<T extends string | number>(
  label: string,
  items: { value: T; label: string; name?: string }[],
  choose: (value: T) => void,
): { root: HTMLElement; show(value: T | null): void; buttons: HTMLButtonElement[] } {
  const buttons = items.map((item) =>
    button(item.label, () => choose(item.value), {
      ...(item.name && { name: item.name }),
      "aria-pressed": "false",
    }),
  );
  const root = h("div", { class: "choices", role: "group", "aria-label": label }, ...buttons);
  return {
    root,
    buttons,
    show: (value) =>
      items.forEach((item, i) => {
        const own = buttons[i];
        if (own) setAttribute(own, "aria-pressed", String(item.value === value));
      }),
  };
}

/** A canvas with the resolution of the screen; `paint` draws in CSS pixels. */
export function canvas(label: string): {
  root: HTMLCanvasElement;
  begin(): { to: CanvasRenderingContext2D; width: number; height: number } | null;
} {
  const root = h("canvas", { role: "img", "aria-label": label });
  const to = root.getContext("2d");
  return {
    root,
    begin() {
      const [width, height] = [root.clientWidth, root.clientHeight];
      if (!to || width === 0 || height === 0) return null;
      const ratio = Math.min(2, window.devicePixelRatio || 1);
      const [w, tall] = [Math.round(width * ratio), Math.round(height * ratio)];
      if (root.width !== w || root.height !== tall) [root.width, root.height] = [w, tall];
      to.setTransform(ratio, 0, 0, ratio, 0, 0);
      return { to, width, height };
    },
  };
}
