// Files, downloads, the clipboard and what is kept.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";

import { drawn, fileUrl, folder, launch, open, press, scene, serve } from "./browser.mjs";

const browser = await launch();
test.after(() => browser.close());

const asked = (page) => page.evaluate(() => call("asks", "number", [], []) !== 0);
const tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const dropTogether = (page, files) => page.evaluate((each) => {
    const data = new DataTransfer();
    for (const [name, content] of each) data.items.add(new File([content], name));
    window.dispatchEvent(Object.assign(new Event("drop", { cancelable: true }), { dataTransfer: data }));
}, files);
const drop = (page, name, text) => dropTogether(page, [[name, text]]);

test("dropped: a mesh, a scene, and what is neither", async () => {
    const { page, said } = await open(browser, fileUrl);
    await drop(page, "solid.obj", tetrahedron);
    await page.waitForFunction(() => document.title.includes("solid.obj"));
    assert.equal((await scene(page)).surface.mesh, "/solid.obj");
    await drop(page, "bad.obj", "v 1 2\nf 1 1 1\n");
    await page.waitForFunction(() => line().includes("bad.obj"));
    await drop(page, "holiday.jpg", "x");
    await page.waitForFunction(() => line().includes("holiday.jpg"));
    assert.equal((await scene(page)).surface.mesh, "/solid.obj");
    assert.deepEqual(said, []);
    await page.close();
});

test("a scene and its mesh are dropped together, or one after the other", async () => {
    const mine = JSON.stringify({ rule: "naive", surface: { mesh: "../meshes/solid.obj" } });
    for (const files of [[["solid.obj", tetrahedron], ["mine.json", mine]], [["mine.json", mine], ["solid.obj", tetrahedron]]]) {
        const { page, said } = await open(browser, fileUrl);
        await dropTogether(page, files);
        await page.waitForFunction(() => document.title.includes("mine.json"));
        assert.equal((await scene(page)).rule, "naive");
        assert.equal(await page.evaluate("line()"), "");
        assert.deepEqual(said, []);
        await page.close();
    }
    const { page } = await open(browser, fileUrl);
    await drop(page, "mine.json", mine);
    await page.waitForFunction(() => line().startsWith("solid.obj: "));
    await drop(page, "solid.obj", tetrahedron);
    await page.waitForFunction(() => document.title.includes("mine.json"));
    assert.equal(await page.evaluate("line()"), "");
    await page.close();
});

test("after a reload a dropped mesh is asked for, and the address is kept", async (t) => {
    const { url } = await serve(t);
    const { page, said } = await open(browser, url);
    await drop(page, "solid.obj", tetrahedron);
    await page.waitForFunction(() => location.hash.startsWith("#normalscope:1."));
    await press(page, "n");
    await new Promise((done) => setTimeout(done, 400));
    const before = await page.evaluate("location.hash");
    await page.reload();
    await drawn(page);
    if (await asked(page)) await press(page, "Escape");
    await new Promise((done) => setTimeout(done, 400));
    assert.equal(await page.evaluate("location.hash"), before);
    assert.match(await page.evaluate("line()"), /^solid.obj: .*drop it/);
    await drop(page, "solid.obj", tetrahedron);
    await page.waitForFunction(() => JSON.parse(call("scene", "string", [], [])).surface.mesh === "/solid.obj");
    assert.equal((await scene(page)).rule, "naive");
    assert.equal(await page.evaluate("line()"), "");
    assert.deepEqual(said, []);
    await page.close();
});

test("a file that is too large, and storage that is full", async () => {
    const { page, said } = await open(browser, fileUrl);
    await page.evaluate(() => { Storage.prototype.setItem = () => { throw new DOMException("full", "QuotaExceededError"); }; });
    await page.evaluate(() => openFiles([{ name: "huge.obj", size: 2 ** 33 }]));
    await page.waitForFunction(() => line() === "huge.obj: cannot be read: larger than 512 MB, the most that a page reads");
    await press(page, "n");
    assert.equal((await scene(page)).rule, "naive");
    assert.deepEqual(said, []);
    await page.close();
});

test("opened by the browser's dialog", async (t) => {
    const file = join(folder(t), "mine.json");
    writeFileSync(file, JSON.stringify({ rule: "cofactor" }));
    const { page } = await open(browser, fileUrl);
    const waiting = page.waitForFileChooser();
    await new Promise((done) => setTimeout(done, 300));  // until the browser knows who waits
    await press(page, "Control", "o");
    const chooser = await waiting;
    await chooser.accept([file]);
    await page.waitForFunction(() => document.title.includes("mine.json"));
    assert.equal((await scene(page)).rule, "cofactor");
    await page.close();
});

