// The address follows what is shown, and a page around this one can drive it.

import assert from "node:assert/strict";
import { join } from "node:path";
import test from "node:test";

import { ask, drawn, folder, launch, listen, open, press, program, scene, serve } from "./browser.mjs";

const browser = await launch();
test.after(() => browser.close());
const lesson = "1-normal-as-a-point";
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

test("back and forward go from step to step of a lesson", async (t) => {
    const { url } = await serve(t);
    const { page, said } = await open(browser, `${url}#${lesson}/2`);
    await press(page, "ArrowRight");
    await page.waitForFunction((end) => location.hash.endsWith(end), {}, "/3");
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
    await send({ normalscope: "reboot" });
    await inner.waitForFunction(() => line().includes('asks for "reboot"'));
    await send({ other: 1 });
    assert.deepEqual(said, []);
    await page.close();
});
