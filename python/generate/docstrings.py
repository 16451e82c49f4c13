"""Writes the docstrings of the Python module from the comments of the public C++ headers.

Usage: docstrings.py --output FILE HEADER...

FILE is C++ code that src/docstrings.cpp includes: pairs of a name ("solve", "Result.rvec", "fisheye.solvePnP") and its
docstring. A docstring is the header's text in the words of Python; the tables below hold what Python calls by another
name, and the little that is true of Python alone.
"""

import argparse
import re
import textwrap
from typing import Dict, List, Sequence, Set, Tuple

import header

WIDTH = 100

Enums = Dict[str, Dict[str, str]]  # enum: constant: text

# Names and sizes of C++ and their names in Python, applied in this order. `check_words` refuses a rule without a use.
WORDS = (
    (r"Nx(\d), Nx1 or 1xN with \d channels, (?:or )?(?:a )?vector of \w+; float or double",
     r"(N, \1), (N, 1, \1) or (1, N, \1); any real type, lists and tuples too"),
    (r"vector of Mat \(3x1, CV_64F\), Vec3d, Vec3f, Point3d\.\.\.", "tuple of (3, 1) arrays"),
    (r"CV_64F, or the depth of the array that was passed", "float64, or the array that was passed"),
    (r"\bCV_64F\b", "float64"),
    (r"\bCV_32S\b", "int32"),
    (r"\bCV_8U\b", "uint8"),
    (r"\bNx(\d)\b", r"(N, \1)"),
    (r"\bn x 1\b", "(n, 1)"),
    (r"\(3x1\)|\b3x1\b", "(3, 1)"),
    (r"any numeric depth", "any real type"),
    (r"wrong shape or depth", "wrong shape or type"),
    (r"\b0, 4, 5, 8, 12 or 14\b", "None or 4, 5, 8, 12 or 14"),
    (r"\bor none\.", "or None."),
    (r"\bthrow(s?)\b", r"raise\1"),
    (r" \(cv::parallel_for_\)", ""),
    (r"\bwrite\(\) wrote", "save() wrote"),
    (r"\bK\(0, 1\)", "K[0, 1]"),
    (r"StsAssert(?: \(-215\))?", "code -215 (assertion)"),
    (r"StsBadArg(?: \(-5\))?", "code -5 (bad argument)"),
    (r"StsParseError", "code -212 (parse error)"),
    (r"StsObjectNotFound", "code -204 (not found)"),
    (r"Calls read\(\) on a file in YAML, XML or JSON: on its entry `camera`, or else on its top level",
     "The file is YAML, XML or JSON, and the camera its entry `camera`, or else its top level"),
    (r"cv::Exception", "gmlpnp.error"),
    (r"cv::gmlpnp::(\w+)", r"gmlpnp.\1"),
    (r"cv::(\w+)::(\w+)", r"cv2.\1.\2"),
    (r"cv::(\w+)", r"cv2.\1"),
    (r"\b(Result|CameraModel)::(\w+)", r"\1.\2"),
    (r"fisheye::solvePnP\b", "gmlpnp.fisheye.solvePnP"),
    (r" @cite zhan2024gmlpnp", " Zhan et al. 2024"),
    (r"#([A-Z]+_\w+)", r"\1"),
    (r"\btrue\b", "True"),
    (r"\bfalse\b", "False"),
    (r"\binfinity\b", "inf"),
    (r"`results` is then untouched", "`results` is then empty"),
    (r"and all outputs are then untouched", "and there are then no vectors and no errors"),
    (r"rvec, tvec and inliers are then untouched",
     "rvec and tvec are then what was passed (None by default), and inliers is None"),
    (r"rvec and tvec are then untouched", "rvec and tvec are then what was passed (None by default)"),
    (r"untouched on failure", "None on failure"),
    (r"^output (?=rotation|translation)", ""),
)

# In the text of a matrix: Python has None in the place of an empty cv::Mat.
MATRIX_WORDS = ((r"\bempty\b", "None"),)

