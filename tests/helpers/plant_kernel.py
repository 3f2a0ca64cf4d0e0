"""The compiled kernels of copies that have an error: the same bits as those of tools/compile_kernel.py, in a fraction
of the time.

Without derivatives, which are four fifths of a kernel, the C of each room is a source of its own that declares what it
needs of the others: only rooms that differ are compiled anew.  With derivatives a copy is translated and compiled as
usual, with less optimising.  Libraries and what they are linked of are kept from run to run (kept.py).
"""

import hashlib
import re
import tempfile
from functools import cache
from pathlib import Path
from threading import Lock

from tests.helpers.kept import cache_folder
from wrcontact.kernel.binding.compiler import FLAGS, KERNEL_UNITS, find_compiler, linked
from wrcontact.kernel.binding.files import LIBRARY_NAME
from wrcontact.storage.atomic import write_atomically

#: What a library is made of, and what makes it.
SOURCES = ("wrcontact/kernel", "wrcontact/interface", "tools")
#: A copy is translated while no other one is: what has been read of one serves the next.
TRANSLATING = Lock()


def make_kernel(tree, derivatives=True):
    """Translate and compile the kernel of a copy; the generated C, of which its FMUs are, is written with
    ``derivatives`` alone."""
    kept = cache_folder(tree.parent) / "compiled"
    known = kept / f"{digest(tree, derivatives)}{Path(LIBRARY_NAME).suffix}"
    if not known.exists():
        write_atomically(known, library(tree, derivatives, kept))
    elif derivatives:
        translate(tree)
    known.touch()  # it is in use
    write_atomically(kernel(tree) / LIBRARY_NAME, known.read_bytes())


def library(tree, derivatives, kept):
    """The library of a copy, as bytes; what has been compiled stays in the folder ``kept``."""
    command = [*compiler(), *FLAGS, "-O1"]
    if derivatives:
        translate(tree)
        return linked(command, kernel(tree).parent, KERNEL_UNITS, LIBRARY_NAME, cache=kept)
    with tempfile.TemporaryDirectory() as folder:
        with TRANSLATING:
            files = apart(tree)
        for name, text in files.items():
            Path(folder, name).write_text(text, encoding="utf-8")
        sources = [name for name in files if name.endswith(".c")]
        return linked(command, folder, sources, LIBRARY_NAME, cache=kept)


def translate(tree):
    """Write the generated C of a copy."""
    from tools import transpile_kernel as tool

    with TRANSLATING:
        tool.write(tool.translate(kernel(tree)), kernel(tree) / "generated")


@cache
def compiler():
    return find_compiler()


def apart(tree):
    """Text of every file of C of steps and preparation, by name: a source for each room, which begins with
    what it needs of all others, and what is written by hand."""
    from tools import transpile_kernel as tool

    modules = tool.read_modules(kernel(tree), derivatives=False)
    known = tool.Kernel(modules)
    values = tool.constant_values(kernel(tree), modules)
    declared, rooms = {}, {}
    for module in modules:
        found = tool.emitted(known, module)
        for name, value in values[module.name].items():
            declared[f"{module.name}__{name}"] = tool.definition(f"{module.name}__{name}", value)
        declared |= {f"{module.name}__{name}": f"{head};" for name, (head, _) in found.items()}
        rooms.setdefault(module.room, []).extend(text for _, text in found.values())
    mark = f"#define WRCONTACT_KERNEL_FINGERPRINT INT64_C(0x{fingerprint(tree):015x})"
    files = {f"{room}.c": '#include "spans.h"\nHERE\n' + "\n\n".join(texts) for room, texts in rooms.items()}
    for path in (kernel(tree) / "native").glob("*.[ch]"):
        text = path.read_text(encoding="utf-8")
        if "derivative" not in path.name and "jacobian" not in path.name:
            files[path.name] = re.sub('#include "../generated/.*', f"{mark}\nHERE", text)
    for name, text in files.items():
        words = set(re.findall(r"\w+", text))
        lines = [line for word, line in declared.items() if word in words]
        files[name] = text.replace("HERE", "\n".join(lines), 1)
    return files


def fingerprint(tree):
    """What tells the kernel of a copy from others (wrcontact/kernel/binding/files.py)."""
    from tools.transpile_kernel import FILES, import_kernel

    return FILES["fingerprint"](kernel(tree), import_kernel(kernel(tree), "layout").digest())


def kernel(tree):
    return tree / "wrcontact" / "kernel"


def digest(tree, derivatives):
    """A hash of all that the library of a copy is made of."""
    found = hashlib.sha256(repr(("planted", compiler(), derivatives)).encode())
    for path in sorted(path for folder in SOURCES for path in (tree / folder).rglob("*.*")):
        if path.suffix in (".py", ".c", ".h") and path.parent.name != "generated":
            found.update(f"{path.relative_to(tree)}\0".encode() + path.read_bytes())
    return found.hexdigest()
