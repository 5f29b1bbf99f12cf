// The address follows what is shown, and a page around this one can drive it.

import assert from "node:assert/strict";
import { join } from "node:path";
import test from "node:test";

import { ask, drawn, fileOf, folder, launch, listen, open, ours, press, program, scene, serve } from "./browser.mjs";

const browser = await launch();
test.after(() => browser.close());
const lesson = "1-normal-as-a-point";
// The address comes a moment after the picture.
const settled = async (page) => { await drawn(page); await new Promise((done) => setTimeout(done, 400)); };
const hash = (page) => page.evaluate("location.hash");

test("the address follows, and does not fill the history", async (t) => {
    const { url } = await serve(t);
    const { page } = await open(browser, url + "#shear");
    const before = await page.evaluate("history.length");
    await press(page, "n");
    await page.waitForFunction(() => location.hash.startsWith("#normalscope:1."));
    assert.equal(await page.evaluate("history.length"), before);
    // What it holds opens elsewhere: here, as a page of its own and by the desktop's program.
    const address = await page.evaluate("location.href");
    const other = await open(browser, address);
    assert.equal((await scene(other.page)).rule, "naive");
    const said = JSON.parse(program("capture", address, "-o", join(folder(t), "a.png"), "--size", "64x64", "--numbers", "-"));
    assert.equal(said.M[0][1], 0.8);
    await page.close();
    await other.page.close();
});

test("the camera is in the address, and a visit leaves one entry in the history", async (t) => {
    const { url } = await serve(t);
    const { page } = await open(browser, url + "#shear");
    await settled(page);
    assert.equal(await hash(page), "#shear");
    const before = await page.evaluate("history.length");
    await page.mouse.move(900, 560);
    for (let i = 0; i < 4; ++i) {
        await page.mouse.down();
        await page.mouse.move(900 - 20 * i, 500, { steps: 3 });
        await page.mouse.up();
        await page.mouse.wheel({ deltaY: -100 });
        await settled(page);
    }
    const { camera } = await scene(page);
    assert.equal(await page.evaluate("history.length"), before);
    assert.ok((await hash(page)).startsWith("#normalscope:1."), await hash(page));
    await page.reload();
    await drawn(page);
    assert.deepEqual((await scene(page)).camera, camera);
    await page.close();
});

test("slides drive it: docs/slides.html", async (t) => {
    const files = { "/slides.html": ours("docs/slides.html") };
    for (const name of ["reveal.js", "reveal.css", "theme/white.css"]) files["/reveal.js/" + name] = fileOf("reveal.js/dist/" + name);
    const { origin } = await serve(t, files);
    const page = await browser.newPage();
    const said = listen(page);
    await page.setViewport({ width: 1200, height: 800 });
    await page.goto(origin + "/slides.html");
    await page.evaluate(() => Reveal.next());
    const inner = await (await page.$("#normals")).contentFrame();
    await drawn(inner);
    for (const [way, step] of [["next", 2], ["next", 3], ["prev", 2]]) {
        await page.evaluate((go) => Reveal[go](), way);
        await inner.waitForFunction((wanted) => JSON.parse(call("told", "string", [], [])).step === wanted, {}, step);
    }
    assert.deepEqual(said.filter((line) => !line.includes("404")), []);  // a theme's own fonts
    await page.close();
});

test("?lesson and ?scene name what an address does", async (t) => {
    const { url } = await serve(t);
    for (const [asks, step] of [[`lesson=${lesson}/3`, 3], [`scene=${lesson}/2`, 2]]) {
        const { page } = await open(browser, url + "?" + asks);
        assert.equal(JSON.parse(await ask(page, "told")).step, step);
        await page.close();
    }
});

test("back and forward go from step to step of a lesson", async (t) => {
    const { url } = await serve(t);
    const { page, said } = await open(browser, `${url}#${lesson}/2`);
    await press(page, "ArrowRight");
    await page.waitForFunction((end) => location.hash.endsWith(end), {}, "/3");
    await press(page, "a");  // what it asks
    await press(page, "ArrowRight");
    await page.waitForFunction((end) => location.hash.endsWith(end), {}, "/4");
    await page.goBack();
    await drawn(page);
    assert.equal(await hash(page), `#${lesson}/3`);
    assert.equal(JSON.parse(await ask(page, "told")).step, 3);
    await page.goForward();
    await drawn(page);
    assert.equal(JSON.parse(await ask(page, "told")).step, 4);
    assert.deepEqual(said, []);
    await page.close();
});

