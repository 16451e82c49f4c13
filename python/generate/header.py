"""Reads the declarations of the public C++ headers and the doxygen comments above them.

The headers are formatted by clang-format, and only what is exported to bindings (CV_EXPORTS_W, CV_WRAP, CV_PROP_RW) and
static methods are of interest. So regular expressions suffice, and no compiler is needed.
"""

import re
from typing import Dict, Iterator, List, Match, NamedTuple, Optional, Pattern, Sequence, Tuple

_COMMENT = r"/\*\*(?P<comment>(?:(?!\*/).)*)\*/\s*"
_FUNCTION = re.compile(
    _COMMENT + r"(?:CV_EXPORTS_W |CV_WRAP |(?=static ))(?P<declaration>[^;{]*?)\s*(?:const)?;", re.DOTALL
)
_DECLARATION = re.compile(
    r"(?:static |virtual )*(?P<returns>\S+) (?P<name>\w+)\((?P<parameters>.*)\)$", re.DOTALL
)
_STRUCT = re.compile(_COMMENT + r"struct CV_EXPORTS_W_SIMPLE (?P<name>\w+)\s*\{(?P<body>.*?)^\};", re.DOTALL | re.M)
_CLASS = re.compile(_COMMENT + r"class CV_EXPORTS_W (?P<name>\w+)\s*\{(?P<body>.*?)^\};", re.DOTALL | re.M)
_ENUM = re.compile(_COMMENT + r"enum (?P<name>\w+)\s*\{(?P<body>.*?)^\};", re.DOTALL | re.M)
_NAMESPACE = re.compile(
    _COMMENT + r"namespace (?!cv\b|gmlpnp\b)(?P<name>\w+) \{(?P<body>.*?)^\}  // namespace (?P=name)$",
    re.DOTALL | re.M,
)
_FIELD = re.compile(r"\s*CV_PROP_RW (?P<type>\w+) (?P<name>\w+);\s*(?://!<(?P<text>.*))?$")
_ENUMERATOR = re.compile(r"\s*(?P<name>\w+)(?: = \d+)?,?\s*(?://!<(?P<text>.*))?$")
_TAG = re.compile(r"@(brief|param|return|throws|overload)\b\s*")


class Parameter(NamedTuple):
    """A parameter of a C++ function."""

    type: str  # without const and &: "InputArray", "Ptr<CameraModel>", "std::vector<Result>"
    name: str
    default: Optional[str]
    returned: bool  # CV_OUT or an output array

    @property
    def array(self) -> bool:
        return self.type.endswith(("Array", "ArrayOfArrays"))


class Comment(NamedTuple):
    """A doxygen comment, without its tags."""

    text: List[str]  # paragraphs; those that start with a blank keep their lines
    parameters: List[Tuple[str, str]]  # names, with commas between several, and text
    returns: str
    throws: str


class Function(NamedTuple):
    """One overload of a function or a method."""

    name: str
    returns: str
    parameters: List[Parameter]
    comment: Comment


class Header(NamedTuple):
    """What the headers declare. Members of classes and namespaces are named "CameraModel.load", "fisheye.solvePnP"."""

    functions: Dict[str, List[Function]]
    texts: Dict[str, Comment]  # of structs, classes, enums, namespaces
    fields: Dict[str, Dict[str, Tuple[str, str]]]  # struct: field: type and text
    enums: Dict[str, Dict[str, str]]  # enum: constant: text


def read(paths: Sequence[str]) -> Header:
    """Reads all headers. Raises ValueError where a parameter has no text or a text has no parameter."""
    header = Header({}, {}, {}, {})
    for path in paths:
        with open(path, encoding="utf-8") as file:
            _read_scope(header, file.read(), "")
    _check(header)
    return header


