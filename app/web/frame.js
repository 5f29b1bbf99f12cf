// In a frame of another page: what its owner is told, and what it may ask for. docs/web.md has both.

const owner = window.parent !== window ? window.parent : null;
const tell = (what) => owner?.postMessage(what, "*");

let told = "";
function tellWhatIsShown() {
    const now = owner ? call("told", "string", [], []) : "";
    if (now === told) return;
    const before = told ? JSON.parse(told) : {};
    told = now;
    const { answer, right, ...what } = JSON.parse(now);
    if (before.name !== what.name) tell({ normalscope: "shown", ...what });
    if (answer && (before.answer !== answer || before.name !== what.name))
        tell({ normalscope: "answered", lesson: what.lesson, step: what.step, answer, right });
}

const doings = {
    open: ({ name }) => open(String(name)),
    step: ({ step }) => told && JSON.parse(told).lesson
        ? open(`#${JSON.parse(told).lesson}/${Number(step)}`)
        : complain("The page around this one asks for a step, but no lesson is shown."),
    next: () => tap("ArrowRight"),
    previous: () => tap("ArrowLeft"),
};
window.addEventListener("message", (event) => {
    const wanted = event.data?.normalscope;
    if (!engine || event.source !== owner || wanted === undefined) return;
    if (Object.hasOwn(doings, wanted)) doings[wanted](event.data);
    else complain(`The page around this one asks for "${String(wanted).slice(0, 40)}", which this program does not know.`);
});
