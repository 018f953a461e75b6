"""What every section of bench/run works with: inputs, winnow, the peers, and runs in turn."""

import atexit
import os
import pathlib
import subprocess
import sys

from harness import MIB, Failed, measure, short

# Title, program, its arguments, and the parameter that it finds for a face count and reports. The
# search is run once and not timed: the timed runs are given the parameter.
PEERS = {
    "meshopt": ("meshoptimizer sloppy", "peer_meshoptimizer", ["--method", "sloppy"], None),
    "meshopt-edges": ("meshoptimizer edges", "peer_meshoptimizer", ["--method", "edges"], None),
    "vtk": ("VTK quadric clustering", "peer_vtk", [], "divisions"),
    "vtk-merge": ("VTK, welding reader", "peer_vtk", ["--merge"], "divisions"),
    "vtk-stream": ("VTK, streamed", "peer_vtk", ["--stream"], "divisions"),
    "vtk-edges": ("VTK quadric decimation", "peer_vtk_decimate", [], None),
    "cgal-lt": ("CGAL Lindstrom-Turk", "peer_cgal", ["--cost", "lindstrom-turk"], None),
    "cgal-gh": ("CGAL Garland-Heckbert", "peer_cgal", ["--cost", "garland-heckbert"], None),
    "openmesh": ("OpenMesh quadric", "peer_openmesh", [], None),
    "open3d": ("Open3D average", "peer_open3d", ["--contraction", "average"], "voxel"),
    "open3d-quadric": ("Open3D quadric", "peer_open3d", ["--contraction", "quadric"], "voxel"),
    "open3d-edges": ("Open3D quadric decimation", "peer_open3d", ["--decimate"], None),
    "meshlab": ("MeshLab clustering", "peer_meshlab", [], "cell"),
    "meshlab-edges": ("MeshLab quadric decimation", "peer_meshlab", ["--collapse"], None),
}

# What winnow is asked for where quality is judged; the first is the base that others are held
# against.
VARIANTS = {
    "winnow": [],
    "winnow, full detail": ["--detail", "full"],
    "winnow volume": ["--refine", "volume"],
    "winnow importance": ["--refine", "importance"],
    "winnow, clustering alone": ["--refine", "none"],
    "winnow mean, clustering alone": ["--refine", "none", "--placement", "mean"],
}


def show_nothing():
    """A window system without a window, for MeshLab; gone with this script."""
    if "DISPLAY" in os.environ:
        return
    reading, writing = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", "640x480x24"],
                              pass_fds=[writing], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL)
    atexit.register(server.terminate)
    os.close(writing)
    with os.fdopen(reading) as number:
        os.environ["DISPLAY"] = f":{number.readline().strip()}"


def faces_out(run):
    report = run["report"]
    return report["faces_out"] if "faces_out" in report else report["output"]["faces"]


def faces_in(run):
    report = run["report"]
    return report["faces_in"] if "faces_in" in report else report["input"]["faces"]


def read_seconds(run):
    """What a peer's driver says of its reading; None of winnow, which clusters as it reads."""
    return run["report"].get("seconds_read")


class Bench:
    def __init__(self, options):
        self.options = options
        self.work = pathlib.Path(options.work)
        self.work.mkdir(parents=True, exist_ok=True)
        self.plots = pathlib.Path(options.plots)
        self.out = self.work / "out.ply"
        self.programs = {path.name: path for name in ("peer_*", "bench_*")
                         for path in pathlib.Path(options.build).rglob(name)
                         if path.is_file() and os.access(path, os.X_OK)}
        total = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
        # A peer that wants more fails by itself and takes nobody along.
        self.peer_limit = int(0.85 * total)
        self.parameters = {}  # found for a peer, an input and a face count
        if "peer_meshlab" in self.programs:
            show_nothing()

    def generate(self, faces, suffix="ply", *more):
        name = "-".join(["scan", short(faces), *(word.strip("-") for word in more)])
        path = self.work / f"{name}.{suffix}"
        if not path.exists():
            print(f"(generating {path.name})", file=sys.stderr, flush=True)
            measure([self.options.winnow, "generate", "scan", "--faces", faces, "-o", path, *more])
        return path

    def winnow(self, source, *more, threads=None, feed=None, **limits):
        return measure([self.options.winnow, "simplify", source, "-o", self.out, "--force",
                        "--json", "--threads", threads or self.options.threads, *more],
                       feed=feed, **limits)

    def cluster(self, source, *more, **limits):
        return self.winnow(source, *more, "--refine", "none", **limits)

    def compare(self, source, simplified, *more):
        return measure([self.options.winnow, "compare", source, simplified, "--json",
                        "--threads", self.options.threads, "--samples", self.options.samples,
                        *more])

    def program(self, name):
        if name not in self.programs:
            raise Failed(f"{name} is not built (see bench/peers/CMakeLists.txt)")
        return self.programs[name]

    def limits(self, path, only):
        command = [self.program("bench_limits"), path, "--only", only, "--threads",
                   self.options.threads]
        return measure(command)["report"]

    def peer_command(self, peer, source, faces, target):
        """The command that makes the peer reach the face count, its parameter found."""
        _, name, arguments, parameter = PEERS[peer]
        command = [self.program(name), source, target]
        if not parameter:
            return [*command, *arguments, "--faces", faces]
        key = (name, source.stem, faces)  # one surface in PLY and in STL needs the same
        if key not in self.parameters:
            found = measure([*command, "--faces", faces], address_limit=self.peer_limit)["report"]
            self.parameters[key] = repr(found[parameter])
        return [*command, *arguments, f"--{parameter}", self.parameters[key]]

    def in_turn(self, candidates):
        """Runs every candidate once a round: name -> its runs, or the reason why there are none.

        One that takes over ten times as long as the first is run in the first round only.
        """
        runs = {name: [] for name in candidates}
        first = next(iter(candidates))
        for _ in range(self.options.rounds):
            for name, run in candidates.items():
                if isinstance(runs[name], str):
                    continue
                if runs[name] and runs[name][0]["seconds"] > 10 * runs[first][0]["seconds"]:
                    continue
                try:
                    runs[name].append(run())
                except Failed as failure:
                    if name == first:
                        raise
                    runs[name] = str(failure)
        return runs


def real_meshes(directory, most=3):
    """The largest binary meshes under a directory that every program can read, by their headers."""
    def readable(path):
        with open(path, "rb") as file:
            head = file.read(4096)
        if head.startswith(b"ply"):
            return b"binary_little_endian" in head and b"element tristrips" not in head
        return len(head) >= 84 and path.stat().st_size >= 84 + 50 * int.from_bytes(head[80:84],
                                                                                   "little")

    if not directory:
        return []
    found = [path for path in pathlib.Path(directory).rglob("*")
             if path.suffix.lower() in (".ply", ".stl") and path.stat().st_size > MIB
             and readable(path)]
    return sorted(found, key=lambda path: path.stat().st_size, reverse=True)[:most]
