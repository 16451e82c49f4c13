"""samples/python/draw.py: the pictures show the data, whatever they are, and files that cannot be used are named."""

import contextlib
import io
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np

PROGRAM = sys.argv.pop(1)
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(PROGRAM))

import draw
import pictures

RESIDUAL_COLUMNS = ("u,v,residual_u,residual_v,cov_uu,cov_uv,cov_vv,x,y,z,cov_xx,cov_xy,cov_xz,cov_yy,cov_yz,cov_zz,"
                    "inside\n")
RESIDUALS = ("# kind residuals\n# title scene: 3 points, GMLPNP\n# unit m\n# image_size 640 480\n"
             "# squared_radius_95 5.991\n" + RESIDUAL_COLUMNS +
             "100,50,0.5,0.25,1,0.5,4,0.01,0.02,0.03,4e-4,0,0,1e-4,0,9e-4,1\n"
             "200,300,-1,0.5,1,0.5,4,-0.01,0.01,0,4e-4,0,0,1e-4,0,9e-4,1\n"
             "600,400,9,-9,1,0.5,4,0.5,0.5,0.5,4e-4,0,0,1e-4,0,9e-4,0\n")
ERRORS = ("# kind errors\n# title study\npair,method,points,solved,rx_rad,ry_rad,rz_rad,tx,ty,tz,rotation_deg,"
          "translation_cm,time_us\n"
          "a,SQPNP,9,1,0,0,0,0,0,0,-2,30,5\na,GMLPNP,9,1,0,0,0,0,0,0,1,10,5\n"
          "b,SQPNP,9,0,,,,,,,,,\nb,GMLPNP,9,1,0,0,0,0,0,0,-3,20,5\n")
ISOTROPY = ("# kind isotropy\n# title study\n# frame map\n# axes east north up\n# unit m\n"
            "# moments 4 0 0 0 9 -2 0 -2 1\n# isotropic 5 0 0 0 5 0 0 0 4\n# distance 0.25\n# p_residuals 0.0005\n"
            "# p_pairs 0.25\n# Object frame.\npair,X,Y,Z,ex,ey,ez,depth,ray_x,ray_y,ray_z\n"
            "a,1,2,3,2,-3,1,9,0,0,1\na,1,2,3,-2,3,-1,9,0,0,1\nb,1,2,3,2,3,-1,9,0,0,1\n")
MAP = ("# kind map\n# title photo_by_ortho: 2 points\n# unit m\n# terrain map_photo.asc\n"
       "# covariance 4 0 0 0 1 0 0 0 9\nwhat,name,easting,northing,elevation\ncentre,GMLPNP_MARGINAL,1200,2200,600\ntruth,,1203,2196,600\n"
       "method,SQPNP,1203,2196,612\nmethod,GMLPNP_MARGINAL,1200,2200,600\npoint,,1100,2100,20\npoint,,1300,2350,30\n")
GROUND = ("ncols 3\nnrows 2\nxllcorner 1000\nyllcorner 2000\ncellsize 200\nNODATA_value -9999\n"
          "10 20 30\n40 -9999 60\n")


class Folder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def drawn(self, text):
        """The axes of the picture of a file, and all its words."""
        figure = pictures.draw(self.write("data.csv", text))
        words = [word.get_text() for word in figure.findobj(pictures.matplotlib.text.Text)]
        return figure.axes, "\n".join(words)


