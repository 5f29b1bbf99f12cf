#!/usr/bin/env python3
"""The mouse in the picture: the knobs, the camera, the light, the probe."""

import json
import math
import unittest

from support import LIGHT, MIDDLE, PANEL, SIZE, Camera, WindowTest, changed

KNOB = 1.15  # of the sphere's radius


class MouseTest(WindowTest):
    def knob(self, scene, axis, factor):
        """Where an axis' knob stands for that factor."""
        return Camera(scene).pixel([KNOB * factor if i == axis else 0 for i in range(3)])

    def test_a_knob_stretches_its_axis(self):
        window = self.window()
        before = window.scene()
        window.drag(self.knob(before, 2, 1), self.knob(before, 2, 1.6))
        after = window.scene()
        factor = after["stack"][0]["scale"][2]
        self.assertAlmostEqual(factor, 1.6, delta=0.03)
        self.assertAlmostEqual(factor, round(factor, 2), places=9)
        self.assertEqual(after, changed(before, "stack.0.scale.2", factor))
        self.assert_undo(window, before, after)

    def test_a_knob_through_zero_mirrors(self):
        window = self.window()
        before = window.scene()
        window.drag(*(self.knob(before, 0, factor) for factor in (0.5, 0.2, 0, -0.2, -0.5)), slowly=True)
        after = window.scene()
        factor = after["stack"][0]["scale"][0]
        self.assertAlmostEqual(factor, -0.5, delta=0.05)
        self.assertEqual(after, changed(before, "stack.0.scale.0", factor))
        self.assert_undo(window, before, after)

    def test_whatever_is_looked_at_when_the_object_is_flat(self):
        window = self.window("flattened")
        before = window.scene()
        for key in "ncevvtig":  # each drawn
            window.key(key)
        after = window.scene()
        self.assertEqual(after["stack"], before["stack"])
        self.assertNotEqual(after, before)

    def test_shift_and_a_knob_scale_evenly(self):
        window = self.window("identity", *LIGHT)
        before = window.scene()
        window.do("keydown", "shift")
        window.drag(self.knob(before, 1, 1), self.knob(before, 1, 1.5))
        window.do("keyup", "shift")
        scale = window.scene()["stack"][0]["scale"]
        self.assertAlmostEqual(scale[0], 1.5, delta=0.03)
        self.assert_near(scale, [scale[0]] * 3, 1e-9)

    def test_knobs_aim_the_ray_and_move_the_slice(self):
        settings = ("stack=[]", 'surface={"formula": "x^2+y^2+z^2-1"}', "ray.from=[-1.2,1.2,0.6]",
                    "ray.toward=[0,0.2,0.4]", "slice.axis=y", "slice.at=0.5")
        window = self.window(*LIGHT, *(word for setting in settings for word in ("--set", setting)))
        before = window.scene()
        camera = Camera(before)
        window.drag(camera.pixel([-1.2, 1.2, 0.6]), camera.pixel([-1.2, 0.9, 0.6]))
        aimed = window.scene()
        self.assert_near(aimed["ray"]["from"], [-1.2, 0.9, 0.6], 0.15)  # the picture is seen from above
        self.assertEqual(aimed, changed(before, "ray.from", aimed["ray"]["from"]))
        self.assert_undo(window, before, aimed)

        edge = 1.06 * math.sqrt(4 - 0.25)
        window.drag(camera.pixel([edge, 0.5, 0]), camera.pixel([edge, 0.2, 0]))
        moved = window.scene()["slice"]
        self.assertAlmostEqual(moved["at"], 0.2, delta=0.03)

    def test_orbit(self):
        window = self.window(*LIGHT)
        before = window.scene()
        window.drag(MIDDLE, (MIDDLE[0] + 50, MIDDLE[1] - 30))
        after = window.scene()
        self.assert_near([after["camera"]["azimuth"], after["camera"]["elevation"]], [30 - 20, 20 - 12], 1e-6)
        self.assertEqual(after | {"camera": before["camera"]}, before)
        self.assert_undo(window, before, after)

    def test_pan(self):
        window = self.window(*LIGHT)
        scenes = [window.scene()]
        for button in (2, 3):
            window.drag(MIDDLE, (MIDDLE[0] + 40, MIDDLE[1] - 30), button=button)
            scenes.append(window.scene())
            # What was in the middle has followed the pointer.
            x, y = Camera(scenes[-2]).pixel((0, 0, 0))
            self.assert_near(Camera(scenes[-1]).pixel((0, 0, 0)), (x + 40, y - 30), 1)
            self.assertEqual(changed(scenes[-1], "camera.target", [0, 0, 0]), scenes[0])
        self.assert_undo(window, *scenes)

    def test_zoom(self):
        window = self.window(*LIGHT)
        before = window.scene()
        window.point(MIDDLE)
        window.wheel(3)
        nearer = window.scene()
        self.assertAlmostEqual(nearer["camera"]["zoom"], 1.12 ** 3, places=6)
        self.assertEqual(changed(nearer, "camera.zoom", 1), changed(before, "camera.zoom", 1))
        window.wheel(-5)
        farther = window.scene()
        self.assertAlmostEqual(farther["camera"]["zoom"], 1.12 ** -2, places=6)
        self.assert_undo(window, before, nearer, farther)

    def test_the_light(self):
        window = self.window(*LIGHT)
        before = window.scene()
        window.do("keydown", "shift")
        window.drag(MIDDLE, (MIDDLE[0] + 50, MIDDLE[1] - 20))
        window.do("keyup", "shift")
        after = window.scene()
        self.assertNotEqual(after["light"], before["light"])
        self.assertEqual(after | {"light": before["light"]}, before)
        self.assert_undo(window, before, after)

    def test_a_click_on_the_surface_places_the_probe(self):
        window = self.window(*LIGHT, "--set", "arrows.show=[]")
        before = window.scene()
        window.click(MIDDLE)  # beside it
        self.assertEqual(window.scene(), before)
        point = [math.sin(0.9) * math.cos(0.5), math.sin(0.5), math.cos(0.9) * math.cos(0.5)]
        window.click(Camera(before).pixel([f * p for f, p in zip((0.5, 2, 1), point)]))
        after = window.scene()
        self.assertAlmostEqual(math.hypot(*after["probe"]), 1, delta=0.01)  # of facets, whose middles lie within
        self.assert_near(after["probe"], point, 0.03)
        self.assertEqual(after | {"probe": before["probe"]}, before)
        self.assert_undo(window, before, after)

    def test_a_click_on_an_arrow_places_the_probe_at_its_foot(self):
        corners = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
        mesh = "".join("v %d %d %d\n" % corner for corner in corners)
        mesh += "".join("f %d %d %d\n" % face for face in (
            (1, 3, 5), (3, 2, 5), (2, 4, 5), (4, 1, 5), (3, 1, 6), (2, 3, 6), (4, 2, 6), (1, 4, 6)))
        (self.folder / "octahedron.obj").write_text(mesh)
        (self.folder / "octahedron.json").write_text(json.dumps({
            "normalscope": 1, "surface": {"mesh": "octahedron.obj"}, "view": "single", "rule": "inverse-transpose",
            "arrows": {"length": 0.2}, "show": {"axes": False}}))
        window = self.window("octahedron.json")
        before = window.scene()
        for corner in ((0, 1, 0), (1, 0, 0)):
            window.click(Camera(before).pixel([1.25 * c for c in corner]))
            self.assert_near(window.scene()["probe"], corner, 1e-5)

    def test_a_click_in_the_right_half_of_a_split_picture(self):
        window = self.window(*LIGHT, "--set", "view=split", "--set", "arrows.show=[]", "--set", "stack=[]")
        before = window.scene()
        half = (SIZE[0] - PANEL) // 2
        point = [math.sin(0.9) * math.cos(0.5), math.sin(0.5), math.cos(0.9) * math.cos(0.5)]
        window.click(Camera(before, (SIZE[0], SIZE[1]), PANEL + half).pixel(point))
        self.assert_near(window.scene()["probe"], point, 0.04)

    def test_a_press_counts_where_the_pointer_has_always_been(self):
        self.window(*LIGHT).point(MIDDLE)
        window = self.window(*LIGHT)
        window.do("mousedown", 1)
        window.point((MIDDLE[0] + 50, MIDDLE[1]))
        window.do("mouseup", 1)
        self.assertAlmostEqual(window.scene()["camera"]["azimuth"], 10, places=6)

    def test_a_press_counts_where_the_pointer_is(self):
        # As a touch screen sends it: the pointer jumps and presses at once.
        window = self.window(*LIGHT)
        before = window.scene()
        window.point((PANEL // 2, MIDDLE[1]))
        window.do("mousemove", "--window", window.id, *MIDDLE, "mousedown", 1)
        window.point((MIDDLE[0] + 50, MIDDLE[1]))
        window.do("mouseup", 1)
        after = window.scene()
        self.assertAlmostEqual(after["camera"]["azimuth"], 10, places=6)
        window.do("mousemove", "--window", window.id, 193, 79, "click", 1)  # the button of the inverse transpose
        window.point(MIDDLE)
        self.assertEqual(window.scene(), after)


if __name__ == "__main__":
    unittest.main()
