"""Sections of bench/run: what winnow holds, what others hold, and how both grow."""

import time

import plot
from bench import PEERS, faces_in, faces_out
from harness import MIB, Failed, Table, measure, mebibytes, median, ratio, short, warm


def section_memory(bench):
    """Peak resident set against --memory"""
    options = bench.options
    table = Table("input", "asked for", "--memory", "peak MiB", "within +32 MiB", "spilled MB",
                  "faces out", "seconds")
    cases = [(short(n), "--ratio 1%", options.memory, n, None) for n in options.memory_faces]
    cases.append((f"{short(options.faces)}, large output", "--ratio 50%", options.small_memory,
                  options.faces, None))
    if options.pipe_faces:
        pipe = [options.winnow, "generate", "scan", "--faces", options.pipe_faces, "-o", "-", "-q"]
        cases.append((f"{short(options.pipe_faces)} through a pipe", "--faces 1M", options.memory,
                      None, pipe))
    result = []
    for name, resolution, memory, faces, pipe in cases:
        source = "-" if pipe else bench.generate(faces)
        try:
            run = bench.winnow(source, *resolution.split(), "--memory", memory, feed=pipe)
        except Failed as failure:
            table.fail(name, failure)
            result.append({"case": name, "failed": str(failure)})
            continue
        within = run["peak_bytes"] <= (mebibytes(memory) + 32) * MIB
        table.add(name, resolution, memory, round(run["peak_bytes"] / MIB),
                  "yes" if within else "NO", run["report"]["spilled_bytes"] / 1e6,
                  faces_out(run), run["seconds"])
        result.append(run | {"case": name, "within": within})
    table.print()
    return result


def commands_for_little(bench, source, memory):
    """Every program's command, none of which looks for its parameter.

    That would be more than the task.
    """
    learned = bench.cluster(source, "--ratio", "1%")["report"]
    commands = {"winnow": [bench.options.winnow, "simplify", source, "-o", bench.out, "--force",
                           "--json", "--ratio", "1%", "--memory", f"{mebibytes(memory) - 32}M"]}
    for peer in bench.options.peers:
        title, name, arguments, parameter = PEERS[peer]
        if peer == "vtk-merge" or name not in bench.programs:  # the reader that welds is for STL
            continue
        value = {"divisions": round(2 / learned["cell_size"]), "voxel": learned["cell_size"],
                 "cell": learned["cell_size"], None: learned["output"]["faces"]}[parameter]
        commands[title] = [bench.programs[name], source, bench.work / "peer.ply", *arguments,
                           f"--{parameter or 'faces'}", value]
    return commands


def section_little(bench):
    """Who finishes in little memory, 1 %"""
    # Memory is resident memory that the kernel cannot drop (see harness.Guard). What needs more
    # than that, or more than the time allowed, is not asked for the same input in less memory, nor
    # for a larger one in as much.
    options = bench.options
    table = Table("program", "faces", "memory", "ends", "faces out", "seconds",
                  "peak MiB, mapped files too")
    result, lost = [], []
    end = time.monotonic() + options.little_minutes * 60
    for faces in sorted(options.little_faces):
        source = bench.generate(faces)
        warm(source)
        for memory in sorted(options.little_memory, key=mebibytes, reverse=True):
            for title, command in commands_for_little(bench, source, memory).items():
                row = {"program": title, "faces": faces, "memory": memory}
                before = [other for other in lost if other["program"] == title
                          and other["faces"] <= faces
                          and mebibytes(other["memory"]) >= mebibytes(memory)]
                try:
                    if before:
                        raise Failed(f"nor {short(before[0]['faces'])} in {before[0]['memory']}")
                    if time.monotonic() > end:
                        raise Failed(f"not tried: {options.little_minutes:g} minutes were over")
                    run = measure(command, resident_limit=mebibytes(memory) * MIB,
                                  address_limit=bench.peer_limit, timeout=options.little_timeout)
                    table.add(title, short(faces), memory, "yes", faces_out(run), run["seconds"],
                              round(run["peak_bytes"] / MIB))
                    result.append(row | run)
                except Failed as failure:
                    table.add(title, short(faces), memory, f"no: {failure}", "", "", "")
                    result.append(row | {"failed": str(failure)})
                    if not before and "not tried" not in str(failure):
                        lost.append(row)
    table.print()
    return result