class Residuals(Folder):
    def test_are_arrows_at_their_pixels(self):
        (image, xy, xz), words = self.drawn(RESIDUALS)
        arrows = [c for c in image.collections if isinstance(c, pictures.matplotlib.quiver.Quiver)]
        inside, outside = sorted(arrows, key=lambda quiver: -quiver.N)
        np.testing.assert_allclose(inside.XY, [[100, 50], [200, 300]])
        np.testing.assert_allclose(outside.XY, [[600, 400]])
        magnified = inside.U[0] / 0.5
        self.assertGreater(magnified, 1)
        self.assertIn(f"{magnified:g} times as large", words)
        np.testing.assert_allclose(inside.V, magnified * np.array([0.25, 0.5]))
        self.assertEqual((image.get_xlim(), image.get_ylim()), ((-0.5, 639.5), (479.5, -0.5)))
        for text in ("scene: 3 points, GMLPNP", "inside its 95 % ellipse: 66.7 %", "outside: 33.3 %", "x [cm]",
                     "z [cm]"):
            self.assertIn(text, words)
        np.testing.assert_allclose(xy.collections[0].get_offsets(), [[1, 2], [-1, 1]])
        np.testing.assert_allclose(xz.collections[1].get_offsets(), [[50, 50]])
        self.assertAlmostEqual(xz.patches[0].width, 2 * np.sqrt(5.991) * 2, places=6)
        self.assertAlmostEqual(xz.patches[0].height, 2 * np.sqrt(5.991) * 3, places=6)

    def test_ellipses_have_the_covariance(self):
        (image, _, _), _ = self.drawn(RESIDUALS)
        lines = [c for c in image.collections if isinstance(c, pictures.LineCollection)]
        outline = lines[0].get_segments()[0] - [100, 50]
        distances = np.einsum("ki,ij,kj->k", outline, np.linalg.inv([[1, 0.5], [0.5, 4]]), outline)
        np.testing.assert_allclose(distances, distances[0])
        magnified = np.sqrt(distances[0] / 5.991)
        self.assertIn(f"{magnified:g} times", image.get_title())

    def test_of_any_data_are_drawn(self):
        head, rows = RESIDUALS.split(RESIDUAL_COLUMNS)
        exact = "1,2,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1\n"
        for text in (head + RESIDUAL_COLUMNS + exact, RESIDUALS.replace("600,400", "1e9,-1e9"),
                     (head + RESIDUAL_COLUMNS + rows).replace("# image_size 640 480\n", ""),
                     head.replace("# image_size 640 480\n", "") + RESIDUAL_COLUMNS + exact * 3):
            axes, words = self.drawn(text)
            axes[0].figure.canvas.draw()
            self.assertIn("scene", words)
        self.assertIn("no noise", self.drawn(head + RESIDUAL_COLUMNS + exact)[1])
        self.assertIn("no residuals", self.drawn("# kind residuals\n" + RESIDUAL_COLUMNS)[1])


class Errors(Folder):
    def test_are_shares_of_all_pairs(self):
        (rotation, translation), words = self.drawn(ERRORS)
        sqpnp, gmlpnp = rotation.lines
        np.testing.assert_allclose(np.transpose(sqpnp.get_data())[:2], [[0, 0], [2, 50]])
        self.assertEqual(max(sqpnp.get_ydata()), 50, "the pair that it did not solve counts")
        np.testing.assert_allclose(np.transpose(gmlpnp.get_data())[:3], [[0, 0], [1, 50], [3, 100]])
        np.testing.assert_allclose(rotation.get_xlim(), (0, 1.03))
        np.testing.assert_allclose(translation.lines[1].get_xdata()[:3], [0, 10, 20])
        for text in ("study", "rotation error [deg]", "translation error [cm]", "SQPNP", "GMLPNP"):
            self.assertIn(text, words)

    def test_of_nothing_solved_are_said_to_be_none(self):
        nothing = "".join(line for line in ERRORS.splitlines(True) if ",1,0" not in line)
        self.assertIn("nothing solved", self.drawn(nothing)[1])


