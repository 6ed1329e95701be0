"""Progress of many runs."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

#: A function of the number of runs that are done.
Advance = Callable[[int], object]


@contextmanager
def shown(progress: bool | Callable[[int, int], object], total: int) -> Iterator[Advance | None]:
    """Shows the progress of ``total`` runs while it is open."""
    if progress is False or progress is None:
        yield None
    elif progress is not True:
        yield lambda done: progress(done, total)
    else:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            line = Line(total)
            try:
                yield line.show
            finally:
                line.end()
        else:
            with tqdm(total=total, unit="run") as bar:
                yield lambda done: bar.update(done - bar.n)


class Line:
    """One line on the standard error, with the number of runs, their rate and the time that is left."""

    def __init__(self, total: int) -> None:
        self._total, self._began_s = total, time.monotonic()
        self._is_written = False

    def show(self, done: int) -> None:
        """Writes the line again."""
        spent_s = max(time.monotonic() - self._began_s, 1e-9)
        rate = done / spent_s
        left = f", {(self._total - done) / rate:.0f} s left" if 0 < done < self._total else ""
        sys.stderr.write(f"\r{done} of {self._total} runs, {rate:.1f} runs/s{left}\x1b[K")
        sys.stderr.flush()
        self._is_written = True

    def end(self) -> None:
        """Ends the line."""
        if self._is_written:
            sys.stderr.write("\n")
