"""The site: it builds without a warning, and a browser shows it, searches it, and needs nobody else's server.

Strict building checks every link and anchor inside the site.
"""

import functools
import http.server
import os
import re
import shutil
import subprocess
import sys
import threading

import pytest

from tests.helpers.kept import locked
from tests.helpers.paths import ROOT

pytestmark = pytest.mark.full
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
SHARES = 3  # of the pages that a browser shows
NARROW, WIDE = {"width": 390, "height": 844}, {"width": 1280, "height": 1000}


@pytest.fixture(scope="module")
def site(tmp_path_factory, testrun_uid):
    """Folder of the built site, built once for all processes of this run."""
    pytest.importorskip("mkdocs")
    folder = tmp_path_factory.getbasetemp().parent / f"site-{testrun_uid}"
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "NO_MKDOCS_2_WARNING": "1"}
    with locked(folder):
        if not (folder / "built").exists():
            done = subprocess.run(
                [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", folder],
                cwd=ROOT,
                env=environment,
                capture_output=True,
                text=True,
            )
            assert done.returncode == 0, done.stderr[-3000:]
            assert not re.search("^WARNING", done.stderr, re.MULTILINE), done.stderr
            (folder / "built").touch()
    return folder


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


@pytest.fixture(scope="module")
def address(site):
    """Where a server on this machine has the site."""
    handler = functools.partial(Quiet, directory=site)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        thread = threading.Thread(target=server.serve_forever, daemon=True)
        thread.start()
        yield f"http://127.0.0.1:{server.server_address[1]}/"
        server.shutdown()


@pytest.fixture(scope="module")
def browser():
    """A browser without a screen."""
    playwright = pytest.importorskip("playwright.sync_api")
    if CHROMIUM is None:
        pytest.skip("chromium is not installed")
    with playwright.sync_playwright() as running:
        found = running.chromium.launch(
            executable_path=CHROMIUM,
            args=[
                "--no-sandbox",
                "--disable-gpu",
                "--disable-background-networking",
                "--disable-component-update",
            ],
        )
        yield found
        found.close()


@pytest.fixture
def page(browser, address):
    """A page, and a list of what went wrong in it: requests that fail or go elsewhere, errors of scripts."""
    opened = browser.new_page(viewport=WIDE)
    opened.wrong = []
    opened.on(
        "requestfailed",
        lambda request: (
            "ERR_ABORTED" in request.failure  # the next page was opened
            or opened.wrong.append(request.url)
        ),
    )
    opened.on(
        "request",
        lambda request: (
            request.url.startswith((address, "data:", "blob:")) or opened.wrong.append(request.url)
        ),
    )
    opened.on("response", lambda response: response.status < 400 or opened.wrong.append(response.url))
    opened.on("pageerror", lambda error: opened.wrong.append(str(error)))
    yield opened
    assert not opened.wrong
    opened.close()


def all_pages(site):
    """Paths of the pages for readers; files of the project that they link are left out."""
    found = sorted(path.parent.relative_to(site).as_posix() for path in site.rglob("index.html"))
    return [path for path in found if not path.startswith("files")]


def test_every_page_of_docs_is_in_the_site(site):
    docs = ROOT / "docs"
    names = (path.relative_to(docs).with_suffix("").as_posix() for path in docs.rglob("*.md"))
    pages = {name.removesuffix("index").rstrip("/") or "." for name in names}
    assert pages <= set(all_pages(site))


@pytest.mark.parametrize("first", range(SHARES))
@pytest.mark.turns(SHARES)
def test_every_page_shows_its_pictures_and_fits_a_narrow_screen(site, address, page, first):
    """No picture is missing, and nothing but boxes that scroll is wider than a telephone."""
    page.set_viewport_size(NARROW)
    for path in all_pages(site)[first::SHARES]:
        page.goto(f"{address}{path}/")
        page.evaluate("document.querySelectorAll('img').forEach(image => image.loading = 'eager')")
        page.wait_for_load_state("load")
        missing = page.evaluate("""Promise.all([...document.images].map(image => image.decode().then(
            () => null, () => image.src))).then(found => found.filter(one => one))""")
        assert not missing, path
        assert page.evaluate("document.documentElement.scrollWidth") <= NARROW["width"], path


def test_search_finds_a_page(address, page):
    """A reader types a word; the first result that is shown leads to a page that has it."""
    page.goto(address)
    page.locator("input[name=query]").click()
    page.locator("input[name=query]").press_sequentially("directional derivatives")
    result = page.locator(".md-search-result__link").first
    result.wait_for(timeout=15_000)
    result.click()
    page.wait_for_url(lambda url: url.rstrip("/") != address.rstrip("/"))
    assert "erivative" in page.locator("article").inner_text()


@pytest.mark.parametrize("first", range(SHARES))
@pytest.mark.turns(SHARES)
def test_equations_are_drawn(site, address, page, first):
    """Equations are MathML with a size, numbered ones have an anchor, and no LaTeX is left in the text."""
    numbered = 0
    for path in all_pages(site)[first::SHARES]:
        if path.startswith("theory"):
            page.goto(f"{address}{path}/")
            text = page.evaluate("""(() => {const copy = document.querySelector('article').cloneNode(true);
                copy.querySelectorAll('code, pre').forEach(one => one.remove());
                return copy.textContent})()""")
            assert "\\frac" not in text and "$" not in text and "\\tag" not in text, path
            sizes = page.evaluate("""[...document.querySelectorAll('.equation math')].map(
                one => one.getBoundingClientRect().height)""")
            assert all(height > 5 for height in sizes), path
            numbered += page.locator(".equation[id]").count()
    assert numbered > 10  # of those that the code cites


def test_a_number_leads_to_its_equation(site):
    """Numbers stand once in the whole site, so that "(7.2)" in the code means one equation."""
    found = [
        number
        for path in site.rglob("theory/**/index.html")
        for number in re.findall(r'class="equation" id="eq-([^"]+)"', path.read_text(encoding="utf-8"))
    ]
    assert len(found) == len(set(found))


def test_notebooks_ran_and_show_something(site):
    """Every notebook has pictures; the worn wheel's conicity is that of its profile, E3 of EN 15302 on rails
    A, 0.5, and with three times the conicity of a new wheel it hunts from a lower speed."""
    files = (site / "notebooks").rglob("index.html")
    texts = {path.parent.name: path.read_text(encoding="utf-8") for path in files}
    assert len(texts) == 2
    assert all(text.count("data:image/png;base64") >= 4 for text in texts.values())
    text = re.sub(r"<[^>]+>", "", texts["worn_wheel_to_hunting"])
    conicity, speed = (
        {wheel: float(found) for wheel, found in re.findall(rf"(new|worn): {words}", text)}
        for words in (r".*conicity ([\d.]+)", r"hunts from (\d+)")
    )
    assert conicity["worn"] > 2 * conicity["new"]
    assert speed["worn"] < 0.75 * speed["new"]


def test_signatures_have_one_argument_a_line(site):
    """Those that do not fit one line."""
    page = (site / "reference" / "api" / "index.html").read_text(encoding="utf-8")
    begin = page.index('id="wrcontact.ContactSystem.evaluate"')
    lines = re.sub(r"<[^>]+>", "", page[begin : page.index("</pre>", begin)]).splitlines()
    arguments = [line.strip() for line in lines if "=" in line and line.startswith("    ")]
    assert "lateral_shift=0.0," in arguments and len(arguments) > 40
    assert all(line.count("=") == 1 for line in arguments)
