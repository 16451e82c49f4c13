"""Writes the tables of doc/lab/real_data.md from what scripts/real_data.sh measured.

real_data_tables.py RESULTS DOCUMENT

After a marker  <!-- results NAME -->  and up to the next one, each table of the document becomes that of the same head in
RESULTS/NAME/table.md or residuals.md, and each sentence on residuals the one there. The rest is left alone."""

import pathlib
import re
import sys

MARKER = re.compile(r"<!-- results (\w+) -->")
SENTENCES = ("Residuals under the true motion", "Test of isotropy")


def narrow(row):
    """A row of a table without the spaces and dashes that line its columns up."""
    cells = [re.sub("^(:?)-+(:?)$", lambda rule: (rule[1] or "-") + "-" + (rule[2] or "-"), cell.strip())
             for cell in row.strip().strip("|").split("|")]
    return "|" + "|".join(cells) + "|" if set("".join(cells)) <= set("-:") else "| " + " | ".join(cells) + " |"


def blocks(lines):
    """Lists of lines: tables, and single lines that are not in one."""
    table = []
    for line in lines:
        if line.startswith("|"):
            table.append(narrow(line))
            continue
        if table:
            yield table
            table = []
        yield [line]
    if table:
        yield table


def key(block):
    """What a block of the document has in common with the one that replaces it; none: nothing does."""
    if len(block) > 1 and block[0].startswith("|"):
        return block[0]
    return next((start for start in SENTENCES if block[0].startswith(start)), None)


def main(results, document):
    results, path = pathlib.Path(results), pathlib.Path(document)
    measured, written, out = {}, 0, []
    for block in blocks(path.read_text().splitlines()):
        marker = MARKER.match(block[0])
        if marker:
            files = [results / marker[1] / name for name in ("table.md", "residuals.md")]
            lines = [line for file in files if file.exists() for line in file.read_text().splitlines()]
            if not lines:
                print(f"{marker[1]}: no results, its tables stay as they are")
            measured = {key(found): found for found in blocks(lines) if key(found)}
        elif block[0].startswith("## "):
            measured = {}
        elif measured and key(block):
            if key(block) not in measured:
                sys.exit(f"{document}: nothing measured replaces '{block[0]}'")
            block = measured[key(block)]
            written += 1
        out += block
    path.write_text("\n".join(out) + "\n")
    print(f"{document}: {written} tables and sentences")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
