// The address follows what is shown, and what is shown the address.

let shown = "";  // the name or link that the address has now
const nameInAddress = () => location.hash.length > 1 ? location.hash : "";

page.addressOf = (name) => location.protocol.startsWith("http") ? location.href.split("#")[0] + "#" + name : name;

const stepOf = (name) => /^(.+)\/\d+$/.exec(name)?.[1];

// Steps of a lesson are places to go back to; all else replaces what was there.
function followAddress() {
    const now = call("shown", "string", [], []);
    if (now === shown || now === awaited?.meanwhile) return;
    awaited = null;
    const isStep = stepOf(now) && stepOf(now) === stepOf(shown);
    shown = now;
    if (location.hash === "#" + now) return;
    try {
        if (isStep) history.pushState(null, "", "#" + now);
        else history.replaceState(null, "", "#" + now);
    } catch { /* a frame without an origin has no address of its own, or it changed too often */ }
}
window.addEventListener("popstate", () => {
    if (!engine || !nameInAddress()) return;
    clearTimeout(following);
    shown = location.hash.slice(1);
    open(location.hash);
});

// ?lesson=NAME, ?scene=NAME: what a page around this one asks for. Without a name: the first lesson.
function nameAskedFor() {
    if (asked.has("lesson")) return asked.get("lesson") || "1-normal-as-a-point";
    return asked.get("scene") || "";
}
