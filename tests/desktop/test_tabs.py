#!/usr/bin/env python3
"""The tabs beside the picture: the stack is scrubbed and played, the derivation opened by its key."""

import unittest

from support import LIGHT, WindowTest, until

WIDE = (1280, 800)
STACK_TAB, CLOSE = (148, 199), (1257, 23)
SLIDER_Y, SLIDER_LEFT, SLIDER_RIGHT = 59, 996, 1192  # in the stack's tab, for a stack of two entries
PLAY = (853, 59)
TWO_ENTRIES = ("--set", 'stack=[{"scale":[1,2,1]},{"rotate":{"axis":[0,0,1],"degrees":40}}]')


class TabsTest(WindowTest):
    def test_scrubbing_the_stack_moves_the_object(self):
        window = self.window("shear", *LIGHT, *TWO_ENTRIES, size=WIDE)
        window.click(STACK_TAB)
        whole, picture = window.scene(), window.picture()
        middle = (SLIDER_LEFT + SLIDER_RIGHT) // 2
        window.drag((SLIDER_RIGHT - 1, SLIDER_Y), (SLIDER_RIGHT - 40, SLIDER_Y), (middle, SLIDER_Y), slowly=True)
        scrubbed = window.scene()
        self.assertIsNone(whole["stack_position"])
        self.assert_near([scrubbed["stack_position"]], [1.0], 0.1)
        self.assertEqual({**scrubbed, "stack_position": None}, whole)
        self.assertNotEqual(window.picture(), picture)
        self.assert_undo(window, whole, scrubbed)

    def test_playing_ends_with_the_whole_stack(self):
        window = self.window("shear", *LIGHT, *TWO_ENTRIES, "--set", "stack_position=1.8", size=WIDE)
        window.click(STACK_TAB)
        window.click(PLAY)
        until(lambda: window.scene()["stack_position"] is None, "the stack played to its end")

    def test_the_derivation_narrows_the_picture(self):
        window = self.window(*LIGHT, size=WIDE)
        alone = window.picture()
        window.key("d")
        beside = window.picture()
        window.key("d")
        self.assertNotEqual(alone, beside)
        self.assertEqual(window.picture(), alone)


if __name__ == "__main__":
    unittest.main()
