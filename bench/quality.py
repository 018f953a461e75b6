"""Sections of bench/run: how far small meshes are from their originals, by `winnow compare`, and
that itself."""

import os
import shutil

from bench import PEERS, VARIANTS, faces_in, faces_out, real_meshes
from harness import MIB, Failed, Table, measure, mebibytes, median, ratio, short, warm
from progressive import measure_progressive
from speed import print_against


def section_collapse(bench):
    """Edge collapse, 1 %, warm: time, memory, and what is lost"""
    options = bench.options
    result = {}
    for source in (bench.generate(options.collapse_faces), *real_meshes(options.data, 2)):
        warm(source)
        share = options.collapse_ratio
        learned = bench.winnow(source, "--ratio", share)
        kept = {}  # name -> its mesh, for the judge

        def candidate(name, command, target, source=source, kept=kept):
            kept[name] = target
            return lambda: measure(command, address_limit=bench.peer_limit,
                                   timeout=options.collapse_timeout)

        candidates = {}
        for i, (name, arguments) in enumerate(VARIANTS.items()):
            target = bench.work / f"variant-{i}.ply"
            candidates[name] = candidate(
                name, [options.winnow, "simplify", source, "-o", target, "--force", "--json",
                       "--threads", options.threads, "--ratio", share, *arguments], target)
        failures = {}
        for peer in options.collapse_peers:
            name, target = PEERS[peer][0], bench.work / f"peer-{peer}.ply"
            try:
                candidates[name] = candidate(name, bench.peer_command(peer, source,
                                                                      faces_out(learned), target),
                                             target)
            except Failed as failure:
                failures[name] = str(failure)
        runs = bench.in_turn(candidates) | failures
        print(f"**{source.name}**, {faces_in(learned)} faces to {share}, "
              f"{options.threads} threads for winnow:\n")
        print_against(runs)
        result[source.name] = {name: {"cluster_passes": found} for name, found in runs.items()}
        table = Table("program", "faces", "RMS % of the diagonal", "max %", "flipped",
                      "non-manifold edges")
        for name, found in runs.items():
            if isinstance(found, str):
                table.fail(name, found)
                continue
            try:
                judged = bench.compare(source, kept[name], "--memory",
                                       options.large_memory)["report"]
            except Failed as failure:
                table.fail(name, failure)
                continue
            both, topology = judged["distance"]["symmetric"], judged["topology"]
            table.add(name, judged["simplified"]["faces"], both["rms_percent"], both["max_percent"],
                      topology["flipped"], topology["non_manifold_edges"])
            result[source.name][name]["judged"] = judged
        table.print()
        for path in kept.values():
            path.unlink(missing_ok=True)
    return result


def section_levels(bench):
    """Several results in one run, and a progressive file, beside a run for each"""
    options = bench.options
    result = {}
    shares = ["50%", "10%", "1%", "0.1%"]
    for source in (bench.generate(options.fidelity_faces), *real_meshes(options.data)):
        warm(source)
        together = measure([options.winnow, "simplify", source, "-o",
                            bench.work / "level-{ratio}.ply", "--ratio", ",".join(shares),
                            "--threads", options.threads, "--force", "--json"])
        table = Table("share", "faces", "RMS % of the diagonal", "of a run of its own", "relative")
        alone_seconds = 0
        for share, level in zip(shares, together["report"]["levels"]):
            alone = bench.winnow(source, "--ratio", share)
            alone_seconds += alone["seconds"]
            rms = [bench.compare(source, name)["report"]["distance"]["symmetric"]["rms_percent"]
                   for name in (level["output"]["file"], bench.out)]
            table.add(share, level["output"]["faces"], *rms, rms[0] / rms[1])
            os.unlink(level["output"]["file"])
            result.setdefault(source.name, {})[share] = rms
        print(f"**{source.name}**, {faces_in(together)} faces: {together['seconds']:.2f} s "
              f"together, {alone_seconds:.2f} s one by one:\n")
        table.print()
        result[source.name]["seconds"] = [together["seconds"], alone_seconds]
        result[source.name]["progressive"] = measure_progressive(bench, source, shares)
    return result


def section_fit(bench):
    """Fitting to the original: distance and time of 0 to 3 passes"""
    options = bench.options
    result = {}
    for source in (bench.generate(options.fidelity_faces), *real_meshes(options.data)):
        warm(source)
        print(f"**{source.name}**:\n")
        table = Table("share", "passes", "RMS % of the diagonal", "relative", "max %", "relative",
                      "flipped", "s", "relative")
        result[source.name] = {}
        for share in ("10%", "1%"):
            passes = {fit: [] for fit in ("0", "1", "2", "3")}
            runs = bench.in_turn({fit: lambda fit=fit, share=share:
                                  bench.winnow(source, "--ratio", share, "--fit", fit)
                                  for fit in passes})
            for fit in passes:
                bench.winnow(source, "--ratio", share, "--fit", fit)
                judged = bench.compare(source, bench.out)["report"]
                both = judged["distance"]["symmetric"]
                found = [both["rms_percent"], both["max_percent"], median(runs[fit], "seconds")]
                passes[fit] = found
                base = passes["0"]
                table.add(share, fit, found[0], found[0] / base[0], found[1], found[1] / base[1],
                          judged["topology"]["flipped"], found[2],
                          ratio(runs[fit], runs["0"]))
            result[source.name][share] = passes
        table.print()
    return result


