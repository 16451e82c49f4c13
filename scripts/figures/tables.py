"""Writes the tables of doc/lab/experiments.md and doc/lab/noise.md between their markers: tables.py RESULTS DOCUMENT

A table stands between  <!-- table NAME -->  and  <!-- end of table -->;  the rest of the document is left alone."""

import math
import pathlib
import re
import sys

from results import Results, distinct

ROTATION, TRANSLATION, CENTRE = "rotation_deg", "translation_percent", "centre_m"


def number(value, digits=3):
    """Significant digits without an exponent where that is readable."""
    if math.isnan(value):
        return "–"
    if value == 0:
        return "0"
    exponent = math.floor(math.log10(abs(value)))
    if exponent < -4 or exponent > 5:
        return f"{value:.{digits - 1}e}"
    return f"{value:.{max(0, digits - 1 - exponent)}f}"


def with_interval(row, key):
    half = (row[key + "_high"] - row[key + "_low"]) / 2
    return f"{number(row[key])} ± {number(half, 2)}"


def ratio(row, key):
    low, high = row[key + "_ratio_low"], row[key + "_ratio_high"]
    return f"{row[key + '_ratio']:.3f} ({low:.3f}–{high:.3f})"


def table(head, lines):
    yield "| " + " | ".join(head) + " |"
    yield "|---" + "|--:" * (len(head) - 1) + "|"
    for line in lines:
        yield "| " + " | ".join(line) + " |"


def errors(results, name, cells, metrics):
    """Means with their intervals, then ratios, of the solvers in chosen cells."""
    rows = [row for row in results.rows(name) if cells is None or row["x"] in cells]
    chosen, solvers = distinct(rows, "cell"), distinct(rows, "solver")
    at = {(row["solver"], row["cell"]): row for row in rows}
    yield from table(["mean"] + chosen,
                     [[s] + [" \\| ".join(with_interval(at[s, c], m) for m in metrics) for c in chosen]
                      for s in solvers])
    yield ""
    yield from table([f"ratio to {rows[0]['ratio_to']}"] + chosen,
                     [[s] + [" \\| ".join(ratio(at[s, c], m) for m in metrics) for c in chosen] for s in solvers])
    unsolved = [f"{row['solver']} in {row['cell']}: {row['trials'] - row['solved']:.0f} of {row['trials']:.0f}"
                for row in rows if row["solved"] < row["trials"]]
    if unsolved:
        yield ""
        yield "Without a pose, and left out of the means: " + "; ".join(unsolved) + "."


def medians(results, name, cells, metrics):
    rows = [row for row in results.rows(name) if row["x"] in cells]
    chosen, solvers = distinct(rows, "cell"), distinct(rows, "solver")
    at = {(row["solver"], row["cell"]): row for row in rows}
    yield from table(["median"] + chosen,
                     [[s] + [" \\| ".join(number(at[s, c][m + "_median"]) for m in metrics) for c in chosen]
                      for s in solvers])


def points(results):
    yield from errors(results, "points", (20, 60, 100, 200), (ROTATION, TRANSLATION))
    yield ""
    yield from medians(results, "points", (20, 60, 100, 200), (ROTATION, TRANSLATION))


def noise(results):
    yield from errors(results, "noise", (0.02, 0.1, 0.3, 0.5), (ROTATION, TRANSLATION))
    yield ""
    yield from medians(results, "noise", (0.02, 0.1, 0.3, 0.5), (ROTATION, TRANSLATION))


def time(results):
    rows = results.rows("time")
    sizes = [20, 50, 100, 200, 500, 1000]
    sizes = [n for n in sizes if any(row["x"] == n for row in rows)]
    at = {(row["solver"], row["x"]): row["us_median"] for row in rows}
    yield from table(["µs, median"] + [f"n = {n}" for n in sizes],
                     [[s] + [number(at[s, n], 2 if at[s, n] < 100 else 3) for n in sizes]
                      for s in distinct(rows, "solver")])


def guess(results):
    rows = results.rows("guess")
    at = {(row["sigma_m"], row["solver"], row["offset_deg"]): row for row in rows}
    offsets = distinct(rows, "offset_deg")
    yield from table(["success [%]"] + [f"{o:g}°" for o in offsets],
                     [[f"{solver}, σ = {sigma:g} m"] + [f"{100 * at[sigma, solver, o]['success']:.1f}" for o in offsets]
                      for sigma in distinct(rows, "sigma_m") for solver in distinct(rows, "solver")])


