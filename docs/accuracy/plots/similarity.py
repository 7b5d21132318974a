#!/usr/bin/env python3
"""How alike two pictures look: the structural similarity (Wang et al. 2004), by scikit-image.

similarity.py RIGHT OTHER [RIGHT OTHER]…    writes a line for each pair: 1 for equal pictures
similarity.py ready                         fails if scikit-image is missing
"""
import sys

sys.dont_write_bytecode = True
from modules import is_there  # noqa: E402

MISSING = "this needs scikit-image: python3-skimage, or what your system calls it"


def similarity(right, other):
    """Of the colors, with the window and the constants of the article."""
    from skimage.io import imread
    from skimage.metrics import structural_similarity
    return structural_similarity(imread(right), imread(other), channel_axis=2, data_range=255,
                                 gaussian_weights=True, sigma=1.5, use_sample_covariance=False)


def main(files):
    if not is_there("skimage"):
        sys.exit(MISSING)
    if files != ["ready"]:
        for right, other in zip(files[::2], files[1::2], strict=True):
            print(f"{similarity(right, other):.6f}")


if __name__ == "__main__":
    main(sys.argv[1:])
