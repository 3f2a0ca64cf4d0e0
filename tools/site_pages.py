"""What mkdocs does not do by itself for the site (mkdocs.yml names this file as a hook).

* Equations: LaTeX between dollar signs becomes MathML, which browsers draw without a script.  A numbered one
  has an anchor: ``\\tag{7.2}`` is ``#eq-7.2``.
* Files of the project outside of docs that a page links, such as an example, become pages of the site.
* Tables can be wider than a narrow screen: each stands in a box that scrolls.
"""

import html
import posixpath
import re
from pathlib import Path

from latex2mathml.converter import convert
from mkdocs.structure.files import File

ROOT = Path(__file__).resolve().parent.parent
DISPLAYED = re.compile(r"^([ ]*)\$\$\s*(.+?)\s*\$\$", re.DOTALL | re.MULTILINE)
INLINE = re.compile(r"(?<![\\$\w])\$(?![\s$])([^$\n]+?(?:\n[^$\n]+?)?)(?<![\s\\])\$(?![\w$])")
TAG = re.compile(r"\\tag\{([^}]*)\}")
CODE = re.compile(r"(^[ ]*```.*?^[ ]*```[ ]*$|`[^`\n]+`)", re.DOTALL | re.MULTILINE)
LINK = re.compile(r"(\]\()((?:\.\./)+[^)#\s]+)(#[^)]*)?\)")
FUNCTION = r"(<mi>(?:sin|cos|tan|ln|exp|arcsin|arccos|arctan)</mi>)(?!<m[on])"  # "cos a" with a gap
LANGUAGES = {".py": "python", ".c": "c", ".csv": "text", ".toml": "toml"}


def on_files(files, config):
    """Add a page for each linked file outside of docs."""
    docs = Path(config.docs_dir)
    for page in [file for file in files if file.src_uri.endswith(".md")]:
        text = (docs / page.src_uri).read_text(encoding="utf-8")
        for _, link, _ in LINK.findall(CODE.sub("", text)):
            source = outside(page.src_uri, link)
            if source and files.get_file_from_path(site_path(source)) is None:
                files.append(File.generated(config, site_path(source), content=shown(source)))
    return files


def on_page_markdown(markdown, page, config, files):
    """Equations and links of one page."""
    pieces = CODE.split(markdown)  # code stands at odd places
    pieces[::2] = [equations(piece) for piece in pieces[::2]]
    return LINK.sub(lambda match: inside(match, page.file.src_uri), "".join(pieces))


def on_page_content(content, page, config, files):
    return re.sub(r"(<table>.*?</table>)", r'<div class="wide">\1</div>', content, flags=re.DOTALL)


def outside(page, link):
    """Path of a linked file from the project's folder, or None for one that lies in docs."""
    path = posixpath.normpath(posixpath.join("docs", posixpath.dirname(page), link))
    return None if path.startswith("docs/") else path


def site_path(source):
    """Where a file of the project stands in the site."""
    return "files/" + re.sub(r"\.md$", "", source).replace(".", "_") + ".md"


def shown(source):
    """The page of a file or a folder of the project."""
    path = ROOT / source
    if path.is_dir():
        names = sorted(file.name for file in path.iterdir() if not file.name.startswith(("_", ".")))
        return f"# {source}\n\nA folder of the project:\n\n" + "\n".join(f"* `{name}`" for name in names)
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".md":
        return re.sub(r"!?\[([^\]]*)\]\((?!http)[^)]*\)", r"\1", text)  # without links to other files
    return f"# {source}\n\n````{LANGUAGES.get(path.suffix, 'text')}\n{text}\n````\n"


def inside(match, page):
    """The link to a file of the project, as one to its page in the site."""
    source = outside(page, match[2])
    if source is None:
        return match[0]
    target = posixpath.relpath(site_path(source), posixpath.dirname(page) or ".")
    return f"{match[1]}{target}{match[3] or ''})"


def equations(text):
    """The text with MathML for LaTeX."""
    text = DISPLAYED.sub(displayed, text)
    return INLINE.sub(lambda match: f'<span class="formula">{mathml(match[1])}</span>', text)


def displayed(match):
    """A displayed equation with its number at the right."""
    number = TAG.search(match[2])
    formula = mathml(TAG.sub("", match[2]), display="block")
    anchor = f' id="eq-{html.escape(number[1])}"' if number else ""
    label = f"<span>({html.escape(number[1])})</span>" if number else ""
    return f'{match[1]}<div class="equation"{anchor}>{formula}{label}</div>'


def mathml(formula, display="inline"):
    drawn = convert(" ".join(formula.split()), display=display)
    return re.sub(FUNCTION, r"\1<mspace width='0.17em'/>", drawn)
