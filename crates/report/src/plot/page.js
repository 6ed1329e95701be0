// One vertical cursor and the values under it, in all charts that share an axis.
(() => {
  const NS = "http://www.w3.org/2000/svg";
  const charts = [...document.querySelectorAll("svg[data-link]")].map((svg) => {
    const [x0, x1, px0, px1] = svg.dataset.x.split(" ").map(Number);
    const [y0, y1, py0, py1] = svg.dataset.y.split(" ").map(Number);
    const lines = [...svg.querySelectorAll("path.line")].map((path) => ({
      name: path.dataset.name,
      runs: path.getAttribute("d").split("M").filter(Boolean)
        .map((run) => run.split("L").map((p) => p.split(",").map(Number))),
    }));
    const make = (tag, name) => {
      const element = svg.appendChild(document.createElementNS(NS, tag));
      element.setAttribute("class", name);
      return element;
    };
    return { svg, x0, x1, px0, px1, y0, y1, py0, py1, lines, unit: svg.dataset.unit,
      cursor: make("path", "cursor"), text: make("text", "read") };
  });
  const valueAt = (chart, line, px) => {
    for (const run of line.runs) {
      for (let i = 0; i + 1 < run.length; i++) {
        const [a, b] = [run[i], run[i + 1]];
        if (a[0] <= px && px <= b[0]) {
          const py = b[0] > a[0] ? a[1] + (b[1] - a[1]) * (px - a[0]) / (b[0] - a[0]) : a[1];
          return chart.y0 + (chart.y1 - chart.y0) * (py - chart.py0) / (chart.py1 - chart.py0);
        }
      }
    }
    return null;
  };
  const show = (group, x) => charts.filter((c) => c.svg.dataset.link === group).forEach((c) => {
    const px = c.px0 + (c.px1 - c.px0) * (x - c.x0) / (c.x1 - c.x0);
    const values = c.lines.map((line) => [line.name, valueAt(c, line, px)])
      .filter(([, v]) => v !== null)
      .map(([name, v]) => (c.lines.length > 1 ? name + " " : "") + Number(v.toPrecision(3)) + " " + c.unit);
    c.cursor.setAttribute("d", `M${px},${c.py1}V${c.py0}`);
    const left = px < (c.px0 + c.px1) / 2;
    c.text.setAttribute("x", left ? px + 6 : px - 6);
    c.text.setAttribute("y", c.py1 + 11);
    c.text.setAttribute("text-anchor", left ? "start" : "end");
    c.text.textContent = [Number(x.toPrecision(4)) + " " + c.svg.dataset.xunit, ...values].join(" · ");
  });
  const hide = (group) => charts.filter((c) => c.svg.dataset.link === group).forEach((c) => {
    c.cursor.setAttribute("d", "");
    c.text.textContent = "";
  });
  charts.forEach((c) => {
    c.svg.addEventListener("pointermove", (event) => {
      const box = c.svg.getBoundingClientRect();
      const px = (event.clientX - box.left) * c.svg.viewBox.baseVal.width / box.width;
      const x = c.x0 + (c.x1 - c.x0) * (px - c.px0) / (c.px1 - c.px0);
      if (x >= c.x0 && x <= c.x1) show(c.svg.dataset.link, x); else hide(c.svg.dataset.link);
    });
    c.svg.addEventListener("pointerleave", () => hide(c.svg.dataset.link));
  });
})();
