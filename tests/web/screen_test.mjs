// Frames only when something changes, sharp pixels, and a context that is lost and comes back.

import assert from "node:assert/strict";
import test from "node:test";

import { drawn, fileUrl, launch, open } from "./browser.mjs";

const browser = await launch();
test.after(() => browser.close());

test("an idle page draws nothing", async () => {
    const { page } = await open(browser, fileUrl);
    await new Promise((done) => setTimeout(done, 6000));  // notes have gone
    const before = await page.evaluate("drawn");
    await new Promise((done) => setTimeout(done, 2000));
    assert.equal(await page.evaluate("drawn"), before);
    await page.close();
});

test("a hidden tab costs nothing", async () => {
    const { page, said } = await open(browser, fileUrl);
    const frames = () => page.evaluate("drawn");
    await page.mouse.click(417, 40);  // play
    const [before, hidden] = await page.evaluate(() => new Promise((done) => {
        const began = drawn;
        const look = () => (drawn > began + 3 ? done([began, document.hidden]) : setTimeout(look, 10));
        look();
    }));
    assert.equal(hidden, false);
    const other = await browser.newPage();
    await other.bringToFront();
    await page.waitForFunction("document.hidden", { polling: 50 });
    await new Promise((done) => setTimeout(done, 300));
    const then = await frames();
    assert.ok(then > before);
    await new Promise((done) => setTimeout(done, 1500));
    assert.equal(await frames(), then);
    await other.close();
    await page.bringToFront();
    await page.waitForFunction((count) => drawn > count, { polling: 50 }, then);
    assert.deepEqual(said, []);
    await page.close();
});

for (const scale of [1, 1.5, 2])
    test(`a canvas pixel is a pixel of the screen, at ${scale}`, async () => {
        const { page, said } = await open(browser, fileUrl, { width: 800, height: 500, scale });
        assert.deepEqual(await page.evaluate("[canvas.width, canvas.height]"), [800 * scale, 500 * scale]);
        await page.setViewport({ width: 640, height: 480, deviceScaleFactor: scale });
        await page.waitForFunction((width) => canvas.width === width, {}, 640 * scale);
        await drawn(page);
        assert.deepEqual(said, []);
        await page.close();
    });

test("a lost context comes back", async () => {
    const { page, said } = await open(browser, fileUrl + "#implicit-torus");
    const before = await page.screenshot();
    await page.evaluate(() => { window.lose = canvas.getContext("webgl2").getExtension("WEBGL_lose_context"); lose.loseContext(); });
    await new Promise((done) => setTimeout(done, 300));
    await page.evaluate(() => lose.restoreContext());
    await new Promise((done) => setTimeout(done, 500));
    await drawn(page);
    await new Promise((done) => setTimeout(done, 500));
    assert.ok(before.equals(await page.screenshot()), "the picture is another");
    assert.deepEqual(said.filter((line) => !/CONTEXT_LOST_WEBGL|loseContext/.test(line)), []);
    await page.close();
});

test("what is seen can be printed", async () => {
    const { page } = await open(browser, fileUrl);
    await page.pdf();
    const colours = await page.evaluate(() => {
        const { width, height } = document.getElementById("printed");
        const { data } = document.getElementById("printed").getContext("2d").getImageData(0, 0, width, height);
        return new Set(new Uint32Array(data.buffer)).size;
    });
    assert.ok(colours > 1000, `${colours} colours`);
    await page.close();
});

test("without WebGL 2 one sentence says so", async () => {
    const page = await browser.newPage();
    await page.evaluateOnNewDocument(() => { HTMLCanvasElement.prototype.getContext = () => null; });
    await page.goto(fileUrl);
    await page.waitForFunction(() => document.querySelector(".sorry")?.textContent.includes("needs WebGL 2"));
    await page.close();
});

test("nothing moves by itself where that is unwanted", async () => {
    const swings = async (motion) => {
        const page = await browser.newPage();
        await page.emulateMediaFeatures([{ name: "prefers-reduced-motion", value: motion }]);
        await page.goto(fileUrl);
        await drawn(page);
        const before = await page.evaluate("drawn");
        await page.keyboard.press("n");
        await drawn(page);
        const frames = (await page.evaluate("drawn")) - before;
        assert.ok(!(await page.evaluate("localStorage.getItem('normalscope.settings') || ''")).includes("motion"));
        await page.close();
        return frames;
    };
    const still = await swings("reduce");
    assert.ok(still <= 12, `${still} frames`);
    assert.ok(await swings("no-preference") > still);
});

test("letters that the program has no font for are the browser's", async () => {
    const { page, said } = await open(browser, fileUrl);
    await page.evaluate(() => {
        const before = page.drawLetter;
        window.drawnLetters = [];
        page.drawLetter = (letter, em) => (drawnLetters.push(letter), before(letter, em));
        complain("\u0416 \u0142 \u05D0: no such letter");
    });
    await page.waitForFunction(() => line().includes("no such letter") && drawnLetters.length > 0);
    assert.deepEqual([...new Set(await page.evaluate("drawnLetters"))].sort(), ["\u0416", "\u05D0"]);
    assert.deepEqual(said, []);
    await page.close();
});

test("whoever does not see is told", async () => {
    const { page } = await open(browser, fileUrl);
    assert.equal(await page.evaluate("document.documentElement.lang"), "en");
    assert.match(await page.evaluate("document.getElementById('said').textContent"), /rule.*degrees/);
    await page.close();
});
