"""What every change must pass, on a clean copy of the files that git tracks.

Both commands of the README; the full tests with everything installed that wrcontact can use; the tests of stored
numbers as on another processor; the generated C; planted errors; FMUs for every platform.  A step that fails does
not end the run: the end lists all failures, each with the command that repeats it in a checkout.  Only what leaves
nothing to run ends it at once: a missing package, or no installation.

The seconds of each step are printed at the end and kept in the user's cache, ``wrcontact/ci_seconds.csv``;
WRCONTACT_CI_SECONDS names another file.
"""

import codecs
import contextlib
import csv
import io
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import traceback
from collections import Counter, namedtuple
from concurrent.futures import ThreadPoolExecutor
from datetime import datetime, timezone
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.helpers.turns import CHANGED, changed_paths, due  # noqa: E402  found through the line above

#: What is kept from run to run, here and by the tests.
CACHE = Path(os.path.expanduser(os.environ.get("XDG_CACHE_HOME") or "~/.cache"), "wrcontact")
#: The README's commands, to the letter: if one changes, so must the other.
INSTALL = "python3 -m venv .venv && .venv/bin/pip install -q"
DEMO = f"{INSTALL} . && .venv/bin/wrcontact demo"
TESTS = f'{INSTALL} ".[test]" && .venv/bin/python -m pytest -q -n auto --dist worksteal'

PYTHON = ".venv/bin/python"
PYTEST = (PYTHON, "-m", "pytest", "-q", "-n", "auto")
#: What is installed meets "wrcontact" already, so that pip adds what an extra needs and nothing else.
EXTRA = (PYTHON, "-m", "pip", "install", "-q", "--no-compile")
EXTRAS = ("cluster", "films", "site", "tables", "vehicle")
#: Extras that one file of tests wants, which does not run every day.
SELDOM = {
    "importers": "tests/fmu/test_importers.py",
    "types": "tests/docs/test_types.py",
    "engines": "tests/motion/test_engines.py",
}
#: The older processor: numpy and glibc without wide vectors and fused multiply-add.
OLDER = {
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX2_Usable,-FMA_Usable",
    "OPENBLAS_CORETYPE": "Haswell",
}
#: Measurements that take half of the seconds of all times, and long studies that tests/docs/test_tables.py repeats.
HALF, TESTED = ("model_times", "sweep"), ("halfspace", "conicity_noise")
FEATURES = (
    "import numpy._core._multiarray_umath as m; "
    "print(*(f for f in m.__cpu_dispatch__ if m.__cpu_features__[f]))"
)
COMPILED = (
    "import wrcontact.kernel.binding.library as library; library.default_kernel(); print(library.__file__)"
)
#: A test that has failed, and a line with which pytest ends.
FAILED = re.compile(r"(?:FAILED|ERROR) (\S+?\.py(?:::[^\[\s]+(?:\[.*?\])?)?)(?: - .*)?")
COUNTS = re.compile(r"=*\s*(?:\d+ [a-z]+,? ?)+in [\d.]+s.*")

Done = namedtuple("Done", "name told command code tests counts seconds cpu")


