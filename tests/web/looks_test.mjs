// The whole page, panel and all, looks as it did when someone last looked: its own baselines, for it has no desktop beside it
// to be held against. NORMALSCOPE_UPDATE_BASELINES=1 makes them anew.

import assert from "node:assert/strict";
import { existsSync, mkdirSync } from "node:fs";
import { dirname, join } from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";

import { fileUrl, folder, launch, open, program } from "./browser.mjs";

const browser = await launch();
test.after(() => browser.close());
const baselines = fileURLToPath(new URL("baselines", import.meta.url));
const update = process.env.NORMALSCOPE_UPDATE_BASELINES;

const screens = {
    desktop: { width: 960, height: 600 },
    phone: { width: 390, height: 844, touch: true },
    tablet: { width: 820, height: 1180, touch: true },
};
for (const [screen, how] of Object.entries(screens))
    test(`the first page on a ${screen}`, async (t) => {
        const { page, said } = await open(browser, fileUrl + "#shear", how);
        await new Promise((done) => setTimeout(done, 500));  // the browser shows what was drawn
        const baseline = join(baselines, `shear-${screen}.png`);
        const seen = update ? baseline : join(folder(t), "seen.png");
        mkdirSync(dirname(seen), { recursive: true });
        await page.screenshot({ path: seen });
        assert.deepEqual(said, []);
        assert.ok(existsSync(baseline), baseline);
        program("compare", seen, baseline, "--tolerance", "3", "--share", "0.003");
        await page.close();
    });
