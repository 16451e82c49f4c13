"""The generated docstrings and stubs say what the header and the module say."""

import ast
import importlib.util
import inspect
import os
import re
import subprocess
import sys
import tempfile
import unittest

import gmlpnp
import gmlpnp.fisheye

FOLDER = os.path.dirname(gmlpnp.__file__)
HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.environ.get("GMLPNP_ROOT", os.path.join(HERE, "..", ".."))
GENERATE = os.path.join(ROOT, "python", "generate")
HEADERS = os.path.join(ROOT, "modules", "gmlpnp", "include", "opencv2")
# Drawing needs opencv_imgproc.
TYPED = [os.path.join(HERE, "typed_use.py")]
if hasattr(gmlpnp, "drawPoseUncertainty"):
    TYPED.append(os.path.join(HERE, "typed_draw.py"))
HAS_MYPY = importlib.util.find_spec("mypy") is not None


def stub(name):
    with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
        return ast.parse(file.read())


def header(*name):
    with open(os.path.join(HEADERS, *name), encoding="utf-8") as file:
        return file.read()


def words(text):
    return re.findall(r"[A-Za-z]+", text)


def functions_in(body, scope):
    """Each function of a stub, in its classes too, with the object of the module that it describes."""
    for node in body:
        if isinstance(node, ast.FunctionDef) and node.name != "__init__":
            yield node, getattr(scope, node.name)
        elif isinstance(node, ast.ClassDef):
            yield from functions_in(node.body, getattr(scope, node.name))


def all_functions():
    yield from functions_in(stub("__init__.pyi").body, gmlpnp)
    yield from functions_in(stub("fisheye.pyi").body, gmlpnp.fisheye)


def dotted(node):
    """An expression like "gmlpnp.fisheye.solvePnP" as text; empty where it is another."""
    if isinstance(node, ast.Attribute):
        return "%s.%s" % (dotted(node.value), node.attr)
    return node.id if isinstance(node, ast.Name) else ""


def signature_of(node):
    """A function of a stub as "image, points = None"."""
    arguments = [argument.arg for argument in node.args.args]
    defaults = [ast.literal_eval(default) for default in node.args.defaults]
    first = len(arguments) - len(defaults)
    return [(argument, *([defaults[i - first]] if i >= first else [])) for i, argument in enumerate(arguments)]


def signatures_by_error(function):
    """pybind11 lists the overloads where a call fits none."""
    try:
        function(nonsense=0)
    except TypeError as error:
        for line in re.findall(r"^ +\d+\. \((.*)\) -> ", str(error), re.MULTILINE):
            found = re.findall(r"(\w+): (?:\w+\[.*?\]|[\w.]+)(?: = ([^,]*))?", line)
            yield [(name, *([ast.literal_eval(default)] if default else [])) for name, default in found]


