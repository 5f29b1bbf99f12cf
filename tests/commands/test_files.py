#!/usr/bin/env python3
"""Files that cannot be read, or are not what they should be: exit code 3 and one line."""

import os
import struct
import unittest

from support import CommandTest

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


class FileTest(CommandTest):
    def refused(self, path, says=()):
        out = self.folder / "out.png"
        self.assert_fails(3, "capture", path, "-o", out, "--size", "32x32", says=(path, *says))
        self.assertFalse(out.exists())

    def accepted(self, name, content, notes=("has no normals",)):
        return self.numbers(self.file(name, content), "--size", "32x32", notes=notes)["surface"]

    # ---- whatever the kind

    def test_missing(self):
        for name in ("none.json", "none.obj", "none.ply", "none.stl"):
            self.refused(self.folder / name, says=("No such file",))

    def test_names_that_are_none(self):
        out = ("-o", self.folder / "out.png")
        self.assert_fails(3, "capture", "", *out, says="its name is empty")
        self.assert_fails(3, "capture", self.scene(surface={"mesh": "a\0b.obj"}), *out, says="cannot hold a NUL")
        self.assert_fails(3, "capture", self.scene(surface={"mesh": ""}), *out, says="surface.mesh: is empty")

    def test_an_unknown_name_is_answered_with_the_built_in_scenes(self):
        self.refused("none", says=("slide-scale", "split"))
        self.refused(self.file("mesh.fbx", "x"), says=(".json", ".obj", ".ply", ".stl"))

    def test_a_folder(self):
        for name in ("folder.json", "folder.obj"):
            (self.folder / name).mkdir()
            self.refused(self.folder / name, says=("folder",))

    def test_unreadable(self):
        # The super-user may read everything that has permissions; a process's memory at 0 nobody can read.
        for name in ("memory.obj", "memory.json"):
            path = self.folder / name
            path.symlink_to("/proc/self/mem")
            self.refused(path, says=("cannot be read",))
        if os.getuid() != 0:
            path = self.file("locked.obj", TRIANGLE)
            path.chmod(0)
            self.refused(path, says=("Permission denied",))

    def test_huge(self):
        for name in ("huge.json", "huge.obj", "huge.stl"):
            path = self.file(name, "")
            with open(path, "wb") as file:
                file.truncate(8 << 30)
            self.refused(path, says=("larger than",))

    def test_empty(self):
        for name in ("empty.json", "empty.obj", "empty.ply", "empty.stl"):
            self.refused(self.file(name, ""), says=("empty",))

    def test_binary(self):
        for seed, name in enumerate(("binary.json", "binary.obj", "binary.ply", "binary.stl")):
            noise = bytes((i * i * 31 + i * 7 + seed) % 256 for i in range(5000))
            self.refused(self.file(name, noise))

    # ---- meshes

    def test_a_truncated_mesh(self):
        self.refused(self.file("m.obj", TRIANGLE[:TRIANGLE.index("v 0 1") + 4]))
        ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" \
              "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n"
        self.refused(self.file("m.ply", ply))
        self.refused(self.file("m.stl", b"\0" * 80 + (1000).to_bytes(4, "little") + b"\0" * 100))

    def test_a_mesh_that_claims_billions(self):
        self.refused(self.file("m.stl", b"\0" * 80 + b"\xff\xff\xff\xff" + b"\0" * 50))
        ply = "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n" \
              "property float z\nelement face 4000000000\nproperty list uchar int vertex_indices\nend_header\n0000"
        self.refused(self.file("m.ply", ply))

    def test_no_faces(self):
        self.refused(self.file("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"))

    def test_faces_out_of_range(self):
        for face in ("f 1 2 4", "f 0 1 2", "f 1 2 -4", "f 1 2 2147483647"):
            self.refused(self.file("m.obj", TRIANGLE.replace("f 1 2 3", face)))

    def test_coordinates(self):
        for number in ("nan", "NaN", "inf", "-inf", "1e300", "1e999", "x", "1.2.3.4x"):
            self.refused(self.file("m.obj", TRIANGLE.replace("v 1 0", f"v {number} 0")))

    def test_zero_area(self):
        self.refused(self.file("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"))
        self.refused(self.file("point.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n"))
        self.accepted("mixed.obj", TRIANGLE + "f 1 1 2\nf 1 2 2\n", notes=("no normals", "2 faces without area left out"))

    def test_meshes_that_are_fine(self):
        self.accepted("m.obj", TRIANGLE)
        self.accepted("M.OBJ", TRIANGLE)
        self.accepted("crlf.obj", TRIANGLE.replace("\n", "\r\n"))
        self.accepted("no newline.obj", TRIANGLE.rstrip())
        self.accepted("material.obj", "mtllib none.mtl\nusemtl none\n" + TRIANGLE)
        self.accepted("far.obj", TRIANGLE.replace(" 1 0", " 1e15 0"))
        self.accepted("tiny.obj", TRIANGLE.replace("v 1 0", "v 1e-15 0").replace("v 0 1", "v 0 1e-15"))

    def test_notes_on_a_mesh(self):
        surface = self.accepted("m.obj", TRIANGLE.replace("f 1 2 3", "f 1//9 2//9 3//9"))
        self.assertEqual(surface, {"triangles": 1, "vertices": 3, "notes": ["m.obj has no normals: computed, area-weighted"]})
        surface = self.accepted("n.obj", "vn 0 0 1\n" + TRIANGLE.replace("f 1 2 3", "f 1//1 2//1 3//1"), notes=())
        self.assertEqual(surface["notes"], [])
        facet = b"\0" * 12 + b"".join(struct.pack("<fff", *p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0))) + b"\0\0"
        surface = self.accepted("s.stl", b"\0" * 80 + struct.pack("<I", 1) + facet + b"more",
                                notes=("vertex normals", "what follows its last facet is left out"))
        self.assertEqual(len(surface["notes"]), 2)

    def test_facets_that_are_none(self):
        self.refused(self.file("float.obj", TRIANGLE.replace("f 1", "f 1.9")), says=("line 4", '"1.9"', "export"))
        self.refused(self.file("m.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                                        "vertex 1 1 0\nendloop\nendfacet\nendsolid x\n"), says=("line 7", "three", "export"))

    # ---- scenes

    def test_scenes_that_are_no_json(self):
        for text in ("{", "[]", "3", "null", '"split"', "{'rule': 1}", '{"normalscope": 1', '{"normalscope": 1} x',
                     "[" * 100_000, '{"a":' * 100_000):
            self.refused(self.file("s.json", text))

    def test_unknown_keys(self):
        self.refused(self.scene(colour="red"), says=("colour", "known"))
        self.refused(self.scene(camera={"azimut": 3}), says=("camera.azimut", "azimuth"))
        self.refused(self.scene(stack=[{"scale": [1, 1, 1]}, {"squash": 2}]), says=("stack.1", "scale"))
        self.refused(self.scene(surface={"form": "sphere"}), says=("surface", "shape", "mesh"))

    def test_a_key_that_is_there_twice(self):
        self.refused(self.file("s.json", '{"rule": "naive", "view": "split", "rule": "cofactor"}'), says=("rule: is there twice",))
        self.refused(self.file("s.json", '{"camera": {"zoom": 1, "zoom": 2}}'), says=("camera.zoom: is there twice",))

    def test_a_very_long_key(self):
        self.refused(self.file("s.json", '{"%s": 1}' % ("k" * 100_000)), says=("unknown key",))
        self.refused(self.file("s.json", '{"camera": {"%s": 1}}' % ("é" * 100_000)), says=("unknown key",))

    def test_wrong_types(self):
        for keys, path in (
                ({"rule": 3}, "rule"),
                ({"rule": "right"}, "rule"),
                ({"view": None}, "view"),
                ({"stack": {}}, "stack"),
                ({"stack": [[1, 2, 3]]}, "stack.0"),
                ({"stack": [{"scale": [1, 2]}]}, "stack.0.scale"),
                ({"stack": [{"scale": [1, "2", 3]}]}, "stack.0.scale.1"),
                ({"stack": [{"rotate": {"axis": [0, 0, 0], "degrees": 3}}]}, "stack.0.rotate.axis"),
                ({"stack": [{"matrix": [[1, 0], [0, 1]]}]}, "stack.0.matrix"),
                ({"stack": [{"scale": [1, 1, 1], "translate": [1, 1, 1]}]}, "stack.0"),
                ({"camera": {"zoom": True}}, "camera.zoom"),
                ({"camera": {"zoom": 0}}, "camera.zoom"),
                ({"arrows": {"every": 1.5}}, "arrows.every"),
                ({"arrows": {"length": -1}}, "arrows.length"),
                ({"surface": {"shape": "teapot"}}, "surface.shape"),
                ({"surface": {"shape": "sphere", "mesh": "a.obj"}}, "surface"),
                ({"surface": {"shape": "sphere", "resolution": 100000}}, "surface.resolution"),
                ({"normalscope": 2}, "normalscope"),
                ({"normalscope": "1"}, "normalscope")):
            with self.subTest(keys):
                self.refused(self.scene(**keys), says=(path + ":",))

    def test_numbers_that_are_none(self):
        for number in ("NaN", "Infinity", "-Infinity", "1e999", "1e300"):
            self.refused(self.file("s.json", '{"normalscope": 1, "stack": [{"scale": [1, %s, 1]}]}' % number), says=("stack.0.scale.1: ",))

    def test_a_stack_of_a_thousand(self):
        self.refused(self.scene(stack=[{"scale": [1, 1, 1]}] * 1000), says=("stack", "1000", "200"))

    def test_a_product_that_overflows(self):
        self.refused_by_product(self.scene(stack=[{"scale": [1e9, 1e9, 1e9]}] * 100))

    def refused_by_product(self, path):
        self.assert_fails(3, "capture", path, "-o", self.folder / "out.png", "--size", "32x32", says=("stack", "below 1e60"))

    def test_a_scene_whose_mesh_is_missing(self):
        path = self.scene(surface={"mesh": "none.obj"})
        self.assert_fails(3, "capture", path, "-o", self.folder / "out.png", says="none.obj")

    def test_a_mesh_is_looked_for_beside_its_scene(self):
        self.file("m.obj", TRIANGLE)
        self.capture(self.scene(surface={"mesh": "m.obj"}), cwd="/", notes=("no normals",))


if __name__ == "__main__":
    unittest.main()
