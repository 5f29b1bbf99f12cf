// What comes in and goes out: files, the clipboard, downloads.

const largestFile = 512 * 1024 * 1024;
const complain = (line) => { call("complain", null, ["string"], [line]); wake(); };

function open(name) {
    call("open", null, ["string"], [name]);
    wake();
}

// Its path within the page.
async function take(file) {
    if (file.size > largestFile) throw Error("larger than 512 MB, the most that a page reads");
    const path = "/" + file.name.replace(/[/\0]/g, "_");
    engine.FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
    return path;
}

async function openFile(file) {
    try {
        open(await take(file));
    } catch (error) {
        complain(`${file.name}: cannot be read: ${error.message || error.name}`);
    }
}

const chooser = document.getElementById("file");
page.chooseFile = () => { chooser.value = ""; chooser.click(); };
chooser.addEventListener("change", () => chooser.files[0] && openFile(chooser.files[0]));
window.addEventListener("dragover", (event) => event.preventDefault());
window.addEventListener("drop", (event) => {
    event.preventDefault();
    if (engine && event.dataTransfer.files[0]) openFile(event.dataTransfer.files[0]);
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