class Isotropy(Folder):
    def test_moments_are_ellipses_and_numbers(self):
        axes, words = self.drawn(ISOTROPY)
        isotropic, found = axes[0].patches
        self.assertAlmostEqual(found.width * found.height, 4 * 5.991 * 2 * 3, places=6)
        self.assertAlmostEqual(isotropic.width, 2 * np.sqrt(5.991 * 5), places=6)
        np.testing.assert_allclose(axes[0].collections[0].get_offsets(), [[2, -3], [-2, 3], [2, 3]])
        for text in ("map", "east [m]", "up [m]", "9.00", "-2.00", "3 residuals of 2 pairs", "3.08, 2, 0.727 m",
                     "2.24, 2.24, 2 m", "distance 0.250", "p = 0.0005, residuals", "p = 0.2500, pairs"):
            self.assertIn(text, words)

    def test_exact_data_are_drawn(self):
        nothing = ISOTROPY.replace("4 0 0 0 9 -2 0 -2 1", "0 " * 9).replace("5 0 0 0 5 0 0 0 4", "0 " * 9)
        axes, words = self.drawn(nothing)
        axes[0].figure.canvas.draw()
        self.assertIn("exact data", words)


class Maps(Folder):
    def test_show_the_camera_the_truth_and_the_solvers(self):
        self.write("map_photo.asc", GROUND)
        axes, words = self.drawn(MAP)
        ground, zoom, height = axes[:3]
        np.testing.assert_allclose(ground.collections[0].get_offsets(), [[1100, 2100], [1300, 2350]])
        np.testing.assert_allclose(ground.collections[1].get_offsets(), [[1200, 2200]])
        self.assertEqual(ground.images[0].get_extent(), (1000, 1600, 2000, 2400))
        self.assertTrue(ground.images[0].get_array().mask[1, 1], "nobody knows the height of this cell")
        self.assertAlmostEqual(zoom.patches[0].width * zoom.patches[0].height, 4 * 5.991 * 2 * 1, places=6)
        at = [tuple(c.get_offsets()[0]) for c in zoom.collections]
        self.assertEqual(at, [(3, -4), (0, 0), (3, -4)], "SQPNP, the estimate, the truth")
        self.assertEqual([line.get_ydata()[0] for line in height.lines], [12, 0])
        for text in ("photo_by_ortho", "SQPNP: 12.00 m off", "GMLPNP_MARGINAL: 5.00 m off", "truth", "easting [m]"):
            self.assertIn(text, words)

    def test_without_truth(self):
        self.write("map_photo.asc", GROUND)
        _, words = self.drawn(MAP.replace("truth,,1203,2196,600\n", ""))
        self.assertNotIn("truth", words)
        self.assertNotIn("off", words)

    def test_a_ground_that_cannot_be_used_is_named(self):
        with self.assertRaisesRegex(OSError, "map_photo.asc: cannot be read"):
            self.drawn(MAP)
        for text in ("", "ncols 3", GROUND.replace("60", ""), GROUND.replace("3\n", "x\n"),
                     GROUND.replace("200\n", "0\n"), GROUND.replace("ncols 3", "ncols 1e999")):
            self.write("map_photo.asc", text)
            with self.assertRaisesRegex(ValueError, "map_photo.asc: is no ESRI ASCII grid"):
                self.drawn(MAP)


