// Fingers. What the first one means is known only when it lifts, moves, rests or is joined by another: until then nothing is
// pressed. On the picture it is the left button; on a control, too, but for up and down, which scrolls. Two on the picture
// pan and pinch.

const slack = 8;    // pixels of the browser's: a finger is not that still
const rests = 400;  // milliseconds, after which a control is held

const fingers = new Map();  // by their number: where they are, in pixels of the canvas
let hand = null;            // what they do, until all are lifted

function touch(event) {
    fingers.set(event.pointerId, place(event));
    if (fingers.size === 1) begin(place(event));
    else if (fingers.size === 2) join();
    wake();
}
function begin(at) {
    point(at);
    settleOnce();
    hand = { does: "nothing yet", from: at, at, onControl: call("on_control", "number", [], []) };
    if (hand.onControl) hand.rest = setTimeout(rest, rests);
}
// Where drawing took longer than that, the finger may have moved long since: a frame begins with all that it did.
function rest() {
    const held = hand;
    requestAnimationFrame(() => { if (hand === held && held.does === "nothing yet") press(); });
}
// What is under a finger is known only after a round with the pointer there.
function settleOnce() {
    call("step", "number", [], []);
    call("step", "number", [], []);
}
function press() {
    clearTimeout(hand.rest);
    hand.does = "press";
    point(hand.from);
    button(0, true, 0);
    wake();
}
function join() {
    letGo();
    if (hand.onControl) return;
    Object.assign(hand, { does: "pinch", two: pair() });
    point(hand.two);
    button(1, true, 0);
}
function pair() {
    const [a, b] = [...fingers.values()];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(a.x - b.x, a.y - b.y) };
}

function moveFinger(event) {
    if (!fingers.has(event.pointerId)) return;
    const at = place(event);
    fingers.set(event.pointerId, at);
    if (hand.does === "nothing yet") decide(at);
    if (hand.does === "press") point(at);
    if (hand.does === "scroll") call("scroll_grabbed", null, ["number"], [at.y - hand.at.y]);
    if (hand.does === "pinch" && fingers.size === 2) pinch();
    if (hand.does !== "nothing yet") hand.at = at;
    wake();
}
const isFar = ({ x, y }) => Math.hypot(x - hand.from.x, y - hand.from.y) >= slack * canvas.width / canvas.clientWidth;
function decide(at) {
    if (!isFar(at)) return;
    const upOrDown = Math.abs(at.y - hand.from.y) > Math.abs(at.x - hand.from.x);
    if (!hand.onControl || !upOrDown || !call("grab_to_scroll", "number", [], [])) return press();
    clearTimeout(hand.rest);
    hand.does = "scroll";
    call("pointer_left", null, [], []);  // nothing is pointed at that goes by below the finger
}
function pinch() {
    const now = pair();
    if (hand.two.apart > 0 && now.apart > 0)
        call("scroll", null, ["number", "number"], [0, 8 * Math.log2(now.apart / hand.two.apart)]);
    point(now);
    hand.two = now;
}

function liftFinger(event) {
    if (!fingers.delete(event.pointerId)) return;
    if (hand.does === "nothing yet" && event.type === "pointerup") {
        press();  // a tap
        button(0, false, 0);
        hand.does = "nothing more";
    } else {
        letGo();
    }
    if (fingers.size === 0) {
        settle();
        call("pointer_left", null, [], []);
        hand = null;
    }
    wake();
}
function letGo() {
    clearTimeout(hand.rest);
    if (hand.does === "pinch") button(1, false, 0);
    if (hand.does === "press") {
        if (hand.onControl && isFar(hand.at)) leaveButton();
        button(0, false, 0);
    }
    hand.does = "nothing more";
}
// A finger that has moved does not press the button on which it began: what is let go elsewhere is not pressed.
function leaveButton() {
    settleOnce();
    if (!call("holds_what_follows", "number", [], [])) call("pointer_left", null, [], []);
}
