"""What shows how far a call is."""

import sys


class ProgressBar:
    """Shows progress on standard error: by tqdm where it is there, else as a line of text."""

    def __init__(self):
        try:
            from tqdm.auto import tqdm  # type: ignore[import]
        except ImportError:
            tqdm = None
        self._tqdm = tqdm
        self._bar = None
        self._stage = None

    def __call__(self, stage, done, total, unit):
        if stage != self._stage:
            self.close()
            self._stage = stage
            if self._tqdm is not None:
                count = {"total": total or None, "unit": " " + unit, "unit_scale": True}
                self._bar = self._tqdm(desc=stage, **count)
        if self._bar is not None:
            self._bar.update(done - self._bar.n)
        else:
            share = f"{100 * done / total:3.0f} %" if total else f"{done} {unit}"
            print(f"\r{stage} {share}", end="", file=sys.stderr, flush=True)

    def close(self):
        """Ends the line that is shown."""
        if self._bar is not None:
            self._bar.close()
        elif self._stage is not None:
            print(file=sys.stderr)
        self._bar = self._stage = None


def progress_bar():
    """A bar for `progress=`: by tqdm where that is installed, else a line on standard error.

    >>> bar = progress_bar()
    >>> bar.close()
    """
    return ProgressBar()