class Run:
    """Steps in a folder, one after the other; what has failed is told at the end."""

    def __init__(self, folder):
        self.folder, self.done, self.began = folder, [], time.monotonic()

    def step(self, name, command, **environment):
        """Run a command, a list of words or a line for bash, with more ``environment``; whether it has passed."""
        print(f"== {name} (after {time.monotonic() - self.began:.0f} s)", flush=True)
        self.done.append(self.ended(name, command, environment, sys.stdout))
        return self.done[-1].code == 0

    def together(self, steps):
        """Run several, {name: command}, one a core at a time; what each of them says is shown at its end."""
        print(f"== {', '.join(steps)} (after {time.monotonic() - self.began:.0f} s)", flush=True)

        def ended(name):
            shown = io.StringIO()
            done = self.ended(name, steps[name], {}, shown)
            print(f"-- {name}", shown.getvalue(), sep="\n", end="", flush=True)
            return done

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            self.done += pool.map(ended, steps)

    def ended(self, name, command, environment, screen):
        """What came of a command that is shown on ``screen``."""
        words = ["bash", "-c", command] if isinstance(command, str) else list(map(str, command))
        line = command if isinstance(command, str) else shlex.join(words)
        told = "".join(
            f"{key}={shlex.quote(str(value))} " for key, value in environment.items() if key != CHANGED
        )
        began = time.monotonic()
        code, text, cpu = self.shown(words, environment, screen)
        tests = [found[1] for found in map(FAILED.fullmatch, text.splitlines()) if found]
        counts = [line.strip("= ") for line in text.splitlines() if COUNTS.fullmatch(line)]
        if code:
            print(f"== {name} has failed with exit code {code}", file=screen, flush=True)
        last = counts[-1] if counts else ""
        return Done(name, told, line, code, tests, last, time.monotonic() - began, cpu)

    def shown(self, words, environment, screen):
        """Exit code, output and processor time [s] of a command, which is shown as it comes.  It goes through a
        file: a process that a test has left behind would keep a pipe open."""
        decoder, said = codecs.getincrementaldecoder("utf-8")("replace"), []
        with tempfile.TemporaryFile() as output, contextlib.ExitStack() as end:
            environment = os.environ | {key: str(value) for key, value in environment.items()}
            try:
                command = subprocess.Popen(
                    words,
                    cwd=self.folder,
                    env=environment,
                    stdin=subprocess.DEVNULL,
                    stdout=output,
                    stderr=subprocess.STDOUT,
                )
            except OSError as problem:
                print(problem, file=screen, flush=True)
                return 127, "", 0.0
            end.callback(command.kill)  # where this is ended meanwhile
            ended, place, cpu = False, 0, 0.0
            while True:
                new = os.pread(output.fileno(), 1 << 20, place)
                place += len(new)
                said.append(decoder.decode(new))
                print(said[-1], end="", file=screen, flush=True)
                if new:
                    continue
                if ended:
                    return command.returncode, "".join(said), cpu
                time.sleep(0.05)
                number, status, used = os.wait4(command.pid, os.WNOHANG)
                if number:  # with all the processes that it has waited for
                    command.returncode = os.waitstatus_to_exitcode(status)
                    ended, cpu = True, used.ru_utime + used.ru_stime

    def failed(self):
        return [done for done in self.done if done.code]

    def report(self):
        """All failures with what repeats them, the seconds of each step, and how the test runs ended."""
        lines = []
        if self.failed():
            lines += ["", "== what has failed, and what repeats it"]
        for done in self.failed():
            lines += [f"{done.name} (exit code {done.code}):", f"    {done.told}{done.command}"]
            for test in dict.fromkeys(done.tests):
                lines.append(f"    {done.told}{PYTHON} -m pytest -m '' {shlex.quote(test)}")
        lines += ["", "== seconds, and seconds of processors"]
        for done in self.done:
            lines.append(f"{done.seconds:7.0f} {done.cpu:7.0f}  {done.name}{' FAILED' * bool(done.code)}")
        seconds = time.monotonic() - self.began
        lines.append(f"{seconds:7.0f} {sum(done.cpu for done in self.done):7.0f}  all {len(self.done)} steps")
        lines += ["", "== tests"]
        lines += [f"{done.name}: {done.counts}" for done in self.done if done.counts]
        return "\n".join([*lines, self.counted(seconds)])

    def counted(self, seconds):
        """All test runs in pytest's words; a step that has failed without a test counts as an error."""
        sums = Counter()
        for done in self.done:
            found = {
                kind.rstrip("s"): int(count) for count, kind in re.findall(r"(\d+) ([a-z]+)", done.counts)
            }
            if done.code and not (found.get("failed") or found.get("error")):
                found["error"] = 1
            sums.update(found)
        kinds = ("failed", "passed", "skipped", "deselected", "error")
        return ", ".join(f"{sums[kind]} {kind}" for kind in kinds if sums[kind]) + f" in {seconds:.2f}s"

    def keep(self, file, commit):
        """Add the seconds to a table; where nothing can be written none is kept."""
        with contextlib.suppress(OSError, RuntimeError):
            path = Path(file).expanduser()
            path.parent.mkdir(parents=True, exist_ok=True)
            new = not path.exists()
            with open(path, "a", newline="", encoding="utf-8") as table:
                rows = csv.writer(table, lineterminator="\n")
                if new:
                    rows.writerow(("when", "commit", "step", "seconds", "cpu_seconds", "exit_code"))
                when = datetime.now(timezone.utc).isoformat(timespec="seconds")
                for done in self.done:
                    rows.writerow(
                        (when, commit, done.name, f"{done.seconds:.1f}", f"{done.cpu:.1f}", done.code)
                    )


