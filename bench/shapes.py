"""Section of bench/run: shapes on which simplifiers go wrong, and what is left of them."""

from bench import faces_out
from harness import Failed, Table, measure

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


def change(ratio):
    return "" if ratio is None else f"{ratio:.1e}"


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
