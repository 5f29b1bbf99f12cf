// How long the page takes, in Chromium without a graphics processor. Prints one line of JSON; ./dev bench makes rows of it.
// The environment is that of tests/web/browser.mjs.

import { readFileSync } from "node:fs";
import { brotliCompressSync, gzipSync } from "node:zlib";

import { drawn, eachOpens, fileUrl, launch, open, pageFile } from "../web/browser.mjs";

const runs = Number(process.argv[2] ?? 5);
const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];
const browser = await launch({ moves: true });

// Milliseconds from the navigation on: until the first picture stands, its pixels in memory, and until the last does.
async function opening(name) {
    const page = await browser.newPage();
    await page.setViewport({ width: 960, height: 600 });
    await page.evaluateOnNewDocument(() => {
        window.took = {};
        const finish = () => canvas.getContext("webgl2").readPixels(0, 0, 1, 1, 0x1908, 0x1401, new Uint8Array(4));
        const look = () => {
            const began = typeof drawn === "number" && drawn > 0;
            if (began) finish();
            if (began && !took.first) took.first = performance.now();
            if (began && isQuiet()) return took.last = performance.now();
            setTimeout(look, 5);
        };
        setTimeout(look, 5);
    });
    await page.goto(fileUrl + name);
    await page.waitForFunction(() => took.last, { polling: 100, timeout: 120000 });
    const { first, last } = await page.evaluate("took");
    await page.close();
    return { first, last };
}
async function openings(name) {
    const all = [];
    for (let run = 0; run < runs; ++run) all.push(await opening(name));
    return { first: median(all.map((each) => each.first)), last: median(all.map((each) => each.last)) };
}

const bytes = readFileSync(pageFile);
const figures = { gzip: gzipSync(bytes, { level: 9 }).length, brotli: brotliCompressSync(bytes).length };
figures.scene_ms = (await openings("#slide-scale")).first;
const formula = await openings("#implicit-torus");
figures.formula_first_ms = formula.first;
figures.formula_ms = formula.last;

const { page } = await open(browser, fileUrl);
figures.frames_per_second = await page.evaluate(() => new Promise((done) => {
    const at = (i) => ({ bubbles: true, pointerId: 1, pointerType: "mouse", button: 0, clientX: 900 - i, clientY: 500 });
    canvas.setPointerCapture = () => {};
    canvas.dispatchEvent(new PointerEvent("pointerdown", at(0)));
    let i = 0, before, begin;
    const move = () => {
        if (++i === 20) [before, begin] = [drawn, performance.now()];  // by then all is made that is made once
        if (i > 20 && performance.now() - begin > 3000) {
            canvas.dispatchEvent(new PointerEvent("pointerup", at(i)));
            return done((drawn - before) * 1000 / (performance.now() - begin));
        }
        canvas.dispatchEvent(new PointerEvent("pointermove", at(i)));
        requestAnimationFrame(move);
    };
    move();
}));
await drawn(page);
await new Promise((done) => setTimeout(done, 5000));
const before = await page.evaluate("drawn");
await new Promise((done) => setTimeout(done, 3000));
figures.idle_frames = (await page.evaluate("drawn")) - before;
const heap = async () => {
    await eachOpens(page);
    return page.evaluate(() => call("heap", "number", [], []));
};
figures.heap = [await heap(), await heap(), await heap()];
console.log(JSON.stringify(figures));
await browser.close();
