// The page draws what the desktop draws, and says the same numbers.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";

import { fileUrl, folder, launch, numbers, open, program } from "./browser.mjs";

const browser = await launch();
test.after(() => browser.close());

// Numbers to 1e-12 of their size, and all else the same; where two differ, its path.
function difference(a, b, path = "") {
    if (typeof a === "number" && typeof b === "number")
        return Math.abs(a - b) <= 1e-12 * Math.max(1, Math.abs(a), Math.abs(b)) ? null : `${path}: ${a}, ${b}`;
    if (a === null || b === null || typeof a !== "object" || typeof b !== "object") return a === b ? null : `${path}: ${a}, ${b}`;
    for (const key of new Set([...Object.keys(a), ...Object.keys(b)])) {
        const found = difference(a[key], b[key], path + "/" + key);
        if (found) return found;
    }
    return null;
}
// Where it was drawn is not what it means.
const meaning = ({ program: by, renderer, gl_version, context, drawn, ...rest }) => rest;

for (const name of ["slide-scale", "shear", "implicit-torus", "1-normal-as-a-point#3"])
    test(name, async (t) => {
        const here = folder(t);
        const { page, said } = await open(browser, `${fileUrl}?panel=0#${name.replace("#", "/")}`, { width: 960, height: 600 });
        const saved = await page.evaluate(() => new Promise((done) => {
            page.download = (file, bytes) => done([...bytes]);
            call("save_picture", null, [], []);
        }));
        writeFileSync(join(here, "page.png"), Buffer.from(saved));
        assert.deepEqual(said, []);
        const size = [saved[18] * 256 + saved[19], saved[22] * 256 + saved[23]].join("x");
        program("capture", name, "-o", join(here, "desktop.png"), "--size", size, "--scale", "1", "--numbers", join(here, "n.json"));
        program("compare", join(here, "page.png"), join(here, "desktop.png"), "--share", "0.003");
        const desktop = JSON.parse(program("capture", name, "-o", join(here, "d.png"), "--size", size, "--numbers", "-").replace(/^[^{]*/, ""));
        assert.equal(difference(meaning(await numbers(page)), meaning(desktop)), null);
        await page.close();
    });
