#!/usr/bin/env python3
"""Matches two pictures by a learned matcher and writes them for samples/uav_localization --matches.

    export_matches.py REFERENCE QUERY OUTPUT [--matcher lightglue|loftr]

OUTPUT is text: a row `u v u' v' confidence` per match, the pixel of the reference and of the query picture. The centre of
the top-left pixel is (0, 0). Name it REFERENCE__QUERY.txt (without extensions) to give the program a folder of several.

lightglue: SuperPoint + LightGlue, https://github.com/cvg/LightGlue (its package `lightglue`).
loftr: LoFTR as in Kornia, https://github.com/kornia/kornia (packages `kornia` and `opencv-python`).
Other matchers: call write_matches() with their pixels.
"""

import argparse
import sys

from output_file import write_text


def write_matches(path, reference, query, confidence=None):
    """Writes N x 2 pixels of the reference, N x 2 of the query and, optionally, N confidences."""
    reference, query = [list(map(tuple, pixels)) for pixels in (reference, query)]
    if len(reference) != len(query):
        raise ValueError(f"{len(reference)} pixels of the reference but {len(query)} of the query")
    confidence = [1.0] * len(query) if confidence is None else list(confidence)
    if len(confidence) != len(query):
        raise ValueError(f"{len(confidence)} confidences for {len(query)} matches")
    rows = ["# u v u' v' confidence: pixel of the reference, pixel of the query\n"]
    for (u, v), (s, t), c in zip(reference, query, confidence):
        rows.append(f"{u:.3f} {v:.3f} {s:.3f} {t:.3f} {c:.4f}\n")
    write_text(path, "".join(rows))


def match_lightglue(reference, query):
    """Pixels of both pictures and scores, by SuperPoint and LightGlue."""
    from lightglue import LightGlue, SuperPoint
    from lightglue.utils import load_image, rbd

    extractor = SuperPoint(max_num_keypoints=4096).eval()
    features = [extractor.extract(load_image(path)) for path in (reference, query)]
    result = rbd(LightGlue(features="superpoint").eval()({"image0": features[0], "image1": features[1]}))
    points = [rbd(f)["keypoints"][result["matches"][:, i]] for i, f in enumerate(features)]
    return points[0].tolist(), points[1].tolist(), result["scores"].tolist()


def match_loftr(reference, query):
    """Pixels of both pictures and confidences, by LoFTR; its pictures' sides must be multiples of 8."""
    import cv2
    import torch
    from kornia.feature import LoFTR

    def load(path):
        grey = cv2.imread(path, cv2.IMREAD_GRAYSCALE)
        if grey is None:
            raise OSError(f"{path}: cannot be read as an image")
        grey = grey[: grey.shape[0] // 8 * 8, : grey.shape[1] // 8 * 8]
        return torch.from_numpy(grey)[None, None].float() / 255

    with torch.inference_mode():
        result = LoFTR("outdoor").eval()({"image0": load(reference), "image1": load(query)})
    return [result[key].tolist() for key in ("keypoints0", "keypoints1", "confidence")]


MATCHERS = {"lightglue": match_lightglue, "loftr": match_loftr}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("reference")
    parser.add_argument("query")
    parser.add_argument("output")
    parser.add_argument("--matcher", choices=MATCHERS, default="lightglue")
    arguments = parser.parse_args()
    try:
        matches = MATCHERS[arguments.matcher](arguments.reference, arguments.query)
        write_matches(arguments.output, *matches)
    except (ImportError, OSError) as error:
        sys.exit(f"export_matches.py: {error}")
    print(f"{arguments.output}: {len(matches[0])} matches")


if __name__ == "__main__":
    main()