def section_fidelity(bench):
    """Distance to the original at the same face count (% of the box diagonal)"""
    options = bench.options
    result = {}
    for source in (bench.generate(options.fidelity_faces), *real_meshes(options.data)):
        share = options.fidelity_ratio
        learned = bench.winnow(source, "--ratio", share)["report"]
        faces = learned["output"]["faces"]
        target = bench.work / "peer.ply"
        print(f"**{source.name}**, {learned['input']['faces']} faces to {share}:\n")
        table = Table("program", "faces",
                      *(f"{way} {what}" for way in ("forward", "backward", "both") for what in
                        ("mean", "RMS", "max")),
                      "duplicate", "flipped", "non-manifold edges", "boundary edges")
        candidates = {}
        for name, arguments in VARIANTS.items():
            candidates[name] = lambda arguments=arguments: (
                bench.winnow(source, "--ratio", share, *arguments), bench.out)[1]
        for peer in options.fidelity_peers:
            candidates[PEERS[peer][0]] = lambda peer=peer: (
                measure(bench.peer_command(peer, source, faces, target),
                        address_limit=bench.peer_limit,
                        timeout=options.collapse_timeout), target)[1]
        result[source.name] = {}
        for name, make in candidates.items():
            try:
                found = bench.compare(source, make(), "--memory", options.large_memory)["report"]
            except Failed as failure:
                table.fail(name, failure)
                continue
            distances = [found["distance"][way][key] for way in ("forward", "backward", "symmetric")
                         for key in ("mean_percent", "rms_percent", "max_percent")]
            topology = found["topology"]
            table.add(name, found["simplified"]["faces"], *distances, topology["duplicate"],
                      topology["flipped"], topology["non_manifold_edges"],
                      topology["boundary_edges"])
            result[source.name][name] = found
        table.print()
    return result


def section_compare(bench):
    """`winnow compare` itself: an original against its small mesh, in a budget"""
    options = bench.options
    table = Table("original", "simplified", "--memory", "seconds", "CPU s", "ns an original face",
                  "peak MiB", "within +32 MiB", "RMS %")
    result = {}
    for faces in options.compare_faces:
        source = bench.generate(faces)
        small = bench.work / "small.ply"
        bench.winnow(source, "--faces", min(faces // 100,
                                            500_000))  # the small mesh must fit into the budget
        shutil.move(bench.out, small)
        warm(source)
        runs = [bench.compare(source, small, "--memory", options.compare_memory)
                for _ in range(options.rounds)]
        report, peak = runs[0]["report"], median(runs, "peak_bytes")
        seconds = median(runs, "seconds")
        table.add(f"{short(faces)}, {os.path.getsize(source) / 1e9:.3g} GB",
                  report["simplified"]["faces"],
                  options.compare_memory, seconds, median(runs, "cpu_seconds"),
                  1e9 * seconds / faces,
                  round(peak / MIB), "yes" if peak <= (mebibytes(options.compare_memory) + 32) * MIB
                  else "NO", report["distance"]["symmetric"]["rms_percent"])
        result[faces] = runs
        small.unlink()
    table.print()
    return result



def section_ratios(bench):
    """Time and error by ratio, warm: winnow and edge collapse"""
    options = bench.options
    source = bench.generate(options.ratio_faces)
    warm(source)
    table = Table("ratio", "program", "faces", "seconds", "of winnow's", "peak MiB",
                  "RMS % of the diagonal", "max %")
    result = {}
    for share in options.ratios:
        faces = round(float(share.rstrip("%")) / 100 * options.ratio_faces)
        judged = {}

        def candidate(name, run, judged=judged):
            def run_and_judge():
                found = run()
                if name not in judged:
                    judged[name] = bench.compare(source, bench.out, "--memory",
                                                 options.large_memory)["report"]
                return found
            return run_and_judge

        candidates = {}
        for name in ("winnow", "winnow, full detail"):
            arguments = VARIANTS[name]
            candidates[name] = candidate(name, lambda arguments=arguments: bench.winnow(
                source, "--ratio", share, *arguments, "--memory", options.large_memory))
        for peer in options.ratio_peers:
            name = PEERS[peer][0]
            candidates[name] = candidate(name, lambda peer=peer: measure(
                bench.peer_command(peer, source, faces, bench.out),
                timeout=options.collapse_timeout))
        runs = bench.in_turn(candidates)
        for name, found in runs.items():
            if isinstance(found, str):
                table.add(share, name, f"failed: {found}", "", "", "", "", "")
                continue
            both = judged[name]["distance"]["symmetric"]
            table.add(share, name, faces_out(found[0]), median(found, "seconds"),
                      ratio(found, runs["winnow"]),
                      max(run["peak_bytes"] for run in found) / MIB, both["rms_percent"],
                      both["max_percent"])
        result[share] = {"cluster_passes": runs, "judged": judged}
    table.print()
    return result
