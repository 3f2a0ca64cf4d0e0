"""The workflow that publishes a release, and how the project is cited: read as YAML."""

import os
import re
import shlex
from importlib.util import find_spec

from tests.helpers.paths import ROOT
from tests.helpers.platforms import for_platforms

WORKFLOW = ROOT / ".github" / "workflows" / "release.yml"
needs_yaml = for_platforms("PyYAML is not installed", "yaml")
#: Programs that GitHub's machines have.
THERE = {"sudo", "apt-get", "test", "mkdir", "mv", "sha256sum", "gh"}


def read(path):
    import yaml

    return yaml.safe_load(path.read_text(encoding="utf-8"))


def steps(jobs):
    return [(name, step) for name, job in jobs.items() for step in job["steps"]]


@needs_yaml
def test_every_command_exists():
    project = (ROOT / "pyproject.toml").read_text(encoding="utf-8")  # Python 3.10 has no reader of TOML
    known = re.findall(r"^(\w+) = \[", project.partition("[project.optional-dependencies]")[2], re.MULTILINE)
    modules = {"pip", "pytest", "mkdocs"}
    seen = []
    for name, step in steps(read(WORKFLOW)["jobs"]):
        assert set(step) <= {"uses", "with", "run", "env", "working-directory"}
        assert ("uses" in step) != ("run" in step)
        if "uses" in step:
            assert re.fullmatch(r"[\w-]+/[\w-]+@(v\d+|release/v1)", step["uses"])
            continue
        first, *words = shlex.split(step["run"])
        seen.append(first)
        if first == "python" and words[0] == "-m":
            assert words[1] in modules and (find_spec(words[1]) or words[1] == "mkdocs")
            for extras in re.findall(r"\.\[([\w,]+)\]", step["run"]):
                assert set(extras.split(",")) <= set(known)
        elif first == "python":
            assert (ROOT / words[0]).is_file() and words[1:] == ["dist/release"]
        else:
            assert first in THERE, first
    assert {"python", "gh", "sha256sum"} <= set(seen)
    assert (ROOT / "mkdocs.yml").is_file() and '\nwrcontact = "wrcontact.cli:main"\n' in project


@needs_yaml
def test_only_what_publishes_may_write():
    page = read(WORKFLOW)
    # YAML takes the key "on" for true
    assert page[True] == {"push": {"tags": ["v*"]}} and page["permissions"] == {}
    rights = {
        name: {right for right, kind in job["permissions"].items() if kind == "write"}
        for name, job in page["jobs"].items()
        if "permissions" in job
    }
    assert rights == {
        "build": set(),
        "site": set(),
        "packages": {"id-token"},
        "files": {"contents"},
        "pages": {"pages", "id-token"},
    }
    for name, job in page["jobs"].items():
        assert ("environment" in job) == bool(rights[name])  # so each of them asks before it publishes
        assert set(job.get("needs", [])) <= set(page["jobs"])
    text = WORKFLOW.read_text(encoding="utf-8")
    assert "secrets." not in text and not re.search(r"https?:|password:|repository-url", text)


@needs_yaml
def test_what_is_handed_on_is_what_was_built():
    found = steps(read(WORKFLOW)["jobs"])
    given = [step["with"] for _, step in found if step.get("uses", "").startswith("actions/upload-artifact")]
    taken = [
        step["with"] for _, step in found if step.get("uses", "").startswith("actions/download-artifact")
    ]
    assert [entry["name"] for entry in given] == ["release"]
    assert {entry["name"] for entry in taken} == {"release"}
    (site,) = (step["with"]["path"] for _, step in found if "upload-pages-artifact" in step.get("uses", ""))
    assert f"site_dir: {site}\n" in (ROOT / "mkdocs.yml").read_text(encoding="utf-8")
    assert given[0]["path"] == "dist/release"


@needs_yaml
def test_citation():
    """The fields that the schema of CFF 1.2.0 requires, and none that it does not know."""
    cited = read(ROOT / "CITATION.cff")
    assert {"cff-version", "message", "title", "authors"} <= set(cited)
    assert set(cited) <= {
        "cff-version",
        "message",
        "title",
        "authors",
        "abstract",
        "keywords",
        "license",
        "type",
    }
    assert cited["cff-version"] == "1.2.0" and cited["type"] == "software" and cited["license"] == "MIT"
    licence = (ROOT / "LICENSE").read_text(encoding="utf-8")
    assert [set(author) for author in cited["authors"]] == [{"name"}]
    assert cited["authors"][0]["name"] in licence
    assert all(isinstance(word, str) and word for word in cited["keywords"])


def test_the_page_on_releases_names_what_is_there():
    page = (ROOT / "docs" / "develop" / "releasing.md").read_text(encoding="utf-8")
    for name in re.findall(r"`((?:tools|tests|wrcontact|\.github)/[\w./]+\.\w+)`", page):
        assert os.path.exists(ROOT / name), name
