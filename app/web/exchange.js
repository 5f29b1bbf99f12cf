// What comes in and goes out: files, the clipboard, downloads.

const largestFile = 512 * 1024 * 1024;
const complain = (line) => { call("complain", null, ["string"], [line]); wake(); };

const lastOf = (path) => path.split("/").pop();

// What cannot be opened before a file is here, and what is shown meanwhile: the address stays until something else is.
let awaited = null;

// A mesh is found by its last name, wherever it lay for whoever made the link.
function open(name) {
    const missing = call("missing", "string", ["string"], [name]);
    awaited = null;
    if (missing && !liesElsewhere(missing)) {
        awaited = { name, file: missing, meanwhile: call("shown", "string", [], []) };
        complain(`${lastOf(missing)}: this page does not have the file, which the scene needs; drop it here, or open it`);
    } else {
        call("open", null, ["string"], [name]);
    }
    wake();
}
function liesElsewhere(missing) {
    const here = "/" + lastOf(missing), { FS } = engine;
    if (here === missing || !FS.analyzePath(here).exists) return false;
    FS.mkdirTree(missing.slice(0, missing.lastIndexOf("/")) || "/");
    FS.symlink(here, missing);
    return true;
}

// Its path within the page.
async function take(file) {
    if (file.size > largestFile) throw Error("larger than 512 MB, the most that a page reads");
    const path = "/" + file.name.replace(/[/\0]/g, "_");
    engine.FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
    return path;
}

// All of them come into the page, since a scene may name others of them.
async function openFiles(files) {
    const paths = [];
    for (const file of files)
        try {
            paths.push(await take(file));
        } catch (error) {
            return complain(`${file.name}: cannot be read: ${error.message || error.name}`);
        }
    if (paths.length === 0) return;
    if (awaited && paths.some((path) => lastOf(path) === lastOf(awaited.file))) open(awaited.name);
    else open(paths.find((path) => /\.json$/i.test(path)) ?? paths[0]);
}

const chooser = document.getElementById("file");
page.chooseFile = () => { chooser.value = ""; chooser.click(); };
chooser.addEventListener("change", () => openFiles([...chooser.files]));
window.addEventListener("dragover", (event) => event.preventDefault());
window.addEventListener("drop", (event) => {
    event.preventDefault();
    if (engine) openFiles([...event.dataTransfer.files]);
});

page.download = (name, bytes) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([bytes]));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
};

// By the clipboard's interface where the page has it, or as one copied before there was one, or else by hand.
page.copy = (text) => {
    const byHand = () => { if (!copyOldWay(text)) showToCopy(text); };
    if (navigator.clipboard?.writeText) navigator.clipboard.writeText(text).catch(byHand);
    else byHand();
};
function copyOldWay(text) {
    const field = document.createElement("textarea");
    field.value = text;
    field.style.position = "fixed";
    document.body.append(field);
    const before = document.activeElement;
    field.select();
    let copied = false;
    try {
        copied = document.execCommand("copy");
    } catch { /* not allowed */ }
    field.remove();
    before?.focus?.({ preventScroll: true });
    return copied;
}
function showToCopy(text) {
    const field = document.getElementById("to-copy-text");
    field.value = text;
    document.getElementById("to-copy").showModal();
    field.select();
}