def said(*words, folder=ROOT):
    """What a command writes."""
    return subprocess.run(words, cwd=folder, check=True, text=True, stdout=subprocess.PIPE).stdout


def refused():
    """A reason not to begin; None if there is none."""
    # The copy has what git tracks. What was forgotten would be in nobody's copy, and a new test would not be missed.
    folders = said("git", "ls-tree", "-d", "--name-only", "HEAD").split()
    forgotten = said("git", "ls-files", "--others", "--exclude-standard", "--", *folders).splitlines()
    if forgotten:
        names = " ".join(forgotten)
        return f"not tracked by git, so no other copy has them: {names} - git add them, or ignore them"
    readme = (ROOT / "README.md").read_text(encoding="utf-8").splitlines()
    missing = [command for command in (DEMO, TESTS) if command not in readme]
    return f"README.md does not show the command: {missing[0]}" if missing else None


def missing_packages():
    """Packages of Debian for what this machine does not have: the kernel wants gcc, tests want the rest."""

    def sanitized(kind):
        words = ["gcc", "-x", "c", f"-fsanitize={kind}", "-", "-o", os.devnull]
        done = subprocess.run(words, input=b"int main(void) { return 0; }", stderr=subprocess.DEVNULL)
        return done.returncode == 0

    def runs(program):
        return shutil.which(program) is not None

    if not (runs("gcc") and sanitized("address,undefined") and sanitized("thread")):
        yield from ("gcc", "libc6-dev")
    if subprocess.run(["python3", "-c", "import ensurepip"], stderr=subprocess.DEVNULL).returncode:
        yield "python3-venv"
    for program, package in (("localedef", "libc-bin"), ("chromium", "chromium"), ("setpriv", "util-linux")):
        if not runs(program):
            yield package
    if not (runs("qemu-aarch64") and Path("/usr/aarch64-linux-gnu/lib").is_dir()):
        yield from ("qemu-user", "libc6-arm64-cross")


def install(packages):
    """Install packages of Debian; whether that was possible."""
    if not shutil.which("apt-get"):
        print(f"please install {' '.join(packages)}: there is no apt-get here", file=sys.stderr)
        return False
    quiet = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    subprocess.run(["apt-get", "update", "-qq"], env=quiet)  # what is not up to date may do
    words = ["apt-get", "install", "-qq", "-y", "--no-install-recommends", *packages]
    return subprocess.run(words, env=quiet).returncode == 0


def copy_to(folder):
    """The files that git tracks, as they are here; not those deleted since."""
    for name in filter(None, said("git", "ls-files", "-z", "--cached").split("\0")):
        if os.path.lexists(ROOT / name):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, folder / name, follow_symlinks=False)


