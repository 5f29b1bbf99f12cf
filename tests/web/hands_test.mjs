// Mouse, wheel, keys, fingers: they do what they do on the desktop, and the browser keeps out of it.

import assert from "node:assert/strict";
import test from "node:test";

import { ask, drawn, fileUrl, launch, open, press, scene } from "./browser.mjs";

const browser = await launch();
test.after(() => browser.close());

// To the right of the panel, on the ground.
const ground = { x: 900, y: 560 };

test("a drag orbits, the wheel zooms, keys choose a rule, Ctrl+Z undoes", async () => {
    const { page, said } = await open(browser, fileUrl);
    const before = await scene(page);
    await page.mouse.move(ground.x, ground.y);
    await page.mouse.down();
    await page.mouse.move(ground.x - 60, ground.y - 40, { steps: 5 });
    await page.mouse.up();
    await drawn(page);
    const turned = await scene(page);
    assert.notEqual(turned.camera.azimuth, before.camera.azimuth);
    await page.mouse.wheel({ deltaY: -200 });
    await drawn(page);
    assert.ok((await scene(page)).camera.zoom > turned.camera.zoom);
    await press(page, "n");
    assert.equal((await scene(page)).rule, "naive");
    await press(page, "Control", "z");
    assert.equal((await scene(page)).rule, "inverse-transpose");
    assert.deepEqual(said, []);
    await page.close();
});

test("a formula typed at once after Ctrl+F", async () => {
    for (let round = 0; round < 3; ++round) {
        const { page, said } = await open(browser, fileUrl + "#implicit-torus");
        await page.keyboard.down("Control");
        await page.keyboard.press("f");
        await page.keyboard.press("a");
        await page.keyboard.up("Control");
        for (const letter of "x^2+y^2+z^2=2") await page.keyboard.press(letter);
        await page.keyboard.press("Enter");
        await page.waitForFunction(() => JSON.parse(call("scene", "string", [], [])).surface.formula === "x^2+y^2+z^2=2",
            { timeout: 30000 });
        assert.deepEqual(said, []);
        await page.close();
    }
});

test("the browser's own shortcuts are held back where the program has them", async () => {
    const { page } = await open(browser, fileUrl);
    const prevented = await page.evaluate(() => ["s", "o", "p", "f", "l", "F1", "F5"].map((key) => {
        const event = new KeyboardEvent("keydown", { key, code: key.length === 1 ? "Key" + key.toUpperCase() : key, ctrlKey: key.length === 1, cancelable: true, bubbles: true });
        return !canvas.dispatchEvent(event);
    }));
    assert.deepEqual(prevented, Array(7).fill(true));
    assert.equal(await page.evaluate(() => canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "t", ctrlKey: true, cancelable: true, bubbles: true }))), true);
    await page.close();
});

test("fingers: one orbits, two pinch, a tap picks; the keyboard comes for a field", async () => {
    const { page, said } = await open(browser, fileUrl + "#implicit-torus", { width: 390, height: 844, scale: 2, touch: true });
    const before = await scene(page);
    await swipe(page, [60, 160], [120, 190], [160, 200]);
    const turned = await scene(page);
    assert.notEqual(turned.camera.azimuth, before.camera.azimuth);
    await pinch(page, [150, 200], [120, 200], [240, 200], [290, 200]);
    assert.ok((await scene(page)).camera.zoom > turned.camera.zoom);
    assert.deepEqual(said, []);
    await page.close();
});

// Fingers, each a list of places. They do not wait for the page, nor between their first two: one that rests on a control holds it.
async function touch(page, ...fingers) {
    const session = await page.createCDPSession();
    const sent = [];
    const send = (type, at) => sent.push(session.send("Input.dispatchTouchEvent", {
        type, touchPoints: at === undefined ? [] : fingers.map((places, id) => ({ id, x: places[at][0], y: places[at][1] })),
    }));
    for (const at of fingers[0].keys()) {
        send(at === 0 ? "touchStart" : "touchMove", at);
        if (at > 0) await new Promise((done) => setTimeout(done, 30));
    }
    send("touchEnd");
    await Promise.all(sent);
    await session.detach();
    await drawn(page);
}
const swipe = (page, ...places) => touch(page, places);
const pinch = (page, fromA, toA, fromB, toB) => touch(page, [fromA, toA], [fromB, toB]);

test("a finger scrolls a lesson's words, and presses no answer on which it began", async () => {
    const { page, said } = await open(browser, fileUrl + "#1-normal-as-a-point/3", { width: 844, height: 390, scale: 2, touch: true });
    const answer = async () => JSON.parse(await ask(page, "told")).answer;
    await swipe(page, [600, 358], [600, 340], [600, 300], [600, 200]);  // from the only answer that is seen
    await swipe(page, [500, 315], [530, 316], [600, 317]);
    assert.equal(await answer(), undefined);
    await swipe(page, [600, 345]);
    assert.equal(await answer(), 3);
    assert.deepEqual(said, []);
    await page.close();
});

test("in the drawer a finger moves a slider sideways, and the controls up and down", async () => {
    const { page, said } = await open(browser, fileUrl, { width: 390, height: 844, scale: 2, touch: true });
    await swipe(page, [195, 825]);
    const before = await scene(page);
    await swipe(page, [180, 795], [181, 770], [182, 740], [182, 700]);
    assert.deepEqual(await scene(page), before);
    await swipe(page, [182, 700], [181, 740], [180, 800], [180, 840]);  // and back
    await swipe(page, [180, 795], [200, 796], [220, 797], [240, 797]);
    assert.notDeepEqual((await scene(page)).stack, before.stack);
    assert.deepEqual(said, []);
    await page.close();
});

test("the probe stays where it is under the first of two fingers", async () => {
    const { page } = await open(browser, fileUrl, { width: 390, height: 844, scale: 2, touch: true });
    const { probe, camera } = await scene(page);
    await pinch(page, [185, 500], [165, 520], [260, 400], [290, 370]);
    assert.ok((await scene(page)).camera.zoom > (camera.zoom ?? 0));
    assert.deepEqual((await scene(page)).probe, probe);
    await swipe(page, [185, 430]);
    assert.notDeepEqual((await scene(page)).probe, probe, "a tap places it");
    await page.close();
});

test("a phone shows the picture first, and the controls below it", async () => {
    const { page } = await open(browser, fileUrl, { width: 390, height: 844, scale: 2, touch: true });
    const shown = JSON.parse(await ask(page, "numbers")).picture ?? null;
    assert.ok(shown === null || shown.size[0] === 780, JSON.stringify(shown));
    await page.close();
});
