/** The components of OpenBridge that this page uses. They are loaded when the first of them is shown. */
import "@oicl/openbridge-webcomponents/dist/building-blocks/bar-horizontal/bar-horizontal.js";
import "@oicl/openbridge-webcomponents/dist/components/alert-icon/alert-icon.js";
import "@oicl/openbridge-webcomponents/dist/navigation-instruments/azimuth-thruster/azimuth-thruster.js";
import "@oicl/openbridge-webcomponents/dist/navigation-instruments/badge-command/badge-command.js";
import "@oicl/openbridge-webcomponents/dist/navigation-instruments/compass/compass.js";
import "@oicl/openbridge-webcomponents/dist/navigation-instruments/main-engine/main-engine.js";
import "@oicl/openbridge-webcomponents/dist/navigation-instruments/pitch-roll/pitch-roll.js";
import "@oicl/openbridge-webcomponents/dist/navigation-instruments/rot-sector/rot-sector.js";
import "@oicl/openbridge-webcomponents/dist/navigation-instruments/rudder/rudder.js";
import "@oicl/openbridge-webcomponents/dist/navigation-instruments/speed-gauge/speed-gauge.js";
import "@oicl/openbridge-webcomponents/dist/navigation-instruments/thruster/thruster.js";
import { ObcWatch } from "@oicl/openbridge-webcomponents/dist/navigation-instruments/watch/watch.js";

/** On a smaller dial nothing can be read [px]. */
const LEAST_PX = 40;

// A dial without a size, in a tab that is not shown, would compute with a scale of zero. It draws itself when it gets a size.
Object.assign(ObcWatch.prototype, {
  shouldUpdate(this: ObcWatch): boolean {
    return this.clientWidth >= LEAST_PX && this.clientHeight >= LEAST_PX;
  },
});
