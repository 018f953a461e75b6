"""Sections of bench/run: shapes on which simplifiers go wrong, and what is left of them."""

from bench import faces_out
from harness import Failed, Table, measure, ratio

# What is made of each: the shape, its size, and what winnow is asked for.
SHAPES = [
    ("thin_shell", ["n=100"], ["--faces", "20k"]),
    ("thin_shell", ["n=400", "wall=0.005"], ["--faces", "20k"]),
    ("thin_shell", ["n=400", "wall=0.01"], ["--faces", "100k"]),
    ("plate", ["n=100"], ["--faces", "12"]),
    ("plate", ["n=300"], ["--faces", "1000"]),
    ("plate", ["n=100", "turn=0.4"], ["--error", "1%"]),
    ("ball_on_ground", [], ["--faces", "1000"]),
    ("room", [], ["--faces", "1100"]),
    ("pipe", [], ["--faces", "200"]),
    ("pipe", ["sides=24", "rings=2000", "length=100000", "double=1"], ["--faces", "1000"]),
    ("capped_cylinder", [], ["--faces", "1000"]),
    ("capped_cylinder", ["sides=40000", "turn=1.1"], ["--faces", "1000"]),
    ("open_fan", [], ["--faces", "100"]),
    ("open_fan", ["n=1000000"], ["--faces", "100"]),
    ("book", ["pages=10000"], ["--faces", "1000"]),
    ("hub", [], ["--faces", "1000"]),
    ("hub", ["n=1000000"], ["--faces", "1000"]),
    ("line", [], ["--faces", "1000"]),
    ("soup", [], ["--faces", "10k"]),
    ("jittered_soup", ["n=50"], ["--faces", "10k"]),
    ("crowd", ["faces=100000"], ["--faces", "10k"]),
    ("crowd", [], ["--faces", "10k"]),
    ("crowd", ["faces=400000"], ["--faces", "10k", "--topology", "free"]),
    ("capped_cube", [], ["--faces", "12"]),
    ("capped_cube", ["turn=0.4", "double=1"], ["--faces", "12"]),
    ("cube_with_caps", [], ["--faces", "12"]),
    ("zero_area_border_square", [], ["--error", "0.1%"]),
    ("polygon_square", [], ["--faces", "4"]),
    ("polygon_square", ["points=25000"], ["--error", "0.1%"]),
    ("disc", [], ["--error", "1%"]),
    ("disc", ["n=400", "rings=100"], ["--error", "1%"]),
    ("strip", [], ["--error", "1%"]),
    ("double_sided", ["n=60"], ["--faces", "2000"]),
    ("strip", ["n=900000"], ["--error", "1%"]),
    ("strip", ["n=900000"], ["--faces", "1000", "--boundary", "keep"]),
    ("far_vertex", ["far=3e7"], ["--faces", "4000"]),
    ("far_vertex", [], ["--refine", "none", "--faces", "1000"]),
    ("far_vertex", ["n=100", "far=1e6", "used=0"], ["--refine", "none", "--faces", "1000"]),
    ("hills", [], ["--faces", "10k"]),
    ("hills", ["n=900"], ["--faces", "60k", "--boundary", "keep"]),
    ("hills", ["n=900"], ["--error", "0.3%"]),
    ("hills", ["n=900"], ["--refine", "none", "--faces", "10k"]),
]

# Large enough for clustering to come first: a generated surface or a shape, and what is asked for.
CLUSTERED = [
    ("scan", ["5M"], ["--ratio", "1%"]),
    ("scan", ["20M"], ["--faces", "200k"]),
    ("thin_shell", ["n=400", "wall=0.005"], ["--faces", "20k"]),
    ("thin_shell", ["n=400", "wall=0.01"], ["--faces", "100k"]),
    ("plate", ["n=300"], ["--faces", "1000"]),
    ("capped_cylinder", ["sides=400000"], ["--faces", "5000"]),
    ("hills", ["n=900"], ["--faces", "20k"]),
    ("hills", ["n=900"], ["--faces", "60k", "--boundary", "keep"]),
    ("hills", ["n=900"], ["--error", "0.3%"]),
    ("terrain", ["2880k"], ["--faces", "100k", "--boundary", "keep"]),
]


