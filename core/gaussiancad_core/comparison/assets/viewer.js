// The 3D view of a comparison's page: WebGL 2, nothing from outside.
// The page holds the geometry as JSON with base64 arrays, see page_geometry.py.
"use strict";
(() => {
  const byId = (name) => document.getElementById(name);
  const data = JSON.parse(byId("geometry").textContent);
  const canvas = byId("view");
  const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
  if (!gl) {
    document.body.dataset.viewer = "unsupported";
    byId("controls").hidden = true;
    return;
  }

  const decode = (text, Kind) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    return new Kind(bytes.buffer);
  };
  const read = (mesh) => ({
    places: decode(mesh.places, Uint16Array),
    values: mesh.values ? decode(mesh.values, Float32Array) : null,
    triangles: decode(mesh.triangles, Uint32Array),
    low: mesh.low,
    extent: mesh.extent,
  });
  const result = read(data.result);
  const reference = read(data.reference);
  const point = (mesh, index) =>
    [0, 1, 2].map((k) => mesh.low[k] + (mesh.places[3 * index + k] / 65535) * mesh.extent[k]);

  const add = (a, b, share = 1) => a.map((value, k) => value + share * b[k]);
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const centre = add(data.low, data.high).map((value) => value / 2);
  const diagonal = Math.hypot(...add(data.high, data.low, -1)) || 1;

  const home = { yaw: 0.6, pitch: 0.5, zoom: 1, target: centre };
  let camera = { ...home };
  let range = data.range;
  let marked = null;
  let flight = 0;

  // ---- drawing

  const program = (vertex, fragment) => {
    const made = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, "#version 300 es\nprecision highp float;\n" + text);
      gl.compileShader(shader);
      gl.attachShader(made, shader);
    }
    gl.bindAttribLocation(made, 0, "place");
    gl.bindAttribLocation(made, 1, "value");
    gl.linkProgram(made);
    const names = {};
    for (let k = 0; k < gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS); k++) {
      const name = gl.getActiveUniform(made, k).name.replace("[0]", "");
      names[name] = gl.getUniformLocation(made, name);
    }
    return { made, names };
  };
  const surface = program(
    `in vec3 place; in float value; uniform mat4 camera; uniform vec3 low, extent;
     out vec3 world; out float deviation;
     void main() { world = low + place * extent; deviation = value;
       gl_Position = camera * vec4(world, 1.0); }`,
    `in vec3 world; in float deviation; out vec4 colour;
     uniform vec3 stops[5]; uniform float range, alpha; uniform vec3 eye; uniform vec4 section;
     void main() {
       if (dot(section.xyz, world) > section.w) discard;
       vec3 normal = normalize(cross(dFdx(world), dFdy(world)));
       float light = 0.5 + 0.5 * abs(dot(normal, eye));
       float where = clamp(deviation / range, -1.0, 1.0) * 2.0 + 2.0;
       int stop = min(int(where), 3);
       vec3 paint = mix(stops[stop], stops[stop + 1], where - float(stop));
       if (alpha < 1.0) paint = vec3(0.35, 0.4, 0.45);
       else if (!gl_FrontFacing) paint = vec3(0.55, 0.52, 0.42);
       colour = vec4(paint * light, alpha);
     }`,
  );
  const plain = program(
    `in vec3 place; uniform mat4 camera; uniform vec2 nudge;
     void main() { gl_Position = camera * vec4(place, 1.0) + vec4(nudge, -0.002, 0.0);
       gl_PointSize = 26.0; }`,
    `uniform vec4 paint; uniform bool ring; out vec4 colour;
     void main() {
       float away = length(gl_PointCoord - 0.5);
       if (ring && (away > 0.48 || away < 0.3)) discard;
       colour = paint;
     }`,
  );
  const buffer = (kind, values) => {
    const made = gl.createBuffer();
    gl.bindBuffer(kind, made);
    gl.bufferData(kind, values, gl.STATIC_DRAW);
    return made;
  };
  const upload = (mesh) => {
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    buffer(gl.ARRAY_BUFFER, mesh.places);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.UNSIGNED_SHORT, true, 0, 0);
    if (mesh.values) {
      buffer(gl.ARRAY_BUFFER, mesh.values);
      gl.enableVertexAttribArray(1);
      gl.vertexAttribPointer(1, 1, gl.FLOAT, false, 0, 0);
    }
    buffer(gl.ELEMENT_ARRAY_BUFFER, mesh.triangles);
    gl.bindVertexArray(null);
    return array;
  };
  const arrays = { result: upload(result), reference: upload(reference) };
  const loose = gl.createVertexArray();
  gl.bindVertexArray(loose);
  const looseBuffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, looseBuffer);
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
  gl.bindVertexArray(null);

  // Right, up and towards the eye; at yaw 0 and pitch 0 the front view: it looks along +Y.
  const frame = () => {
    const [s, c] = [Math.sin(camera.yaw), Math.cos(camera.yaw)];
    const [t, d] = [Math.sin(camera.pitch), Math.cos(camera.pitch)];
    return { right: [c, s, 0], up: [-s * t, c * t, d], eye: [s * d, -c * d, t] };
  };
  const matrix = (view) => {
    const high = (1.7 * camera.zoom) / diagonal;
    const wide = (high * canvas.height) / canvas.width;
    const rows = [
      view.right.map((v) => v * wide),
      view.up.map((v) => v * high),
      view.eye.map((v) => -v / (2 * diagonal)),
    ];
    const out = new Float32Array(16);
    rows.forEach((row, r) => {
      row.forEach((value, k) => (out[4 * k + r] = value));
      out[12 + r] = -dot(row, camera.target);
    });
    out[15] = 1;
    return out;
  };
  const section = () => {
    const axis = ["x", "y", "z"].indexOf(byId("axis").value);
    if (axis < 0) return null;
    const share = Number(byId("cut").value) / 1000;
    return { axis, at: data.low[axis] + share * (data.high[axis] - data.low[axis]) };
  };

  const drawSurface = (array, mesh, view, camera4, cut, alpha) => {
    const { made, names } = surface;
    gl.useProgram(made);
    gl.uniformMatrix4fv(names.camera, false, camera4);
    gl.uniform3fv(names.low, mesh.low);
    gl.uniform3fv(names.extent, mesh.extent);
    gl.uniform3fv(names.stops, data.stops.flat().map((value) => value / 255));
    gl.uniform1f(names.range, range);
    gl.uniform1f(names.alpha, alpha);
    gl.uniform3fv(names.eye, view.eye);
    const plane = [0, 0, 0, 1];
    if (cut) {
      // The half towards the eye is taken off.
      const side = view.eye[cut.axis] >= 0 ? 1 : -1;
      plane[cut.axis] = side;
      plane[3] = side * cut.at;
    }
    gl.uniform4fv(names.section, plane);
    gl.bindVertexArray(array);
    gl.drawElements(gl.TRIANGLES, mesh.triangles.length, gl.UNSIGNED_INT, 0);
  };
  const drawLoose = (kind, points, camera4, paint, ring) => {
    const { made, names } = plain;
    gl.useProgram(made);
    gl.uniformMatrix4fv(names.camera, false, camera4);
    gl.uniform4fv(names.paint, paint);
    gl.uniform1i(names.ring, ring);
    gl.bindVertexArray(loose);
    gl.bindBuffer(gl.ARRAY_BUFFER, looseBuffer);
    gl.bufferData(gl.ARRAY_BUFFER, points, gl.DYNAMIC_DRAW);
    // Lines are one pixel wide; drawn beside each other they are three.
    const steps = kind === gl.LINES ? [[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]] : [[0, 0]];
    for (const [x, y] of steps) {
      gl.uniform2f(names.nudge, (2 * x) / canvas.width, (2 * y) / canvas.height);
      gl.drawArrays(kind, 0, points.length / 3);
    }
  };
  const outline = (mesh, cut) => {
    const found = [];
    const height = (index) =>
      mesh.low[cut.axis] + (mesh.places[3 * index + cut.axis] / 65535) * mesh.extent[cut.axis] - cut.at;
    for (let k = 0; k < mesh.triangles.length; k += 3) {
      const corners = [0, 1, 2].map((i) => mesh.triangles[k + i]);
      const heights = corners.map(height);
      const ends = [];
      for (let i = 0; i < 3; i++) {
        const [a, b] = [heights[i], heights[(i + 1) % 3]];
        if (a < 0 !== b < 0) {
          const from = point(mesh, corners[i]);
          ends.push(add(from, add(point(mesh, corners[(i + 1) % 3]), from, -1), a / (a - b)));
        }
      }
      if (ends.length === 2) found.push(...ends[0], ...ends[1]);
    }
    return new Float32Array(found);
  };

  let waiting = false;
  const draw = () => {
    waiting = false;
    const ratio = window.devicePixelRatio || 1;
    canvas.width = Math.max(2, Math.round(canvas.clientWidth * ratio));
    canvas.height = Math.max(2, Math.round(canvas.clientHeight * ratio));
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(1, 1, 1, 1);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const view = frame();
    const camera4 = matrix(view);
    const cut = section();
    if (byId("show-result").checked) drawSurface(arrays.result, result, view, camera4, cut, 1);
    if (byId("show-reference").checked) {
      gl.enable(gl.BLEND);
      gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
      gl.depthMask(false);
      drawSurface(arrays.reference, reference, view, camera4, cut, 0.3);
      gl.disable(gl.BLEND);
      gl.depthMask(true);
    }
    if (cut) {
      drawLoose(gl.LINES, outline(reference, cut), camera4, [0.0, 0.45, 0.2, 1], false);
      drawLoose(gl.LINES, outline(result, cut), camera4, [0.05, 0.05, 0.05, 1], false);
    }
    gl.disable(gl.DEPTH_TEST);
    if (marked) drawLoose(gl.POINTS, new Float32Array(marked), camera4, [0, 0, 0, 1], true);
    document.body.dataset.viewer = gl.getError() === gl.NO_ERROR ? "ready" : "broken";
  };
  const redraw = () => {
    if (!waiting) {
      waiting = true;
      requestAnimationFrame(draw);
    }
  };

  // ---- moving about

  const turn = (x, y) => {
    camera.yaw -= x;
    camera.pitch = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, camera.pitch + y));
    redraw();
  };
  const zoom = (factor) => {
    camera.zoom = Math.min(200, Math.max(0.2, camera.zoom * factor));
    redraw();
  };
  const pan = (x, y) => {
    const view = frame();
    const step = (2 * diagonal) / (1.7 * camera.zoom * canvas.clientHeight);
    camera.target = add(add(camera.target, view.right, -x * step), view.up, y * step);
    redraw();
  };
  const fly = (goal) => {
    const start = { ...camera };
    // The shorter way around.
    const yaw = start.yaw + Math.atan2(Math.sin(goal.yaw - start.yaw), Math.cos(goal.yaw - start.yaw));
    const calm = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    const began = performance.now();
    const current = ++flight;
    const step = (now) => {
      if (current !== flight) return;
      const time = calm ? 1 : Math.min(1, Math.max(0, (now - began) / 450));
      const share = time * time * (3 - 2 * time);
      camera = {
        yaw: start.yaw + share * (yaw - start.yaw),
        pitch: start.pitch + share * (goal.pitch - start.pitch),
        zoom: start.zoom * (goal.zoom / start.zoom) ** share,
        target: add(start.target, add(goal.target, start.target, -1), share),
      };
      draw();
      if (time < 1) requestAnimationFrame(step);
    };
    step(began);
  };
  const look = (yaw, pitch) => fly({ yaw, pitch, zoom: 1, target: centre });

  const pointers = new Map();
  let dragged = 0;
  canvas.addEventListener("pointerdown", (event) => {
    flight++;
    dragged = 0;
    pointers.set(event.pointerId, event);
    if (event.isTrusted) canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const [x, y] = [event.clientX - last.clientX, event.clientY - last.clientY];
    dragged += Math.abs(x) + Math.abs(y);
    if (pointers.size === 2) {
      const other = [...pointers.values()].find((each) => each.pointerId !== event.pointerId);
      const away = (each) => Math.hypot(each.clientX - other.clientX, each.clientY - other.clientY);
      zoom(Math.max(1, away(event)) / Math.max(1, away(last)));
      pan(x / 2, y / 2);
    } else if (event.shiftKey || event.buttons & 6) pan(x, y);
    else turn(x * 0.01, y * 0.01);
    pointers.set(event.pointerId, event);
  });
  const release = (event) => {
    if (pointers.delete(event.pointerId) && event.type === "pointerup" && dragged < 4) pick(event);
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY * 0.0015));
  }, { passive: false });
  const keys = {
    ArrowLeft: () => turn(-0.1, 0),
    ArrowRight: () => turn(0.1, 0),
    ArrowUp: () => turn(0, -0.1),
    ArrowDown: () => turn(0, 0.1),
    "+": () => zoom(1.2),
    "-": () => zoom(1 / 1.2),
    Home: () => look(home.yaw, home.pitch),
  };
  canvas.addEventListener("keydown", (event) => {
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });

  // The deviation under a click: the nearest triangle of the result along the line of sight.
  const pick = (event) => {
    const view = frame();
    const box = canvas.getBoundingClientRect();
    const step = (2 * diagonal) / (1.7 * camera.zoom * box.height);
    const x = (event.clientX - box.left - box.width / 2) * step;
    const y = (box.top + box.height / 2 - event.clientY) * step;
    const cut = section();
    const side = cut && view.eye[cut.axis] >= 0 ? 1 : -1;
    const flat = (p) => {
      const rest = add(p, camera.target, -1);
      return [dot(rest, view.right) - x, dot(rest, view.up) - y];
    };
    let best = null;
    for (let k = 0; k < result.triangles.length; k += 3) {
      const ids = [0, 1, 2].map((i) => result.triangles[k + i]);
      const corners = ids.map((index) => point(result, index));
      const [a, b, c] = corners.map(flat);
      const parts = [[b, c], [c, a], [a, b]].map(([p, q]) => p[0] * q[1] - p[1] * q[0]);
      const sum = parts[0] + parts[1] + parts[2];
      if (!sum || parts.some((part) => part / sum < 0)) continue;
      const shares = parts.map((part) => part / sum);
      const place = [0, 1, 2].map((i) => shares.reduce((t, s, j) => t + s * corners[j][i], 0));
      if (cut && side * (place[cut.axis] - cut.at) > 0) continue;
      const depth = dot(place, view.eye);
      if (!best || depth > best.depth) {
        const value = shares.reduce((t, s, j) => t + s * result.values[ids[j]], 0);
        best = { depth, place, value };
      }
    }
    if (best) tell(best.place, best.value);
  };
  const number = (value) => Number(value.toPrecision(4)).toString();
  const tell = (place, value) => {
    marked = place;
    const sign = value > 0 && data.signed ? "+" : "";
    const words = place.map((each) => number(each)).join(", ");
    byId("told").textContent = `${sign}${number(value)} mm at ${words}`;
    redraw();
  };

  // ---- controls

  const colour = (value) => {
    const where = (Math.min(1, Math.max(-1, value / range)) + 1) * 2;
    const stop = Math.min(3, Math.floor(where));
    const mixed = data.stops[stop].map((c, k) => c + (data.stops[stop + 1][k] - c) * (where - stop));
    return `rgb(${mixed.map(Math.round).join(" ")})`;
  };
  const setRange = (value) => {
    if (!(value > 0)) return;
    range = value;
    byId("range").value = number(range);
    // The slider runs over three decades around the range that the engine chose.
    byId("range-slider").value = Math.round(1000 * Math.log10(range / data.range));
    document.querySelectorAll("[data-share]").forEach((tick) => {
      const at = Number(tick.dataset.share) * range;
      tick.textContent = `${at > 0 && data.signed ? "+" : ""}${number(at)} mm`;
    });
    document.querySelectorAll("rect[data-middle]").forEach((bar) => {
      bar.style.fill = colour(Number(bar.dataset.middle));
    });
    redraw();
  };
  byId("range").addEventListener("change", (event) => setRange(Number(event.target.value)));
  byId("range-slider").addEventListener("input", (event) => {
    setRange(data.range * 10 ** (Number(event.target.value) / 1000));
  });
  for (const name of ["axis", "cut", "show-result", "show-reference"]) {
    byId(name).addEventListener("input", redraw);
  }
  const quarter = Math.PI / 2;
  const views = {
    home: [home.yaw, home.pitch],
    front: [0, 0],
    top: [0, quarter],
    right: [quarter, 0],
    rear: [2 * quarter, 0],
    left: [-quarter, 0],
    bottom: [0, -quarter],
  };
  document.querySelectorAll("button[data-view]").forEach((button) => {
    button.addEventListener("click", () => look(...views[button.dataset.view]));
  });
  document.querySelectorAll("button[data-point]").forEach((button) => {
    button.addEventListener("click", () => {
      const place = button.dataset.point.split(",").map(Number);
      const out = add(place, centre, -1);
      const flatLength = Math.hypot(out[0], out[1]);
      const yaw = flatLength > 1e-6 * diagonal ? Math.atan2(out[0], -out[1]) : camera.yaw;
      const pitch = Math.min(1.2, Math.max(-1.2, Math.atan2(out[2], flatLength)));
      tell(place, Number(button.dataset.value));
      fly({ yaw, pitch, zoom: 3, target: place });
      canvas.scrollIntoView({ block: "nearest" });
    });
  });
  new ResizeObserver(redraw).observe(canvas);
  byId("controls").hidden = false;
  byId("still").hidden = true;
  canvas.hidden = false;
  setRange(range);
  draw();
})();
