"""Compile the kernel in place, for developers: ``python tools/compile_kernel.py`` after
tools/transpile_kernel.py.

    --folder DIR        write the library there instead of into wrcontact/kernel
    --check-bounds      end the program if an index is outside its array
    --quick             with less optimising: the same bits, in half the time
    --without-derivatives   steps and preparation alone, in a quarter of the time
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from wrcontact.kernel.binding.compiler import (  # noqa: E402
    KERNEL_UNITS,
    STEP_UNITS,
    CompilerProblem,
    compile_library,
)
from wrcontact.kernel.binding.files import HERE  # noqa: E402


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--folder", type=Path, default=HERE)
    parser.add_argument("--check-bounds", action="store_true")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--without-derivatives", action="store_true")
    options = parser.parse_args()
    flags = ["-DWRCONTACT_CHECK_BOUNDS"] * options.check_bounds + ["-O1"] * options.quick
    try:
        units = STEP_UNITS if options.without_derivatives else KERNEL_UNITS
        print(compile_library(options.folder, extra_flags=flags, units=units))
    except (CompilerProblem, OSError) as problem:
        sys.exit(str(problem))


if __name__ == "__main__":
    main()