class Stubs(unittest.TestCase):
    def test_parameters_and_defaults_are_those_of_the_module(self):
        stubs, runtime = {}, {}
        for node, function in all_functions():
            name = "%s.%s" % (function.__module__, getattr(function, "__qualname__", node.name))
            stubs.setdefault(name, []).append(signature_of(node))
            runtime[name] = list(signatures_by_error(function))
        self.assertGreater(len(stubs), 20)
        self.assertEqual(stubs, runtime)

    def test_defaults_of_fields_are_those_of_the_constructors(self):
        for struct in (gmlpnp.Params, gmlpnp.RansacParams):
            body = next(node for node in stub("__init__.pyi").body if getattr(node, "name", "") == struct.__name__).body
            constructor = next(node for node in body if isinstance(node, ast.FunctionDef))
            for argument, default in zip(constructor.args.kwonlyargs, constructor.args.kw_defaults):
                value = ast.literal_eval(default)
                if value is not Ellipsis:  # an array
                    self.assertEqual(getattr(struct(), argument.arg), value, argument.arg)

    def test_types_of_fields_are_those_of_their_values(self):
        for name in ("Params", "RansacParams", "Result"):
            body = next(node for node in stub("__init__.pyi").body if getattr(node, "name", "") == name).body
            types = {node.target.id: node.annotation for node in body if isinstance(node, ast.AnnAssign)}
            for field, annotation in types.items():
                value = getattr(getattr(gmlpnp, name)(), field)
                if isinstance(annotation, ast.Subscript):
                    self.assertIsNone(value, field)
                else:
                    expected = "_Float64" if type(value).__name__ == "ndarray" else type(value).__name__
                    self.assertEqual(annotation.id, expected, field)

    def test_docstrings_are_those_of_the_module(self):
        seen = set()
        for node, function in all_functions():
            if id(function) not in seen:  # the first of its overloads
                self.assertEqual(ast.get_docstring(node), inspect.getdoc(function), node.name)
            seen.add(id(function))
        for node in stub("__init__.pyi").body:
            if isinstance(node, ast.ClassDef):
                self.assertEqual(ast.get_docstring(node), inspect.getdoc(getattr(gmlpnp, node.name)), node.name)

    def test_each_function_has_its_types_checked(self):
        """Each of them stands where mypy compares its type with the type that users rely on."""
        used = set()
        for path in TYPED:
            with open(path, encoding="utf-8") as file:
                used.update(dotted(node) for node in ast.walk(ast.parse(file.read())))
        for module in (gmlpnp, gmlpnp.fisheye):
            for name in module.__all__:
                if callable(getattr(module, name)):
                    self.assertIn("%s.%s" % (module.__name__, name), used)
        for name in vars(gmlpnp.CameraModel):
            if not name.startswith("_"):
                self.assertTrue({"camera." + name, "gmlpnp.CameraModel." + name} & used, name)

    @unittest.skipUnless(HAS_MYPY, "mypy is not installed")
    def test_mypy_finds_them_consistent_with_the_module(self):
        # Classes of pybind11 have a metaclass of their own, and one without a constructor raises in its __init__.
        allowed = [r"gmlpnp\.(CameraModel|Params|RansacParams|Result)", r"gmlpnp\.CameraModel\.__init__"]
        with tempfile.TemporaryDirectory() as folder:
            allowlist = os.path.join(folder, "allowed")
            with open(allowlist, "w", encoding="utf-8") as file:
                file.write("\n".join(allowed))
            self.mypy(folder, "mypy.stubtest", "gmlpnp", "--allowlist", allowlist)

    @unittest.skipUnless(HAS_MYPY, "mypy is not installed")
    @unittest.skipIf(sys.version_info < (3, 11), "typing.assert_type is new in Python 3.11")
    def test_mypy_sees_the_types_that_users_rely_on(self):
        with tempfile.TemporaryDirectory() as folder:
            self.mypy(folder, "mypy", "--strict", "--cache-dir", folder, *TYPED)

    def mypy(self, folder, *arguments):
        environment = dict(os.environ, MYPYPATH=os.path.dirname(FOLDER), PYTHONPATH=os.path.dirname(FOLDER))
        done = subprocess.run(
            [sys.executable, "-m", *arguments],
            cwd=folder,
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            universal_newlines=True,
            check=False,
        )
        self.assertEqual(done.returncode, 0, done.stdout)


