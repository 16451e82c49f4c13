"""Every relative link and picture of the documents leads to a file, and every anchor to a heading: test_links.py ROOT"""

import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)
FENCED = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
LEFT_OUT = {"build", ".git"}


def anchor(heading):
    """As GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def broken_links(document):
    for target in LINK.findall(FENCED.sub("", document.read_text(encoding="utf-8"))):
        if re.match(r"[a-z]+:", target):
            continue
        name, _, wanted = target.partition("#")
        path = document.parent / name if name else document
        if not path.exists():
            yield f"{document}: {target} is no file"
        elif wanted and wanted not in map(anchor, HEADING.findall(path.read_text(encoding="utf-8"))):
            yield f"{document}: {target} is no heading"


def main(root):
    documents = [path for path in sorted(pathlib.Path(root).rglob("*.md"))
                 if not LEFT_OUT & set(path.relative_to(root).parts)]
    broken = [link for document in documents for link in broken_links(document)]
    print("\n".join(broken) or f"{len(documents)} documents")
    return 1 if broken or not documents else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