# None of this may be left.
CPP = re.compile(r"::|@\w|#\w|\bCV_|\bSts[A-Z]|\b(?:true|false|noArray|throws?)\b")

# Paragraphs that mean nothing to Python, by their start.
OMITTED = ("For a lens of your own, derive",)

# What is true of Python alone.
NOTES = {
    "Params": "Every option is an attribute and a keyword of the constructor, as in gmlpnp.Params(maxRounds=10). "
    "Arrays are copied, both ways: to change one, assign the whole array.",
    "RansacParams": "Every option is an attribute and a keyword of the constructor.",
    "Result": "X = R p + t, with the rotation R of rvec. Vectors are (3, 1) float64 arrays like the rvec of cv2, and "
    "matrices are float64 arrays; each access gives a copy. Where a solve returned False, only status means anything.",
    "CameraModel": "The static methods make one.",
    "drawPoseUncertainty": "The picture is a C-contiguous array of uint8 and shape (height, width) or (height, width, "
    "channels).",
    "CameraModel.unproject": "rays[valid.ravel() > 0] are the rays.",
}

# Functions that are not bound, and the bound ones that refer to them ("as in read()") and borrow their text.
BORROWED = {"CameraModel.read": "CameraModel.load"}

# Parameters of Python that C++ has for its outputs, and outputs that are parameters too.
PASSED = {
    "rvec": "start of useExtrinsicGuess. A float array of shape (3, 1) or (3,) is filled and returned itself.",
    "tvec": "likewise.",
    "rvecs": "an output only; the argument is ignored.",
    "tvecs": "an output only; the argument is ignored.",
    "reprojectionError": "an output only; the argument is ignored.",
    "inliers": "an output only; the argument is ignored.",
}
RETURNED = {
    "image": "the picture that was passed.",
    "cameraMatrix": "the matrix that was passed.",
    "rvec": "the array that was passed where it is a float array of shape (3, 1) or (3,), else a new (3, 1) array.",
    "tvec": "likewise.",
}

# How Python calls the types that the text of the header leaves to the C++ signature.
TYPES = {
    "Ptr<CameraModel>": "CameraModel",
    "Result": "Result",
    "Params": "Params or None",
    "RansacParams": "RansacParams or None",
    "Size": "tuple (width, height)",
    "TermCriteria": "tuple (type, maxCount, epsilon) or None",
    "UsacParams": "cv2.UsacParams, any object with its attributes, or None",
    "std::vector<Result>": "tuple of Result",
}


def in_python(text: str, enums: Enums) -> str:
    """The text with the names of Python."""
    for enum, constants in enums.items():
        names = list(constants)
        listed = " and ".join(names) if len(names) == 2 else names[0].split("_")[0] + "_..."
        text = re.sub("#%s\\b" % enum, listed, text)
    for pattern, replacement in WORDS:
        text = re.sub(pattern, replacement, text)
    return text


def check_words(paths: Sequence[str]) -> None:
    """Raises ValueError for a rule that changes nothing: the header says it in another way now, and Python's text would
    keep the words of C++."""
    code = ""
    for path in paths:
        with open(path, encoding="utf-8") as file:
            code += re.sub(r"\n\s*(?://! )?", " ", file.read())
    code = code.replace("output rotation", "\noutput rotation")
    for pattern, _ in WORDS + MATRIX_WORDS:
        if not re.search(pattern, code, re.MULTILINE):
            raise ValueError("no text of the headers matches: " + pattern)


def arguments(name: str, function: header.Function) -> Tuple[List[header.Parameter], List[header.Parameter]]:
    """The parameters of Python, required and optional. Functions of cv2 take their outputs as optional arguments, in
    cv2 and here; other functions return them only."""
    as_cv2 = name.split(".")[-1].startswith("solvePnP")
    required: List[header.Parameter] = []
    optional: List[header.Parameter] = []
    for parameter in function.parameters:
        if parameter.returned and not parameter.type.startswith("InputOutput"):
            if as_cv2:
                optional.append(parameter)
        elif parameter.default is None:
            required.append(parameter)
        else:
            optional.append(parameter)
    return required, optional


