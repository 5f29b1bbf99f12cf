// What web/browser.h declares: the engine asks the page around it, by the object that the page made it with.
addToLibrary({
    page_copy: (text) => Module.page.copy(UTF8ToString(text)),
    page_title: (text) => { document.title = UTF8ToString(text); },
    page_cursor: (name) => { Module.page.canvas.style.cursor = UTF8ToString(name); },
    page_remember: (key, text) => Module.page.remember(UTF8ToString(key), UTF8ToString(text)),
    page_is_full_screen: () => document.fullscreenElement ? 1 : 0,
    page_toggle_full_screen: () => Module.page.toggleFullScreen(),
    page_choose_file: () => Module.page.chooseFile(),
    page_download: (name, bytes, size) => Module.page.download(UTF8ToString(name), HEAPU8.slice(bytes, bytes + size)),
    page_draw_letter__deps: ["malloc"],
    page_draw_letter: (letter, em, measures) => {
        const drawn = Module.page.drawLetter(String.fromCodePoint(letter), em);
        if (!drawn) return 0;
        HEAPF32.set(drawn.measures, measures >> 2);
        const cover = _malloc(drawn.cover.length);
        HEAPU8.set(drawn.cover, cover);
        return cover;
    },
    page_address__deps: ["$stringToNewUTF8"],
    page_address: (name) => stringToNewUTF8(Module.page.addressOf(UTF8ToString(name))),
});
