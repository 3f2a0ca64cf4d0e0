"""Compile the kernel in place, for developers: ``python tools/compile_kernel.py`` after
tools/transpile_kernel.py.

    --folder DIR        write the library there instead of into wrcontact/kernel
    --check-bounds      end the program if an index is outside its array
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "build_hooks"))

from kernel_compiler import KERNEL, CompilerProblem, compile_library  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--folder", type=Path, default=KERNEL)
    parser.add_argument("--check-bounds", action="store_true")
    options = parser.parse_args()
    try:
        print(compile_library(options.folder, extra_flags=["-DWRCONTACT_CHECK_BOUNDS"] if options.check_bounds
                              else []))
    except (CompilerProblem, OSError) as problem:
        sys.exit(str(problem))


if __name__ == "__main__":
    main()