def section_growth(bench):
    """Time a face as the input grows, 1 %, without spilling"""
    options = bench.options
    table = Table("faces", "seconds", "ns a face", "CPU ns a face", "times the first", "spilled")
    result, first, times = {}, None, []
    for faces in options.growth_faces:
        source = bench.generate(faces)
        warm(source)
        runs = [bench.cluster(source, "--ratio", "1%", "--memory", options.large_memory)
                for _ in range(options.rounds)]
        result[faces] = runs
        seconds, cpu = (median(runs, key) / faces_in(runs[0]) for key in ("seconds", "cpu_seconds"))
        first = first or seconds
        times.append((faces, 1e9 * seconds))
        table.add(short(faces), median(runs, "seconds"), 1e9 * seconds, 1e9 * cpu, seconds / first,
                  runs[0]["report"]["spilled_bytes"])
    table.print()
    memory = [(faces, bench.winnow(bench.generate(faces), "--faces", "1M", "--memory",
                                   options.memory)
               ["peak_bytes"] / MIB) for faces in options.growth_faces]
    for faces, peak in memory:
        print(f"{short(faces)} to 1M in {options.memory}: {peak:.0f} MiB at the peak")
    print()
    plot.write(bench.plots / "growth.svg", [
        ("Time a face", "ns, by faces of the input", {f"to 1 %, {options.large_memory}": times}),
        ("Peak memory", "MiB, by faces of the input", {f"to 1M faces, {options.memory}": memory})],
        short)
    return result | {"peak_mib_to_1M": memory}


def section_output(bench):
    """Time and memory as the output grows, from one input"""
    options = bench.options
    source = bench.generate(options.faces)
    warm(source)
    table = Table("asked for", "--memory", "faces out", "seconds", "ns an input face",
                  "CPU ns an input face", "peak MiB", "bytes an output face", "scratch MB")
    result, times, peaks = {}, {}, {}
    for memory in (options.large_memory, options.memory):
        for wanted in options.output_faces:
            runs = [bench.winnow(source, "--faces", wanted, "--memory", memory)
                    for _ in range(options.rounds)]
            result[f"{wanted} in {memory}"] = runs
            faces, out = faces_in(runs[0]), faces_out(runs[0])
            seconds, peak = median(runs, "seconds"), median(runs, "peak_bytes")
            table.add(short(wanted), memory, out, seconds, 1e9 * seconds / faces,
                      1e9 * median(runs, "cpu_seconds") / faces, round(peak / MIB), peak / out,
                      runs[0]["report"]["spilled_bytes"] / 1e6)
            times.setdefault(memory, []).append((wanted, 1e9 * seconds / faces))
            peaks.setdefault(memory, []).append((wanted, peak / MIB))
    table.print()
    plot.write(bench.plots / "output.svg", [
        (f"Time a face, {short(options.faces)} faces in",
         "ns an input face, by faces of the output", times),
        (f"Peak memory, {short(options.faces)} faces in", "MiB, by faces of the output", peaks)],
        short)
    return result


def section_spill(bench):
    """Spilling against not spilling, 10 %"""
    options = bench.options
    source = bench.generate(options.faces)
    warm(source)
    cell = repr(bench.cluster(source, "--ratio", "10%")["report"]["cell_size"])
    runs = bench.in_turn({budget: lambda budget=budget: bench.winnow(source, "--cell", cell,
                                                                     "--memory", budget)
                          for budget in (options.large_memory, options.small_memory)})
    table = Table("--memory", "seconds", "times", "spilled MB", "scratch bytes an input face",
                  "peak MiB")
    for budget, found in runs.items():
        if isinstance(found, str):
            table.fail(budget, found)
            continue
        spilled = found[0]["report"]["spilled_bytes"]
        table.add(budget, median(found, "seconds"), ratio(found, runs[options.large_memory]),
                  spilled / 1e6,
                  spilled / faces_in(found[0]), round(median(found, "peak_bytes") / MIB))
    table.print()
    return runs
