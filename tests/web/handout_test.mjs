// A handout whose pictures wake to the program.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";

import { drawn, folder, launch, listen, program, scene } from "./browser.mjs";

const browser = await launch();
test.after(() => browser.close());

test("one program for all pictures, where each was touched", async (t) => {
    const here = folder(t);
    const evil = "\"'><script>window.caught = 1</script>";
    writeFileSync(join(here, "solid.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    writeFileSync(join(here, "mine.json"), JSON.stringify({ lesson: evil, about: evil, steps: [
        { caption: "as it is", scene: { rule: "naive" } }, { caption: evil, scene: { surface: { mesh: "solid.obj" } } }] }));
    program("handout", join(here, "mine.json"), "-o", join(here, "page.html"), "--live", "--size", "480x300");

    const page = await browser.newPage();
    const said = listen(page);
    const asked = [];
    page.on("request", (request) => asked.push(request.url().split(":")[0]));
    await page.setViewport({ width: 800, height: 900 });
    await page.goto(pathToFileURL(join(here, "page.html")).href);
    const inner = await (await page.$("#live")).contentFrame();
    const pictures = await page.$$("img");
    const wake = async (picture) => {
        await picture.click();
        await page.waitForFunction(() => live.classList.contains("awake"), { timeout: 60000 });
        await drawn(inner);
        const [frame, still] = [await (await page.$("#live")).boundingBox(), await picture.boundingBox()];
        for (const key of ["x", "y", "width", "height"]) assert.ok(Math.abs(frame[key] - still[key]) < 1, key);
        return scene(inner);
    };
    assert.equal((await wake(pictures[0])).rule, "naive");
    await page.keyboard.press("i");
    await inner.waitForFunction(() => call("shown", "string", [], []).startsWith("normalscope:") && JSON.parse(call("scene", "string", [], [])).rule === "inverse-transpose");
    await drawn(inner);
    assert.equal((await wake(pictures[1])).surface.mesh, "/1-solid.obj");
    assert.equal(await inner.evaluate("line()"), "");
    assert.equal((await wake(pictures[0])).rule, "inverse-transpose", "it is as it was left");
    await page.click("#back");
    assert.equal(await page.evaluate(() => getComputedStyle(live).visibility), "hidden");
    await page.emulateMediaType("print");
    for (const part of ["#live", "#back", ".touch"])
        assert.equal(await page.$eval(part, (element) => getComputedStyle(element).display), "none");
    assert.equal(page.frames().length, 2);
    assert.equal(await page.evaluate("window.caught"), undefined);
    assert.deepEqual([...new Set(asked)].filter((scheme) => !["file", "data", "about"].includes(scheme)), []);
    assert.deepEqual(said, []);
    await page.close();
});
