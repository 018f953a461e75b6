"""A progressive file beside runs of its own: bytes, times, distance to the original."""

from harness import Failed, Table, measure, median


def extract(bench, file, share, *more):
    return measure([bench.options.winnow, "extract", file, "-o", bench.work / "level.ply",
                    "--ratio", share, "--threads", bench.options.threads, "--force", "--json",
                    *more])


def rms_of(bench, source, level):
    return bench.compare(source, level)["report"]["distance"]["symmetric"]["rms_percent"]


def make(bench, source, *more):
    file = bench.work / "levels.wpm"
    run = measure([bench.options.winnow, "progressive", source, "-o", file, "--base", "100",
                   "--threads", bench.options.threads, "--force", "--json", *more])
    return file, run, run["report"]["output"]["bytes"] / run["report"]["output"]["faces"]


def measure_progressive(bench, source, shares):
    """Prints and returns what a file of `source` is like. Levels are held against --detail full."""
    bits = make(bench, source, "--bits", "16")
    direct = [bench.winnow(source, "--ratio", "1%", "--detail", "full")
              for _ in range(bench.options.rounds)]
    file, made, size = make(bench, source)
    print(f"A progressive file: {size:.2f} bytes a face, {bits[2]:.2f} with 16 bits; made in "
          f"{made['seconds']:.2f} s ({made['cpu_seconds']:.2f} s of processor time), "
          f"{made['cpu_seconds'] / median(direct, 'cpu_seconds'):.2f} times a direct run to 1 %\n")
    table = Table("share", "faces", "RMS % of the diagonal", "of a direct run", "relative",
                  "raw, CPU s", "faces/s")
    result = {"bytes_a_face": size, "bytes_a_face_16_bits": bits[2], "made": made,
              "direct": direct, "levels": {}}
    for share in shares:
        try:
            level = extract(bench, file, share)
        except Failed as reason:  # fewer faces than the coarsest mesh has
            table.fail(share, reason)
            continue
        rms = [rms_of(bench, source, bench.work / "level.ply")]
        bench.winnow(source, "--ratio", share, "--detail", "full")
        rms.append(rms_of(bench, source, bench.out))
        raw = extract(bench, file, share, "--raw")
        faces = raw["report"]["output"]["faces"]
        table.add(share, faces, *rms, rms[0] / rms[1], raw["cpu_seconds"],
                  faces / raw["cpu_seconds"])
        result["levels"][share] = {"rms": rms, "level": level, "raw": raw}
    table.print()
    return result