def returns(function: header.Function) -> List[str]:
    """The names of what Python returns."""
    names = ["retval"] if function.returns != "void" else []
    return names + [parameter.name for parameter in function.parameters if parameter.returned]


def signature(name: str, function: header.Function) -> str:
    """In the form of cv2: "solveRays(objectPoints, rays[, params]) -> retval, result"."""
    required, optional = arguments(name, function)
    text = ", ".join(parameter.name for parameter in required)
    text += "".join("[, " + parameter.name for parameter in optional) + "]" * len(optional)
    text = re.sub(r"^\[, ", "[", text)
    return "%s(%s) -> %s" % (function.name, text, ", ".join(returns(function)))


def _fill(text: str, indent: str = "", hanging: str = "") -> str:
    return textwrap.fill(
        text,
        WIDTH,
        initial_indent=indent,
        subsequent_indent=indent + hanging,
        break_on_hyphens=False,
        break_long_words=False,
    )


def _entry(name: str, text: str) -> str:
    """An item of the sections Args and Returns."""
    return _fill("%s: %s" % (name, _stopped(text)), " " * 4, " " * 4)


def paragraphs(name: str, comment: header.Comment, enums: Enums) -> List[str]:
    """The text above the parameters, and what is true of Python alone."""
    text = []
    for paragraph in comment.text:
        if paragraph.startswith(OMITTED):
            continue
        words = in_python(paragraph, enums)
        text.append(words if paragraph.startswith((" ", "- ")) else _fill(words))
    if name in NOTES:
        text.append(_fill(NOTES[name]))
    return text


def _annotation(parameter: header.Parameter) -> str:
    notes = [TYPES[parameter.type]] if parameter.type in TYPES else []
    default = parameter.default
    if default is not None and not default.endswith(")"):
        value = default.replace("cv::gmlpnp::", "")
        notes.append("default " + {"true": "True", "false": "False"}.get(value, value))
    return " (%s)" % ", ".join(notes) if notes else ""


def _arguments_text(name: str, overloads: List[header.Function], enums: Enums) -> List[str]:
    lines: List[str] = []
    seen: Set[str] = set()
    for function in overloads:
        required, optional = arguments(name, function)
        taken = {parameter.name: parameter for parameter in required + optional}
        for names, text in function.comment.parameters:
            new = [each for each in names.split(", ") if each in taken and each not in seen]
            seen.update(new)
            if not new:
                continue
            parameter = taken[new[0]]
            if parameter.returned and parameter.type.startswith("Output"):
                text = PASSED[parameter.name]
            annotation = _annotation(parameter) if len(new) == 1 else ""
            lines.append(_entry(", ".join(new) + annotation, in_python(text, enums)))
    return lines


def _returns_text(overloads: List[header.Function], enums: Enums) -> List[str]:
    lines: List[str] = []
    seen: Set[str] = set()
    for function in overloads:
        texts = {each: text for names, text in function.comment.parameters for each in names.split(", ")}
        texts["retval"] = function.comment.returns or "the camera."
        for name in returns(function):
            if name in seen:
                continue
            seen.add(name)
            kind = next((parameter.type for parameter in function.parameters if parameter.name == name), "")
            text = RETURNED[name] if kind.startswith("InputOutput") else texts[name]
            note = " (%s)" % TYPES[kind] if kind in TYPES else ""
            lines.append(_entry(name + note, in_python(text, enums)))
    return lines


def function_docstring(name: str, overloads: List[header.Function], enums: Enums) -> str:
    """Signatures, text, and the sections Args, Returns and Raises."""
    parts = ["\n".join(signature(name, function) for function in overloads)]
    parts += paragraphs(name, overloads[0].comment, enums)
    for title, lines in (
        ("Args:", _arguments_text(name, overloads, enums)),
        ("Returns:", _returns_text(overloads, enums)),
    ):
        if lines:
            parts.append("\n".join([title] + lines))
    throws = overloads[0].comment.throws
    if throws:
        text = re.sub(r"^(gmlpnp\.error) ", r"\1: ", in_python(throws, enums))
        parts.append("Raises:\n" + _fill(text, " " * 4, " " * 4))
    return "\n\n".join(parts)