class Docstrings(unittest.TestCase):
    def test_fields_carry_the_text_of_the_header(self):
        members = re.findall(r"CV_PROP_RW \w+ (\w+);\s*//!< (.*)", header("gmlpnp.hpp"))
        self.assertGreater(len(members), 15)
        texts = " ".join(
            word.lower()
            for struct in (gmlpnp.Params, gmlpnp.RansacParams, gmlpnp.Result)
            for name in dir(struct)
            if not name.startswith("_")
            for word in words(getattr(struct, name).__doc__)
        )
        for name, text in members:
            start = re.split(r"[#(:;,]|\b(?:empty|Nx1|true|false)\b", text)[0]
            self.assertIn(" ".join(words(start)).lower(), texts, name)

    def test_functions_carry_the_text_of_the_header(self):
        """The first sentence, and the text of each parameter up to the first name or size of C++."""
        pattern = r"/\*\* @brief ((?:(?!\*/).)*)\*/\s*CV_EXPORTS_W \w+ (\w+)\("
        comments = re.findall(pattern, header("gmlpnp.hpp") + header("gmlpnp", "draw.hpp"), re.DOTALL)
        self.assertGreater(len(comments), 12)
        for comment, name in comments:
            functions = [getattr(module, name) for module in (gmlpnp, gmlpnp.fisheye) if hasattr(module, name)]
            if not functions:  # drawing needs opencv_imgproc
                continue
            texts = " ".join(word for function in functions for word in words(function.__doc__))
            brief = re.split(r"\(?\bcv::|\.\s", comment)[0]
            self.assertIn(" ".join(words(brief)), texts, name)
            for parameter, text in re.findall(r"@param (iterationsCount|confidence|camera|criteria) (.*)", comment):
                start = re.split(r"[.:,;]", text)[0]
                self.assertIn(" ".join(words(start)), texts, (name, parameter))

    def test_constants_carry_the_text_of_the_header(self):
        body = stub("__init__.pyi").body
        texts = {
            node.target.id: following.value.value
            for node, following in zip(body, body[1:])
            if isinstance(node, ast.AnnAssign) and isinstance(following, ast.Expr)
        }
        pattern = r"^    ((?:STATUS|NOISE)_\w+)(?: = 0)?,?\s+//!< (.*)"
        constants = re.findall(pattern, header("gmlpnp.hpp"), re.MULTILINE)
        self.assertEqual(len(constants), 11)
        for name, text in constants:
            start = " ".join(words(text.split(",")[0]))
            self.assertIn(start.lower(), " ".join(words(texts[name])).lower(), name)

    def test_fields_say_what_their_constants_mean(self):
        for field, text in (
            (gmlpnp.Result.status, "\n\nThe outcome of a call. Converged and max rounds are successes"),
            (gmlpnp.Result.status, "\nSTATUS_NO_CONSENSUS: RANSAC: no pose has more inliers"),
            (gmlpnp.Result.noiseModel, "\nNOISE_OBJECT: the object points alone are noisy."),
            (gmlpnp.Params.method, "\nSOLVEPNP_GMLPNP: Algorithm 1 of the paper"),
        ):
            self.assertIn(text, field.__doc__)

    def test_outputs_of_cpp_are_returns(self):
        returns = gmlpnp.solveRansac.__doc__.partition("Returns:\n")[2]
        self.assertRegex(returns, r"^    retval: True with a finite pose")
        self.assertIn("    result (Result): pose, noise, uncertainty, from the inliers.", returns)
        self.assertIn("    inliers: (n, 1), int32: rows of the points within the threshold", returns)
        self.assertIn("None on failure", returns)
        arguments = gmlpnp.solveRansac.__doc__.partition("Args:\n")[2].partition("\n\n")[0]
        names = re.findall(r"^    (\w+)", arguments, re.MULTILINE)
        self.assertEqual(
            names, ["objectPoints", "imagePoints", "camera", "ransac", "params", "cameraMatrix", "distCoeffs"]
        )

    def test_exceptions_and_types_are_those_of_python(self):
        self.assertRegex(gmlpnp.solve.__doc__, r"Raises:\n    gmlpnp.error: code -215 \(assertion\)")
        self.assertIn("(N, 3), (N, 1, 3) or (1, N, 3)", gmlpnp.solve.__doc__)
        self.assertIn("It is None where", gmlpnp.Result.poseCovariance.__doc__)


class Generator(unittest.TestCase):
    """What must not slip through to users stops the build."""

    @classmethod
    def setUpClass(cls):
        sys.path.insert(0, GENERATE)
        cls.docstrings = __import__("docstrings")
        cls.header = __import__("header")
        sys.path.remove(GENERATE)

    def read(self, code):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "test.hpp")
            with open(path, "w", encoding="utf-8") as file:
                file.write(code)
            return self.header.read([path])

    def test_reads_overloads_and_defaults(self):
        comment = "/** @brief Solves.\n\n    y = x\n\n@param x in,\n  once.\n@param y out.\n@return true. */\n"
        code = comment + "CV_EXPORTS_W bool f(InputArray x = g(1, 2), OutputArray y);\n"
        function = self.read(code).functions["f"][0]
        self.assertEqual(function.comment, (["Solves.", "    y = x"], [("x", "in, once."), ("y", "out.")], "true.", ""))
        expected = [("InputArray", "x", "g(1, 2)", False), ("OutputArray", "y", None, True)]
        self.assertEqual([tuple(each) for each in function.parameters], expected)
        self.assertEqual(self.docstrings.signature("f", function), "f([x]) -> retval, y")

    def test_refuses_a_parameter_without_a_text(self):
        with self.assertRaisesRegex(ValueError, "f: describes the parameters"):
            self.read("/** @brief Solves.\n@param x in. */\nCV_EXPORTS_W bool f(InputArray x, InputArray y);\n")

    def test_refuses_a_field_without_a_text(self):
        with self.assertRaisesRegex(ValueError, "S.x has no comment"):
            self.read("/** @brief S. */\nstruct CV_EXPORTS_W_SIMPLE S\n{\n    CV_PROP_RW int x;\n};\n")

    def test_refuses_words_of_cpp(self):
        for word in ("cv_::Mat", "CV_16U", "StsOutOfRange", "@ref x", "#Unknown"):
            declared = self.read("/** @brief Takes %s. */\nCV_EXPORTS_W bool f();\n" % word)
            with self.assertRaisesRegex(ValueError, "f: its docstring has a word of C"):
                self.docstrings.docstrings(declared)

    def test_refuses_a_rule_that_no_text_needs(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "test.hpp")
            with open(path, "w", encoding="utf-8") as file:
                file.write("// Nothing.")
            with self.assertRaisesRegex(ValueError, "no text of the headers matches"):
                self.docstrings.check_words([path])


if __name__ == "__main__":
    unittest.main()
