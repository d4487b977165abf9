// Inspector: any pixel of any picture, enlarged, with what lies over its samples. Without it the page says the same of first wrong pixels.
"use strict";
(() => {
  const holder = document.getElementById("cases");
  if (!holder) return;
  const cases = JSON.parse(holder.textContent);
  const make = (name, about, ...inside) => {
    const element = document.createElement(name);
    Object.assign(element, about);
    element.append(...inside);
    return element;
  };
  const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  for (const one of cases) {
    one.drawn = bytes(one.drawn);
    one.right = one.right ? bytes(one.right) : one.drawn;
    one.wrong = new Set(one.wrong ?? []);
  }
  document.documentElement.classList.add("scripted");

  // What lies over a point: parity of the crossings at or left of it; an upper end belongs to an edge, a lower one does not.
  const covers = (corners, px, py) => {
    let inside = false;
    corners.forEach(([ax, ay], index) => {
      const [bx, by] = corners[(index + 1) % corners.length];
      if ((ay <= py) === (by <= py)) return;
      const side = (bx - ax) * (py - ay) - (by - ay) * (px - ax);
      if (by > ay ? side <= 0 : side >= 0) inside = !inside;
    });
    return inside;
  };
  const on = ([a, b, c], x, y) => a * x + b * y + c;
  const edge = ([ax, ay], [bx, by], x, y) => (bx - ax) * (y - ay) - (by - ay) * (x - ax);
  const over = (one, px, py) => one.faces.flatMap(([corners, depth, values, opacity], number) => {
    if (!covers(corners, px, py)) return [];
    const near = on(depth, px, py);
    const color = values.map((plane) => on(plane, px, py) / near);
    const edges = corners.map((corner, index) => edge(corner, corners[(index + 1) % corners.length], px, py));
    return [{ number, near, color, edges, opacity }];
  });
  const front = (found) => found.filter((face) => face.opacity === 1).reduce((best, face) => (best && best.near >= face.near ? best : face), null);

  const level = (data, one, x, y) => [0, 1, 2].map((channel) => data[(y * one.width + x) * 3 + channel]);
  const swatch = (rgb) => [
    Object.assign(make("span", { className: "swatch" }), {}), " ", make("span", { className: "level" }, rgb.join(",")),
  ].map((part, index) => (index === 0 ? (part.style.background = `rgb(${rgb})`, part) : part));
  const short = (number) => String(+number.toPrecision(6));

  // The enlarged picture, as the page's own: pixels, edges, sample points. Units are samples.
  const zoom = (one, state) => {
    const side = one.samples, around = state.around;
    const low = (middle, end) => Math.max(0, Math.min(middle - around, end - 2 * around - 1));
    const left = low(state.x, one.width), top = low(state.y, one.height);
    const right = Math.min(one.width, left + 2 * around + 1), bottom = Math.min(one.height, top + 2 * around + 1);
    let shapes = "";
    for (let y = top; y < bottom; y++) {
      for (let x = left; x < right; x++) {
        const [sx, sy] = [x * side, y * side];
        const box = `M${sx} ${sy}h${side}v${side}h-${side}z`;
        shapes += `<path fill="rgb(${level(one.drawn, one, x, y)})" d="${box}"/>`;
        if (one.wrong.has(y * one.width + x)) {
          shapes += `<path fill="rgb(${level(one.right, one, x, y)})" d="M${sx + side} ${sy}v${side}h-${side}z"/>`;
          shapes += `<path class="bad" d="${box}M${sx + side} ${sy}l-${side} ${side}"/>`;
        }
      }
    }
    const found = front(over(one, state.x * side + 0.5, state.y * side + 0.5));
    one.faces.forEach(([corners], number) => {
      const points = corners.join(" ");
      const kind = found && found.number === number ? "edge front" : "edge";
      shapes += `<polygon class="halo" points="${points}"/><polygon class="${kind}" points="${points}"/>`;
    });
    let dots = "", inside = "";
    for (let y = top * side; y < bottom * side; y++) {
      for (let x = left * side; x < right * side; x++) {
        const dot = `M${x}.5 ${y}.5h0`;
        dots += dot;
        if (one.kind !== "lines" && one.faces.some(([corners]) => covers(corners, x + 0.5, y + 0.5))) inside += dot;
      }
    }
    shapes += `<path class="dots under" d="${dots}"/><path class="dots" d="${dots}"/><path class="dots inside" d="${inside}"/>`;
    shapes += `<path class="chosen" d="M${state.x * side} ${state.y * side}h${side}v${side}h-${side}z"/>`;
    const [width, height] = [(right - left) * side, (bottom - top) * side];
    const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    svg.setAttribute("class", "zoom");
    svg.setAttribute("viewBox", `${left * side} ${top * side} ${width} ${height}`);
    svg.setAttribute("role", "img");
    svg.setAttribute("aria-label", `pixels around (${state.x}, ${state.y}), with edges and sample points`);
    svg.style.aspectRatio = `${width}/${height}`;
    // Numbers alone go into this text: names and output of students never do.
    svg.innerHTML = shapes;
    svg.addEventListener("click", (event) => {
      const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
      inspect(state.number, Math.floor(at.x / side), Math.floor(at.y / side));
    });
    return svg;
  };

  const table = (one, found, px, py) => {
    const winner = front(found);
    const rows = found.map((face) => make("tr", {},
      make("th", { scope: "row" }, `${face.number}${face === winner ? ", in front" : ""}`),
      make("td", {}, short(face.near)),
      make("td", {}, one.kind === "lit" ? face.color.map(short).join(", ") : face.color.map((light) => short(light * 255)).join(", ")),
      make("td", {}, face.edges.map((value) => (value === 0 ? "0 (through the center)" : short(value))).join(", "))));
    if (!rows.length) return make("p", { className: "quiet" }, "No polygon covers it: the background shows.");
    const head = ["Polygon", "1/w", one.kind === "lit" ? "Normal" : "Color, levels", "Edge values"].map((text) => make("th", { scope: "col" }, text));
    return make("div", { className: "scroll" }, make("table", {}, make("thead", {}, make("tr", {}, ...head)), make("tbody", {}, ...rows)));
  };
  const samples = (one, state) => {
    const parts = [];
    for (let at = 0; at < one.samples ** 2; at++) {
      const px = state.x * one.samples + (at % one.samples) + 0.5, py = state.y * one.samples + Math.floor(at / one.samples) + 0.5;
      parts.push(make("h4", {}, `Sample at (${px}, ${py})`));
      parts.push(one.kind === "lines" ? make("p", { className: "quiet" }, "A line shows where it leaves the sample's diamond.") : table(one, over(one, px, py), px, py));
    }
    return parts;
  };

  const panel = make("section", { className: "inspector", tabIndex: -1, id: "inspector" });
  panel.setAttribute("aria-label", "pixel inspector");
  let current = null;
  const show = () => {
    const state = current, one = cases[state.number];
    const [drawn, right] = [level(one.drawn, one, state.x, state.y), level(one.right, one, state.x, state.y)];
    const wrong = one.wrong.has(state.y * one.width + state.x);
    const button = (text, label, act) => Object.assign(make("button", { type: "button", title: label, ariaLabel: label }, text), { onclick: act });
    const head = make("header", {}, make("h3", {}, `Pixel (${state.x}, ${state.y})`),
      button("−", "smaller", () => { state.around = Math.min(12, state.around + 1); show(); }),
      button("+", "larger", () => { state.around = Math.max(1, state.around - 1); show(); }),
      button("Next wrong pixel", "next wrong pixel", () => next()),
      button("Close", "close", () => { panel.remove(); history.replaceState(null, "", location.pathname + location.search); current = null; }));
    const words = make("div", {},
      make("p", { id: "inspected" }, "drawn ", ...swatch(drawn), wrong ? ", right " : ", which is right", ...(wrong ? swatch(right) : [])),
      ...samples(one, state),
      make("p", { className: "quiet" }, "Click a pixel, or move with the arrow keys. Yellow: what is in front, and covered sample points. A wrong pixel shows what was drawn above its diagonal and what is right below."));
    panel.replaceChildren(head, make("div", { className: "lens" }, zoom(one, state), words));
  };
  const next = () => {
    const one = cases[current.number], here = current.y * one.width + current.x;
    const all = [...one.wrong].sort((a, b) => a - b);
    const at = all.find((index) => index > here) ?? all[0];
    if (at !== undefined) inspect(current.number, at % one.width, Math.floor(at / one.width));
  };
  // A click, an arrow key and an address that ends in #inspect=NUMBER,X,Y all come here.
  const inspect = (number, x, y) => {
    const one = cases[number];
    if (!one) return;
    const inside = (value, end) => Math.max(0, Math.min(end - 1, value | 0));
    current = { number, x: inside(x, one.width), y: inside(y, one.height), around: current?.around ?? 3 };
    const home = document.getElementById(`case${number}`);
    for (let outer = home.parentElement; outer; outer = outer.parentElement) if (outer.tagName === "DETAILS") outer.open = true;
    const place = home.classList.contains("thumb") ? home.parentElement : home.querySelector(".pictures");
    if (panel.previousElementSibling !== place) place.after(panel);
    show();
    history.replaceState(null, "", `#inspect=${number},${current.x},${current.y}`);
  };
  document.addEventListener("click", (event) => {
    const picture = event.target.closest?.("img[data-case]");
    if (!picture) return;
    const box = picture.getBoundingClientRect(), one = cases[+picture.dataset.case];
    const x = Math.floor(((event.clientX - box.left) / box.width) * one.width), y = Math.floor(((event.clientY - box.top) / box.height) * one.height);
    inspect(+picture.dataset.case, x, y);
    panel.focus({ preventScroll: true });
  });
  for (const picture of document.querySelectorAll("img[data-case]")) {
    picture.tabIndex = 0;
    picture.title = "Click a pixel to ask about it";
    picture.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      const one = cases[+picture.dataset.case], first = Math.min(...one.wrong, one.width * one.height);
      const at = one.wrong.size ? first : 0;
      inspect(+picture.dataset.case, at % one.width, Math.floor(at / one.width));
      panel.focus({ preventScroll: true });
    });
  }
  panel.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!step || !current) return;
    event.preventDefault();
    inspect(current.number, current.x + step[0], current.y + step[1]);
    panel.focus({ preventScroll: true });
  });
  for (const button of document.querySelectorAll(".copy")) {
    button.hidden = false;
    button.addEventListener("click", () => {
      navigator.clipboard?.writeText(button.closest("details").querySelector(".file").textContent).then(() => { button.textContent = "Copied"; });
    });
  }
  const asked = () => {
    const found = /^#inspect=(\d+),(\d+),(\d+)$/.exec(location.hash);
    if (!found) return;
    inspect(...found.slice(1).map(Number));
    panel.scrollIntoView({ block: "center" });
  };
  addEventListener("hashchange", asked);
  asked();
})();