def _read_scope(header: Header, code: str, scope: str) -> None:
    for inner in (_CLASS, _NAMESPACE):
        for match in inner.finditer(code):
            name = scope + match["name"]
            header.texts[name] = _comment(match["comment"])
            _read_scope(header, match["body"], name + ".")
        code = inner.sub("", code)
    for match in _STRUCT.finditer(code):
        header.texts[scope + match["name"]] = _comment(match["comment"])
        header.fields[scope + match["name"]] = {
            field["name"]: (field["type"], text) for field, text in _members(match["body"], _FIELD)
        }
    for match in _ENUM.finditer(code):
        header.texts[scope + match["name"]] = _comment(match["comment"])
        header.enums[scope + match["name"]] = {
            constant["name"]: text for constant, text in _members(match["body"], _ENUMERATOR)
        }
    for match in _FUNCTION.finditer(code):
        function = _function(match["declaration"], _comment(match["comment"]))
        header.functions.setdefault(scope + function.name, []).append(function)


def _members(body: str, pattern: Pattern[str]) -> Iterator[Tuple[Match[str], str]]:
    """Each line that matches, with its text: on the lines above it (//!) or behind it (//!<)."""
    text: List[str] = []
    for line in body.splitlines():
        if line.lstrip().startswith("//! "):
            text.append(line.strip()[len("//! ") :])
            continue
        member = pattern.match(line)
        if member:
            if member["text"]:
                text.append(member["text"].strip())
            yield member, " ".join(text)
        text = []


def _function(declaration: str, comment: Comment) -> Function:
    match = _DECLARATION.match(declaration)
    if match is None:
        raise ValueError("unexpected declaration: " + declaration)
    parameters = [_parameter(part) for part in _split(match["parameters"])]
    return Function(match["name"], match["returns"], parameters, comment)


def _parameter(text: str) -> Parameter:
    left, _, default = text.partition(" = ")
    type_, _, name = left.rpartition(" ")
    bare = type_.replace("CV_OUT ", "").replace("const ", "").rstrip("&")
    returned = "CV_OUT " in type_ or "Output" in bare
    return Parameter(bare, name, re.sub(r"\s+", " ", default) or None, returned)


def _split(parameters: str) -> List[str]:
    """At the commas outside all brackets."""
    parts, depth, start = [], 0, 0
    for i, character in enumerate(parameters):
        if character in "(<":
            depth += 1
        elif character in ")>":
            depth -= 1
        elif character == "," and depth == 0:
            parts.append(parameters[start:i])
            start = i + 1
    parts.append(parameters[start:])
    return [re.sub(r"\s+", " ", part).strip() for part in parts if part.strip()]


def _comment(raw: str) -> Comment:
    comment = Comment([], [], "", "")
    lines = raw.strip().splitlines()
    margin = min((len(line) - len(line.lstrip()) for line in lines[1:] if line.strip()), default=0)
    lines = [lines[0]] + [line[margin:].rstrip() for line in lines[1:]]
    tag = "brief"
    paragraph: List[str] = []

    def finish() -> None:
        nonlocal comment
        text = " ".join(line.strip() for line in paragraph)
        if tag == "param":
            names, text = re.match(r"((?:\w+, )*\w+) (.*)", text).groups()  # type: ignore[union-attr]
            comment.parameters.append((names, text))
        elif tag == "return":
            comment = comment._replace(returns=text)
        elif tag == "throws":
            comment = comment._replace(throws=text)
        elif paragraph:
            verbatim = paragraph[0].startswith((" ", "- "))
            comment.text.append("\n".join(paragraph) if verbatim else text)
        paragraph.clear()

    for line in lines:
        match = _TAG.match(line)
        if match:
            if paragraph:
                finish()
            tag, line = match[1], line[match.end() :]
        elif not line:
            if paragraph:
                finish()
            tag = "text"
            continue
        elif paragraph and line.startswith(" ") and not paragraph[0].startswith((" ", "- ")) and tag == "text":
            finish()
        if line:
            paragraph.append(line)
    if paragraph:
        finish()
    return comment


def _check(header: Header) -> None:
    for name, overloads in header.functions.items():
        for function in overloads:
            described = [each for names, _ in function.comment.parameters for each in names.split(", ")]
            declared = [parameter.name for parameter in function.parameters]
            if described != declared:
                raise ValueError("%s: describes the parameters %s, has %s" % (name, described, declared))
    for struct, fields in header.fields.items():
        for field, (_, text) in fields.items():
            if not text:
                raise ValueError("%s.%s has no comment" % (struct, field))
    for constants in header.enums.values():
        for constant, text in constants.items():
            if not text:
                raise ValueError(constant + " has no comment")
