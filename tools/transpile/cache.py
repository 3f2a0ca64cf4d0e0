"""Translations kept from one run to the next, in the user's folder of caches: only modules whose translation
may have changed go through Pyccel.

The C of a module follows from its own text, from the kinds of the functions and constants that it imports,
and from Pyccel.  Their hash is the name under which it is kept.  Beside a module that is translated stand
stubs of those that it imports: the same functions of the same kinds, with nothing in them.
"""

import ast
import hashlib
import json
import os
from pathlib import Path

from differentiate.modules import Kernel

from .modules import VALUES
from .translator import PYCCEL_VERSION, START, run_pyccel

#: Translations that are kept at most, the newest ones.
MOST = 2000


def translated(modules, fresh=False):
    """Pyccel's header and code, by module name; ``fresh`` keeps and reads nothing."""
    if fresh:
        return run_pyccel(modules)
    kernel = Kernel(modules)
    paths = {module.name: folder() / f"{key(kernel, module)}.json" for module in modules}
    found = {name: read(path) for name, path in paths.items()}
    changed = [module for module in modules if not found[module.name]]
    if changed:
        found |= run_pyccel(changed, stubs(kernel, changed))
        for module in changed:
            keep(paths[module.name], found[module.name])
    return found


def folder():
    """Where translations are kept."""
    usual = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache", "wrcontact", "translated")
    usual.mkdir(parents=True, exist_ok=True)
    return usual


def read(path):
    """A kept translation, or None."""
    try:
        return tuple(json.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError):
        return None


def keep(path, pair):
    """Write a translation, and forget the oldest ones."""
    part = path.with_suffix(f".{os.getpid()}")
    part.write_text(json.dumps(pair), encoding="utf-8")
    part.replace(path)
    kept = list(path.parent.glob("*.json"))
    if len(kept) > MOST:
        for old in sorted(kept, key=lambda one: one.stat().st_mtime)[: MOST // 2]:
            old.unlink(missing_ok=True)


def key(kernel, module):
    """The hash under which the translation of a module is kept."""
    texts = [PYCCEL_VERSION, START.read_text(encoding="utf-8"), module.name, module.source().decode()]
    for home, names in sorted(module.imports.items()):
        texts.append(f"{home}: {sorted(described(kernel, home, name) for name in names)}")
    return hashlib.sha256("\0".join(texts).encode()).hexdigest()[:32]


def described(kernel, home, name):
    """What of a function or a constant its users' translation follows from."""
    module = kernel.modules[home]
    if name in module.functions:
        return stub(kernel, home, name)
    return next(
        f"{name}: {ast.unparse(node.annotation)}"
        for node in module.tree.body
        if isinstance(node, ast.AnnAssign) and node.target.id == name
    )


def stub(kernel, home, name):
    """A function of the same kind with nothing in it."""
    arguments = ast.unparse(kernel.node(home, name).args)
    kinds = kernel.returns(home, name)
    lines = [f"    result_{i} = {VALUES[kind]}" for i, kind in enumerate(kinds)]
    results = ", ".join(f"result_{i}" for i in range(len(kinds)))
    return "\n".join([f"def {name}({arguments}):", *lines, f"    return {results}", ""])


def stubs(kernel, changed):
    """Text by name of what stands beside the changed modules: all that they import, of which
    only the names and kinds are known."""
    names = {module.name for module in changed}
    wanted = {}
    for module in changed:
        for home, used in module.imports.items():
            if home not in names:
                wanted.setdefault(home, set()).update(used)
    texts = {}
    for home, used in wanted.items():
        module = kernel.modules[home]
        constants = [
            node
            for node in module.tree.body
            if isinstance(node, ast.AnnAssign) and (home != "layout" or node.target.id in used)
        ]
        lines = ["from typing import Final"]
        for node in constants:
            kind = ast.unparse(node.annotation)[len("Final[") : -1]
            lines.append(f"{node.target.id}: Final[{kind}] = {VALUES.get(kind) or ast.unparse(node.value)}")
        lines += [stub(kernel, home, name) for name in sorted(used) if name in module.functions]
        texts[home] = "\n".join(lines) + "\n"
    return texts
