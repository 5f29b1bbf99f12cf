// A browser with the page in it, for the tests beside this file.
//
//   NORMALSCOPE_PAGE     the page
//   NORMALSCOPE          the desktop's program
//   NORMALSCOPE_MODULES  a folder with node_modules/puppeteer-core

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { extname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const require = createRequire(join(resolve(process.env.NORMALSCOPE_MODULES), "package.json"));
const puppeteer = require("puppeteer-core");

// A file of a package, or of this project's.
export const fileOf = (path) => readFileSync(require.resolve(path));
export const ours = (path) => readFileSync(new URL("../../" + path, import.meta.url));

export const pageFile = resolve(process.env.NORMALSCOPE_PAGE);
export const program = (...args) => execFileSync(process.env.NORMALSCOPE, args, { encoding: "utf8", maxBuffer: 1 << 26 });
export const names = (command) => program(command).split("\n").map((line) => /^([a-z0-9][\w-]*)/.exec(line)?.[1]).filter(Boolean);

// Pixels are drawn by the processor, as in every machine that tests.
const chromium = {
    browser: "chrome",
    executablePath: process.env.NORMALSCOPE_CHROMIUM || "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars"],
};
const firefox = {
    browser: "firefox",
    executablePath: process.env.NORMALSCOPE_FIREFOX || "/usr/bin/firefox-esr",
    extraPrefsFirefox: { "webgl.force-enabled": true, "privacy.file_unique_origin": false },
};
const settings = { headless: true, timeout: 60000, protocolTimeout: 120000 };
export const launchFirefox = () => puppeteer.launch({ ...firefox, ...settings });
// In the tests what moves by itself does so in Firefox alone: three frames in four would be its.
export const launch = ({ moves = false } = {}) => puppeteer.launch({
    ...chromium, ...settings, args: [...chromium.args, ...(moves ? [] : ["--force-prefers-reduced-motion"])],
});

export function folder(test) {
    const path = mkdtempSync(join(tmpdir(), "normalscope-web-"));
    test.after(() => rmSync(path, { recursive: true, force: true }));
    return path;
}

// Serves the page as the simplest of servers does, without any headers of its own; and other pages by their paths.
const kinds = { ".css": "text/css", ".js": "text/javascript" };
export function serve(test, others = {}) {
    const page = readFileSync(pageFile);
    const asked = [];
    const server = createServer((request, response) => {
        const path = new URL(request.url, "http://x").pathname;
        asked.push(path);
        if (path === "/normalscope.html") response.setHeader("Content-Type", "text/html").end(page);
        else if (others[path]) response.setHeader("Content-Type", kinds[extname(path)] ?? "text/html").end(others[path]);
        else response.writeHead(path === "/favicon.ico" ? 204 : 404).end();
    });
    test.after(() => server.close());
    return new Promise((done) => server.listen(0, "127.0.0.1", () =>
        done({ url: `http://127.0.0.1:${server.address().port}/normalscope.html`, origin: `http://127.0.0.1:${server.address().port}`, asked })));
}
export const fileUrl = pathToFileURL(pageFile).href;

// What the console said that is no mere remark; a page without faults says nothing.
export function listen(page) {
    const said = [];
    // That reading pixels waits for them is what it is for.
    const harmless = /GPU stall due to ReadPixels|Automatic fallback to software WebGL/;
    page.on("console", (message) => harmless.test(message.text()) || said.push(`${message.type()}: ${message.text()}`));
    page.on("pageerror", (error) => said.push(`error: ${error.message}`));
    return said;
}

// In the page or a frame of it: from when on everything has been drawn.
export async function drawn(frame) {
    await frame.waitForFunction(() => typeof isQuiet === "function" && isQuiet(), { timeout: 90000, polling: 50 });
}

export async function open(browser, url, { width = 960, height = 600, scale = 1, touch = false } = {}) {
    const page = await browser.newPage();
    const said = listen(page);
    await page.setViewport({ width, height, deviceScaleFactor: scale, hasTouch: touch, isMobile: touch });
    // Files share their storage: what one test leaves unsaved would be offered to the next.
    if (url.startsWith("file:"))
        await page.evaluateOnNewDocument(() => {
            try {
                if (!sessionStorage.begun) localStorage.clear(), sessionStorage.begun = 1;
            } catch { /* Firefox runs this in an empty page, too, which has no storage */ }
        });
    await page.goto(url);
    await drawn(page);
    return { page, said };
}

// What the page's own functions say.
export const ask = (frame, name) => frame.evaluate((which) => call(which, "string", [], []), name);
export const numbers = async (frame) => JSON.parse(await ask(frame, "numbers"));

// What is seen, as a file has it; and keys as a person presses them.
export const scene = async (frame) => JSON.parse(await ask(frame, "scene"));
export async function press(page, ...keys) {
    for (const key of keys) await page.keyboard.down(key);
    for (const key of keys.reverse()) await page.keyboard.up(key);
    await drawn(page);
}

// Every scene and lesson, one after the other in one page.
export async function eachOpens(page) {
    for (const name of [...names("scenes"), ...names("lessons"), "exercises:42"]) {
        await page.evaluate((hash) => { location.hash = hash; }, name);
        await page.waitForFunction((wanted) => document.title.includes(wanted.split(":")[0]), { timeout: 60000 }, name);
        await drawn(page);
        assert.equal(await page.evaluate("line()"), "", name);
    }
}
