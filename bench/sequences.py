"""The section of bench/run about meshes that move, by `winnow compare-sequence`."""

import pathlib

from harness import Table, measure

# How all frames are simplified at once.
VARIANTS = {
    "default": [],
    "deformation weight 1": ["--deformation-weight", "1"],
    "both weights (Zhang and Wu's cost)": ["--deformation-weight", "1", "--feature-weight", "1"],
    "4 % per frame": ["--per-frame", "4%"],
}


def sequences_in(data):
    """Folders of numbered files, in the directory of real meshes."""
    if data is None:
        return []
    folders = [path for path in pathlib.Path(data).rglob("*") if path.is_dir()]
    return [(path, frames) for path in sorted(folders)
            if len(frames := sorted(path.glob("[0-9]*.obj"))) >= 3]


def section_sequences(bench):
    """A mesh that moves: each frame alone, and all frames at once"""
    options = bench.options
    result = {}
    for path, frames in sequences_in(options.data):
        for share in ("10%", "3%"):
            print(f"**{path.name}**, {len(frames)} frames to {share}:\n")
            table = Table("how", "mean RMS %", "of alone", "worst of alone", "flipped at most",
                          "flicker of the original", "seconds")
            folder = bench.work / f"sequence-{path.name}"
            folder.mkdir(exist_ok=True)

            def judged(name, seconds, alone=None, frames=frames, folder=folder, table=table):
                found = measure([options.winnow, "compare-sequence", *frames, "--",
                                 *sorted(folder.glob("*.ply")), "--json", "--samples", "100k",
                                 "--threads", options.threads])["report"]
                alone = alone or found
                flicker = found["flicker"]
                worst = max(rms / by_itself for rms, by_itself in
                            zip(found["rms"]["of_frames"], alone["rms"]["of_frames"]))
                table.add(name, found["rms"]["mean_percent"],
                          found["rms"]["mean"] / alone["rms"]["mean"], worst,
                          found["flipped"]["most"],
                          flicker["simplified"] / flicker["original"] if flicker else "-", seconds)
                return found

            for old in folder.glob("*.ply"):
                old.unlink()
            runs = [measure([options.winnow, "simplify", frame, "-o",
                             folder / f"{frame.stem}.ply", "--ratio", share, "--json",
                             "--threads", options.threads]) for frame in frames]
            alone = judged("each frame alone", sum(run["report"]["seconds"] for run in runs))
            kept = {"each frame alone": alone}
            for name, arguments in VARIANTS.items():
                for old in folder.glob("*.ply"):
                    old.unlink()
                run = measure([options.winnow, "sequence", *frames, "-o", folder / "{frame}.ply",
                               "--ratio", share, "--json", "--threads", options.threads,
                               *arguments])
                kept[name] = judged(name, run["report"]["seconds"], alone)
            table.print()
            result[f"{path.name} {share}"] = kept
    return result
