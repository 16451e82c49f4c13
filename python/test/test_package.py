"""The C++ header, the module, its stubs and its docstrings name the same things."""

import ast
import os
import re
import unittest

import gmlpnp
import gmlpnp.fisheye

FOLDER = os.path.dirname(gmlpnp.__file__)
ROOT = os.environ.get("GMLPNP_ROOT", os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))


def public(names):
    return {name for name in names if not name.startswith("_")}


class Stub:
    """What a .pyi declares: names, members of classes, parameters of functions."""

    def __init__(self, name):
        with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
            body = ast.parse(file.read()).body
        self.variables = {node.target.id for node in body if isinstance(node, ast.AnnAssign)}
        self.classes = {node.name: node for node in body if isinstance(node, ast.ClassDef)}
        self.functions = self.functions_of(body)
        self.modules = {alias.asname for node in body if isinstance(node, ast.ImportFrom) for alias in node.names}

    @staticmethod
    def functions_of(body):
        """Per name the parameters of each overload, an optional one as (name, True)."""
        functions = {}
        for node in body:
            if isinstance(node, ast.FunctionDef):
                arguments = [argument.arg for argument in node.args.args if argument.arg != "self"]
                required = len(arguments) - len(node.args.defaults)
                functions.setdefault(node.name, []).append(
                    [(argument, i >= required) for i, argument in enumerate(arguments)]
                )
        return functions

    def names(self):
        return public(self.variables | set(self.classes) | set(self.functions) | (self.modules - {None, "np"}))

    def members(self, name):
        fields = {node.target.id for node in self.classes[name].body if isinstance(node, ast.AnnAssign)}
        return public(fields | set(self.functions_of(self.classes[name].body)))


def documented(function, name):
    """The parameters in the signatures of a docstring: "f(a, b[, c[, d]]) -> retval"."""
    signatures = re.findall(rf"^{name}\((.*)\) -> ", function.__doc__, re.MULTILINE)
    return [list(parameters_of(signature)) for signature in signatures]


def parameters_of(signature):
    required, _, optional = signature.partition("[")
    for part, is_optional in ((required, False), (optional, True)):
        for word in re.findall(r"\w+", part):
            yield word, is_optional


class Package(unittest.TestCase):
    def setUp(self):
        self.stub = Stub("__init__.pyi")

    def test_stub_names_what_the_module_has(self):
        self.assertEqual(self.stub.names(), set(gmlpnp.__all__))
        self.assertEqual(Stub("fisheye.pyi").names(), set(gmlpnp.fisheye.__all__))
        self.assertEqual(public(dir(gmlpnp)), set(gmlpnp.__all__))

    def test_stub_names_what_the_classes_have(self):
        for name in self.stub.classes:
            members = public(dir(getattr(gmlpnp, name)))
            if name == "error":
                members -= public(dir(RuntimeError))
            self.assertEqual(self.stub.members(name), members, name)

    def test_params_are_keywords_of_the_constructor(self):
        for struct in (gmlpnp.Params, gmlpnp.RansacParams):
            body = self.stub.classes[struct.__name__].body
            constructor = next(node for node in body if isinstance(node, ast.FunctionDef))
            keywords = {argument.arg for argument in constructor.args.kwonlyargs}
            self.assertEqual(keywords, public(dir(struct)))

    def test_stub_and_docstrings_have_the_same_parameters(self):
        modules = ((gmlpnp, self.stub), (gmlpnp.fisheye, Stub("fisheye.pyi")))
        for module, stub in modules:
            for name, overloads in stub.functions.items():
                self.assertEqual(documented(getattr(module, name), name), overloads, name)
        for name, overloads in Stub.functions_of(self.stub.classes["CameraModel"].body).items():
            self.assertEqual(documented(getattr(gmlpnp.CameraModel, name), name), overloads, name)

    def test_documented_keywords_are_accepted(self):
        """A keyword that does not exist is a TypeError; None is not, but the library refuses it."""
        for module, stub in ((gmlpnp, self.stub), (gmlpnp.fisheye, Stub("fisheye.pyi"))):
            for name, overloads in stub.functions.items():
                for parameters in overloads:
                    scalars = {"useExtrinsicGuess": False, "flags": gmlpnp.SOLVEPNP_GMLPNP, "VVSlambda": 1.0}
                    scalars.update(iterationsCount=100, reprojectionError=8.0, confidence=0.99)
                    scalars.update(result=gmlpnp.Result(), length=1.0, thickness=1)
                    values = {parameter: scalars.get(parameter) for parameter, _ in parameters}
                    with self.assertRaises(gmlpnp.error, msg=name):
                        getattr(module, name)(**values)

    def test_everything_has_a_docstring(self):
        for name in gmlpnp.__all__:
            if not isinstance(getattr(gmlpnp, name), int):
                self.assertTrue(getattr(gmlpnp, name).__doc__, name)
        for struct in (gmlpnp.Params, gmlpnp.RansacParams, gmlpnp.Result, gmlpnp.CameraModel):
            for name in public(dir(struct)):
                self.assertTrue(getattr(struct, name).__doc__, name)

    def test_public_names_say_gmlpnp(self):
        for name in ("error", "Params", "Result", "CameraModel", "solve", "solvePnP"):
            self.assertEqual(getattr(gmlpnp, name).__module__, "gmlpnp", name)

    def test_everything_in_the_header_is_bound(self):
        headers = os.path.join(ROOT, "modules", "gmlpnp", "include", "opencv2")
        with open(os.path.join(headers, "gmlpnp.hpp"), encoding="utf-8") as file:
            text, _, fisheye = file.read().partition("namespace fisheye {")
        with open(os.path.join(headers, "gmlpnp", "camera.hpp"), encoding="utf-8") as file:
            camera = file.read()
        function, wrapped = r"CV_EXPORTS_W (?:bool|int|void) (\w+)\(", r"CV_WRAP (?:virtual|static) .*?(\w+)\("
        self.assertLessEqual(set(re.findall(function, text)), set(gmlpnp.__all__))
        self.assertLessEqual(set(re.findall(function, fisheye)), set(gmlpnp.fisheye.__all__))
        self.assertLessEqual(set(re.findall(wrapped, camera)), public(dir(gmlpnp.CameraModel)))
        constants = set(re.findall(r"^    ((?:SOLVEPNP|STATUS|NOISE)_\w+)", text, re.MULTILINE))
        self.assertTrue({"SOLVEPNP_GMLPNP", "STATUS_DEGENERATE", "NOISE_BOTH"} <= constants)
        self.assertLessEqual(constants, set(gmlpnp.__all__))
        for struct in (gmlpnp.Params, gmlpnp.RansacParams, gmlpnp.Result):
            body = re.search(rf"^struct \w+ {struct.__name__}$(.*?)^}};", text, re.MULTILINE | re.DOTALL).group(1)
            self.assertEqual(set(re.findall(r"CV_PROP_RW \w+ (\w+);", body)), public(dir(struct)))

    def test_version_and_typing_marker(self):
        self.assertRegex(gmlpnp.__version__, r"^\d+\.\d+\.\d+$")
        self.assertTrue(os.path.exists(os.path.join(FOLDER, "py.typed")))


if __name__ == "__main__":
    unittest.main()
