// The page draws what the desktop draws, and says the same numbers.

import test from "node:test";

import { launch } from "./browser.mjs";
import { sameAsDesktop } from "./compared.mjs";

const browser = await launch();
test.after(() => browser.close());

for (const name of ["slide-scale", "shear", "implicit-torus", "1-normal-as-a-point#3", "flat", "error-map"])
    test(name, (t) => sameAsDesktop(t, browser, name));
for (const scale of [1.5, 2])
    test(`split, at ${scale} device pixels a pixel`, (t) => sameAsDesktop(t, browser, "split", scale));
