"""The command line of build_fmu.py."""

import argparse
import sys

from ..kernel.binding.platforms import PLATFORMS
from ..profiles.options import ENDINGS, WORDS, ProfileFile, parsed
from ..profiles.remarks import remarks_in_lines
from ..storage.atomic import sentence_of
from .build import build_fmu
from .compilers import has_zig
from .native import build_native_fmus


def main(arguments=None):
    """The command line of build_fmu.py; returns the exit code."""
    parser = argparse.ArgumentParser(prog="build_fmu.py",
                                     description="Pack the FMU of a wheelset on track and print its path.")
    parser.add_argument("--output", metavar="DIR", default="dist", help="folder of the FMU (default: dist)")
    for kind in ("wheel", "rail"):
        meaning = f"{kind} profile to pack and use as the default: a file of points in mm, or a built-in name"
        parser.add_argument(f"--{kind}", metavar="FILE", help=meaning)
        _add_file_options(parser, kind)
    parser.add_argument("--smoothing-um", metavar="NUMBER", type=float,
                        help="smoothing of measured points: root mean square distance between the curve and "
                             "the points, in um (default: their estimated noise; 0: no smoothing)")
    parser.add_argument("--native", action="store_true",
                        help="pack the two native FMUs instead, for FMI 2.0 and FMI 3.0, which need no "
                             "Python")
    names = ", ".join(PLATFORMS)
    parser.add_argument("--platforms", metavar="NAME[,NAME]",
                        help=f"platforms of the native FMUs: by default this machine's; or any of {names}; "
                             "or all. Other platforms than this machine's need ziglang")
    chosen = vars(parser.parse_args(arguments))
    native, platforms = chosen.pop("native"), chosen.pop("platforms")
    if platforms and not native:
        parser.error("--platforms is permitted only with --native")
    smoothing = chosen.pop("smoothing_um")
    for kind in ("wheel", "rail"):
        given = {name: chosen.pop(f"{kind}_{name}", None) for name in ENDINGS}
        given = {name: value for name, value in given.items() if value is not None}
        if given and chosen[kind] is None:
            parser.error(f"--{kind}-{ENDINGS[next(iter(given))]} is permitted only with --{kind} FILE")
        chosen[kind] = ProfileFile(chosen[kind], **given) if given else chosen[kind]
    chosen["smoothing"] = None if smoothing is None else 1e-6 * smoothing
    if has_zig():
        print("compiling with ziglang; the first build for a platform takes up to two minutes",
              file=sys.stderr)
    try:
        with remarks_in_lines("build_fmu.py"):
            print(*_built(native, platforms, chosen), sep="\n")
    except (ValueError, OSError) as problem:
        print(f"build_fmu.py: {sentence_of(problem) if isinstance(problem, OSError) else problem}",
              file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("build_fmu.py: interrupted; no file is half written", file=sys.stderr)
        return 130
    return 0


def _add_file_options(parser, kind):
    """Add the options on how the file of a ``kind`` of profile is read."""
    for name in ENDINGS:
        if name == "file_inclination" and kind == "wheel":
            continue
        flag, target = f"--{kind}-{ENDINGS[name]}", f"{kind}_{name}"
        if name.startswith("mirror"):
            parser.add_argument(flag, dest=target, help=WORDS[name], action=argparse.BooleanOptionalAction)
        else:
            parser.add_argument(flag, dest=target, help=WORDS[name], type=_reader(name),
                                metavar="Y,Z" if name == "shift" else "VALUE")


def _reader(name):
    """The function that reads the text of an option."""
    def read(text):
        try:
            return int(text) if name == "select" and text.isdecimal() else (
                text if name == "select" else parsed(name, text))
        except ValueError as wrong:
            raise argparse.ArgumentTypeError(str(wrong)) from None

    return read


def _built(native, platforms, chosen):
    """Build the requested FMUs and return their paths."""
    if not native:
        return [build_fmu(**chosen)]
    names = list(PLATFORMS) if platforms == "all" else platforms and platforms.split(",")
    return build_native_fmus(**chosen, platforms=names)