def all_steps(run, work, turn, changed):
    """The steps in their order."""
    run.together(  # the translation needs nothing but Python
        {
            "the README's demo": DEMO,
            "the generated C is that of the kernel's Python": [
                "python3",
                "tools/transpile_kernel.py",
                "--check",
            ],
        }
    )
    run.step("the README's tests", TESTS)
    if not (run.folder / ".venv" / "bin" / "pytest").exists():
        print("Without the installation nothing else can run.", flush=True)
        return
    run.step("ruff check", [PYTHON, "-m", "ruff", "check"])
    run.step("ruff format", [PYTHON, "-m", "ruff", "format", "--check", "-q"])
    run.step(
        "the kernel is compiled, not its fallback",
        [PYTHON, "-I", "-c", COMPILED],
        WRCONTACT_KERNEL="compiled",
    )
    extras = [*EXTRAS, *(extra for extra, tests in SELDOM.items() if due(tests, turn, changed))]
    single = {"what wrcontact can use is installed": [*EXTRA, f"wrcontact[{','.join(extras)}]"]}
    single["the tests see a share of the planted errors"] = [
        *(PYTHON, "-m", "tests.helpers.plant_errors"),
        *("--share", 4, "--turn", turn, "--workers", 1),
    ]
    run.together(single)  # each of them has one process
    if due("benchmarks", turn, changed):  # errors are measured by tests/docs/test_tables.py
        quick = (PYTHON, "-m", "benchmarks", "--quick")  # with what is installed now
        run.together(
            {
                "benchmarks of models run": [*quick, *HALF],
                "the other benchmarks run": [*quick, "times", "studies", "--without", *HALF, *TESTED],
            }
        )

    today = {"WRCONTACT_TURN": turn} | ({CHANGED: work / "changed"} if changed is not None else {})
    features = said(run.folder / PYTHON, "-c", FEATURES, folder=run.folder).strip()
    run.step(
        "stored numbers on an older processor",
        [*PYTEST, "--dist", "worksteal", "-m", "machine and not complete"],
        NPY_DISABLE_CPU_FEATURES=features,
        **OLDER,
        **today,
    )
    run.step(
        "the full tests",
        [*PYTEST, "--dist", "worksteal", "--durations", 60, "-m", "full and not platforms and not complete"],
        WRCONTACT_FUZZ_CALLS=30_000,
        WRCONTACT_IMPORTERS="all",
        **today,
    )
    if due("platforms", turn, changed):
        run.step("what builds for other machines is installed", [*EXTRA, "wrcontact[release]"])
        run.step(
            "FMUs and wheels for other machines",
            [*PYTEST, "--dist", "loadfile", "-m", "platforms and not complete"],
            **today,
        )


def compiled(work):
    """The folder of compiled sources that the tests keep; one in ``work`` where nothing can be kept."""
    folder = CACHE / "tests" / "compiled"
    with contextlib.suppress(OSError):
        folder.mkdir(parents=True, exist_ok=True)
    return folder if os.access(folder, os.W_OK) else work / "compiled"


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that the copy is removed
    reason = refused()
    packages = [] if reason else list(missing_packages())
    if packages and not install(packages):
        reason = f"not installed: {' '.join(packages)}"
    if reason:
        print(reason, file=sys.stderr)
        return 1
    commit, changed = said("git", "rev-parse", "--short", "HEAD").strip(), changed_paths(ROOT)
    turn = datetime.now(timezone.utc).timetuple().tm_yday
    with tempfile.TemporaryDirectory() as work:
        copy, work = Path(work, "copy"), Path(work)
        copy.mkdir()
        copy_to(copy)
        if changed is not None:
            (work / "changed").write_text("\n".join(changed), encoding="utf-8")
        os.environ |= {
            "WRCONTACT_SKIPS": "listed",
            # installations, benchmarks and tests compile the same sources once (tests/helpers/kept.py)
            "WRCONTACT_COMPILED": str(compiled(work)),
        }
        # in the copy Python may keep what it has compiled: a dozen processes read each test and each package
        os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
        run = Run(copy)
        try:
            all_steps(run, work, turn, changed)
        except Exception:  # what has been done is told nevertheless
            run.done.append(Done("the steps themselves", "", ".ci/run", 1, [], "", 0.0, 0.0))
            traceback.print_exc()
        run.keep(os.environ.get("WRCONTACT_CI_SECONDS") or CACHE / "ci_seconds.csv", commit)
        print(run.report(), flush=True)
    return 1 if run.failed() else 0


if __name__ == "__main__":
    sys.exit(main())
