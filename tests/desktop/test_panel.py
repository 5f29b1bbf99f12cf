#!/usr/bin/env python3
"""The real sliders and buttons of the panel."""

import subprocess
import unittest
import zlib

from support import LIGHT, NORMALSCOPE, WindowTest, changed

NAIVE, INVERSE_TRANSPOSE, COFACTOR = (73, 79), (193, 79), (312, 79)
HIGH = (640, 560)  # enough for the sliders and what is said below them
LETTERS = range(28, 44)  # where those of the sliders stand


def rows(png):
    """The RGB pixels of a PNG, row by row."""
    at, data = 8, b""
    while at < len(png):
        length, kind = int.from_bytes(png[at:at + 4], "big"), png[at + 4:at + 8]
        if kind == b"IHDR":
            width, height, channels = (*(int.from_bytes(png[at + 8 + i:at + 12 + i], "big") for i in (0, 4)),
                                       {2: 3, 6: 4}[png[at + 17]])
        if kind == b"IDAT":
            data += png[at + 8:at + 8 + length]
        at += length + 12
    data, stride = zlib.decompress(data), width * channels
    before = bytearray(stride)
    for y in range(height):
        kind, row = data[y * (stride + 1)], bytearray(data[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = (row[i - channels], before[i], before[i - channels]) if i >= channels else (0, before[i], 0)
            if kind == 1:
                row[i] = row[i] + left & 255
            elif kind == 2:
                row[i] = row[i] + up & 255
            elif kind == 3:
                row[i] = row[i] + (left + up) // 2 & 255
            elif kind == 4:
                nearest = min((left, up, corner), key=lambda v, p=left + up - corner: abs(p - v))
                row[i] = row[i] + nearest & 255
        before = row
        yield [row[x * channels:x * channels + 3] for x in range(width)]


def hue(pixel):
    """0, 1 or 2 for red, green or blue; None for what is none of them clearly."""
    largest = max(range(3), key=lambda i: pixel[i])
    return largest if pixel[largest] > 1.45 * sorted(pixel)[1] else None


def scale_sliders():
    """How far down the sliders of the first scale are: where, in equal steps, a red letter, a green and a blue follow."""
    picture = subprocess.run(
        [NORMALSCOPE, "capture", "--panel", "--context", "osmesa", "--size", "%dx%d" % HIGH, "-o", "-"],
        check=True, capture_output=True).stdout
    letters = []
    for y, row in enumerate(rows(picture)):
        for color in {hue(row[x]) for x in LETTERS} - {None}:
            if letters and letters[-1][0] == color and y - letters[-1][2] < 4:
                letters[-1][2] = y
            else:
                letters.append([color, y, y])
    middles = [(color, (first + last) / 2) for color, first, last in letters]
    for (a, x), (b, y), (c, z) in zip(middles, middles[1:], middles[2:]):
        if (a, b, c) == (0, 1, 2) and 20 < y - x < 50 and abs((z - y) - (y - x)) < 4:
            return [round(at) for at in (x, y, z)]
    raise AssertionError(f"no sliders among {middles}")


class PanelTest(WindowTest):
    @classmethod
    def setUpClass(cls):
        cls.rows = scale_sliders()

    def slider(self, axis, x=200):
        return (x, self.rows[axis])

    def test_the_y_slider(self):
        window = self.window(size=HIGH)
        before = window.scene()
        window.drag(self.slider(1), self.slider(1, 190), self.slider(1, 180), slowly=True)
        after = window.scene()
        factor = after["stack"][0]["scale"][1]
        self.assertTrue(1 < factor < 1.9, factor)
        self.assertEqual(after, changed(before, "stack.0.scale.1", factor))
        self.assert_undo(window, before, after)

    def test_a_slider_through_zero(self):
        window = self.window(*LIGHT, size=HIGH)
        before = window.scene()
        window.drag(self.slider(0), self.slider(0, 185), self.slider(0, 175), self.slider(0, 150), slowly=True)
        after = window.scene()
        factor = after["stack"][0]["scale"][0]
        self.assertTrue(-2 < factor < 0, factor)
        self.assertEqual(after, changed(before, "stack.0.scale.0", factor))
        self.assert_undo(window, before, after)

    def test_the_sliders_stay_where_they_are(self):
        # Whatever there is to be said of a reflection or of a flat object.
        window = self.window(*LIGHT, size=HIGH)
        for axis, way in ((0, (185, 150)), (2, (180, 160)), (1, (190, 180)), (2, (210, 220))):
            before = window.scene()["stack"][0]["scale"]
            window.drag(*(self.slider(axis, x) for x in (200, *way)), slowly=True)
            after = window.scene()["stack"][0]["scale"]
            self.assertEqual([i for i in range(3) if before[i] != after[i]], [axis])

    def test_a_click_alone_changes_nothing(self):
        window = self.window(*LIGHT, size=HIGH)
        before = window.scene()
        window.click(self.slider(2, 100))
        self.assertEqual(window.scene(), before)

    def test_typing_a_number(self):
        window = self.window(*LIGHT, size=HIGH)
        scenes = [window.scene()]
        for text, value in (("-1.5e0", -1.5), ("nan", -1.5), ("0", 0), ("1/4", 0.25)):  # e and n are letters here
            window.click(self.slider(2, 340))
            window.type(text)
            window.key("Return")
            scenes.append(window.scene())
            self.assertEqual(scenes[-1], changed(scenes[0], "stack.0.scale.2", value), text)
        self.assert_undo(window, scenes[0], scenes[1], *scenes[3:])

    def test_locked_factors_keep_their_proportions(self):
        window = self.window(*LIGHT, size=HIGH)
        window.click((242, self.rows[0] - 31))
        window.drag(self.slider(1), self.slider(1, 190), self.slider(1, 180), slowly=True)
        x, y, z = window.scene()["stack"][0]["scale"]
        self.assertTrue(1 < y < 1.9, y)
        self.assert_near([x, z], [y / 4, y / 2], 1e-9)

    def test_the_rules(self):
        window = self.window(*LIGHT, size=HIGH)
        scenes = [window.scene()]
        for place, rule in ((NAIVE, "naive"), (COFACTOR, "cofactor"), (INVERSE_TRANSPOSE, "inverse-transpose")):
            window.click(place)
            scenes.append(window.scene())
            self.assertEqual(scenes[-1], changed(scenes[0], "rule", rule))
        self.assert_undo(window, *scenes)


if __name__ == "__main__":
    unittest.main()
