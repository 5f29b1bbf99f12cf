// What a page draws and says, held against the desktop's program.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { fileUrl, folder, numbers, open, program } from "./browser.mjs";

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

// `name`: a scene, or NAME#n. At these device pixels a pixel.
export async function sameAsDesktop(test, browser, name, scale = 1) {
    const here = folder(test);
    const { page, said } = await open(browser, `${fileUrl}?panel=0#${name.replace("#", "/")}`, { scale });
    const saved = await page.evaluate(() => new Promise((done) => {
        page.download = (file, bytes) => done([...bytes]);
        call("save_picture", null, [], []);
    }));
    writeFileSync(join(here, "page.png"), Buffer.from(saved));
    assert.deepEqual(said, []);
    const size = [saved[18] * 256 + saved[19], saved[22] * 256 + saved[23]].join("x");
    const capture = ["capture", name, "-o", join(here, "desktop.png"), "--size", size, "--scale", String(scale), "--numbers", join(here, "n.json")];
    program(...capture);
    program("compare", join(here, "page.png"), join(here, "desktop.png"), "--share", "0.003");
    assert.equal(difference(meaning(await numbers(page)), meaning(JSON.parse(readFileSync(join(here, "n.json"), "utf8")))), null);
    await page.close();
}
