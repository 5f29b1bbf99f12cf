// In a frame of another page: what its owner is told, and what it may ask for. docs/web.md has both.

const owner = window.parent !== window ? window.parent : null;
const tell = (what) => owner?.postMessage(what, "*");

let told = "", askedFor = null;
const answers = new Map();  // by step: those that the owner knows of
function tellWhatIsShown() {
    const now = owner ? call("told", "string", [], []) : "";
    if (now === told && askedFor === null) return;
    const before = told ? JSON.parse(told) : {};
    told = now;
    const { answer, right, ...what } = JSON.parse(now);
    if (askedFor !== null) tell({ normalscope: "shown", ...what, asked: askedFor });
    else if (before.name !== what.name) tell({ normalscope: "shown", ...what });
    askedFor = null;
    const place = `${what.lesson}/${what.step}`;
    if (answer && answers.get(place) !== answer)
        tell({ normalscope: "answered", lesson: what.lesson, step: what.step, answer, right });
    answers.set(place, answer);
}

const doings = {
    async open({ name, files = [] }) {
        for (const file of files) await take(file);
        askedFor = String(name);
        open(askedFor);
    },
    step: ({ step }) => told && JSON.parse(told).lesson
        ? open(`#${JSON.parse(told).lesson}/${Number(step)}`)
        : complain("The page around this one asks for a step, but no lesson is shown"),
    next: () => tap("ArrowRight"),
    previous: () => tap("ArrowLeft"),
};
window.addEventListener("message", async (event) => {
    const wanted = event.data?.normalscope;
    if (!engine || event.source !== owner || wanted === undefined) return;
    try {
        if (!Object.hasOwn(doings, wanted)) throw Error("this program does not know that");
        await doings[wanted](event.data);
    } catch (error) {
        complain(`The page around this one asks for "${String(wanted).slice(0, 40)}": ${error.message}`);
    }
});
