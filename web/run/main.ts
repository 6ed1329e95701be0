import "@oicl/openbridge-webcomponents/dist/openbridge.css";
import "../src/style/index.css";
import "./style/page.css";
import { Workbench } from "./workbench";

const root = document.querySelector<HTMLElement>("#app");
if (!root) throw new Error("index.html has an element #app");
new Workbench(root).start();