test("what is said not to be there is forgotten once something is", async (t) => {
    const { url } = await serve(t);
    const { page, said } = await open(browser, url + "#nosuch");
    for (const bad of ["", "%zz"]) {
        if (bad) await page.evaluate((hash) => { location.hash = hash; }, bad);
        await page.waitForFunction((name) => line().includes(name), {}, bad || "nosuch");
        await page.evaluate(() => { location.hash = "shear"; });
        await page.waitForFunction(() => document.title.startsWith("shear") && line() === "");
    }
    assert.deepEqual(said, []);
    await page.close();
});

test("the page is in the light that it is asked for, else in the browser's", async (t) => {
    const { url } = await serve(t);
    const theme = async (rest, prefers) => {
        const page = await browser.newPage();
        await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: prefers }]);
        await page.goto(url + rest);
        await drawn(page);
        const seen = (await scene(page)).theme ?? "light";
        await page.close();
        return seen;
    };
    for (const rest of ["", "?scene=shear", "?lesson", "#shear", `#${lesson}/2`, "#exercises:42"])
        assert.equal(await theme(rest, "dark"), "dark", rest);
    for (const rest of ["&scene=shear", `#${lesson}/2`]) {
        assert.equal(await theme("?theme=dark" + rest, "light"), "dark", rest);
        assert.equal(await theme("?theme=light" + rest, "dark"), "light", rest);
    }
    const { page } = await open(browser, url + "?theme=dark#shear");
    await press(page, "n");
    await page.waitForFunction(() => location.hash.startsWith("#normalscope:1."));
    const link = await hash(page);
    await page.close();
    assert.equal(await theme(link, "light"), "dark", "a reload changes nothing");
    assert.equal(await theme("?theme=light" + link, "dark"), "light");
});

test("exercises have their number", async (t) => {
    const { url } = await serve(t);
    const { page } = await open(browser, url + "#exercises:42");
    assert.equal(await hash(page), "#exercises:42");
    await page.close();
});

test("a page around it is told of steps and answers, and may ask for steps", async (t) => {
    const around = `<!DOCTYPE html><script>const heard = []; addEventListener("message", (event) => heard.push(event.data));</script>
<iframe sandbox="allow-scripts" width="900" height="600" src="/normalscope.html?panel=0#${lesson}/1"></iframe>`;
    const { origin } = await serve(t, { "/around": around });
    const page = await browser.newPage();
    const said = listen(page);
    await page.goto(origin + "/around");
    const inner = await (await page.waitForSelector("iframe")).contentFrame();
    await drawn(inner);
    const send = (what) => page.evaluate((data) => document.querySelector("iframe").contentWindow.postMessage(data, "*"), what);
    await send({ normalscope: "next" });
    await page.waitForFunction(() => heard.some((what) => what.normalscope === "shown" && what.step === 2));
    await send({ normalscope: "step", step: 4 });
    await page.waitForFunction(() => heard.some((what) => what.normalscope === "shown" && what.step === 4));
    await send({ normalscope: "open", name: "shear" });
    await page.waitForFunction(() => heard.some((what) => what.name === "shear"));
    assert.equal(await page.evaluate("heard[0].normalscope"), "ready");
    await send({ normalscope: "open", name: `${lesson}/3` });
    await page.waitForFunction((name) => heard.some((what) => what.asked === name && what.name === name), {}, `${lesson}/3`);
    await inner.evaluate(() => tap("a"));
    const answered = () => page.evaluate(() => heard.filter((what) => what.normalscope === "answered").length);
    await page.waitForFunction(() => heard.some((what) => what.normalscope === "answered" && what.step === 3));
    for (const step of [2, 3]) {
        await send({ normalscope: "step", step });
        await page.waitForFunction((wanted) => heard.at(-1).step === wanted, {}, step);
    }
    await drawn(inner);
    assert.equal(await answered(), 1);
    await send({ normalscope: "reboot" });
    await inner.waitForFunction(() => line().includes('asks for "reboot"'));
    await send({ other: 1 });
    assert.deepEqual(said, []);
    await page.close();
});
