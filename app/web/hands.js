// Mouse and pen; what a finger does is in fingers.js.

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

// A notch of a mouse's wheel is one step, whatever unit the browser counts in.
canvas.addEventListener("wheel", (event) => {
    if (!engine) return;
    event.preventDefault();
    const unit = [1 / 100, 1 / 3, 1][event.deltaMode];
    const faster = event.ctrlKey ? 6 : 1;  // fingers that pinch on a touchpad
    call("scroll", null, ["number", "number"], [-event.deltaX * unit, -event.deltaY * unit * faster]);
    wake();
}, { passive: false });
