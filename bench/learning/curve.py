"""Draws the training curve of the package's mouse, with built-in mice on the same mazes: docs/learning.svg.

    build/bench-learning/bin/python bench/learning/curve.py docs/learning.svg
"""

import json
import sys
from importlib import resources

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "labmouse"
import matplotlib.pyplot as plt  # noqa: E402

import labmouse  # noqa: E402
from labmouse import learn  # noqa: E402


def main() -> None:
    written = json.loads(resources.files("labmouse.learn").joinpath("mouse.json").read_text(encoding="utf-8"))
    mazes = learn.MazeSet("validation")[:100]
    race = labmouse.race("cautious,flood-return,ariadne", mazes, runs=5, progress=False)
    lines = dict(zip(race.standings["name"], race.standings["mean_par1"]))
    lines["bound"] = float(race.mazes["bound"].mean())
    figure, axes = plt.subplots(figsize=(7, 4))
    points = written["curve"]
    axes.plot([point["generation"] for point in points], [point["validation"] for point in points], "o-", clip_on=False, zorder=3)
    axes.annotate("learned", (points[-1]["generation"] * 1.02, points[-1]["validation"]), ha="left", va="center", color="C0", fontsize=8, annotation_clip=False)
    for name, score in lines.items():
        axes.axhline(score, color="grey", linewidth=0.8)
        axes.annotate(f"{name} {score:.1f}", (points[-1]["generation"] * 1.02, score), ha="left", va="top" if name == "ariadne" else "center", fontsize=8, annotation_clip=False)
    axes.set_yscale("log")
    axes.set_yticks([35, 40, 50, 60, 80, 100], labels=["35", "40", "50", "60", "80", "100"])
    axes.minorticks_off()
    axes.set_xlim(0, points[-1]["generation"])
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_xlabel("generation (24 policies on 16 fresh mazes each)")
    axes.set_ylabel("mean score, 100 held-out mazes")
    figure.tight_layout()
    figure.savefig(sys.argv[1], bbox_inches="tight", metadata={"Date": None})


if __name__ == "__main__":
    main()