test("the picture is saved by a download", async (t) => {
    const { page, said } = await open(browser, fileUrl);
    await page.evaluate(() => { page.download = (name, bytes) => { window.saved = { name, first: [...bytes.slice(0, 4)], length: bytes.length }; }; });
    await press(page, "Control", "p");
    await press(page, "Enter");
    await page.waitForFunction(() => window.saved);
    assert.deepEqual((await page.evaluate("saved.first")), [0x89, 0x50, 0x4e, 0x47]);
    assert.deepEqual(said, []);
    await page.close();
});

test("Ctrl+L and Ctrl+V: an address through the clipboard, here to here", async (t) => {
    const { url, origin } = await serve(t);
    await browser.defaultBrowserContext().overridePermissions(origin, ["clipboard-read", "clipboard-write"]);
    const { page } = await open(browser, url + "#shear");
    await page.bringToFront();
    await press(page, "n");
    await press(page, "Control", "l");
    const copied = await page.evaluate(() => navigator.clipboard.readText());
    assert.ok(copied.startsWith(url + "#normalscope:1."), copied);
    await press(page, "i");
    assert.equal((await scene(page)).rule, "inverse-transpose");
    await page.evaluate((text) => {
        const data = new DataTransfer();
        data.setData("text/plain", text);
        window.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
    }, copied);
    await page.waitForFunction(() => JSON.parse(call("scene", "string", [], [])).rule === "naive");
    await page.close();
});

test("where nothing may be copied, it is shown", async (t) => {
    const { origin } = await serve(t, { "/frame": `<!DOCTYPE html><iframe sandbox="allow-scripts" width="800" height="500" src="/normalscope.html#shear"></iframe>` });
    const page = await browser.newPage();
    await page.goto(origin + "/frame");
    const inner = await (await page.waitForSelector("iframe")).contentFrame();
    await drawn(inner);
    await inner.evaluate(() => { document.execCommand = () => false; page.copy("what is to be copied"); });
    await inner.waitForFunction(() => document.getElementById("to-copy").open && document.getElementById("to-copy-text").value === "what is to be copied");
    await page.close();
});

test("lessons' progress and unsaved work are there again", async (t) => {
    const { url } = await serve(t);
    const { page } = await open(browser, url + "#1-normal-as-a-point/3");
    await page.waitForFunction(() => localStorage.getItem("normalscope.settings")?.includes("1-normal-as-a-point"));
    await page.close();
});

test("a lesson that is being written survives a reload, and is offered until it is answered", async (t) => {
    const { url } = await serve(t);
    const { page, said } = await open(browser, url + "#shear");
    await page.evaluate(() => storage.set("unsaved", JSON.stringify([{
        file: "mine", scene: { rule: "naive" },
        lesson: { normalscope: 1, lesson: "Mine", steps: [{ caption: "My own words.", scene: { rule: "naive" } }] }, step: 0,
    }])));
    const lessonIsKept = () => page.evaluate(() => Object.values(localStorage).some((text) => text.includes("My own words.")));
    await page.reload();
    await drawn(page);
    assert.ok(await asked(page));
    await press(page, "Escape");
    await press(page, "n");
    await press(page, "c");
    assert.ok(await lessonIsKept(), "not now: it is still there");
    await page.waitForFunction(() => location.hash === "#" + call("shown", "string", [], []));
    await page.reload();
    await drawn(page);
    await press(page, "Enter");
    await page.waitForFunction(() => JSON.parse(call("told", "string", [], [])).caption === "My own words.");
    assert.deepEqual(said, []);
    await page.close();
});

test("a changed scene goes on after a reload, by its address", async (t) => {
    const { url } = await serve(t);
    const { page } = await open(browser, url + "#shear");
    await press(page, "c");
    await page.waitForFunction(() => location.hash.startsWith("#normalscope:1."));
    await page.reload();
    await drawn(page);
    assert.equal(await asked(page), false);
    assert.equal((await scene(page)).rule, "cofactor");
    assert.match(await page.title(), /^\u2022 shear/);
    await page.close();
});

test("two pages keep their work apart, and only that of a page that is gone is offered", async (t) => {
    const { url } = await serve(t);
    const { page: first } = await open(browser, url + "#shear");
    await press(first, "c");
    const { page: second } = await open(browser, url + "#shear");
    assert.equal(await asked(second), false);
    await press(second, "n");
    await first.close();
    const { page: third } = await open(browser, url + "#split");
    assert.ok(await asked(third));
    await press(third, "Enter");
    assert.equal((await scene(third)).rule, "cofactor");
    await second.close();
    await third.close();
});
