# make            these lines
# make setup      .venv with wrcontact as it stands here, and its tests (needs gcc)
# make kernel     after a change in wrcontact/kernel: translate it to C, and compile that with less optimising
# make pages     after a change of names, options or measurements: write all that is generated from them
# make check      before each commit: ruff, structure, doctests, and the tests of the compiled kernel; two minutes
# make full       before each merge: what .ci/run runs, on a clean copy; 10 … 15 minutes
# make complete   each night: every test there is; hours
#
# CONTRIBUTING.md says which test belongs where.  PYTHON=... takes another Python than that of .venv.

PYTHON ?= .venv/bin/python
PYTEST = $(PYTHON) -m pytest -q -n auto --dist worksteal

help:
	@sed -n 's/^# \(make.*\)/\1/p' Makefile

setup:
	python3 -m venv .venv
	.venv/bin/pip install -q -e ".[test,tables,cluster]"

kernel:
	$(PYTHON) tools/transpile_kernel.py
	$(PYTHON) tools/compile_kernel.py --quick

pages:
	$(PYTHON) docs/make_pages.py

check:
	$(PYTHON) -m ruff check
	$(PYTHON) -m ruff format --check -q
	$(PYTEST)

full:
	.ci/run

complete:
	$(PYTEST) -m ""

.PHONY: help setup kernel pages check full complete
