// Every scene and lesson opens, from a server, a file and a frame that may do nothing but run scripts.

import assert from "node:assert/strict";
import test from "node:test";

import { ask, drawn, eachOpens, fileUrl, launch, listen, open, serve } from "./browser.mjs";

const browser = await launch();
test.after(() => browser.close());

test("each scene and lesson, one after the other", async (t) => {
    const { url, asked } = await serve(t);
    const { page, said } = await open(browser, url);
    await eachOpens(page);
    assert.deepEqual(said, []);
    assert.deepEqual([...new Set(asked)].filter((path) => path !== "/favicon.ico"), ["/normalscope.html"]);
    await page.close();
});

test("from a file", async () => {
    const { page, said } = await open(browser, fileUrl + "#shear");
    assert.equal(await page.title(), "shear – Normalscope");
    assert.deepEqual(said, []);
    await page.close();
});

test("in a frame with nothing but scripts", async (t) => {
    const frame = `<!DOCTYPE html><button id="before">B</button><iframe sandbox="allow-scripts" width="800" height="500"
        src="/normalscope.html#shear"></iframe><button id="after">A</button>`;
    const { origin } = await serve(t, { "/frame": frame });
    const page = await browser.newPage();
    const said = listen(page);
    await page.goto(origin + "/frame");
    const inner = await (await page.waitForSelector("iframe")).contentFrame();
    await drawn(inner);
    assert.equal(await inner.title(), "shear – Normalscope");
    assert.match(await ask(inner, "shown"), /^shear$/);
    const focused = () => page.evaluate(() => document.activeElement.id || document.activeElement.tagName);
    await page.focus("#before");
    await page.keyboard.press("Tab");
    await page.keyboard.press("Tab");  // the program's, whose panel goes
    assert.equal(await focused(), "IFRAME");
    await page.keyboard.press("Escape");
    await page.keyboard.press("Tab");
    assert.equal(await focused(), "after");
    assert.deepEqual(said, []);
    await page.close();
});

test("what no name is", async () => {
    for (const [bad, why] of [["#nothing", /no such file, nor a built-in scene/], ["#normalscope:1.AAAA", /link: it is cut off or damaged/],
                              ["#1-normal-as-a-point/99", /no such step/], ["#/etc/passwd.json", /cannot be read/]]) {
        const { page, said } = await open(browser, fileUrl + bad);
        assert.match(await page.evaluate("line()"), why);
        assert.match(await page.title(), /Normalscope/);
        assert.deepEqual(said, []);
        await page.close();
    }
});
