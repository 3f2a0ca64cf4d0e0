"""Docstrings as Markdown, for the site (mkdocs.yml names this file as an extension of mkdocstrings).

The docstrings of wrcontact have numpy's sections, with words where numpy has types: ``name : words``.
Sections become lists, examples become blocks of code, and Sphinx' roles become links.
"""

import re
from inspect import cleandoc
from pathlib import Path

import griffe

SECTION = re.compile(r"^([A-Z][A-Za-z ]+)\n-{3,}\n", re.MULTILINE)
ENTRY = re.compile(r"^(\S[^\n]*?) : ", re.MULTILINE)
ROLE = re.compile(r":(?:class|func|meth|mod|attr|data):`(~?)([\w.]+)`", re.ASCII)
EXAMPLE = re.compile(r"(?:^>>> .*\n?(?:^(?!\s*$).*\n?)*)+", re.MULTILINE)
#: What the page of the interface shows, and so can be linked.
SHOWN = set(
    re.findall(
        r"^::: (\S+)",
        (Path(__file__).parent.parent / "docs/reference/api.md").read_text(encoding="utf-8"),
        re.MULTILINE,
    )
)
LISTED = ("Parameters", "Attributes", "Returns", "Raises", "Other Parameters")


class Markdown(griffe.Extension):
    """Rewrites each docstring when griffe has read it."""

    def on_object(self, *, obj, **_):
        if obj.docstring is not None:
            obj.docstring.value = markdown(obj.docstring.value)


def markdown(text):
    """A docstring with Markdown for its sections, examples and roles."""
    first, *sections = SECTION.split(cleandoc(text))
    parts = [examples(first)]
    for title, body in zip(sections[::2], sections[1::2]):
        words = items(body) if title in LISTED else examples(body)
        parts.append(f"**{title}**\n\n{words}")
    return links("\n\n".join(part.strip("\n") for part in parts if part.strip()))


def items(body):
    """A list for a section: each entry begins at the left, and its words go on further right."""
    lines = []
    for line in body.rstrip().split("\n"):
        if line and not line.startswith(" "):
            name, colon, words = line.partition(" : ")
            lines.append(
                f"* {code(name)}: {words}"
                if colon
                else f"* {code(name)}"
                if name.isidentifier()
                else f"* {name}"
            )
        elif re.match(r" +'\w+', :class:", line):  # a choice of a method
            name, _, words = line.strip().partition(" : ")
            lines.append(f"    * {name.replace(chr(39), '`')}: {words}")
        else:
            lines.append(f"    {line.strip()}" if line.strip() else "")
    return "\n".join(lines)


def code(names):
    return ", ".join(f"`{name}`" for name in names.split(", "))


def examples(text):
    """Lines that begin with ``>>>``, and what follows them, as a block of code."""
    return EXAMPLE.sub(lambda match: f"```pycon\n{without_directives(match[0])}\n```\n", text)


def without_directives(example):
    return re.sub(r" *# doctest: .*", "", example).rstrip()


def links(text):
    """Roles as links to where the site has the object, or as code."""

    def link(match):
        name = match[2].rpartition(".")[2] if match[1] else match[2]
        return f"[`{name}`][{match[2]}]" if match[2] in SHOWN else f"`{name}`"

    return ROLE.sub(link, text).replace("``", "`")
