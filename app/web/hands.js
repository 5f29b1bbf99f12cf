// Mouse, pen and fingers.

const fingers = new Map();  // by their number: where they are, in pixels of the canvas
let two = null;             // of two fingers: their middle and distance

const place = (event) => ({ x: event.clientX * canvas.width / canvas.clientWidth, y: event.clientY * canvas.height / canvas.clientHeight });
const point = ({ x, y }) => call("pointer", null, ["number", "number"], [x, y]);
const button = (which, down, held) => call("button", null, ["number", "number", "number"], [which, down ? 1 : 0, held]);
const dearButton = [0, 2, 1, 3, 4];  // the browser's second is the middle one

canvas.addEventListener("pointerdown", (event) => {
    if (!engine) return;
    event.preventDefault();
    touched = event.pointerType === "touch";
    if (document.activeElement !== letters) canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    if (touched) return touch(event);
    point(place(event));
    button(dearButton[event.button] ?? 0, true, modifiers(event));
    wake();
});
canvas.addEventListener("pointermove", (event) => {
    if (!engine) return;
    if (event.pointerType === "touch") return moveFinger(event);
    point(place(event));
    wake();
});
for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, (event) => {
        if (!engine) return;
        if (event.pointerType === "touch") return liftFinger(event);
        button(dearButton[event.button] ?? 0, false, modifiers(event));
        wake();
    });
canvas.addEventListener("pointerleave", (event) => {
    if (engine && event.pointerType !== "touch") call("pointer_left", null, [], []), wake();
});
canvas.addEventListener("contextmenu", (event) => event.preventDefault());

// One finger is the left button. With a second one both pan and pinch, until all are lifted.
function touch(event) {
    fingers.set(event.pointerId, place(event));
    if (fingers.size === 1) {
        point(place(event));
        settleOnce();
        button(0, true, 0);
    } else if (fingers.size === 2) {
        button(0, false, 0);
        two = pair();
        if (!call("on_control", "number", [], [])) {
            point(two);
            button(1, true, 0);
        }
    }
    wake();
}
// What is under a finger is known only after a round with the pointer there.
function settleOnce() {
    call("step", "number", [], []);
    call("step", "number", [], []);
}
function pair() {
    const [a, b] = [...fingers.values()];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(a.x - b.x, a.y - b.y) };
}
function moveFinger(event) {
    if (!fingers.has(event.pointerId)) return;
    fingers.set(event.pointerId, place(event));
    if (!two) {
        point(place(event));
    } else if (fingers.size === 2) {
        const now = pair();
        if (two.apart > 0 && now.apart > 0) call("scroll", null, ["number", "number"], [0, 8 * Math.log2(now.apart / two.apart)]);
        point(now);
        two = now;
    }
    wake();
}
function liftFinger(event) {
    if (!fingers.delete(event.pointerId)) return;
    if (two && fingers.size === 1) button(1, false, 0);
    if (!two && fingers.size === 0) button(0, false, 0);
    if (fingers.size === 0) {
        two = null;
        settle();
        call("pointer_left", null, [], []);
    }
    wake();
}

// A notch of a mouse's wheel is one step, whatever unit the browser counts in.
canvas.addEventListener("wheel", (event) => {
    if (!engine) return;
    event.preventDefault();
    const unit = [1 / 100, 1 / 3, 1][event.deltaMode];
    const faster = event.ctrlKey ? 6 : 1;  // fingers that pinch on a touchpad
    call("scroll", null, ["number", "number"], [-event.deltaX * unit, -event.deltaY * unit * faster]);
    wake();
}, { passive: false });
