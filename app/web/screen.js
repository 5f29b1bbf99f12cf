// When to draw, and how large.

let wanted = 0;         // a frame that the browser has been asked for
let later = 0;          // a timer until the next one
let drawn = 0;          // frames so far
let nextIn = 0;         // seconds, from the last one on

function sizeNow() {
    const scale = window.devicePixelRatio || 1;
    const box = canvas.getBoundingClientRect();
    return { width: Math.max(Math.round(box.width * scale), 1), height: Math.max(Math.round(box.height * scale), 1), scale };
}

// Draws what has changed, and comes again only when there is something to do: an idle page has no frames.
function frame() {
    wanted = 0;
    clearTimeout(later);
    if (!engine || document.hidden) return;
    const due = call("step", "number", [], []);
    nextIn = due < 0 ? Infinity : due;
    ++drawn;
    showKeyboard(call("wants_letters", "number", [], []));
    if (due !== 0) after();
    if (due === 0) wanted = requestAnimationFrame(frame);
    else if (due > 0) later = setTimeout(wake, 1000 * due);
}

// Nothing is left to be drawn, but for a line that will go by itself.
const isQuiet = () => engine !== null && drawn > 0 && !wanted && nextIn > 0.2;

function wake() {
    if (!wanted && engine) wanted = requestAnimationFrame(frame);
}

// At once, until nothing is left to do: what the browser allows only within an event depends on what is under the finger.
function settle() {
    for (let i = 0; i < 4; ++i) call("step", "number", [], []);
    showKeyboard(call("wants_letters", "number", [], []));
    wake();
}

// When nothing is on its way: what is seen is said wherever it is to be said.
function after() {
    if (call("is_busy", "number", [], [])) return;
    call("remember_settings", null, [], []);
    clearTimeout(following);
    following = setTimeout(followAddress, 250);  // not each notch of a wheel
    describe();
    tellWhatIsShown();
}

let following = 0;
let said = "";
function describe() {
    const now = call("description", "string", [], []);
    if (now !== said) document.getElementById("said").textContent = said = now;
}

function resize(width, height, scale) {
    if (!engine || (canvas.width === width && canvas.height === height)) return;
    canvas.width = width;
    canvas.height = height;
    call("resize", null, ["number", "number", "number"], [width, height, scale]);
    wanted || frame();  // a canvas whose size was set is empty
}

new ResizeObserver((entries) => {
    const exact = entries[0].devicePixelContentBoxSize?.[0];
    const { width, height, scale } = sizeNow();
    // What the browser counts to the pixel, unless a scale is but simulated.
    if (exact && Math.abs(exact.inlineSize - width) <= 1) resize(exact.inlineSize, exact.blockSize, scale);
    else resize(width, height, scale);
}).observe(canvas);
function watchScale() {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", () => {
        const { width, height, scale } = sizeNow();
        resize(width, height, scale);
        watchScale();
    }, { once: true });
}
watchScale();

document.addEventListener("visibilitychange", wake);
canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    if (engine) call("lose", null, [], []);
});
canvas.addEventListener("webglcontextrestored", () => {
    if (!engine) return;
    call("restore", null, [], []);
    wake();
});

// A drawing buffer is empty once it has been shown: what is printed is a copy.
window.addEventListener("beforeprint", () => {
    if (!engine) return;
    const printed = document.getElementById("printed");
    printed.width = canvas.width;
    printed.height = canvas.height;
    call("resize", null, ["number", "number", "number"], [canvas.width, canvas.height, sizeNow().scale]);  // drawn anew
    call("step", "number", [], []);
    printed.getContext("2d").drawImage(canvas, 0, 0);
});

page.toggleFullScreen = () => {
    if (document.fullscreenElement) document.exitFullscreen();
    else document.documentElement.requestFullscreen?.().catch(() => {});  // a frame may not be allowed to
};
document.addEventListener("fullscreenchange", wake);
