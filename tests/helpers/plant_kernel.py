"""The C of copies of the kernel that have an error: all errors in one run of Pyccel, and of each copy only
what the error changes.  A module with an error stands beside the others under another name, since what it
calls and what calls it is translated as before."""

import copy
from concurrent.futures import ProcessPoolExecutor

#: What the generated C is made of.
SOURCES = ("wrcontact/kernel", "wrcontact/interface")


def changed_files(plain, trees, workers=2):
    """Of each of ``trees``, a copy with an error: {name: text} of the generated files that are not those of
    the copy ``plain``, which has none."""
    import tools.transpile_kernel as tool

    # the C that is there is the plain kernel's
    there = {path.name: path.read_text(encoding="utf-8") for path in generated(plain).glob("*.[ch]")}
    own = [tree for tree in trees if any(not same(plain, tree, folder) for folder in SOURCES)]
    if not own:
        return [{} for _ in trees]
    with ProcessPoolExecutor(workers) as pool:
        kernels = [tree / "wrcontact" / "kernel" for tree in (plain, *own)]
        first, *others = pool.map(tool.read_modules, kernels)
    before = {module.name: module for module in first}
    pairs = [
        [(before[module.name], module) for module in modules if module.text != before[module.name].text]
        for modules in others
    ]
    raw = translated(first, pairs)
    files = dict(
        zip(
            own,
            (
                spliced(tool, there, tree, modules, found, raw, number)
                for number, (tree, modules, found) in enumerate(zip(own, others, pairs))
            ),
        )
    )
    return [files.get(tree, {}) for tree in trees]


def generated(tree):
    return tree / "wrcontact" / "kernel" / "generated"


def same(plain, tree, folder):
    """Whether the Python in a folder of both copies is the same."""
    return all(
        path.read_bytes() == (tree / path.relative_to(plain)).read_bytes()
        for path in (plain / folder).rglob("*.py")
    )


def translated(modules, pairs):
    """Pyccel's header and code by name, of all modules that some copy changes and, with the copy's number at
    its name, of what it has in their place."""
    from differentiate.modules import Kernel
    from transpile.cache import stubs

    import tools.transpile_kernel as tool

    changed = {was.name: was for found in pairs for was, _ in found}
    for number, found in enumerate(pairs):
        for _, module in found:
            other = changed[f"{module.name}_v{number}"] = copy.copy(module)
            other.name = f"{module.name}_v{number}"
            other.path = module.path.with_name(f"{other.name}.py")
    changed = list(changed.values())
    return tool.run_pyccel(changed, stubs(Kernel(modules), changed)) if changed else {}


def spliced(tool, there, tree, modules, pairs, raw, number):
    """The files of a copy that differ from those that are ``there``: rooms in which a module is exchanged,
    the constants' header and the unit with the fingerprint."""
    from transpile.lanes import in_lanes, parameter_kinds
    from transpile.tidy import tidy_code
    from transpile.units import constants_header, step_unit

    kinds = parameter_kinds(there["derivatives.h"])
    kernel = tree / "wrcontact" / "kernel"
    plain = [module for module in modules if not module.derivative]
    files = {"constants.h": constants_header(kernel, plain), "unit.c": step_unit(kernel, plain)}
    for was, module in pairs:
        name = f"{module.room}.c"
        text = files.get(name, there[name])
        old = tidy_code(was, raw[was.name][1])
        new = tidy_code(
            module, raw[f"{module.name}_v{number}"][1].replace(f"{module.name}_v{number}", module.name)
        )
        if module.derivative:
            old, new = in_lanes(old, kinds), in_lanes(new, kinds)
        if text.count(old) != 1:
            raise tool.Refused(f"{name} is not what the kernel's Python gives; run tools/transpile_kernel.py")
        files[name] = text.replace(old, new)
    return {name: text for name, text in files.items() if text != there[name]}
