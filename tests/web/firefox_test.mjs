// The same in Firefox, which has other limits: no OES_sample_variables, for one, so that edges of traced surfaces are smoothed in
// another way. Under Xvfb: without a display it has no WebGL.

import assert from "node:assert/strict";
import test from "node:test";

import { eachOpens, fileUrl, launchFirefox, listen, open, scene, serve } from "./browser.mjs";
import { sameAsDesktop } from "./compared.mjs";

const browser = await launchFirefox();
test.after(() => browser.close());

test("each scene and lesson, one after the other", async (t) => {
    const { url } = await serve(t);
    const { page, said } = await open(browser, url);
    await eachOpens(page);
    assert.deepEqual(said, []);
    await page.close();
});

test("a traced surface is as smooth as on the desktop", (t) => sameAsDesktop(t, browser, "implicit-torus"));

test("keys and the mouse", async () => {
    const { page, said } = await open(browser, fileUrl + "#shear");
    const before = await scene(page);
    await page.mouse.move(900, 560);
    await page.mouse.down();
    await page.mouse.move(840, 520, { steps: 4 });
    await page.mouse.up();
    await page.keyboard.press("n");
    await page.waitForFunction(() => JSON.parse(call("scene", "string", [], [])).rule === "naive");
    assert.notEqual((await scene(page)).camera.azimuth, before.camera.azimuth);
    assert.deepEqual(said, []);
    await page.close();
});

test("in a frame with nothing but scripts", async (t) => {
    const { origin } = await serve(t, { "/frame": `<!DOCTYPE html><iframe sandbox="allow-scripts" width="800" height="500" src="/normalscope.html#shear"></iframe>
<script>addEventListener("message", ({ data }) => { if (data.normalscope === "shown") document.title = data.name; });</script>` });
    const page = await browser.newPage();
    const said = listen(page);
    await page.goto(origin + "/frame");
    await page.waitForFunction(() => document.title === "shear", { timeout: 60000 });
    assert.deepEqual(said, []);
    await page.close();
});