class Files(Folder):
    def test_that_cannot_be_used_are_named(self):
        for text, complaint in (("", "no '# kind' line"), ("u,v\n1,2\n", "no '# kind' line"),
                                ("# kind poem\nu\n1\n", "unknown kind 'poem'"),
                                (RESIDUALS.replace("u,v,", "a,b,"), "no column 'u'"),
                                (RESIDUALS.replace("100,50,", "100,fifty,"), "v: could not convert"),
                                (RESIDUALS.replace("100,50,", "100,nan,"), "v: a number is not finite"),
                                (RESIDUALS.replace("100,50,", "100,50,7,"), ":7: expected 17 cells, found 18"),
                                (RESIDUALS.replace("95 5.991", "95"), "1 numbers after '# squared_radius_95', found 0"),
                                (ISOTROPY.replace("east north", "east"), "three names after '# axes'"),
                                (ERRORS.replace("tz", "TZ"), "no column with errors"),
                                (MAP.replace("centre,", "middle,"), "one row 'centre'")):
            with self.assertRaisesRegex(ValueError, f"data.csv.*{complaint}"):
                self.drawn(text)

    def run_program(self, *arguments):
        with contextlib.redirect_stdout(io.StringIO()) as output, contextlib.redirect_stderr(io.StringIO()) as errors:
            code = draw.main(arguments)
        return code, output.getvalue(), errors.getvalue()

    def test_are_drawn_by_the_program(self):
        data = self.write("errors.csv", ERRORS)
        done = subprocess.run([sys.executable, "-B", PROGRAM, data], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, self.path("errors.png") + "\n", ""))
        done = subprocess.run([sys.executable, "-B", PROGRAM], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("usage", done.stderr)

    def test_of_a_folder_become_pictures_beside_them(self):
        self.write("residuals.csv", RESIDUALS)
        self.write("errors.csv", ERRORS)
        self.write("positions.csv", "pair,points\na,1\n")
        code, output, complaint = self.run_program(self.folder)
        self.assertEqual((code, complaint), (0, ""))
        self.assertEqual(output.split(), [self.path("errors.png"), self.path("residuals.png")])
        for picture in output.split():
            pixels = pictures.plt.imread(picture)
            colours = len(np.unique(pixels.reshape(-1, pixels.shape[2]), axis=0))
            self.assertGreater(colours, 50, "a picture of nothing")

    def test_are_drawn_where_asked_and_always_alike(self):
        data = self.write("errors.csv", ERRORS)
        for name in ("one.svg", "two.svg", "one.pdf", "two.pdf"):
            self.assertEqual(self.run_program(data, "-o", self.path(name)), (0, self.path(name) + "\n", ""))
        for kind in (".svg", ".pdf"):
            with open(self.path("one" + kind), "rb") as one, open(self.path("two" + kind), "rb") as two:
                self.assertEqual(one.read(), two.read())
        folder = self.path("a/b")
        self.assertEqual(self.run_program(data, "--output=" + folder)[:2], (0, os.path.join(folder, "errors.png\n")))

    def test_and_calls_that_make_no_sense(self):
        data, other = self.write("residuals.csv", RESIDUALS), self.write("errors.csv", ERRORS)
        one, below = self.path("one.png"), os.path.join(other, "one.png")
        os.mkdir(self.path("empty"))
        for arguments, complaint in (((self.path("nowhere.csv"),), "nowhere.csv: cannot be read"),
                                     ((self.path("empty"),), "empty: holds nothing that can be drawn"),
                                     ((data, other, "--output=" + one), "2 files to draw; name a folder"),
                                     ((data, data), "residuals.png: two files would be drawn to it"),
                                     ((other, "--output=" + below), "one.png: cannot be written")):
            code, output, message = self.run_program(*arguments)
            self.assertEqual((code, output), (1, ""))
            self.assertRegex(message, f"^draw.py: .*{complaint}")

    def test_a_picture_is_written_whole_or_not_at_all(self):
        picture = self.write("residuals.png", "kept")
        data = self.write("residuals.csv", RESIDUALS.replace("100,50,", "100,fifty,"))
        self.assertEqual(self.run_program(data)[0], 1)
        with open(picture, encoding="ascii") as file:
            self.assertEqual(file.read(), "kept")
        self.assertEqual(sorted(os.listdir(self.folder)), ["residuals.csv", "residuals.png"])

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full here")
    def test_a_full_disk_is_an_error(self):
        os.symlink("/dev/full", self.path("full.png"))
        code, _, message = self.run_program(self.write("errors.csv", ERRORS), "-o", self.path("full.png"))
        self.assertEqual(code, 1)
        self.assertIn("full.png: cannot be written (No space left on device)", message)


if __name__ == "__main__":
    unittest.main()
