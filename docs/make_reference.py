"""Write docs/reference/command_line.md and the messages of docs/reference/statuses.md from the package:
``python docs/make_reference.py``."""

import re
from inspect import cleandoc
from pathlib import Path

import typer

from wrcontact.cli.commands import main
from wrcontact.cli.groups import ORDER
from wrcontact.cli.help import EXAMPLE, OWN
from wrcontact.status import SENTENCES, Terms, written

FOLDER = Path(__file__).resolve().parent / "reference"
COMMAND_LINE, STATUSES = FOLDER / "command_line.md", FOLDER / "statuses.md"
BEGIN, END = "<!-- python docs/make_reference.py: messages -->", "<!-- end: messages -->"
WHEN = {
    "infinite": "not finite",
    "beyond": "too large",
    "outside": "out of range",
    "below": "too small",
    "nonzero": "",
    "always": "",
}
MODE = {None: "", True: " (compliant contact)", False: " (rigid and elastic contact)"}


def command_line():
    """The page of the command line."""
    group = typer.main.get_command(main)
    about = " ".join(cleandoc(group.help).split())
    words = [
        f"* [`wrcontact {name}`](#wrcontact-{name}): {one.get_short_help_str(200)}"
        for name, one in group.commands.items()
    ]
    lines = [
        "# Command line",
        "",
        f"{about} `docs/make_reference.py` writes this page from the command.",
        "",
        *words,
    ]
    groups = {name: groups_of(command) for name, command in group.commands.items()}
    common = common_rows(groups.values())
    for name, command in group.commands.items():
        lines += ["", *of_command(name, command), *tables_of(groups[name], common)]
    lines += ["", "## Options of several commands", "", "Each command above says which of these it takes."]
    for title, rows in common.items():
        lines += ["", f"### {title}", "", *table(rows)]
    return "\n".join(lines) + "\n"


def of_command(name, command):
    """Lines on one command, without its options."""
    text, example = cleandoc(command.help or ""), EXAMPLE.search(cleandoc(command.help or ""))
    paragraphs = [" ".join(part.split()) for part in EXAMPLE.sub("", text).strip().split("\n\n")]
    lines = [f"## wrcontact {name}", "", *"\n\n".join(map(angled, paragraphs)).split("\n")]
    if example:
        lines += ["", "```", " ".join(example[1].split()), "```"]
    return lines


def groups_of(command):
    """{title: rows of its options}."""
    groups = {title: [] for title in (OWN, *ORDER)}
    for option in command.params:
        if option.param_type_name == "option" and option.name not in ("help", "help_all"):
            groups.setdefault(getattr(option, "rich_help_panel", None) or OWN, []).append(row(option))
    return groups


def common_rows(commands):
    """{title: rows} of the groups that several of the ``commands`` have, each row once."""
    found = {}
    for title in ORDER:
        having = [groups[title] for groups in commands if groups[title]]
        if len(having) > 1:
            found[title] = list(dict.fromkeys(line for rows in having for line in rows))
    return found


def tables_of(groups, common):
    """Tables of a command's own options, and which of the ``common`` ones it takes."""
    lines, takes = [], []
    for title, rows in groups.items():
        if not rows:
            continue
        if title not in common:
            lines += ["", f"**{title}**", "", *table(rows)]
            continue
        left_out = [name_in(line) for line in common[title] if line not in rows]
        link = f"[{title}](#{re.sub('[^a-z -]', '', title.lower()).replace(' ', '-')})"
        if len(left_out) <= len(rows):
            takes.append(f"{link}{' without ' if left_out else ''}{', '.join(left_out)}")
        else:
            takes.append(f"of {link} {', '.join(map(name_in, rows))}")
    return [*lines, "", f"It also takes {'; '.join(takes)}."] if takes else lines


def name_in(line):
    """The option of a row, as code."""
    return f"`{re.search('`(--[a-z0-9-]+)', line)[1]}`"


def table(rows):
    """Lines of a table of options."""
    return ["| option | meaning |", "|---|---|", *rows]


def row(option):
    """A row of the table of options."""
    names = " / ".join((*option.opts, *option.secondary_opts))
    flag = getattr(option, "is_flag", False) or not option.metavar
    words = angled(" ".join((option.help or "").split())).rstrip(".") + "."
    if not flag and "|" in option.metavar:
        words = f"One of {option.metavar.replace('|', ', ')}. {words}"
    elif not flag:
        names += f" {option.metavar}"
    if not flag and option.default not in (None, ""):
        words += f" Default: {option.default}."
    return f"| `{names}` | {words.replace('|', chr(92) + '|')} |"


def angled(text):
    """Text without marks that Markdown reads as something else."""
    return re.sub(r"<(\w+)>", r"&lt;\1&gt;", text)


def messages():
    """Table of the sentences on statuses, with ``…`` for values of a pose; both sides in one row."""
    found = {}
    for said in SENTENCES:
        text = written(said.text, Terms(), lambda name: "…").replace("|", "\\|")
        if said.test == "infinite":
            text = text.replace(said.name, "NAME")
        text, name = (re.sub(r"\b(left|right)\.", "side.", one) for one in (text, said.name))
        found.setdefault((int(said.status), text, WHEN[said.test], said.compliant), {})[name] = None
    lines = ["| status | input | message |", "|---:|---|---|"]
    for (status, text, when, compliant), names in found.items():
        name = "any" if len(names) > 3 else ", ".join(f"`{one}`" for one in names)
        lines.append(f"| {status} | {name}{' ' + when if when else ''}{MODE[compliant]} | {text} |")
    return "\n".join(lines)


def statuses():
    """The page of statuses, with its table written anew."""
    page = STATUSES.read_text(encoding="utf-8")
    return re.sub(
        f"{re.escape(BEGIN)}.*{re.escape(END)}",
        lambda _: f"{BEGIN}\n{messages()}\n{END}",
        page,
        flags=re.DOTALL,
    )


if __name__ == "__main__":
    COMMAND_LINE.write_text(command_line(), encoding="utf-8")
    STATUSES.write_text(statuses(), encoding="utf-8")
