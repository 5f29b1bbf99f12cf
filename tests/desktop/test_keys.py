#!/usr/bin/env python3
"""Each key that help lists, and undo."""

import unittest

from support import LIGHT, MIDDLE, PANEL, SIZE, Camera, WindowTest, changed, png_size


class KeysTest(WindowTest):
    def test_what_is_drawn(self):
        window = self.window("shear", *LIGHT)
        scenes = [window.scene()]
        for keys, changes in (
                ("negtvr", {"rule": "naive", "color": "error", "theme": "dark", "view": "split", "stack": [{"scale": [1, 1, 1]}]}),
                ("cegtv", {"rule": "cofactor", "color": "lit", "theme": "light", "view": "overlay"}),
                ("iv", {"rule": "inverse-transpose", "view": "single"})):
            window.key(*keys)
            scenes.append(window.scene())
            if "g" in keys:
                changes["show"] = scenes[-2]["show"] | {"ghost": not scenes[-2]["show"]["ghost"]}
            self.assertEqual(scenes[-1], scenes[-2] | changes)
        window.key(*["ctrl+z"] * 13)  # each was a step of its own
        self.assertEqual(window.scene(), scenes[0])
        window.key(*["ctrl+shift+z"] * 13)
        self.assertEqual(window.scene(), scenes[-1])

    def test_views_from_the_sides(self):
        window = self.window(*LIGHT)
        for key, azimuth, elevation in (("1", 0, 0), ("2", 90, 0), ("3", 0, 90)):
            before = window.scene()
            window.key(key)
            self.assertEqual(window.scene(), changed(changed(before, "camera.azimuth", azimuth), "camera.elevation", elevation))

    def test_frame(self):
        window = self.window(*LIGHT, "--set", "camera.zoom=0.2", "--set", "camera.target=[3,2,1]")
        before = window.scene()
        window.key("f")
        after = window.scene()
        self.assert_near(after["camera"]["target"], [0, 0, 0], 0.01)
        self.assertEqual(after | {"camera": before["camera"]}, before)
        # The object fills the picture, with room for the arrows.
        reach = SIZE[1] / 2 - Camera(after).pixel((0, 2, 0))[1]
        self.assertAlmostEqual(reach / (min(SIZE[0] - PANEL, SIZE[1]) / 2), 0.9, delta=0.1)
        self.assert_undo(window, before, after)

    def test_undo_and_redo(self):
        window = self.window(*LIGHT)
        first = window.scene()
        window.key("ctrl+z", "ctrl+shift+z", "ctrl+y")  # nothing to undo yet
        self.assertEqual(window.scene(), first)
        window.key("n", "e", "t")
        last = window.scene()
        window.key("ctrl+z", "ctrl+z", "ctrl+z", "ctrl+z")
        self.assertEqual(window.scene(), first)
        window.key("ctrl+y", "ctrl+y", "ctrl+y", "ctrl+y")
        self.assertEqual(window.scene(), last)
        window.key("ctrl+z", "c")  # what had been undone is forgotten
        new = window.scene()
        self.assertEqual(new, changed(changed(last, "theme", "light"), "rule", "cofactor"))
        window.key("ctrl+shift+z")
        self.assertEqual(window.scene(), new)

    def test_help(self):
        # It lies over the middle of the picture, where the wheel then does not zoom.
        window = self.window(*LIGHT)
        zoom = 1.0
        for key, shown in (("F1", True), ("Escape", False), ("F1", True), ("F1", False)):
            window.key(key)
            window.point((MIDDLE[0], SIZE[1] // 2))
            window.wheel(1)
            if not shown:
                zoom *= 1.12
            self.assertAlmostEqual(window.scene()["camera"]["zoom"], zoom, places=6, msg=key)

    def test_panel(self):
        window = self.window(*LIGHT)
        before = window.scene()
        for key in ("Tab", "h"):
            window.key(key)
            self.assertEqual(png_size(window.picture()), SIZE, key)
            window.key(key)
            self.assertEqual(png_size(window.picture()), (SIZE[0] - PANEL, SIZE[1]), key)
        self.assertEqual(window.scene(), before)

    def test_keys_are_text_in_a_dialog(self):
        window = self.window(*LIGHT)
        before = window.scene()
        window.key("ctrl+s")
        window.type("nicvegtr123fh")
        window.key("Escape")
        self.assertEqual(window.scene(), before)

    def test_keys_do_nothing_behind_a_dialog(self):
        window = self.window(*LIGHT)
        before = window.scene()
        window.key("n", "ctrl+s")
        window.click((SIZE[0] // 2, SIZE[1] // 2))  # into the list, so that nothing is being typed
        window.key("c", "v", "ctrl+z", "Escape")
        self.assertEqual(window.scene(), changed(before, "rule", "naive"))
        # Not even before the dialog has been drawn.
        window.do("key", "--delay", 0, "ctrl+s", "c", "e", "t")
        window.key("Escape")
        self.assertEqual(window.scene(), changed(before, "rule", "naive"))


if __name__ == "__main__":
    unittest.main()
