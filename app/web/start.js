// The page around the engine: `page` is what the engine asks, and `engine` what the page calls. The other scripts add to it.
const canvas = document.getElementById("canvas");
const page = { canvas };
let engine = null;

// A page within another's text has no address: its frame's name stands for that.
const asked = new URLSearchParams(location.protocol === "about:" ? window.name : location.search);

// Where storage is forbidden, as in a sandbox, nothing is kept.
const storage = {
    get(key) {
        try {
            return localStorage.getItem("normalscope." + key) || "";
        } catch {
            return "";
        }
    },
    keys() {
        try {
            return Object.keys(localStorage).filter((key) => key.startsWith("normalscope.")).map((key) => key.slice(12));
        } catch {
            return [];
        }
    },
    set(key, text) {
        try {
            if (text) localStorage.setItem("normalscope." + key, text);
            else localStorage.removeItem("normalscope." + key);
        } catch { /* full, or forbidden: what is seen is still in the address */ }
    },
};
page.remember = (key, text) => storage.set(key === "unsaved" ? ownWork : key, text);

// Unsaved work has a key of this page's own, so that two of them do not write over each other's. A lock of that name says
// that its page lives.
const locks = navigator.locks;
const ownWork = locks ? "unsaved." + Date.now().toString(36) + Math.random().toString(36).slice(2) : "unsaved";

// What pages that are gone have left becomes this one's.
async function takeUpLeftWork() {
    const living = new Set();
    try {
        locks?.request(ownWork, () => new Promise(() => {})).catch(() => {});
        for (const { name } of (await locks?.query())?.held ?? []) living.add(name);
    } catch { /* a page without an origin, which has no storage either */ }
    const left = storage.keys().filter((key) => /^unsaved(\.|$)/.test(key) && !living.has(key));
    const works = left.flatMap((key) => {
        try {
            return JSON.parse(storage.get(key));
        } catch {
            return [];
        }
    });
    if (works.length === 0) return "";
    const text = JSON.stringify(works);
    storage.set(ownWork, text);
    if (storage.get(ownWork) === text)
        for (const key of left) if (key !== ownWork) storage.set(key, "");
    return text;
}

const call = (name, result, types, values) => engine.ccall("page_" + name, result, types, values);

function sorry(line) {
    const wait = document.getElementById("wait");
    wait.hidden = false;
    wait.className = "sorry";
    wait.textContent = line;
    canvas.hidden = true;
    tell({ normalscope: "failed", line });
}

// One letter is one byte, plus one.
function bytesOf(text) {
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i) - 1;
    return bytes;
}

async function start() {
    if (!window.WebAssembly) return sorry("Normalscope needs WebAssembly, which this browser does not have.");
    const probe = document.createElement("canvas").getContext("webgl2");
    if (!probe) return sorry("Normalscope needs WebGL 2, which this browser does not have or has turned off.");
    probe.getExtension("WEBGL_lose_context")?.loseContext();
    try {
        engine = await makeEngine({ page, wasmBinary: bytesOf(engineText), print: console.log, printErr: console.warn });
    } catch (error) {
        return sorry("Normalscope cannot start: " + error.message);
    }
    const { width, height, scale } = sizeNow();
    canvas.width = width;
    canvas.height = height;
    const named = nameInAddress() || nameAskedFor();
    const prefers = (what) => matchMedia(`(prefers-${what})`).matches ? 1 : 0;
    const light = ["light", "dark"].find((theme) => theme === asked.get("theme"));
    const dark = light ? Number(light === "dark") : prefers("color-scheme: dark");
    const settings = storage.get("settings") || (named || owner ? "{}" : "");  // nobody is greeted within another page
    // A page within another's is not asked about what it is not to show.
    const left = named && owner ? "" : await takeUpLeftWork();
    const missing = named && call("missing", "string", ["string"], [named]);
    const failed = call("start", "string", ["string", "string", "string", "number", "number", "number", "number", "number", "number"],
        [missing ? "" : named, settings, left, width, height, scale, dark, light ? 1 : 0, prefers("reduced-motion: reduce")]);
    if (failed) return sorry("Normalscope cannot start: " + failed + ".");
    document.getElementById("wait").hidden = true;
    call("set_in", null, ["number", "number"], [asked.get("panel") === "0" ? 0 : 1, asked.has("present") ? 1 : 0]);
    matchMedia("(prefers-reduced-motion: reduce)").addEventListener("change", (event) => call("move", null, ["number"], [event.matches ? 0 : 1]));
    if (missing) open(named);  // which says what it waits for
    tell({ normalscope: "ready" });
    frame();
}

window.addEventListener("DOMContentLoaded", start);

const line = () => call("line", "string", [], []);  // the message that is shown
