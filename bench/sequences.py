"""The section of bench/run about meshes that move, by `winnow compare-sequence`."""

import pathlib
import struct

from harness import Table, measure

# How all frames are simplified at once.
VARIANTS = {
    "deformation-sensitive decimation": ["--quadrics", "accumulated", "--fit", "0"],
    "Zhang and Wu": ["--quadrics", "accumulated", "--deformation-weight", "1",
                     "--feature-weight", "1", "--per-frame", "4%", "--fit", "0"],
    "default": [],
    "fitted once": ["--fit", "1"],
    "not fitted": ["--fit", "0"],
    "deformation weight 1": ["--deformation-weight", "1"],
    "both weights": ["--deformation-weight", "1", "--feature-weight", "1"],
    "4 % per frame": ["--per-frame", "4%"],
}


def sequences_in(data):
    """Folders of numbered files, in the directory of real meshes."""
    if data is None:
        return []
    folders = [path for path in pathlib.Path(data).rglob("*") if path.is_dir()]
    return [(path, frames) for path in sorted(folders)
            if len(frames := sorted(path.glob("[0-9]*.obj"))) >= 3]


def positions_of(obj):
    """The vertices of an OBJ, three numbers each."""
    with open(obj, encoding="ascii") as lines:
        return [tuple(map(float, line.split()[1:4])) for line in lines if line.startswith("v ")]


def first_for_all(bench, frames, folder, share):
    """Simplifies the first frame alone, and moves its vertices by the mean of what went into each.
    Returns the seconds that this took the first frame."""
    options = bench.options
    small, where = folder / "first.obj", folder / "first.npy"
    run = measure([options.winnow, "simplify", frames[0], "-o", small, "--map", where, "--ratio",
                   share, "--force", "--json", "--threads", options.threads])
    content = where.read_bytes()
    head = 10 + int.from_bytes(content[8:10], "little")
    went = [number for (number,) in struct.iter_unpack("<q", content[head:])]
    start = positions_of(frames[0])
    text = small.read_text(encoding="ascii").splitlines()
    places = positions_of(small)
    faces = [line for line in text if line.startswith("f ")]
    for frame in frames:
        sums = [[0.0, 0.0, 0.0, 0] for _ in places]
        for number, here, before in zip(went, positions_of(frame), start):
            if number >= 0:
                total = sums[number]
                for axis in range(3):
                    total[axis] += here[axis] - before[axis]
                total[3] += 1
        lines = [" ".join(["v", *(repr(place[axis] + total[axis] / max(total[3], 1))
                                  for axis in range(3))]) for place, total in zip(places, sums)]
        (folder / f"{frame.stem}.moved.obj").write_text("\n".join(lines + faces) + "\n",
                                                        encoding="ascii")
    small.unlink()
    return run["report"]["seconds"]


def time_by_frames(bench, path, frames):
    """Prints what it takes to simplify the first frames, the first two times as many and so on."""
    table = Table("frames", "CPU seconds", "a frame more", "resident MiB")
    found = {}
    before = None
    count = max(len(frames) // 8, 2)
    while count <= len(frames):
        folder = bench.work / f"sequence-{path.name}"
        folder.mkdir(exist_ok=True)
        run = measure([bench.options.winnow, "sequence", *frames[:count], "-o",
                       folder / "{frame}.ply", "--ratio", "10%", "--force", "--json",
                       "--threads", 1])
        now = found[count] = run["cpu_seconds"]
        more = (now - before[1]) / (count - before[0]) if before else "-"
        table.add(count, now, more, run["peak_bytes"] / 2**20)
        before = (count, now)
        count *= 2
    print(f"**{path.name}**, time by the number of frames:\n")
    table.print()
    return found


def section_sequences(bench):
    """A mesh that moves: each frame alone, and all frames at once"""
    options = bench.options
    result = {}
    for path, frames in sequences_in(options.data):
        for share in ("10%", "3%"):
            print(f"**{path.name}**, {len(frames)} frames to {share}:\n")
            table = Table("how", "mean RMS %", "of alone", "worst of alone", "flipped at most",
                          "frames with more flipped", "flicker of the original", "seconds")
            folder = bench.work / f"sequence-{path.name}"
            folder.mkdir(exist_ok=True)

            def judged(name, seconds, alone=None, ending="ply", frames=frames, folder=folder,
                       table=table):
                found = measure([options.winnow, "compare-sequence", *frames, "--",
                                 *sorted(folder.glob(f"*.{ending}")), "--json", "--samples", "100k",
                                 "--threads", options.threads])["report"]
                alone = alone or found
                flicker = found["flicker"]
                worst = max(rms / by_itself for rms, by_itself in
                            zip(found["rms"]["of_frames"], alone["rms"]["of_frames"]))
                more = sum(flipped > by_itself for flipped, by_itself in
                           zip(found["flipped"]["of_frames"], alone["flipped"]["of_frames"]))
                table.add(name, found["rms"]["mean_percent"],
                          found["rms"]["mean"] / alone["rms"]["mean"], worst,
                          found["flipped"]["most"], more,
                          flicker["simplified"] / flicker["original"] if flicker else "-", seconds)
                return found

            for old in folder.glob("*.ply"):
                old.unlink()
            runs = [measure([options.winnow, "simplify", frame, "-o",
                             folder / f"{frame.stem}.ply", "--ratio", share, "--json",
                             "--threads", options.threads]) for frame in frames]
            alone = judged("each frame alone", sum(run["report"]["seconds"] for run in runs))
            kept = {"each frame alone": alone}
            name = "the first frame's sequence for all"
            kept[name] = judged(name, first_for_all(bench, frames, folder, share), alone,
                                "moved.obj")
            for name, arguments in VARIANTS.items():
                for old in folder.glob("*.ply"):
                    old.unlink()
                run = measure([options.winnow, "sequence", *frames, "-o", folder / "{frame}.ply",
                               "--ratio", share, "--json", "--threads", options.threads,
                               *arguments])
                kept[name] = judged(name, run["report"]["seconds"], alone)
            table.print()
            result[f"{path.name} {share}"] = kept
        result[f"{path.name} by frames"] = time_by_frames(bench, path, frames)
    return result