def rounds(results):
    rows = results.rows("rounds")
    at = {(row["estimator"], row["round"]): row for row in rows}
    chosen = (1, 2, 3, 5, 8, 12)
    lines = []
    for estimator in distinct(rows, "estimator"):
        for key, label, show in (("determinant_median", "median of \\|Σ̂\\| [m⁶]", lambda r: number(r["determinant_median"])),
                                 ("frobenius", "‖Σ̂ − Σ‖ [m²]", lambda r: with_interval(r, "frobenius")),
                                 (ROTATION, "rotation [°]", lambda r: with_interval(r, ROTATION)),
                                 (TRANSLATION, "translation [%]", lambda r: with_interval(r, TRANSLATION))):
            lines.append([f"{estimator}: {label}"] + [show(at[estimator, k]) for k in chosen])
    yield from table(["round"] + [str(k) for k in chosen], lines)
    yield ""
    yield f"Mean of the true \\|Σ\\|: {number(rows[0]['true_determinant'])} m⁶."


def covariance(results):
    rows = results.rows("covariance")
    sizes = distinct(rows, "x")
    at = {(row["sigma_m"], row["estimator"], row["x"]): row for row in rows}
    yield from table(["‖Σ̂ − Σ‖ / ‖Σ‖"] + [f"n = {n:g}" for n in sizes],
                     [[f"{e}, σ = {s:g} m"] + [with_interval(at[s, e, n], "relative_frobenius") for n in sizes]
                      for s in distinct(rows, "sigma_m") for e in distinct(rows, "estimator")])


def consistency(results):
    yield from errors(results, "consistency", (100, 1000, 10000), (ROTATION, TRANSLATION))
    yield ""
    rows = results.rows("consistency")
    lines = []
    for solver in distinct(rows, "solver"):
        mine = {row["x"]: row for row in rows if row["solver"] == solver}
        lines.append([solver] + [f"{math.log(mine[10000][m] / mine[1000][m]) / math.log(10):.2f}"
                                 for m in (ROTATION, TRANSLATION)])
    yield from table(["slope from n = 1000 to 10 000", "rotation", "translation"], lines)


def depth(results):
    yield from errors(results, "depth", None, (ROTATION, CENTRE))


def pixels(results):
    yield from errors(results, "pixels", None, (ROTATION, CENTRE))


def omnidir(results):
    yield from errors(results, "omnidir", None, (ROTATION, CENTRE))


def outliers(results):
    rows = results.rows("outliers")
    shares = distinct(rows, "x")
    at = {(row["cell"], row["solver"], row["x"]): row for row in rows}
    for cell in distinct(rows, "cell"):
        yield from table([f"{cell}: mean rotation [°]"] + [f"{100 * x:g} %" for x in shares],
                         [[s] + [with_interval(at[cell, s, x], ROTATION) for x in shares]
                          for s in distinct(rows, "solver")])
        yield ""


def coverage(results):
    rows = results.rows("coverage")
    sizes = distinct(rows, "x")
    at = {(row["solver"], row["noise"], row["half_field_deg"], row["x"]): row for row in rows}
    for solver in distinct(rows, "solver"):
        yield from table([solver] + [f"n = {n:g}" for n in sizes],
                         [[f"{kind}, ±{field:g}°"] + [f"{at[solver, kind, field, n]['coverage']:.3f}" for n in sizes]
                          for kind in distinct(rows, "noise") for field in distinct(rows, "half_field_deg")])
        yield ""


ENTRIES = ("xx", "xy", "xz", "yy", "yz", "zz")
SYMBOLS = {"object": "Σ", "bearing": "Γ"}


def signed(row, key, digits=3):
    half = (row[key + "_high"] - row[key + "_low"]) / 2
    return f"{row[key]:+.{digits}f} ± {half:.{digits}f}"


def recovery(results):
    rows = results.rows("recovery")
    at = {(r["view"], r["x"], r["problems"], r["noise"], r["entry"]): r for r in rows}
    for view in distinct(rows, "view"):
        keys = [(n, problems, noise) for n in distinct(rows, "x") for problems in distinct(rows, "problems")
                for noise in distinct(rows, "noise") if at[view, n, problems, noise, "xx"]["trials"] > 1]

        def name(n, problems, noise):
            return f"n = {n:g}, {problems} ({at[view, n, problems, noise, 'xx']['trials']:.0f}): {SYMBOLS[noise]}"

        for label, show in (("mean error", lambda r: signed(r, "error")),
                            ("standard error (median) \\| mean squared score",
                             lambda r: f"{number(r['standard_error_median'])} \\| {number(r['squared_score'])}")):
            yield from table([f"{view}: {label}"] + list(ENTRIES),
                             [[name(*key)] + [show(at[(view,) + key + (entry,)]) for entry in ENTRIES]
                              for key in keys])
            yield ""


