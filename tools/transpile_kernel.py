"""Translate the kernel's Python modules to C: wrcontact/kernel/*.py -> wrcontact/kernel/generated/.

    python tools/transpile_kernel.py            write the C files
    python tools/transpile_kernel.py --check    write nothing; exit 1 if the files are not up to date

A developer's tool, with nothing but Python's own library. The C files are committed, so that installing needs a C
compiler only. They depend on the modules alone.

The steps are the files of tools/transpile: ``modules`` reads the Python, with its records lowered to offsets
(lower_records.py) and its derivatives beside it (tools/differentiate); ``emit`` writes the C of each function,
``tidy`` what stands around functions, and ``units`` all files.

* ``Final`` constants become ``static const`` definitions in a header, with the value that Python gives them. The
  compiler can fold them, and nothing has to be initialised at run time, where threads could race.
* Functions are ``static``, in the order of the Python source, each under its docstring. Four translation
  units include them: ``unit.c`` holds a step, ``prepare_unit.c`` what lays out the tables once,
  ``sections_unit.c`` the search over rails whose section changes, ``changing_unit.c`` a step on them, ``derivative_unit.c`` the derivatives. What is marked ``@seldom`` is not inlined, ``@inlined`` always, and
  ``@native`` stands in native/spans.h (kernel/layout/record.py).
* ``unit.c`` also defines the fingerprint of the modules (wrcontact/kernel/binding/files.py).

Python that would be something else in C is refused, with the line: a name that changes its kind; ``else`` after
a loop; a loop that changes its own variable, or whose variable is read after it; powers, and what of math is
not exact (the room elementary has functions with the same bits everywhere); a module variable that is not
``Final``; a call of anything that the kernel, spans.h and a few exact functions of math.h do not define.
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

# found through the line above
from differentiate.modules import Kernel  # noqa: E402
from transpile.emit import emitted  # noqa: E402
from transpile.modules import (  # noqa: E402
    FILES,
    KERNEL,
    Module,
    Refused,
    flat_name,
    import_kernel,
    read_modules,
    source_modules,
)
from transpile.tidy import definition  # noqa: E402
from transpile.units import assemble, constant_values  # noqa: E402

#: Also for the tests and for other tools.
__all__ = [
    "FILES",
    "KERNEL",
    "Kernel",
    "Module",
    "Refused",
    "assemble",
    "constant_values",
    "definition",
    "emitted",
    "flat_name",
    "import_kernel",
    "main",
    "read_modules",
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
        files = translate(options.kernel)
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


def translate(kernel, derivatives=True):
    """Text of every generated file by name, from the modules in the folder ``kernel``; without ``derivatives``
    only what steps and preparation include."""
    return assemble(kernel, read_modules(kernel, derivatives), derivatives)


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
