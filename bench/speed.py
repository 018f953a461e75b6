"""Sections of bench/run: how long winnow takes, beside peers and what the machine allows."""

import os
import statistics

from bench import PEERS, faces_in, faces_out, read_seconds
from harness import MIB, Failed, Table, drop_from_cache, measure, median, ratio, warm


def cell_of(bench, source, share="1%"):
    return repr(bench.cluster(source, "--ratio", share)["report"]["cell_size"])


def print_against(runs):
    """A table of programs run in turn, against the first of them."""
    base = next(iter(runs))
    table = Table("program", "faces out", "seconds", "of it reading", "Mtri/s", "times winnow",
                  "CPU s", "peak MiB", "bytes a face")
    for name, found in runs.items():
        if isinstance(found, str):
            table.fail(name, found)
            continue
        faces = faces_in(found[0])
        seconds, peak = median(found, "seconds"), median(found, "peak_bytes")
        reading = [read_seconds(run) for run in found]
        table.add(name, faces_out(found[0]), seconds,
                  "" if None in reading else statistics.median(reading),
                  faces / 1e6 / seconds, ratio(found, runs[base]), median(found, "cpu_seconds"),
                  round(peak / MIB), peak / faces)
    table.print()


def against_peers(bench, share):
    result = {}
    for suffix in ("ply", "stl"):
        source = bench.generate(bench.options.faces, suffix)
        warm(source)
        learned = bench.cluster(source, "--ratio", share)
        cell = repr(learned["report"]["cell_size"])
        candidates = {f"winnow --ratio {share}": lambda: bench.winnow(source, "--ratio", share),
                      f"winnow --ratio {share} --refine none":
                          lambda: bench.cluster(source, "--ratio", share),
                      "winnow --cell": lambda: bench.winnow(source, "--cell", cell)}
        failures = {}
        for peer in bench.options.peers:
            if peer == "vtk-merge" and suffix == "ply":
                continue
            try:
                command = bench.peer_command(peer, source, faces_out(learned),
                                             bench.work / "peer.ply")
                candidates[PEERS[peer][0]] = lambda command=command: measure(
                    command, address_limit=bench.peer_limit)
            except Failed as failure:
                failures[PEERS[peer][0]] = str(failure)
        runs = bench.in_turn(candidates) | failures
        print(f"**{suffix.upper()}**, {faces_in(learned)} faces to {share}, warm, "
              f"{bench.options.threads} threads for winnow:\n")
        print_against(runs)
        result[suffix] = runs
    return result


def section_warm(bench):
    """Warm cache, 1 %: winnow and its peers"""
    return against_peers(bench, "1%")


def section_tenth(bench):
    """Warm cache, 10 %: winnow and its peers"""
    return against_peers(bench, "10%")


def section_limits(bench):
    """As a part of what the machine allows, warm, 1 %"""
    # Parts of: the map-and-sum loop with as many threads; the file's bytes read in order by one
    # thread; the memory's bandwidth with as many threads, read only and in the triad. The file's
    # bytes are counted once.
    parts = ("of map-and-sum", "of reading the file", "of reading memory", "of triad")
    table = Table("input", "threads", "resolution", "winnow Mtri/s", "winnow GB/s", *parts)
    limits = Table("input", "threads", "map-and-sum Mtri/s", "reading the file GB/s",
                   "reading memory GB/s", "triad GB/s")
    result = {}
    for suffix, loop in (("ply", "through_indices"), ("stl", "corners")):
        source = bench.generate(bench.options.faces, suffix)
        warm(source)
        cell = cell_of(bench, source)
        rounds = []
        for _ in range(bench.options.rounds):
            sums = bench.limits(source, "sums")["map_and_sum_mtri_s"][loop]["mapped"]
            reading = bench.limits(source, "warm")["read_warm_gb_s"]
            memory = bench.limits(source, "memory")
            for threads in range(1, bench.options.threads + 1):
                for name, value in (("--cell", cell), ("--ratio", "1%")):
                    run = bench.cluster(source, name, value, threads=threads)
                    mtri = faces_in(run) / 1e6 / run["seconds"]
                    gb = os.path.getsize(source) / 1e9 / run["seconds"]
                    allowed = (sums[str(threads)], reading,
                               memory["memory_read_gb_s"][str(threads)],
                               memory["memory_triad_gb_s"][str(threads)])
                    rounds.append({"threads": threads, "resolution": name, "winnow_mtri_s": mtri,
                                   "winnow_gb_s": gb, "limit_mtri_s": allowed[0],
                                   "read_warm_gb_s": reading,
                                   "memory_read_gb_s": allowed[2], "memory_triad_gb_s": allowed[3],
                                   "memory_copy_gb_s": memory["memory_copy_gb_s"][str(threads)],
                                   "part": mtri / allowed[0]}
                                  | {part: gb / limit
                                     for part, limit in zip(parts[1:], allowed[1:])})
        for threads in range(1, bench.options.threads + 1):
            for name in ("--cell", "--ratio"):
                mine = [r for r in rounds if r["threads"] == threads and r["resolution"] == name]
                table.add(suffix.upper(), threads, name, *(median(mine, key) for key in
                                                           ("winnow_mtri_s", "winnow_gb_s", "part",
                                                            *parts[1:])))
            limits.add(suffix.upper(), threads, *(median(mine, key) for key in
                                                  ("limit_mtri_s", "read_warm_gb_s",
                                                   "memory_read_gb_s", "memory_triad_gb_s")))
        result[suffix] = rounds
    table.print()
    limits.print()
    return result


