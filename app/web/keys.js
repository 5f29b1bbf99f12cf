// Keys and letters.

const letters = document.getElementById("letters");
const modifiers = (event) => event.ctrlKey | event.shiftKey << 1 | event.altKey << 2 | event.metaKey << 3;

// A browser's own: closing and changing tabs, its tools, and Alt with letters, which are menus.
function isBrowsers(event) {
    if (event.key === "F12" || event.metaKey) return true;
    if (event.ctrlKey && ["n", "t", "w", "r", "Tab", "PageUp", "PageDown"].includes(event.key)) return true;
    return event.ctrlKey && event.shiftKey && ["I", "J", "N", "P", "T", "R"].includes(event.key);
}

function passKey(event, down) {
    call("key", null, ["string", "string", "number", "number", "number"],
        [event.key, event.code, modifiers(event), down ? 1 : 0, event.repeat ? 1 : 0]);
    wake();
}

function type(text) {
    for (const letter of text) call("type", null, ["number"], [letter.codePointAt(0)]);
    wake();
}

let escaped = false;  // in another page: after Esc, Tab goes on through that page
function leaves(event) {
    if (event.key === "Tab" && escaped) return true;
    if (event.key !== "Shift") escaped = owner !== null && event.key === "Escape";
    return false;
}

let pasting = null;  // Ctrl+V, until the browser says what is in the clipboard

function onKeyDown(event) {
    if (!engine || event.isComposing || isBrowsers(event) || event.target.closest("dialog")) return;
    if (event.key === "Unidentified" || event.keyCode === 229) return;  // letters will come by themselves
    if (leaves(event)) return;
    if (event.ctrlKey && !event.shiftKey && event.key.toLowerCase() === "v") {
        pasting = event;
        return;
    }
    event.preventDefault();
    passKey(event, true);
    const printed = [...event.key].length === 1;
    const composed = event.getModifierState?.("AltGraph") || !(event.ctrlKey || event.altKey);
    if (printed && composed) type(event.key);
}

window.addEventListener("keydown", onKeyDown);
window.addEventListener("keyup", (event) => {
    if (engine && !event.isComposing) passKey(event, false);
});
window.addEventListener("paste", (event) => {
    if (!engine || event.target.closest?.("dialog")) return;
    event.preventDefault();
    const files = [...event.clipboardData.files];
    if (files.length > 0) return openFiles(files);
    call("pasted", null, ["string"], [event.clipboardData.getData("text/plain")]);
    const key = pasting || { key: "v", code: "KeyV", ctrlKey: true };
    passKey(key, true);
    pasting = null;
});
window.addEventListener("blur", () => engine && (call("focus", null, ["number"], [0]), wake()));
window.addEventListener("focus", () => engine && (call("focus", null, ["number"], [1]), wake()));

// Keyboards on screens, and whatever composes letters, write into a field of the browser's.
letters.addEventListener("input", (event) => {
    if (event.isComposing) return;
    letters.value = "";
    if (event.inputType === "deleteContentBackward") return tap("Backspace");
    if (event.inputType === "insertLineBreak") return tap("Enter");
    if (event.data) type(event.data);
});
letters.addEventListener("compositionend", (event) => {
    letters.value = "";
    type(event.data);
});

function tap(key) {
    passKey({ key, code: key }, true);
    passKey({ key, code: key }, false);
}

let touched = false;  // what was used last has no keys of its own
function showKeyboard(isWanted) {
    if (isWanted && document.activeElement !== letters) letters.focus({ preventScroll: true });
    else if (!isWanted && document.activeElement === letters) touched ? letters.blur() : canvas.focus({ preventScroll: true });
}
