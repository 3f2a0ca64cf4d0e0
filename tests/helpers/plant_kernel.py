"""The C of copies of the kernel that have an error: of each copy what differs from the C that is there."""

#: What the generated C is made of.
SOURCES = ("wrcontact/kernel", "wrcontact/interface")


def changed_files(plain, tree, derivatives=True):
    """{name: text} of the generated files of ``tree``, a copy with an error, that are not those of the copy
    ``plain``, which has none; without ``derivatives`` those of the steps alone."""
    import tools.transpile_kernel as tool

    if all(same(plain, tree, folder) for folder in SOURCES):
        return {}
    files = tool.translate(tree / "wrcontact" / "kernel", derivatives)
    there = {path.name: path.read_text(encoding="utf-8") for path in generated(plain).glob("*.[ch]")}
    return {name: text for name, text in files.items() if text != there.get(name)}


def generated(tree):
    return tree / "wrcontact" / "kernel" / "generated"


def same(plain, tree, folder):
    """Whether the Python in a folder of both copies is the same."""
    return all(
        path.read_bytes() == (tree / path.relative_to(plain)).read_bytes()
        for path in (plain / folder).rglob("*.py")
    )
