#!/usr/bin/env python3
"""Plants wrong includes into a copy of the sources, and sees that arrows.py finds each, and only that.

arrows_test.py ROOT
"""
import os
import shutil
import sys
import tempfile
import unittest

import arrows

ROOT = sys.argv.pop() if len(sys.argv) > 1 else os.path.join(arrows.HERE, "..", "..")


class Arrows(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.copy = os.path.join(cls.folder.name, "copy")
        for top in arrows.SEARCHED:
            shutil.copytree(os.path.join(ROOT, top), os.path.join(cls.copy, top))
        shutil.copy(os.path.join(ROOT, "CONTRIBUTING.md"), cls.copy)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def found(self, path, include):
        """@return what is found where the first line of a file, new if there is none, is that include"""
        whole = os.path.join(self.copy, path)
        before = None
        if os.path.exists(whole):
            with open(whole, encoding="utf-8") as text:
                before = text.read()
        os.makedirs(os.path.dirname(whole), exist_ok=True)
        with open(whole, "w", encoding="utf-8") as text:
            text.write(f"#include {include}\n{before or ''}")
        try:
            return arrows.check(self.copy)
        finally:
            if before is None:
                os.remove(whole)
            else:
                with open(whole, "w", encoding="utf-8") as text:
                    text.write(before)

    def assert_wrong(self, path, include, *words):
        found = self.found(path, include)
        self.assertTrue(found, "nothing was found")
        for word in words:
            self.assertIn(word, found[0])
        self.assertTrue(any(line.startswith(f"{path}:1: ") for line in found), found)

    def test_the_sources_as_they_are(self):
        self.assertEqual(arrows.check(self.copy), [])

    def test_a_room_above(self):
        self.assert_wrong("src/bullet/sheet/planted.h", '"bullet/layer/layer.h"', "src/bullet/layer", "above")
        self.assert_wrong("src/cloth/planted.cpp", '"water/wicking.h"', "src/water", "above")
        self.assert_wrong("demos/stage/planted.h", '"window/panel.h"', "demos/window", "above")
        self.assert_wrong("src/bullet/world/planted.h", '"../../../demos/world/angles.h"', "demos/world", "above")

    def test_a_room_beside(self):
        self.assert_wrong("src/bullet/small_steps/planted.h", '"bullet/bullet_solvers/stock_contacts.h"', "beside")
        self.assert_wrong("src/bullet/bullet_solvers/planted.h", '"bullet/small_steps/tethers.h"', "beside")

    def test_a_public_header_of_a_room_above(self):
        self.assert_wrong("src/bullet/contact/planted.h", '"drench/wet_cloth.h"', "src/bullet/layer", "above")
        self.assert_wrong("include/drench/sheet.h", "<drench/wet_contact.h>", "src/bullet/layer", "above")

    def test_bullet_where_none_is(self):
        for include in ("<BulletSoftBody/btSoftBody.h>", "<LinearMath/btVector3.h>", "<btBulletDynamicsCommon.h>",
                        "<bullet/btBulletCollisionCommon.h>"):
            self.assert_wrong("src/water/planted.h", include, "knows no Bullet")
        self.assert_wrong("src/bullet/simd/planted.h", "<LinearMath/btVector3.h>", "knows no Bullet")
        self.assert_wrong("src/files/planted.cpp", '"drench/wet_cloth.h"', "above")

    def test_bullet_by_way_of_a_public_header(self):
        found = self.found("include/drench/water.h", "<LinearMath/btVector3.h>")
        self.assertTrue(any(line.startswith("src/water/") and '"drench/water.h", and so LinearMath/btVector3.h'
                            in line.replace("<", '"') for line in found), found)

    def test_a_circle(self):
        found = self.found("src/water/edge_runs.h", '"water/film_flow.h"')
        self.assertTrue(any("which includes it" in line for line in found), found)

    def test_a_new_arrow_that_goes_down_is_to_be_drawn(self):
        found = self.found("src/bullet/world/planted.h", '"water/wicking.h"')
        lacks = "CONTRIBUTING.md:1: lacks what arrows.py --draw prints: "
        self.assertEqual(found, [lacks + "src/bullet/contact        -> src/bullet/world",
                                 lacks + "src/bullet/world          -> src/bullet/simd  src/water"])

    def test_a_room_that_is_not_listed(self):
        self.assert_wrong("src/attic/planted.h", "<vector>", "src/attic", "not in rooms.txt")


if __name__ == "__main__":
    unittest.main()