def _borrow(lender: header.Function, borrower: header.Function) -> header.Function:
    """The borrower with the lender's text in the place of "as in read()"."""
    reference = "as in %s()" % lender.name
    texts = dict(lender.comment.parameters)
    comment = borrower.comment
    throws = re.sub("^cv::Exception ", "", lender.comment.throws).rstrip(".")
    return borrower._replace(
        comment=comment._replace(
            text=lender.comment.text + comment.text,
            parameters=[(name, texts[name] if text == reference + "." else text) for name, text in comment.parameters],
            throws=comment.throws.replace(reference, throws),
        )
    )


def _meanings(text: str, declared: header.Header) -> List[str]:
    """What the constants mean where a field is one of them: integers of Python have no docstring."""
    found = re.match("one of #(\\w+)", text, re.IGNORECASE)
    if found is None:
        return []
    enum = found[1]
    constants = [
        _fill("%s: %s" % (name, _stopped(in_python(meaning, declared.enums))), "", " " * 4)
        for name, meaning in declared.enums[enum].items()
    ]
    return paragraphs(enum, declared.texts[enum], declared.enums) + ["\n".join(constants)]


def docstrings(declared: header.Header) -> Dict[str, str]:
    """A docstring for each name: functions, methods, structs, classes, fields, constants and namespaces."""
    texts = {}
    for name, overloads in declared.functions.items():
        if name in BORROWED:
            continue
        for lender, borrower in BORROWED.items():
            if name == borrower:
                overloads = [_borrow(declared.functions[lender][0], function) for function in overloads]
        texts[name] = function_docstring(name, overloads, declared.enums)
    for name, comment in declared.texts.items():
        if name in declared.enums:
            continue
        parts = paragraphs(name, comment, declared.enums)
        if name in declared.fields and declared.fields[name] and "keyword" in NOTES.get(name, ""):
            parts.insert(0, name + "([name=value, ...])")
        texts[name] = "\n\n".join(parts)
    for struct, fields in declared.fields.items():
        for field, (type_, text) in fields.items():
            words = in_python(text, declared.enums)
            for pattern, replacement in MATRIX_WORDS if type_ == "Mat" else ():
                words = re.sub(pattern, replacement, words)
            texts["%s.%s" % (struct, field)] = "\n\n".join([_fill(_sentence(words))] + _meanings(text, declared))
    for constants in declared.enums.values():
        for constant, text in constants.items():
            texts[constant] = _fill(_sentence(in_python(text, declared.enums)))
    for name, text in texts.items():
        left = CPP.search(text)
        if left:
            raise ValueError("%s: its docstring has a word of C++, %r" % (name, left[0]))
    return texts


def _sentence(text: str) -> str:
    """Comments behind a member start small and end without a full stop."""
    start = text if re.match(r"\w*[A-Z(]|-R", text) else text[0].upper() + text[1:]
    return _stopped(start)


def _stopped(text: str) -> str:
    return text if text.endswith(".") else text + "."


def cpp(texts: Dict[str, str]) -> str:
    """The pairs as C++ initializers."""
    lines = ["// Generated by python/generate/docstrings.py from the public headers; edit those."]
    for name, text in texts.items():
        if ')doc"' in text:
            raise ValueError(name + ": the text ends a raw string")
        lines.append('{"%s", R"doc(%s)doc"},' % (name, text))
    return "\n".join(lines) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", required=True, help="the C++ code to write")
    parser.add_argument("headers", nargs="+")
    options = parser.parse_args()
    check_words(options.headers)
    with open(options.output, "w", encoding="utf-8") as file:
        file.write(cpp(docstrings(header.read(options.headers))))


if __name__ == "__main__":
    main()
