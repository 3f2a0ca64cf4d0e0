"""Translate the kernel's Python modules to C: wrcontact/kernel/*.py -> wrcontact/kernel/generated/.

    python tools/transpile_kernel.py            write the C files
    python tools/transpile_kernel.py --check    write nothing; exit 1 if the files are not up to date

What has not changed since it was last translated by the first command is not translated again (cache.py).

A developer's tool: it needs Pyccel (``pip install ".[dev]"``, which needs gcc and gfortran). The C files are
committed, so that installing needs a C compiler only. The output depends on the modules and on Pyccel's
version, on nothing else.

What Pyccel writes is tidied like this:

* ``Final`` constants become ``static const`` definitions in the header, with the value that Python gives
  them. The compiler can fold them, and nothing has to be initialised at run time (where threads could race):
  ``<module>__init`` is gone, and the wrappers for CPython with it.
* Headers include ``native/spans.h`` and each other, instead of Pyccel's own library of containers.
* Functions are ``static``, in the order of the Python source, each under its docstring. Three translation
  units include them: ``unit.c`` holds a step, ``prepare_unit.c`` what lays out the tables once,
  ``derivative_unit.c`` the derivatives, which tools/differentiate writes. What is marked ``@seldom`` is not
  inlined, ``@inlined`` always, and ``@native`` stands in spans.h (kernel/layout/record.py). Locals that
  Pyccel adds and nobody reads go.
* ``unit.c`` also defines the fingerprint of the modules (wrcontact/kernel/binding/files.py).

The steps are the files of tools/transpile: ``modules`` reads the Python, ``translator`` runs Pyccel, ``tidy``
writes the C of one module, ``lanes`` gives rates their type, and ``units`` writes all files.

Before Pyccel the end of a range gets a name (``for k in range(int(work[3]))`` ends at ``k_end``) where the
loop might change it: C reads it anew in each turn, Python once.

Other Python that Pyccel translates to something else without a word is refused, with the line: ``else`` after
a loop; a loop that changes its own variable, or whose variable is read after it; powers, and what of math is
not exact (the room elementary has functions with the same bits everywhere); a slice as an argument; a module
variable that is not ``Final``; a call of anything that spans.h and a few exact functions of math.h do not
define.
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

# found through the line above
from transpile.cache import translated  # noqa: E402
from transpile.modules import FILES, KERNEL, Module, Refused, flat_name, read_modules, source_modules  # noqa: E402
from transpile.translator import run_pyccel  # noqa: E402
from transpile.units import assemble  # noqa: E402

#: Also for the tests and for other tools.
__all__ = [
    "FILES",
    "KERNEL",
    "Module",
    "Refused",
    "assemble",
    "flat_name",
    "main",
    "read_modules",
    "run_pyccel",
    "source_modules",
    "translate",
]


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--check", action="store_true", help="write nothing; exit 1 if the C files are not up to date"
    )
    parser.add_argument("--kernel", type=Path, default=KERNEL, help="folder of the kernel's modules")
    options = parser.parse_args(arguments)
    try:
        files = translate(options.kernel, fresh=options.check)
    except Refused as refusal:
        sys.exit(f"The kernel was not translated: {refusal}")
    generated = options.kernel / "generated"
    stale = stale_files(files, generated)
    if not options.check:
        write(files, generated)
        print(f"{len(files)} files in {generated}, {len(stale)} of them changed")
    elif stale:
        sys.exit(
            "The generated C is not what the kernel's Python gives; run tools/transpile_kernel.py. "
            f"Stale: {', '.join(stale)}"
        )
    else:
        print(f"The {len(files)} generated files are up to date.")


def translate(kernel, fresh=True):
    """Text of every generated file by name, from the modules in the folder ``kernel``; what is not ``fresh``
    may come from an earlier translation."""
    modules = read_modules(kernel)
    return assemble(kernel, modules, translated(modules, fresh))


def stale_files(files, generated):
    """Names that are missing, superfluous or different in the folder ``generated``."""
    present = {path.name: path.read_bytes() for path in generated.glob("*.[ch]")}
    wanted = {name: text.encode() for name, text in files.items()}
    return sorted(name for name in present.keys() | wanted.keys() if present.get(name) != wanted.get(name))


def write(files, generated):
    """Make the folder ``generated`` hold exactly ``files``."""
    generated.mkdir(exist_ok=True)
    for path in generated.glob("*.[ch]"):
        if path.name not in files:
            path.unlink()
    for name, text in files.items():
        (generated / name).write_bytes(text.encode())


if __name__ == "__main__":
    main()
