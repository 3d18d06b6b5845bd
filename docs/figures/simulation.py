#!/usr/bin/python3
"""Draws the figures of docs/simulation.md into docs/images/.

    docs/figures/simulation.py BUILD/.../scene_frame

scene_frame is built with the tests. Needs numpy and matplotlib.
"""
import pathlib
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
IMAGES = ROOT / "docs" / "images"


def frame(tool, scene, number):
    """One frame of config/scenes/SCENE.yaml as an array."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "frame.pgm"
        subprocess.run([tool, ROOT / "config" / "scenes" / f"{scene}.yaml", str(number), path], check=True)
        data = path.read_bytes()
    header, _, pixels = data.partition(b"\n")
    width, height = (int(value) for value in header.split()[1:3])
    return np.frombuffer(pixels, np.uint8).reshape(height, width)


def filter_histogram(tool):
    """Fig. 2 of the paper: grey levels before and after adding the band-pass filter."""
    figure, axes = plt.subplots(2, 2, figsize=(9, 5.6), gridspec_kw={"height_ratios": [1.35, 1]})
    for column, (scene, title) in enumerate([("filter_off", "without filter"), ("filter_on", "with filter")]):
        image = frame(tool, scene, 1)
        axes[0, column].imshow(image[::2, ::2], cmap="gray", vmin=0, vmax=255, interpolation="nearest")
        axes[0, column].set_title(title)
        axes[0, column].axis("off")
        axes[1, column].hist(image.ravel(), bins=np.arange(257) - 0.5, color="0.3", log=True)
        axes[1, column].set(xlim=(-2, 257), ylim=(1, 2e6), xlabel="grey level [DN]")
    axes[1, 0].set_ylabel("pixels")
    figure.tight_layout()
    figure.savefig(IMAGES / "filter_histogram.png", dpi=80)


def presets(tool):
    """The stripe around the bead in both presets, full resolution."""
    figure, axes = plt.subplots(2, 1, figsize=(9, 4.2))
    for axis, (scene, number) in zip(axes, [("realistic", 100), ("harsh", 130)]):
        image = frame(tool, scene, number)[470:620, 480:1200]
        axis.imshow(image, cmap="gray", vmin=0, vmax=255, interpolation="nearest")
        axis.set_title(scene)
        axis.axis("off")
    figure.tight_layout()
    figure.savefig(IMAGES / "presets.png", dpi=80)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    IMAGES.mkdir(exist_ok=True)
    filter_histogram(sys.argv[1])
    presets(sys.argv[1])