def change(part):
    return "" if part is None else f"{part:.1e}"


def judge(bench, source):
    """What the judge says of bench.out; the reason where it says nothing in time."""
    options = bench.options
    try:
        return measure([options.winnow, "compare", source, bench.out, "--json", "--threads",
                        options.threads, "--samples", "100k", "--memory", options.large_memory],
                       timeout=options.shape_timeout)["report"]
    except Failed as failure:
        return str(failure)


def section_shapes(bench):
    """Shapes on which simplifiers go wrong"""
    options = bench.options
    table = Table("shape", "faces in", "asked", "faces out", "seconds", "edges with other than two",
                  "area", "volume", "RMS %")
    result = {}
    source = bench.work / "shape.ply"
    for shape, size, asked in SHAPES:
        name, title = " ".join([shape, *size]), " ".join(asked)
        made = measure([bench.program("bench_shapes"), shape, source, *size])["report"]
        row = result[f"{name} {title}"] = {"made": made}
        try:
            run = row["run"] = bench.winnow(source, *asked, timeout=options.shape_timeout)
        except Failed as failure:
            row["failed"] = str(failure)
            table.add(name, made["faces"], title, f"failed: {failure}", "", "", "", "", "")
            continue
        judged = row["judged"] = judge(bench, source)
        cells = [f"not judged: {judged}", "", "", ""]
        if not isinstance(judged, str):
            topology = judged["topology"]
            cells = [topology["boundary_edges"] + topology["non_manifold_edges"],
                     change(judged["area_change"]),
                     change(judged["volume_change"]),
                     judged["distance"]["symmetric"]["rms_percent"]]
        table.add(name, made["faces"], title, faces_out(run), run["seconds"], *cells)
    table.print()
    source.unlink()
    return result


def beside(key, base, other):
    """By which part of it the other differs from the base; nothing where one has none."""
    return change(other[key] / base[key] - 1) if base[key] and other[key] else ""


def section_clustered(bench):
    """Clustering first beside full detail"""
    options = bench.options
    table = Table("input", "asked", "clustered", "faces, full", "edges with other than two, full",
                  "area beside full", "volume beside full", "processor time beside full")
    result = {}
    source = bench.work / "shape.ply"

    def run(*asked):
        done = bench.winnow(source, *asked)
        done["info"] = measure([options.winnow, "info", bench.out, "--json"])["report"]
        return done

    for shape, size, asked in CLUSTERED:
        name, title = " ".join([shape, *size]), " ".join(asked)
        if shape in ("scan", "terrain"):
            measure([options.winnow, "generate", shape, "--faces", *size, "-o", source, "--force"])
        else:
            measure([bench.program("bench_shapes"), shape, source, *size])
        runs = bench.in_turn({"clustered": lambda: run(*asked),
                              "full": lambda: run(*asked, "--detail", "full")})
        row = result[f"{name} {title}"] = runs
        if isinstance(runs["full"], str):
            table.fail(name, runs["full"])
            continue
        (first, *_), (full, *_) = row["clustered"], row["full"]

        def odd(done):
            return done["info"]["edges"]["boundary"] + done["info"]["edges"]["non_manifold"]

        table.add(name, title, "yes" if first["report"]["clustered"]["first"] else "no",
                  f"{faces_out(first)}, {faces_out(full)}", f"{odd(first)}, {odd(full)}",
                  beside("area", full["info"], first["info"]),
                  beside("volume", full["info"], first["info"]),
                  ratio(runs["clustered"], runs["full"], "cpu_seconds"))
    table.print()
    source.unlink()
    return result
