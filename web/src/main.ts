import { App } from "./app";
import "@oicl/openbridge-webcomponents/dist/openbridge.css";
import "./style/index.css";
import { h } from "./ui/dom";

const root = document.querySelector<HTMLElement>("#app");
if (!root) throw new Error("index.html has an element #app");
const token = new URLSearchParams(location.search).get("token");
if (token) {
  const url = new URL("live", location.href);
  url.protocol = location.protocol === "https:" ? "wss:" : "ws:";
  url.search = new URLSearchParams({ token }).toString();
  new App(root, url.href).start();
} else {
  root.append(
    h(
      "p",
      { class: "no-token" },
      "This page is opened by a link that ends in “?token=…”. Ask the instructor for yours; the server printed them all where it was started.",
    ),
  );
}
