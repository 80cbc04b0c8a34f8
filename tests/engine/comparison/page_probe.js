window.addEventListener("load", () => {
  const canvas = document.getElementById("view");
  const pixels = () => {
    const gl = canvas.getContext("webgl2");
    const all = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, all);
    let sum = 0, inked = 0;
    for (let k = 0; k < all.length; k += 4) {
      const ink = 765 - all[k] - all[k + 1] - all[k + 2];
      inked += ink > 0;
      sum = (sum + ink * (1 + k % 9973)) % 1e9;
    }
    return [sum, inked / (canvas.width * canvas.height)];
  };
  const seen = {};
  const wait = (time) => new Promise((done) => setTimeout(done, time));
  const point = (kind, x, y) => canvas.dispatchEvent(
    new PointerEvent(kind, { pointerId: 1, clientX: x, clientY: y, buttons: 1, bubbles: true }));
  (async () => {
    await wait(300);
    const box = canvas.getBoundingClientRect();
    const [x, y] = [box.left + box.width / 2, box.top + box.height / 2];
    seen.first = pixels();
    point("pointerdown", x, y); point("pointerup", x, y); await wait(200);
    seen.told = document.getElementById("told").textContent;
    seen.marked = pixels();
    point("pointerdown", x, y);
    point("pointermove", x + 60, y + 20);
    point("pointerup", x + 60, y + 20);
    await wait(200); seen.turned = pixels();
    canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
    await wait(200); seen.keyed = pixels();
    canvas.dispatchEvent(new WheelEvent("wheel", { deltaY: -300, cancelable: true }));
    await wait(200); seen.zoomed = pixels();
    const range = document.getElementById("range");
    range.value = 0.5; range.dispatchEvent(new Event("change"));
    await wait(200); seen.ranged = pixels();
    seen.ticks = [...document.querySelectorAll("[data-share]")].map((each) => each.textContent);
    const axis = document.getElementById("axis");
    axis.value = "z"; axis.dispatchEvent(new Event("input"));
    await wait(200); seen.cut = pixels();
    document.querySelector("button[data-point]").click();
    await wait(900); seen.flown = pixels();
    seen.worst = document.getElementById("told").textContent;
    seen.state = document.body.dataset.viewer;
    seen.still = document.getElementById("still").hidden;
    const out = document.createElement("pre");
    out.id = "seen"; out.textContent = JSON.stringify(seen);
    document.body.append(out);
  })();
});