def recovery_sums(results):
    rows = results.rows("recovery_sums")
    at = {(r["view"], r["x"]): r for r in rows}
    sizes = distinct(rows, "x")
    lines = []
    for view in distinct(rows, "view"):
        for key, label in (("sum", "sum of both, over the true one"), ("object", "‖Σ̂ − Σ‖ / ‖Σ‖"),
                           ("bearing", "‖Γ̂ − Γ‖ / ‖Γ‖")):
            slope = math.log(at[view, sizes[-1]][key] / at[view, sizes[0]][key]) / math.log(sizes[-1] / sizes[0])
            lines.append([f"{view}: {label}"] + [with_interval(at[view, n], key) for n in sizes] +
                         ["" if key == "sum" else f"{slope:.2f}"])
    yield from table(["mean"] + [f"n = {n:g}" for n in sizes] + ["slope"], lines)


def small(results):
    rows = results.rows("small")
    at = {(r["noise"], r["x"]): r for r in rows}
    noises = distinct(rows, "noise")

    def ratio_of(row, key):
        return f"{row[key]:.3f} ({row[key + '_low']:.3f}–{row[key + '_high']:.3f})"

    head = ["ratio to isotropic"] + [f"{noise}: {what}" for noise in noises for what in ("rotation", "translation")]
    yield from table(head, [[f"n = {n:g}"] + [ratio_of(at[noise, n], key) for noise in noises for key in
                                              ("rotation_deg_ratio", "translation_percent_ratio")]
                            for n in distinct(rows, "x")])


def bias(results):
    rows = results.rows("bias")
    at = {(r["cell"], r["solver"]): r for r in rows}
    solvers = distinct(rows, "solver")
    ours, others = solvers[-1], solvers[:-1]

    def best(cell, key):
        return min(at[cell, solver][key] for solver in others)

    def share(cell, solver):  # of the deviation of a single error
        row = at[cell, solver]
        half = (row["depth_m_high"] - row["depth_m_low"]) / 2 / row["depth_deviation_m"]
        return f"{row['depth_m'] / row['depth_deviation_m']:+.3f} ± {half:.3f}"

    yield from table(["cell", "rotation \\| translation, over the better of the two"] +
                     [f"depth error of {solver}" for solver in solvers],
                     [[cell, " \\| ".join(f"{at[cell, ours][key] / best(cell, key):.3f}"
                                          for key in (ROTATION, TRANSLATION))] + [share(cell, s) for s in solvers]
                      for cell in distinct(rows, "cell")])


def tails(results):
    rows = results.rows("tails")
    at = {(r["noise"], r["x"], r["tails"]): r for r in rows}
    kinds = distinct(rows, "tails")

    def both(row):
        return " \\| ".join(f"{row[key]:.3f} ({row[key + '_low']:.3f}–{row[key + '_high']:.3f})"
                            for key in ("rotation_deg_ratio", "translation_percent_ratio"))

    yield from table(["ratio to Gaussian"] + kinds[1:],
                     [[f"{noise}, n = {n:g}"] + [both(at[noise, n, kind]) for kind in kinds[1:]]
                      for noise in distinct(rows, "noise") for n in distinct(rows, "x")])


TABLES = {
    "experiments.md": [points, noise, time, guess, rounds, covariance, consistency, depth, pixels, omnidir, outliers],
    "noise.md": [recovery, recovery_sums, small, bias, coverage, tails],
}


def main(folder, document):
    results, path = Results(folder), pathlib.Path(document)
    text = path.read_text()
    for make in TABLES[path.name]:
        if not results.has(make.__name__):
            print(f"{make.__name__}: no results, the table stays as it is")
            continue
        block = re.compile(rf"(<!-- table {make.__name__} -->\n).*?(<!-- end of table -->)", re.DOTALL)
        body = "\n" + "\n".join(make(results)).strip() + "\n\n"
        text, found = block.subn(lambda match: match[1] + body + match[2], text)
        if found != 1:
            sys.exit(f"{document}: {found} places for the table {make.__name__}, not 1")
    path.write_text(text)
    print(f"{document}: {len(TABLES[path.name])} tables")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
