"""Running programs as whole processes and measuring them, for bench/run."""

import json
import os
import pathlib
import platform
import re
import resource
import signal
import statistics
import subprocess
import tempfile
import threading
import time

MIB = 1 << 20


class Failed(Exception):
    """A program ended badly; the text is its last words."""


def count(text):
    """31M -> 31000000."""
    suffixes = {"k": 10**3, "M": 10**6, "G": 10**9}
    return round(float(text.rstrip("kMG")) * suffixes.get(text[-1], 1))


def short(number):
    """31000000 -> 31M."""
    for size, suffix in ((10**9, "G"), (10**6, "M"), (10**3, "k")):
        if number >= size and number % (size // 10) == 0:
            return f"{number / size:g}{suffix}"
    return str(number)


def mebibytes(text):
    """256M -> 256, 8G -> 8192: a budget as winnow reads it."""
    return int(float(text[:-1]) * {"M": 1, "G": 1024}[text[-1]])


def without_directories(text, command):
    """The text with the command's files by bare names: where they lie is nobody's business."""
    for word in command:
        if os.sep in word:
            text = text.replace(word, os.path.basename(word))
    return text


def descendants(pid):
    """A process and all that it started."""
    found = [pid]
    for one in found:
        try:
            for task in pathlib.Path(f"/proc/{one}/task").iterdir():
                found += map(int, (task / "children").read_text().split())
        except OSError:  # it has ended meanwhile
            pass
    return found


def unreclaimable(pid):
    """Resident bytes of a process and all that it started which the kernel cannot drop.

    No file is behind them.
    """
    total = 0
    for one in descendants(pid):
        try:
            status = pathlib.Path(f"/proc/{one}/status").read_text()
        except OSError:
            continue
        total += sum(int(kib) for kib in re.findall(r"^Rss(?:Anon|Shmem):\s+(\d+)", status, re.M))
    return total * 1024


class Guard:
    """Ends a process, and all that it started, that takes too long or holds too much memory.

    It says which it was. The memory is what a memory cgroup without swap would count against it
    (less the kernel's own part), looked at every few milliseconds: no right to make cgroups is
    needed, and memory that is asked for but never touched costs nothing, unlike under RLIMIT_DATA
    or RLIMIT_AS.
    """

    def __init__(self, pid, seconds, resident_bytes):
        self.reason = None
        self.ended = threading.Event()
        self.arguments = pid, seconds, resident_bytes
        self.thread = threading.Thread(target=self.watch, daemon=True)
        if seconds or resident_bytes:
            self.thread.start()

    def watch(self):
        pid, seconds, resident_bytes = self.arguments
        start = time.perf_counter()
        while not self.ended.wait(0.005 if resident_bytes else 0.1):
            if seconds and time.perf_counter() - start > seconds:
                self.reason = f"did not finish in {seconds:g} s"
            elif resident_bytes and unreclaimable(pid) > resident_bytes:
                self.reason = "needs more memory"
            if self.reason:
                os.killpg(pid, signal.SIGKILL)
                return

    def stop(self):
        """The process has ended but is not yet forgotten: its number is still its own."""
        self.ended.set()
        if self.thread.is_alive():
            self.thread.join()


def measure(command, feed=None, address_limit=None, resident_limit=None, timeout=None):
    """Runs a command to its end: its seconds, CPU seconds, peak resident set, and its JSON.

    `feed` is a command whose output is piped in; only the fed process is measured. The kernel
    counts the peak from before exec, so nothing smaller than this script (about 20 MiB) can be
    seen. `address_limit` bounds all addresses, `resident_limit` the resident memory that no file is
    behind, `timeout` the seconds.
    """
    def limit():
        if address_limit:
            resource.setrlimit(resource.RLIMIT_AS, (address_limit, address_limit))

    command = [str(word) for word in command]
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as errors:
        feeder = subprocess.Popen([str(w) for w in feed], stdout=subprocess.PIPE) if feed else None
        start = time.perf_counter()
        process = subprocess.Popen(command, stdin=feeder.stdout if feeder else subprocess.DEVNULL,
                                   stdout=out,
                                   stderr=errors, preexec_fn=limit, start_new_session=True)
        if feeder:
            feeder.stdout.close()
        guard = Guard(process.pid, timeout, resident_limit)
        try:
            os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)
        except KeyboardInterrupt:  # which the process, in a session of its own, has not seen
            os.killpg(process.pid, signal.SIGKILL)
            raise
        seconds = time.perf_counter() - start
        guard.stop()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if feeder:
            feeder.wait()
        if guard.reason:
            raise Failed(guard.reason)
        out.seek(0)
        errors.seek(0)
        said = errors.read().decode(errors="replace").strip().splitlines()
        if process.returncode != 0:
            code = process.returncode
            ending = f"exit code {code}" if code > 0 else f"killed by signal {-code}"
            raise Failed(without_directories(said[-1], command) if said else ending)
        text = without_directories(out.read().decode(), command)
    return {"command": without_directories(" ".join(command), command), "seconds": seconds,
            "cpu_seconds": usage.ru_utime + usage.ru_stime, "peak_bytes": usage.ru_maxrss * 1024,
            "report": json.loads(text) if text.lstrip().startswith("{") else None}


def drop_from_cache(path):
    """Leaves nothing of a file in the page cache; says which share stayed all the same."""
    with open(path, "rb") as file:
        os.fsync(file.fileno())
        os.posix_fadvise(file.fileno(), 0, 0, os.POSIX_FADV_DONTNEED)
    stayed = subprocess.run(["fincore", "--bytes", "--noheadings", "--output", "RES", str(path)],
                            capture_output=True, text=True, check=True).stdout
    return int(stayed or 0) / os.path.getsize(path)


def warm(path):
    with open(path, "rb") as file:
        while file.read(4 * MIB):
            pass


def median(runs, key):
    return statistics.median(run[key] for run in runs)


def ratio(runs, base, key="seconds"):
    """Median of the rounds' ratios.

    A program that was run less often is held against the same rounds.
    """
    return statistics.median(a[key] / b[key] for a, b in zip(runs, base))


class Table:
    def __init__(self, *heads):
        self.rows = [heads]

    def add(self, *cells):
        self.rows.append([str(round(cell)) if isinstance(cell, float) and cell >= 1000 else
                          f"{cell:.3g}" if isinstance(cell, float) else str(cell)
                          for cell in cells])

    def fail(self, name, reason):
        self.add(name, f"failed: {reason}", *[""] * (len(self.rows[0]) - 2))

    def print(self):
        for i, row in enumerate(self.rows):
            print("| " + " | ".join(row) + " |")
            if i == 0:
                print("|" + "---|" * len(row))
        print(flush=True)


def cpu_model():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()