def section_cold(bench):
    """Cold cache, --cell: against a direct sequential read"""
    table = Table("input", "winnow s", "winnow GB/s", "direct read GB/s", "part", "left in cache")
    result = {}
    for suffix in ("ply", "stl"):
        source = bench.generate(bench.options.faces, suffix)
        cell = cell_of(bench, source)
        rounds = []
        for _ in range(bench.options.rounds):
            reads = bench.limits(source, "reads")
            stayed = drop_from_cache(source)
            run = bench.winnow(source, "--cell", cell)
            rate = os.path.getsize(source) / 1e9 / run["seconds"]
            direct = reads["read_direct_gb_s"]
            if direct is None:
                raise Failed("this file system cannot read past the page cache")
            rounds.append(run | {"gb_s": rate, "direct_gb_s": direct, "stayed": stayed,
                                 "cold_gb_s": reads["read_cold_gb_s"], "part": rate / direct})
        table.add(suffix.upper(), *(median(rounds, key) for key in
                                    ("seconds", "gb_s", "direct_gb_s", "part", "stayed")))
        result[suffix] = rounds
    table.print()
    return result


def section_threads(bench):
    """1 thread against all, warm, 1 %"""
    table = Table("input", "threads", "seconds", "CPU s", "times as fast as 1")
    result = {}
    for suffix in ("ply", "stl"):
        source = bench.generate(bench.options.faces, suffix)
        warm(source)
        cell = cell_of(bench, source)
        runs = bench.in_turn({str(n): lambda n=n: bench.winnow(source, "--cell", cell, threads=n)
                              for n in range(1, bench.options.threads + 1)})
        for threads, found in runs.items():
            table.add(suffix.upper(), threads, median(found, "seconds"), median(found,
                                                                                "cpu_seconds"),
                      ratio(runs["1"], found))
        result[suffix] = runs
    table.print()
    return result


def section_shuffled(bench):
    """Shuffled faces, warm, 1 %"""
    table = Table("input", "memory", "seconds in order", "seconds shuffled", "times",
                  "CPU s in order", "CPU s shuffled", "peak MiB shuffled")
    result = {}
    # The vertices of the PLY fit into their share of the first budget, but not of the others.
    for suffix, memory in (("ply", "2G"), ("ply", "512M"), ("ply", "256M"), ("stl", "512M")):
        sources = {"in order": bench.generate(bench.options.faces, suffix),
                   "shuffled": bench.generate(bench.options.faces, suffix, "--shuffle")}
        for source in sources.values():
            warm(source)
        cell = cell_of(bench, sources["in order"])
        runs = bench.in_turn({name: lambda source=source: bench.winnow(source, "--cell", cell,
                                                                       "--memory", memory)
                              for name, source in sources.items()})
        if isinstance(runs["shuffled"], str):
            raise Failed(runs["shuffled"])
        ordered, shuffled = runs["in order"], runs["shuffled"]
        table.add(suffix.upper(), memory, median(ordered, "seconds"), median(shuffled, "seconds"),
                  ratio(shuffled, ordered), median(ordered, "cpu_seconds"), median(shuffled,
                                                                                   "cpu_seconds"),
                  round(median(shuffled, "peak_bytes") / MIB))
        result[f"{suffix} {memory}"] = runs
    table.print()
    return result
